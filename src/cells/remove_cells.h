// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_CELLS_REMOVE_CELLS_H
#define EXTREMAL_MESH_3_SRC_CELLS_REMOVE_CELLS_H

#include <CGAL/Extremal_mesh_3/Cell_complex.h>

namespace CGAL::Extremal_mesh_3 {

/// What is left of a cell complex.
struct Remaining_cells {
  Cell_complex cells;
  std::vector<std::uint32_t> point; ///< of each point: which one it was
  std::vector<std::uint32_t> cell;  ///< of each cell: which one it was
};

/// takes cells away. Where those that are left meet in a point only, each fan of them gets a point of its own, so that
/// they form a manifold with border. O(n log n).
/// \param removed  of each cell
Remaining_cells remove_cells(const Cell_complex& cells, const std::vector<char>& removed);

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_CELLS_REMOVE_CELLS_H
