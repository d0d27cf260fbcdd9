// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Polygons on a surface that need be neither planar nor convex, covered by triangles.
#ifndef EXTREMAL_MESH_3_SRC_CELLS_POLYGON_TRIANGLES_H
#define EXTREMAL_MESH_3_SRC_CELLS_POLYGON_TRIANGLES_H

#include <CGAL/Extremal_mesh_3/types.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

/// How to cover a polygon.
struct Polygon_triangles {
  Point middle{}; ///< the mean of the corners
  /// triangles of corners; empty: those that join the middle with each side are to be taken
  std::vector<std::array<std::uint32_t, 3>> ears;
  double area = 0; ///< of the triangles
};

/// covers a polygon by the triangles around its middle if all sides are seen from there the same way round, as it is with all
/// but very concave polygons. From those ears are cut off; if that cannot be done either (the polygon crosses
/// itself) the triangles around the middle are taken all the same.
Polygon_triangles triangles_of_polygon(std::span<const Point* const> corners);

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_CELLS_POLYGON_TRIANGLES_H
