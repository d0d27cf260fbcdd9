// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_FITTING_ADJACENCY_H
#define EXTREMAL_MESH_3_SRC_FITTING_ADJACENCY_H

#include <CGAL/Extremal_mesh_3/Cell_complex.h>

#include <cstdint>
#include <span>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

/// The neighbours of each vertex, as one flat array.
struct Adjacency {
  std::vector<std::size_t> begin{0};
  std::vector<std::uint32_t> vertices;

  std::size_t size() const { return begin.size() - 1; }
  std::span<const std::uint32_t> operator[](std::size_t v) const {
    return {vertices.data() + begin[v], vertices.data() + begin[v + 1]};
  }
};

/// the vertices at the other ends of edges.
Adjacency neighbours_along_edges(const Cell_complex& cells);

/// the same, and the other vertices of the same cells. Cells of more than 16 sides, whose vertices are
/// quadratically many pairs, count for their edges only.
Adjacency neighbours_across_cells(const Cell_complex& cells);

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_FITTING_ADJACENCY_H
