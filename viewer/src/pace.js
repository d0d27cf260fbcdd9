// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How much is drawn while the picture moves: as much as this machine draws in time. All of it is drawn once it rests.

/** ms: a frame that takes longer is one that people see. */
const budget = 33;
/** ms after the last movement until the picture rests; longer where all of it takes longer to draw, but not this long. */
const rest = 180, longestRest = 1000;
const leastShare = 0.01;

export class Pace {
  /** \param redraw  called as the picture comes to rest, when it was not drawn whole */
  constructor(redraw) {
    this.redraw = redraw;
    this.moving = false;
    this.whole = 0; // ms that all of it takes
    this.share = 1; // of the lines, while it moves
    this.timer = 0;
  }

  /** whether all of it takes longer than a frame may. */
  get slow() {
    return this.whole > budget;
  }

  /** whether less than all is drawn: a coarser surface, and the strongest lines, `share` of all. */
  get reduced() {
    return this.moving && this.slow;
  }

  /** the camera has moved. */
  move() {
    this.moving = true;
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.stop(), Math.min(longestRest, Math.max(rest, this.whole)));
  }

  stop() {
    const { reduced } = this;
    this.moving = false;
    if (reduced) this.redraw();
  }

  /** learns from a frame that took so many ms. */
  took(ms, reduced) {
    if (!reduced) {
      this.whole = ms;
      this.share = Math.min(this.share, Math.max(leastShare, budget / ms));
    } else if (ms > budget) this.share = Math.max(leastShare, this.share * Math.max(0.5, (0.9 * budget) / ms));
    else if (ms < 0.7 * budget) this.share = Math.min(1, 1.25 * this.share);
  }
}
