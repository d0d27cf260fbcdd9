// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "remove_cells.h"

#include "Union_find.h"

namespace CGAL::Extremal_mesh_3 {

Remaining_cells remove_cells(const Cell_complex& cells, const std::vector<char>& removed) {
  constexpr std::uint32_t none = 0xffffffffU;
  const auto remains = [&](std::int32_t c) { return c != Cell_complex::no_cell && !removed[std::size_t(c)]; };

  // A corner is named by the position of the half-edge that leaves it in its cell.
  std::vector<std::uint32_t> position(2 * cells.edges.size(), none), next(cells.half_edges.size());
  for (std::size_t c = 0; c < cells.number_of_cells(); ++c)
    for (std::size_t p = cells.cell_begin[c]; p < cells.cell_begin[c + 1]; ++p) {
      position[cells.half_edges[p]] = std::uint32_t(p);
      next[p] = std::uint32_t(p + 1 < cells.cell_begin[c + 1] ? p + 1 : cells.cell_begin[c]);
    }

  // Corners that an edge joins stay one point.
  Union_find corners(cells.half_edges.size());
  for (std::size_t e = 0; e < cells.edges.size(); ++e)
    if (remains(cells.edge_cells[e][0]) && remains(cells.edge_cells[e][1])) {
      const std::uint32_t p = position[2 * e], q = position[2 * e + 1];
      corners.unite(p, next[q]);
      corners.unite(next[p], q);
    }

  Remaining_cells result;
  std::vector<std::uint32_t> point(cells.half_edges.size(), none), polygons;
  std::vector<std::size_t> begin{0};
  std::vector<Point> points;
  for (std::size_t c = 0; c < cells.number_of_cells(); ++c) {
    if (removed[c])
      continue;
    for (std::size_t p = cells.cell_begin[c]; p < cells.cell_begin[c + 1]; ++p) {
      std::uint32_t& id = point[corners.find(std::uint32_t(p))];
      if (id == none) {
        id = std::uint32_t(points.size());
        const std::uint32_t v = cells.source(cells.half_edges[p]);
        points.push_back(cells.points[v]);
        result.point.push_back(v);
      }
      polygons.push_back(id);
    }
    begin.push_back(polygons.size());
    result.cell.push_back(std::uint32_t(c));
  }
  result.cells = make_cell_complex(std::move(points), begin, polygons);
  return result;
}

} // namespace CGAL::Extremal_mesh_3
