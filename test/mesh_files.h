// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_TEST_MESH_FILES_H
#define CGAL_EXTREMAL_MESH_3_TEST_MESH_FILES_H

#include "meshes.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstring>
#include <string>

/// The contents of mesh files, put together by hand.
namespace mesh_files {

using meshes::Polygons;

/// the shortest decimal that reads back as the same number.
inline std::string decimal(double x) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof(text), x).ptr};
}

inline std::string words(const CGAL::Extremal_mesh_3::Point& p) {
  std::string text;
  for (const double x : p)
    text.append(" ").append(decimal(x));
  return text;
}

inline std::string words(const std::vector<std::uint32_t>& corners, std::uint32_t add = 0) {
  std::string text;
  for (const std::uint32_t corner : corners)
    text.append(" ").append(std::to_string(corner + add));
  return text;
}

inline std::string off(const Polygons& m) {
  std::string text = "OFF\n" + std::to_string(m.points.size()) + " " + std::to_string(m.polygons.size()) + " 0\n";
  for (const auto& p : m.points)
    text += words(p) + "\n";
  for (const auto& polygon : m.polygons)
    text += std::to_string(polygon.size()) + words(polygon) + "\n";
  return text;
}

inline std::string obj(const Polygons& m) {
  std::string text = "# by hand\nmtllib none.mtl\no thing\n";
  for (const auto& p : m.points)
    text.append("v").append(words(p)).append("\n");
  for (const auto& polygon : m.polygons)
    text.append("f").append(words(polygon, 1)).append("\n");
  return text;
}

/// the bytes of a number.
template <typename Number> std::string bytes(Number x, std::endian order = std::endian::little) {
  std::string b(sizeof(Number), '\0');
  std::memcpy(b.data(), &x, sizeof(Number));
  if (order != std::endian::native)
    std::reverse(b.begin(), b.end());
  return b;
}

inline std::string ply_header(const std::string& format, const Polygons& m) {
  return "ply\nformat " + format + " 1.0\ncomment by hand\nelement vertex " + std::to_string(m.points.size()) +
         "\nproperty double x\nproperty double y\nproperty double z\nproperty uchar red\nelement face " +
         std::to_string(m.polygons.size()) + "\nproperty list uchar int vertex_indices\nend_header\n";
}

inline std::string ply_text(const Polygons& m) {
  std::string text = ply_header("ascii", m);
  for (const auto& p : m.points)
    text += words(p) + " 255\n";
  for (const auto& polygon : m.polygons)
    text += std::to_string(polygon.size()) + words(polygon) + "\n";
  return text;
}

inline std::string ply_binary(const Polygons& m, std::endian order) {
  std::string text = ply_header(order == std::endian::little ? "binary_little_endian" : "binary_big_endian", m);
  for (const auto& p : m.points)
    text += bytes(p[0], order) + bytes(p[1], order) + bytes(p[2], order) + '\xff';
  for (const auto& polygon : m.polygons) {
    text += char(polygon.size());
    for (const std::uint32_t corner : polygon)
      text += bytes(std::int32_t(corner), order);
  }
  return text;
}

/// \pre there are triangles only
inline std::string stl_text(const Polygons& m) {
  std::string text = "solid by hand\n";
  for (const auto& polygon : m.polygons) {
    text += "  facet normal 0 0 1\n    outer loop\n";
    for (const std::uint32_t corner : polygon)
      text += "      vertex" + words(m.points[corner]) + "\n";
    text += "    endloop\n  endfacet\n";
  }
  return text + "endsolid by hand\n";
}

/// \pre there are triangles only
inline std::string stl_binary(const Polygons& m) {
  std::string text = "solid, but binary";
  text.resize(80);
  text += bytes(std::uint32_t(m.polygons.size()));
  for (const auto& polygon : m.polygons) {
    text += std::string(12, '\0');
    for (const std::uint32_t corner : polygon)
      for (const double x : m.points[corner])
        text += bytes(float(x));
    text += std::string(2, '\0');
  }
  return text;
}

/// a prism over a triangle, of triangles and quadrilaterals; its normals point outwards.
inline Polygons prism() {
  return {{{0, 0, 0}, {1.5, 0, 0}, {0, 1.25, 0}, {0, 0, 2}, {1.5, 0, 2}, {0, 1.25, 2}},
          {{0, 2, 1}, {3, 4, 5}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}}};
}

/// a tetrahedron whose coordinates are floats; its normals point outwards.
inline Polygons tetrahedron() {
  return {{{0, 0, 0}, {1.5, 0, 0}, {0, 1.25, 0}, {0, 0, 2}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
}

/// the polygons of cells.
inline Polygons polygons_of(const CGAL::Extremal_mesh_3::Cell_complex& cells) {
  Polygons m{cells.points, {}};
  for (std::size_t c = 0; c < cells.number_of_cells(); ++c) {
    m.polygons.emplace_back();
    for (std::size_t h = cells.cell_begin[c]; h < cells.cell_begin[c + 1]; ++h)
      m.polygons.back().push_back(cells.source(cells.half_edges[h]));
  }
  return m;
}

} // namespace mesh_files

#endif // CGAL_EXTREMAL_MESH_3_TEST_MESH_FILES_H
