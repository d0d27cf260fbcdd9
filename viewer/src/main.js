// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
import { readData } from "./data.js";
import { makeLines } from "./lines.js";
import { describe, makeChoice, makeLegend, makeLevelSlider, makeSlider, showDetails } from "./panel.js";
import { makePoints } from "./points.js";
import { Stage } from "./stage.js";
import { makeSurface } from "./surface.js";

const $ = (id) => document.getElementById(id);
const data = readData($("data"));
const surface = data.surface && makeSurface(data);
const lines = makeLines(data, Boolean(surface));
const points = makePoints(data);
const stage = new Stage($("canvas"), data, [surface, lines, points].filter(Boolean));

let selected = null;

function setVisible(key, on) {
  const type = data.line_types.findIndex((t) => t.name === key), kind = data.vertex_classes.findIndex((k) => k.name === key);
  if (type >= 0) lines.uniforms.visible.value.setComponent(type, Number(on));
  else if (kind >= 0) points.uniforms.visible.value[kind] = Number(on);
  else if (key === "surface" && surface) {
    surface.object.visible = on;
    lines.uniforms.fade.value = data.closed && !on;
  } else throw new RangeError(`there is nothing called ${key}`);
  showSwitch[key]?.(on);
  stage.draw();
}

function isVisible(key) {
  const type = data.line_types.findIndex((t) => t.name === key), kind = data.vertex_classes.findIndex((k) => k.name === key);
  if (type >= 0) return lines.uniforms.visible.value.getComponent(type) > 0;
  if (kind >= 0) return points.uniforms.visible.value[kind] > 0;
  return Boolean(surface?.object.visible);
}

function setLeastStrength(least) {
  lines.uniforms.leastStrength.value = least;
  showStrength(least);
  stage.draw();
}

/** shows the mesh at one of `data.levels` of its simplification, by its number there. */
function setLevel(i) {
  if (!(data.levels ? i in data.levels.level : i === 0)) throw new RangeError(`there is no level ${i}`);
  points.uniforms.level.value = lines.uniforms.level.value = i;
  const bytes = 3 * data.cells.sign.length;
  if (data.levels) surface?.paint(data.levels.colours.subarray(i * bytes, (i + 1) * bytes));
  showLevel?.(i);
  stage.draw();
}

/** the cells that are lit up with an element: itself, or those around it. */
function cellsOf({ kind, id }) {
  if (kind === "cell") return [id];
  if (kind === "edge") return [...new Set([data.edges.left[id], data.edges.right[id]])];
  const cells = new Set();
  data.edges.source.forEach((source, e) => {
    if (source === id || data.edges.target[e] === id) cells.add(data.edges.left[e]).add(data.edges.right[e]);
  });
  return [...cells];
}

function select(element) {
  selected = element;
  lines.uniforms.picked.value = element?.kind === "edge" ? element.id : -1;
  points.uniforms.picked.value = element?.kind === "vertex" ? element.id : -1;
  surface?.light(element ? cellsOf(element) : []);
  showDetails($("details"), data, element);
  stage.draw();
}

function setStereo(mode) {
  stage.setStereo(mode);
  pressStereo(mode);
}

function setTint(mode) {
  if (surface) surface.uniforms.tint.value = ["cells", "curvature", "plain"].indexOf(mode);
  pressTint?.(mode);
  stage.draw();
}

$("source").textContent = data.source.match(/^[^=<>*]*[/\\]([^/\\]+\.[A-Za-z.]+)$/)?.[1] ?? (data.source || "extremal mesh");
$("source").title = data.source;
$("counts").textContent =
  `${data.vertices.class.length.toLocaleString("en")} vertices · ${data.edges.type.length.toLocaleString("en")} edges · ` +
  `${data.cells.sign.length.toLocaleString("en")} cells` + (data.frame ? ` · ${data.frame}` : "");
const showSwitch = makeLegend($("legend"), data, setVisible);
const showStrength = makeSlider($("controls"), "strength", "Strength of lines", [...data.edges.strength], setLeastStrength);
const showLevel = data.levels && makeLevelSlider($("controls"), data.levels, setLevel);
const pressTint = surface && makeChoice($("controls"), "Tint", [["cells", "cells"], ["curvature", "curvature"], ["plain", "plain"]], setTint);
const pressStereo = makeChoice($("controls"), "Stereo pair", [["off", "off"], ["parallel", "parallel"], ["crossed", "crossed"]], setStereo);
if (data.vertex_classes.some((k) => k.name === "anchor" && k.count > 0)) setVisible("anchor", false);
$("reset").addEventListener("click", () => stage.reset());

// A click picks; a drag turns.
let pressed = null;
const canvas = $("canvas");
canvas.addEventListener("pointerdown", (event) => (pressed = [event.clientX, event.clientY]));
canvas.addEventListener("pointerup", (event) => {
  if (!pressed || Math.hypot(event.clientX - pressed[0], event.clientY - pressed[1]) > 4) return;
  const box = canvas.getBoundingClientRect();
  select(stage.pick(event.clientX - box.left, event.clientY - box.top));
});
window.addEventListener("keydown", (event) => {
  if (event.key === "Escape") select(null);
  if (event.key === "r") stage.reset();
});

/**
 * What scripts can do with the page, as the tests do. Places are in CSS pixels of the canvas.
 *   data                                   what the page shows
 *   isVisible(key), setVisible(key, on)    line types, classes of vertices, "surface"
 *   setLeastStrength(s)
 *   setLevel(i)                            the i-th of data.levels, from 0, of the simplification
 *   setTint("cells" | "curvature" | "plain"), setStereo("off" | "parallel" | "crossed")
 *   pick(x, y)                             {kind, id} or null
 *   select({kind, id} | null), selected(), describe({kind, id})
 *   placeOf(point)                         where a point [x, y, z] is seen
 *   seen()                                 segments and vertices that are not switched off
 *   render(share)                          draws now, with a share as while the picture moves on a slow machine: of the
 *                                          strongest lines and their vertices, coarser; returns the number of draw calls
 *   drawn()                                segments, vertices and triangles in the last picture, switched off or not
 *   atRest()                               whether the picture does not move, and all of it was drawn
 */
window.extremalMeshViewer = {
  data, isVisible, setVisible, setLeastStrength, setLevel, setTint, setStereo, select,
  selected: () => selected,
  describe: (element) => describe(data, element),
  pick: (x, y) => stage.pick(x, y),
  placeOf: (point) => stage.project(point.map((x, a) => x - data.center[a])),
  seen: () => ({ segments: lines.segments(), vertices: points.count() }),
  atRest: () => stage.atRest(),
  drawn: () => ({ segments: lines.drawn(), vertices: points.drawn(), triangles: surface?.drawn() ?? 0 }),
  render(share) {
    stage.render(share);
    return stage.renderer.info.render.calls;
  },
};
