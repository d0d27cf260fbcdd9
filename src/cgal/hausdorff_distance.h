// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_CGAL_HAUSDORFF_DISTANCE_H
#define EXTREMAL_MESH_3_SRC_CGAL_HAUSDORFF_DISTANCE_H

#include "Triangles.h"

namespace CGAL::Extremal_mesh_3 {

/// the symmetric Hausdorff distance of two surfaces, up to an error, as CGAL's Polygon_mesh_processing bounds it.
/// \pre both have triangles; error > 0
double hausdorff_distance(const Triangles& a, const Triangles& b, double error);

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_CGAL_HAUSDORFF_DISTANCE_H
