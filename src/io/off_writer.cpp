// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Surfaces as OFF. Colours stand behind the corners of a face, as integers, under the header OFF: so CGAL, Geomview,
// MeshLab and meshio read them or pass over them. (OpenMesh 9 expects such colours under the header COFF only, which to
// the others means colours of vertices.) There are no comments, which some readers do not know.
#include "../algorithms/patches.h"
#include "Off_file.h"
#include "cell_colours.h"

#include <CGAL/Extremal_mesh_3/io.h>

#include <vector>

namespace CGAL::Extremal_mesh_3 {

namespace {

/// appends the points of a half-edge but its last, as indices of the vertices followed by each edge's inner points.
/// \param first_inner  of each edge: the index of its first inner point
void append_corners(const Extremal_mesh& mesh, Half_edge h, const std::vector<std::uint32_t>& first_inner,
                    std::vector<std::uint32_t>& corners) {
  const auto inner = std::uint32_t(mesh.edge(h / 2).polyline.size() - 2);
  corners.push_back(mesh.source(h));
  for (std::uint32_t i = 0; i < inner; ++i)
    corners.push_back(first_inner[h / 2] + (h % 2 == 0 ? i : inner - 1 - i));
}

} // namespace

void write_off(const std::string& file, const Extremal_mesh& mesh, Cell_colouring colouring) {
  std::vector<std::uint32_t> first_inner(mesh.number_of_edges());
  std::size_t number_of_points = mesh.number_of_vertices();
  for (std::size_t e = 0; e < mesh.number_of_edges(); ++e) {
    first_inner[e] = std::uint32_t(number_of_points);
    number_of_points += mesh.edge(e).polyline.size() - 2;
  }
  std::vector<std::vector<std::uint32_t>> polygons;
  std::vector<std::size_t> cells;
  for (std::size_t c = 0; c < mesh.number_of_cells(); ++c) {
    const Extremal_mesh_cell& cell = mesh.cell(c);
    if (cell.euler_characteristic != 1 || cell.boundary.size() != 1)
      continue;
    std::vector<std::uint32_t> corners;
    for (const Half_edge h : cell.boundary.front()) {
      append_corners(mesh, h, first_inner, corners);
      // along the border of the surface, of which nothing is known between its vertices
      if (mesh.vertex(mesh.target(h)).kind == Vertex_kind::boundary)
        corners.push_back(mesh.target(h));
    }
    if (corners.size() < 3)
      continue;
    polygons.push_back(std::move(corners));
    cells.push_back(c);
  }

  const std::vector<Colour> colours = cell_colours(mesh, colouring);
  Off_file out(file, number_of_points, polygons.size());
  for (std::size_t v = 0; v < mesh.number_of_vertices(); ++v)
    out.add_point(mesh.vertex(v).point);
  for (std::size_t e = 0; e < mesh.number_of_edges(); ++e) {
    const std::vector<Point>& line = mesh.edge(e).polyline;
    for (std::size_t i = 1; i + 1 < line.size(); ++i)
      out.add_point(line[i]);
  }
  for (std::size_t i = 0; i < polygons.size(); ++i)
    out.add_polygon(polygons[i], colours[cells[i]]);
  out.commit();
}

void write_off(const std::string& file, const Cell_patches& patches, const Extremal_mesh& mesh,
               Cell_colouring colouring) {
  require_patches_of(mesh, patches);
  const std::vector<Colour> colours = cell_colours(mesh, colouring);
  Off_file out(file, patches.points.size(), patches.cell.size());
  for (const Point& p : patches.points)
    out.add_point(p);
  for (std::size_t i = 0; i < patches.cell.size(); ++i)
    out.add_polygon(polygon(patches, i), colours[patches.cell[i]]);
  out.commit();
}

void write_off(const std::string& file, const Cell_complex& cells) {
  Off_file out(file, cells.points.size(), cells.number_of_cells());
  for (const Point& p : cells.points)
    out.add_point(p);
  std::vector<std::uint32_t> corners;
  for (std::size_t c = 0; c < cells.number_of_cells(); ++c) {
    corners.clear();
    for (std::size_t i = cells.cell_begin[c]; i < cells.cell_begin[c + 1]; ++i)
      corners.push_back(cells.source(cells.half_edges[i]));
    out.add_polygon(corners);
  }
  out.commit();
}

} // namespace CGAL::Extremal_mesh_3
