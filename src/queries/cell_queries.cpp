// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Extremal_mesh_3/cell_queries.h>

#include "require.h"

#include <algorithm>
#include <map>
#include <utility>

namespace CGAL::Extremal_mesh_3 {

namespace {

Cell_side side_of(const Extremal_mesh& mesh, Half_edge h) {
  const Extremal_mesh_edge& edge = mesh.edge(h / 2);
  return {h, edge.family, edge.type, mesh.left_cell(h ^ 1U)};
}

} // namespace

std::vector<std::vector<Cell_side>> cell_sides(const Extremal_mesh& mesh, std::uint32_t cell) {
  require_cell(mesh, cell);
  std::vector<std::vector<Cell_side>> walks;
  for (const std::vector<Half_edge>& walk : mesh.cell(cell).boundary) {
    walks.emplace_back();
    for (const Half_edge h : walk)
      walks.back().push_back(side_of(mesh, h));
  }
  return walks;
}

std::vector<Cell_neighbour> neighbours(const Extremal_mesh& mesh, std::uint32_t cell) {
  require_cell(mesh, cell);
  std::map<std::uint32_t, double> lengths;
  for (const std::vector<Half_edge>& walk : mesh.cell(cell).boundary)
    for (const Half_edge h : walk)
      lengths[mesh.left_cell(h ^ 1U)] += mesh.edge(h / 2).length;
  std::vector<Cell_neighbour> result;
  result.reserve(lengths.size());
  for (const auto& [neighbour, length] : lengths)
    result.push_back({neighbour, length});
  return result;
}

std::vector<std::uint32_t> cells_around(const Extremal_mesh& mesh, std::uint32_t vertex) {
  require_vertex(mesh, vertex);
  const Extremal_mesh_vertex& v = mesh.vertex(vertex);
  std::vector<std::uint32_t> cells;
  if (v.kind == Vertex_kind::boundary && !v.star.empty())
    cells.push_back(mesh.left_cell(v.star.front() ^ 1U));
  for (const Half_edge h : v.star)
    cells.push_back(mesh.left_cell(h));
  return cells;
}

std::optional<Quadrilateral> quadrilateral(const Extremal_mesh& mesh, std::uint32_t cell) {
  require_cell(mesh, cell);
  const Extremal_mesh_cell& c = mesh.cell(cell);
  if (c.euler_characteristic != 1 || c.touches_border || c.boundary.size() != 1 || c.boundary[0].size() != 4)
    return std::nullopt;
  Quadrilateral result;
  result.cell = cell;
  for (std::size_t i = 0; i < 4; ++i)
    result.sides[i] = side_of(mesh, c.boundary[0][i]);
  const auto key = [](const std::array<Cell_side, 4>& s) {
    return std::pair(std::array{s[0].type, s[1].type, s[2].type, s[3].type}, s[0].half_edge);
  };
  std::array<Cell_side, 4> turned = result.sides;
  for (int i = 0; i < 3; ++i) {
    std::rotate(turned.begin(), turned.begin() + 1, turned.end());
    if (key(turned) < key(result.sides))
      result.sides = turned;
  }
  return result;
}

std::vector<Quadrilateral> quadrilaterals(const Extremal_mesh& mesh) {
  std::vector<Quadrilateral> result;
  for (std::uint32_t c = 0; c < mesh.number_of_cells(); ++c)
    if (const auto found = quadrilateral(mesh, c))
      result.push_back(*found);
  return result;
}

} // namespace CGAL::Extremal_mesh_3
