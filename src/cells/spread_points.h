// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_CELLS_SPREAD_POINTS_H
#define EXTREMAL_MESH_3_SRC_CELLS_SPREAD_POINTS_H

#include <CGAL/Extremal_mesh_3/Cell_complex.h>

namespace CGAL::Extremal_mesh_3 {

/// chooses points of each component of the cells, each as far as possible from those chosen before. O(points · n).
/// \param n  at most so many per component
/// \return of each component, indices of points
std::vector<std::vector<std::uint32_t>> spread_points(const Cell_complex& cells, std::size_t n);

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_CELLS_SPREAD_POINTS_H
