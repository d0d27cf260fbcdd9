// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// VTK's XML PolyData. Each array is in base64 behind its size in bytes, as the format has it. The data of "cells", in VTK's sense,
// are those of vertices, then lines, then polygons; what does not apply is -1, or NaN.
#include "../algorithms/patches.h"
#include "Line_points.h"
#include "Text_file.h"
#include "base64.h"
#include "colours.h"

#include <CGAL/Extremal_mesh_3/interchange.h>

#include <cstdint>
#include <limits>
#include <numeric>
#include <span>
#include <type_traits>

namespace CGAL::Extremal_mesh_3 {

namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

template <typename Number>
void write_array(Text_file& out, std::string_view name, const std::vector<Number>& numbers, int components = 1) {
  constexpr std::string_view type = std::is_same_v<Number, double>         ? "Float64"
                                    : std::is_same_v<Number, std::int64_t> ? "Int64"
                                    : std::is_same_v<Number, std::int32_t> ? "Int32"
                                                                           : "UInt8";
  out.print(FMT_COMPILE("<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"binary\">\n"), type,
            name, components);
  // encoded in one: VTK reads parts of an array at places that it counts from the beginning of both
  const std::string size = little_endian(std::vector<std::uint64_t>{numbers.size() * sizeof(Number)});
  out << base64(std::string_view(size + little_endian(numbers))) << "\n</DataArray>\n";
}

/// Polygons, lines or vertices as VTK has them.
struct Corners {
  std::vector<std::int64_t> connectivity, offsets;
  void add(std::span<const std::uint32_t> corners, std::size_t first = 0) {
    for (const std::uint32_t corner : corners)
      connectivity.push_back(std::int64_t(first + corner));
    offsets.push_back(std::int64_t(connectivity.size()));
  }
  void write(Text_file& out, std::string_view name) const {
    out << "<" << name << ">\n";
    write_array(out, "connectivity", connectivity);
    write_array(out, "offsets", offsets);
    out << "</" << name << ">\n";
  }
};

/// The data of vertices, edges and polygons.
struct Columns {
  std::vector<std::int32_t> vertex, kind, umbilic_type, edge, family, type, left_cell, right_cell, cell, sign;
  std::vector<double> umbilic_index, length, strength, sharpness, area, weight;
  std::vector<std::uint8_t> colours;

  void add(const Colour& colour) {
    for (auto* column : {&vertex, &kind, &umbilic_type, &edge, &family, &type, &left_cell, &right_cell, &cell, &sign})
      column->push_back(column == &sign ? 0 : -1);
    for (auto* column : {&umbilic_index, &length, &strength, &sharpness, &area, &weight})
      column->push_back(nothing);
    colours.insert(colours.end(), colour.begin(), colour.end());
  }
  void add_vertex(std::size_t v, const Extremal_mesh_vertex& data) {
    add(vertex_colour(data));
    vertex.back() = std::int32_t(v);
    kind.back() = static_cast<std::int32_t>(data.kind);
    umbilic_type.back() = static_cast<std::int32_t>(data.umbilic_type);
    umbilic_index.back() = data.umbilic_index;
  }
  void add_edge(std::size_t e, const Extremal_mesh_edge& data) {
    add(line_colour(data.type));
    edge.back() = std::int32_t(e);
    family.back() = data.family;
    type.back() = static_cast<std::int32_t>(data.type);
    left_cell.back() = std::int32_t(data.left_cell);
    right_cell.back() = std::int32_t(data.right_cell);
    length.back() = data.length;
    strength.back() = data.strength;
    sharpness.back() = data.sharpness;
  }
  void add_polygon(std::uint32_t c, const Extremal_mesh_cell& data) {
    add(cell_colour(data.sign));
    cell.back() = std::int32_t(c);
    sign.back() = data.sign;
    area.back() = data.area;
    weight.back() = data.weight;
  }
  void write(Text_file& out) const {
    write_array(out, "vertex", vertex);
    write_array(out, "kind", kind);
    write_array(out, "umbilic_type", umbilic_type);
    write_array(out, "umbilic_index", umbilic_index);
    write_array(out, "edge", edge);
    write_array(out, "family", family);
    write_array(out, "type", type);
    write_array(out, "length", length);
    write_array(out, "strength", strength);
    write_array(out, "sharpness", sharpness);
    write_array(out, "left_cell", left_cell);
    write_array(out, "right_cell", right_cell);
    write_array(out, "cell", cell);
    write_array(out, "sign", sign);
    write_array(out, "area", area);
    write_array(out, "weight", weight);
    write_array(out, "colour", colours, 3);
  }
};

std::vector<double> flat(const std::vector<std::array<double, 3>>& vectors) {
  std::vector<double> numbers;
  numbers.reserve(3 * vectors.size());
  for (const auto& v : vectors)
    numbers.insert(numbers.end(), v.begin(), v.end());
  return numbers;
}

} // namespace

void write_vtp(const std::string& file, const Extremal_mesh& mesh, const Cell_patches& patches) {
  require_patches_of(mesh, patches);
  Line_points all(mesh);
  const std::size_t first_of_surface = all.points.size();
  all.points.insert(all.points.end(), patches.points.begin(), patches.points.end());
  all.normals.insert(all.normals.end(), patches.normals.begin(), patches.normals.end());
  all.k1.resize(all.points.size(), nothing);
  all.k2.resize(all.points.size(), nothing);

  Corners vertices, lines, polygons;
  Columns columns;
  for (std::uint32_t v = 0; v < mesh.number_of_vertices(); ++v) {
    vertices.add(std::array{v});
    columns.add_vertex(v, mesh.vertex(v));
  }
  for (std::size_t e = 0; e < mesh.number_of_edges(); ++e) {
    lines.add(all.edges[e]);
    columns.add_edge(e, mesh.edge(e));
  }
  for (std::size_t i = 0; i < patches.cell.size(); ++i) {
    polygons.add(polygon(patches, i), first_of_surface);
    columns.add_polygon(patches.cell[i], mesh.cell(patches.cell[i]));
  }

  Text_file out(file);
  out.print(
      FMT_COMPILE("<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
                  "header_type=\"UInt64\">\n<PolyData>\n<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"{}\" "
                  "NumberOfLines=\"{}\" NumberOfStrips=\"0\" NumberOfPolys=\"{}\">\n"),
      all.points.size(), vertices.offsets.size(), lines.offsets.size(), polygons.offsets.size());
  out << "<Points>\n";
  write_array(out, "Points", flat(all.points), 3);
  out << "</Points>\n<PointData Normals=\"normal\">\n";
  write_array(out, "normal", flat(all.normals), 3);
  write_array(out, "k_max", all.k1);
  write_array(out, "k_min", all.k2);
  out << "</PointData>\n<CellData>\n";
  columns.write(out);
  out << "</CellData>\n";
  vertices.write(out, "Verts");
  lines.write(out, "Lines");
  polygons.write(out, "Polys");
  out << "</Piece>\n</PolyData>\n</VTKFile>\n";
  out.commit();
}

} // namespace CGAL::Extremal_mesh_3
