// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_CELLS_REFINE_FOLDS_H
#define EXTREMAL_MESH_3_SRC_CELLS_REFINE_FOLDS_H

#include "Octree.h"
#include "parallel.h"
#include "surface_points.h"

#include <vector>

namespace CGAL::Extremal_mesh_3 {

/// Polygons woven in the cubes of a lattice.
struct Woven_cells {
  std::vector<Cut_edge> cuts; ///< where each point comes from
  std::vector<Point> points;
  std::vector<std::size_t> polygon_begin{0};
  std::vector<std::uint32_t> corners;
  std::vector<Grid_cube> cubes; ///< of each polygon
};

/// Cubes that are as they should not be, at the finest level or because there are too many of them.
struct Unsettled_cubes {
  std::vector<Grid_cube> folded;    ///< in which the lattice is still too coarse for the surface
  std::vector<Grid_cube> ambiguous; ///< whose polygons could be woven in several ways
};

/// weaves the polygons anew, in smaller cubes, where the lattice is too coarse for the surface: where the normals
/// around a polygon differ by a right angle or so, the polygon faces elsewhere than the surface does, or the surface
/// does not pass by its middle. There the lattice may have joined or cut what the surface has not.
/// \param tree  the cubes that are to be divided in any case; those that are divided for folds are added
/// \param keeps_balance  the tree is balanced and stays so
Unsettled_cubes refine_folds(const Function_3& f, const Lattice& lattice, Woven_cells& cells, Thread_pool& pool,
                             Octree& tree, bool keeps_balance);

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_CELLS_REFINE_FOLDS_H
