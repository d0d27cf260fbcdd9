// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_APPLICATIONS_DIVIDE_H
#define EXTREMAL_MESH_3_SRC_APPLICATIONS_DIVIDE_H

#include "../cgal/Triangles.h"

#include <CGAL/Extremal_mesh_3/extract_extremal_mesh.h>

#include <functional>

namespace CGAL::Extremal_mesh_3 {

/// divides the polygons of a manifold into triangles, as `triangulate()` does, no two edges of which join the same points: diagonals of
/// concave polygons that do get a point in their middle. O(n log n).
Cell_patches divide_into_triangles(const Cell_patches& manifold);

/// divides the edges of triangles that are chosen in the middle. The triangles keep their cells. O(n log n).
Cell_patches divide_edges(const Cell_patches& triangles,
                          const std::function<bool(std::uint32_t, std::uint32_t)>& choose);

/// the triangles without their cells.
Triangles triangles_of(const Cell_patches& triangles);

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_APPLICATIONS_DIVIDE_H
