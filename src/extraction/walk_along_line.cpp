// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Searches across a chord need lines that keep to one side of their ends. One that turns back in a cell, or runs along its
// border first, has a tangent everywhere nevertheless.
#include "walk_along_line.h"

#include "../differential/vector.h"

#include <algorithm>
#include <cmath>

namespace CGAL::Extremal_mesh_3 {

namespace {

/// The tangent may leave the way to the next point by so many radians.
constexpr double greatest_turn = 0.5;
/// Steps grow where the tangent turns by less than this.
constexpr double little_turn = 0.2;
/// A step is corrected by no more than this part of itself.
constexpr double greatest_correction = 0.3;
/// Steps in parts of the chord: the first one, and the least.
constexpr double first_step = 0.2, least_step = 1e-3;
constexpr int most_steps = 100;
/// The line goes nowhere farther than so many times the chord, or than the cell is large, by so much of it.
constexpr double farthest = 10, part_of_reach = 1.5;
/// A point is on the line when a step across it is less than this part of the chord.
constexpr double settled = 1e-12;

class Line_walk {
public:
  Line_walk(const Surface& surface, const Segment& segment, bool backward)
      : surface_(surface), from_(segment.ends[backward ? 1 : 0].at), to_(segment.ends[backward ? 0 : 1].at),
        family_(segment.family), turned_(family_ == 1 ? -1 : 1),
        rising_((backward ? -1 : 1) * turned_ * segment.sign_on_left), length_(distance(from_.p, to_.p)),
        farthest_(std::max(farthest * length_, part_of_reach * segment.reach)) {}

  /// tells whether the tangent at the first end is known, as it is not at a vertex.
  bool can_begin() const { return dot(from_.tangent, from_.tangent) > 0; }

  /// tells whether the line keeps near to the chord, as far as its tangents tell.
  bool is_nearly_straight() const { return sees_end({from_, forward(from_)}); }

  /// \return whether the end was reached
  bool reach_end(std::vector<Line_place>& points) const {
    Step at{from_, forward(from_)};
    double step = first_step * length_;
    for (int i = 0; i < most_steps; ++i) {
      if (sees_end(at) && !points.empty())
        return true;
      step = std::min(step, 0.6 * distance(at.place.p, to_.p));
      auto next = advance(at, step);
      while (!next && step > least_step * length_) {
        step /= 2;
        next = advance(at, step);
      }
      if (!next)
        return false;
      if (angle(at.tangent, next->tangent) < little_turn)
        step *= 1.5;
      at = *next;
      points.push_back(at.place);
    }
    return false;
  }

private:
  struct Step {
    Line_place place;
    Vector tangent; ///< forward
  };
  struct Phase_slope {
    Vector gradient;
    double size = 0;
  };

  /// the tangent on the way from the first end to the second: E_g has its sign on the left.
  Vector forward(const Line_place& at) const { return -rising_ * at.tangent; }

  static double angle(const Vector& a, const Vector& b) { return std::atan2(norm(cross(a, b)), dot(a, b)); }

  static Phase_slope slope_at(const Sample& s) {
    const auto [x, y] = phase_gradient(s);
    return {x * s.shape.u + y * s.shape.v(), std::sqrt(x * x + y * y)};
  }

  /// The line goes straight to the end from here, as far as the tangents tell.
  bool sees_end(const Step& at) const {
    const Vector way = to_.p - at.place.p, arriving = forward(to_);
    return angle(at.tangent, way) < greatest_turn &&
           (dot(arriving, arriving) == 0 || angle(arriving, way) < greatest_turn);
  }

  std::optional<Step> advance(const Step& at, double step) const {
    std::optional<Sample> s;
    Point p = at.place.p + step * at.tangent;
    for (int i = 0; i < 8; ++i) {
      s = surface_.sample(p, at.place.n, step, Surface::to_place);
      if (!s || !s->has_fourth)
        return std::nullopt;
      const Phase_slope slope = slope_at(*s);
      if (!(slope.size > 0) || !std::isfinite(slope.size))
        return std::nullopt;
      const double off = -std::arg(turned_ * s->shape.Phi()) / slope.size;
      if (std::abs(off) > greatest_correction * step)
        return std::nullopt;
      if (std::abs(off) < settled * length_ || (i > 3 && std::abs(off) < 100 * settled * length_))
        break;
      if (i == 7)
        return std::nullopt;
      p = s->p + off / slope.size * slope.gradient;
    }
    const Line_place place = line_place(surface_, *s, family_, 1e-3 * length_);
    const Vector way = place.p - at.place.p, tangent = forward(place);
    if (angle(at.tangent, way) > greatest_turn || angle(tangent, way) > greatest_turn ||
        distance(place.p, from_.p) > farthest_)
      return std::nullopt;
    return Step{place, tangent};
  }

  const Surface& surface_;
  const Line_place &from_, &to_;
  int family_;
  double turned_; ///< takes Φ to the positive numbers on lines of the family
  double rising_; ///< whether its phase rises to the left, or falls
  double length_, farthest_;
};

} // namespace

std::vector<Line_place> walk_along_line(const Surface& surface, const Segment& segment, bool even_if_straight) {
  std::vector<Line_place> points;
  for (const bool backward : {false, true}) {
    const Line_walk walk(surface, segment, backward);
    if (!walk.can_begin())
      continue;
    if (!even_if_straight && walk.is_nearly_straight())
      return {};
    if (walk.reach_end(points)) {
      if (backward)
        std::reverse(points.begin(), points.end());
      return points;
    }
    points.clear();
  }
  return {};
}

} // namespace CGAL::Extremal_mesh_3
