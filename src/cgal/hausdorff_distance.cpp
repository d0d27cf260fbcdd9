// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "hausdorff_distance.h"
#include "surface_mesh.h"

#include <CGAL/Polygon_mesh_processing/distance.h>

namespace CGAL::Extremal_mesh_3 {

double hausdorff_distance(const Triangles& a, const Triangles& b, double error) {
  const Surface_of_triangles first = surface_mesh_of(a), second = surface_mesh_of(b);
  return Polygon_mesh_processing::bounded_error_symmetric_Hausdorff_distance<CGAL::Sequential_tag>(first, second, error);
}

} // namespace CGAL::Extremal_mesh_3
