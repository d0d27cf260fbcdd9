// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the program wrote into the page. Arrays of numbers are in base64, little-endian.

function bytes(text) {
  const binary = atob(text);
  const result = new Uint8Array(binary.length);
  for (let i = 0; i < result.length; ++i) result[i] = binary.charCodeAt(i);
  return result;
}

const floats = (text) => new Float32Array(bytes(text).buffer);
const integers = (text) => new Uint32Array(bytes(text).buffer);
const small = (text) => new Int16Array(bytes(text).buffer);

/** reads the data of the page: see src/view/view_data.cpp, which wrote it. */
export function readData(element) {
  const data = JSON.parse(element.textContent);
  const { lines, surface, levels } = data;
  lines.points = floats(lines.points);
  lines.normals = small(lines.normals);
  lines.types = bytes(lines.types);
  data.vertices.normals = small(data.vertices.normals);
  data.cells.colours = bytes(data.cells.colours);
  if (levels) {
    levels.of_vertex = bytes(levels.of_vertex);
    levels.of_segment = bytes(levels.of_segment);
    levels.colours = bytes(levels.colours);
  }
  if (surface) {
    surface.points = floats(surface.points);
    surface.normals = small(surface.normals);
    surface.triangles = integers(surface.triangles);
    surface.cells = integers(surface.cells);
  }
  return data;
}
