// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_CGAL_TRIANGLES_H
#define EXTREMAL_MESH_3_SRC_CGAL_TRIANGLES_H

#include <CGAL/Extremal_mesh_3/types.h>

#include <array>
#include <cstdint>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

/// An oriented manifold of triangles, perhaps with border.
struct Triangles {
  std::vector<Point> points;
  std::vector<std::array<std::uint32_t, 3>> corners; ///< of each triangle, counter-clockwise seen from outside
};

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_CGAL_TRIANGLES_H
