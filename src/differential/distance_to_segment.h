// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_DIFFERENTIAL_DISTANCE_TO_SEGMENT_H
#define EXTREMAL_MESH_3_SRC_DIFFERENTIAL_DISTANCE_TO_SEGMENT_H

#include "vector.h"

#include <algorithm>

namespace CGAL::Extremal_mesh_3 {

/// from a point to the nearest one between a and b
inline double distance_to_segment(const Point& p, const Point& a, const Point& b) {
  const Vector ab = b - a;
  const double length2 = dot(ab, ab);
  const double t = length2 > 0 ? std::clamp(dot(p - a, ab) / length2, 0.0, 1.0) : 0;
  return distance(p, a + t * ab);
}

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_DIFFERENTIAL_DISTANCE_TO_SEGMENT_H
