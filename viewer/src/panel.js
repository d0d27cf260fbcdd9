// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Legend, switches, sliders and the table of what is picked: plain elements of the page.

const hex = (colour) => `rgb(${colour.join(",")})`;
const words = (name) => name.replaceAll("_", " ");
const shapes = ["disk", "drop", "triangle", "star", "disk", "square", "disk", "disk"];

function element(tag, attributes = {}, ...children) {
  const result = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) result.setAttribute(name, value);
  result.append(...children);
  return result;
}

/** a row of the legend that is a switch. */
function toggleRow(row, key, text, count, swatch, on, change) {
  const button = element("button", { class: "row", "data-key": key, "aria-pressed": String(on), title: "show or hide" },
    swatch, element("span", { class: "name" }, text), element("span", { class: "count" }, count.toLocaleString("en")));
  button.addEventListener("click", () => change(button.getAttribute("aria-pressed") !== "true"));
  row.append(button);
  return (value) => button.setAttribute("aria-pressed", String(value));
}

/** rows of the legend for all classes and types that there are. \return functions by key that show a switch's state */
export function makeLegend(root, data, change) {
  const show = {};
  const section = (title) => {
    const part = element("section", {}, element("h2", {}, title));
    root.append(part);
    return part;
  };
  const lines = section("Lines");
  data.line_types.forEach((type) => {
    if (type.edges === 0 && type.segments === 0) return;
    const swatch = element("i", { class: "swatch line", style: `background:${hex(type.colour)}` });
    show[type.name] = toggleRow(lines, type.name, words(type.name), type.edges, swatch, true, (on) => change(type.name, on));
  });
  const points = section("Vertices");
  data.vertex_classes.forEach((kind, i) => {
    if (kind.count === 0) return;
    const swatch = element("i", { class: `swatch ${shapes[i]}`, style: `background:${hex(kind.colour)}` });
    show[kind.name] = toggleRow(points, kind.name, words(kind.name), kind.count, swatch, kind.name !== "anchor", (on) => change(kind.name, on));
  });
  const cells = section("Surface");
  if (data.surface)
    show.surface = toggleRow(cells, "surface", "surface", data.cells.sign.length, element("i", { class: "swatch sheet" }), true, (on) => change("surface", on));
  for (const sign of [1, -1]) {
    const count = data.cells.sign.filter((s) => s === sign).length;
    const swatch = element("i", { class: "swatch sheet", style: `background:${hex(data.sign_colours[sign > 0 ? 0 : 1])}` });
    cells.append(element("div", { class: "row" }, swatch, element("span", { class: "name" }, sign > 0 ? "cells with E > 0" : "cells with E < 0"),
      element("span", { class: "count" }, count.toLocaleString("en"))));
  }
  return show;
}

/** buttons of which one is pressed. \return a function that presses one */
export function makeChoice(root, title, choices, change) {
  const group = element("div", { class: "choice", role: "group", "aria-label": title });
  const press = (value) => {
    for (const button of group.children) button.setAttribute("aria-pressed", String(button.dataset.value === value));
  };
  for (const [value, text] of choices) {
    const button = element("button", { "data-value": value }, text);
    button.addEventListener("click", () => change(value));
    group.append(button);
  }
  root.append(element("div", { class: "control" }, element("span", {}, title), group));
  press(choices[0][0]);
  return press;
}

/**
 * a slider over the ranks of values: at its left end all are shown, at its right end only the greatest.
 * \return a function that shows a threshold
 */
export function makeSlider(root, key, title, values, change) {
  const sorted = values.filter((v) => v !== null && v !== undefined).sort((a, b) => a - b);
  const input = element("input", { type: "range", min: 0, max: 1000, value: 0, "data-key": key, "aria-label": title });
  const output = element("output", {}, "all");
  const threshold = (share) => (share === 0 || sorted.length === 0 ? 0 : sorted[Math.min(sorted.length - 1, Math.floor(share * sorted.length))]);
  const text = (least) => (least > 0 ? `≥ ${least.toPrecision(3)}` : "all");
  input.addEventListener("input", () => change(threshold(input.value / 1000)));
  root.append(element("label", { class: "control" }, element("span", {}, title), input, output));
  return (least) => {
    output.textContent = text(least);
    if (document.activeElement !== input)
      input.value = least > 0 ? Math.round((1000 * sorted.filter((v) => v < least).length) / Math.max(1, sorted.length)) : 0;
  };
}

/**
 * a slider over the levels of the simplification: at its left end the mesh itself is seen, at its right end the simplest one.
 * \return a function that shows a level
 */
export function makeLevelSlider(root, levels, change) {
  const last = levels.level.length - 1;
  const input = element("input", { type: "range", min: 0, max: last, value: 0, "data-key": "level", "aria-label": "Simplification" });
  const output = element("output", {});
  const show = (i) => {
    output.textContent = i === 0 ? "none" : `${levels.cells[i].toLocaleString("en")} cells`;
    output.title = `level ${levels.level[i]}: ${levels.vertices[i]} vertices, ${levels.edges[i]} edges, ${levels.cells[i]} cells; ` +
      `persistence above ${levels.persistence[i].toPrecision(4)}`;
    if (document.activeElement !== input) input.value = i;
  };
  input.addEventListener("input", () => change(Number(input.value)));
  root.append(element("label", { class: "control" }, element("span", {}, "Simplification"), input, output));
  show(0);
  return show;
}

const number = (x) => (x === null || x === undefined ? "∞" : Number.isInteger(x) ? String(x) : x.toPrecision(6));

/** a coordinate, to what can be told apart in a surface of this radius. */
const place = (x, radius) => String(Number((Math.abs(x) < 1e-9 * radius ? 0 : x).toPrecision(7)));

/** what is known of an element, as rows of a table. */
export function describe(data, { kind, id }) {
  const { vertices: v, edges: e, cells: c } = data;
  if (kind === "vertex") {
    const rows = [["kind", words(data.vertex_classes[v.class[id]].name)], ["position", v.point[id].map((x) => place(x, data.radius)).join("  ")],
      ["k1", number(v.k1[id])], ["k2", number(v.k2[id])], ["degree", String(v.degree[id])]];
    if (v.index[id] !== 0) rows.push(["index", number(v.index[id])], ["lines through it", String(v.ridges[id])]);
    rows.push(["strength", number(v.strength[id])]);
    if (v.persistence) rows.push(["persistence", number(v.persistence[id])]);
    return rows;
  }
  if (kind === "edge")
    return [["type", words(data.line_types[e.type[id]].name)], ["family", String(e.family[id])], ["ends", `${e.source[id]}, ${e.target[id]}`],
      ["length", number(e.length[id])], ["strength", number(e.strength[id])], ["sharpness", number(e.sharpness[id])],
      ["stability", number(e.stability[id])], ["cells beside it", `${e.left[id]}, ${e.right[id]}`]];
  return [["sign of E", c.sign[id] > 0 ? "+" : "−"], ["area", number(c.area[id])], ["weight", number(c.weight[id])],
    ["edges", String(c.edges[id])], ["Euler characteristic", String(c.euler_characteristic[id])]];
}

/** shows what is picked, or nothing. */
export function showDetails(root, data, element_) {
  root.replaceChildren();
  root.hidden = !element_;
  if (!element_) return;
  const table = element("table");
  for (const [name, value] of describe(data, element_)) table.append(element("tr", {}, element("th", {}, name), element("td", {}, value)));
  root.append(element("h2", {}, `${element_.kind} ${element_.id}`), table);
}
