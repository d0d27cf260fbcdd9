// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_CELLS_BOUNDING_BOX_H
#define EXTREMAL_MESH_3_SRC_CELLS_BOUNDING_BOX_H

#include "../differential/vector.h"

#include <algorithm>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

/// the diagonal of the axis-parallel box around points; 0 of none.
inline double diagonal_of(const std::vector<Point>& points) {
  if (points.empty())
    return 0;
  Point low = points[0], high = points[0];
  for (const Point& p : points)
    for (std::size_t a = 0; a < 3; ++a) {
      low[a] = std::min(low[a], p[a]);
      high[a] = std::max(high[a], p[a]);
    }
  return distance(low, high);
}

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_CELLS_BOUNDING_BOX_H
