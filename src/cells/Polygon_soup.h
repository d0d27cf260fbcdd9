// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_CELLS_POLYGON_SOUP_H
#define EXTREMAL_MESH_3_SRC_CELLS_POLYGON_SOUP_H

#include <CGAL/Extremal_mesh_3/types.h>

#include <cstdint>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

using Polygon = std::vector<std::uint32_t>; ///< indices of points

/// Points, and polygons that do not know of each other: what a file holds.
struct Polygon_soup {
  std::vector<Point> points;
  std::vector<Polygon> polygons;
};

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_CELLS_POLYGON_SOUP_H
