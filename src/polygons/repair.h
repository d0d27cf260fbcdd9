// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_POLYGONS_REPAIR_H
#define EXTREMAL_MESH_3_SRC_POLYGONS_REPAIR_H

#include "../cells/Polygon_soup.h"

#include <CGAL/Extremal_mesh_3/read_mesh.h>

namespace CGAL::Extremal_mesh_3 {

/// makes an oriented manifold of polygons: all steps of `Mesh_repairs`, in their order.
/// \throws std::runtime_error if no polygon is left
Mesh repair(Polygon_soup soup, double weld_tolerance);

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_POLYGONS_REPAIR_H
