// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_APPLICATIONS_TRIANGLES_H
#define EXTREMAL_MESH_3_SRC_APPLICATIONS_TRIANGLES_H

#include "../cells/polygon_triangles.h"

#include <array>
#include <span>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

using Corners = std::array<Point, 3>;

/// appends the triangles of a polygon, as `triangulate()` has them.
inline void append_triangles(std::span<const Point> polygon, std::vector<Corners>& triangles) {
  const std::size_t n = polygon.size();
  if (n == 3) {
    triangles.push_back({polygon[0], polygon[1], polygon[2]});
    return;
  }
  std::vector<const Point*> corners;
  for (const Point& p : polygon)
    corners.push_back(&p);
  const Polygon_triangles cover = triangles_of_polygon(corners);
  for (const auto& [a, b, c] : cover.ears)
    triangles.push_back({polygon[a], polygon[b], polygon[c]});
  if (cover.ears.empty())
    for (std::size_t i = 0; i < n; ++i)
      triangles.push_back({cover.middle, polygon[i], polygon[(i + 1) % n]});
}

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_APPLICATIONS_TRIANGLES_H
