// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_CGAL_MESH_ORIENTATION_H
#define EXTREMAL_MESH_3_SRC_CGAL_MESH_ORIENTATION_H

#include "../cells/Polygon_soup.h"

#include <cstddef>

namespace CGAL::Extremal_mesh_3 {

/// What orientation found.
struct Orientation_counts {
  std::vector<bool> turned;              ///< polygons whose corners were reversed
  std::size_t non_manifold_edges = 0;    ///< with three or more polygons
  std::size_t non_manifold_vertices = 0; ///< around which the polygons formed several fans
};

/// makes an oriented 2-manifold of polygons, as CGAL's Polygon_mesh_processing does: neighbours at an edge are oriented
/// alike, the surface is cut along edges with three or more polygons and where it is one-sided, and a point is repeated
/// for each of several fans around it.
/// \pre the corners of each polygon are different, and no two polygons have the same corners
Orientation_counts orient(Polygon_soup& soup);

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_CGAL_MESH_ORIENTATION_H
