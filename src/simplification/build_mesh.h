// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_SIMPLIFICATION_BUILD_MESH_H
#define EXTREMAL_MESH_3_SRC_SIMPLIFICATION_BUILD_MESH_H

#include "Embedded_graph.h"

namespace CGAL::Extremal_mesh_3 {

/// makes an extremal mesh of a graph whose edges run along the lines of `original`.
Extremal_mesh build_mesh(const Embedded_graph& graph, const Extremal_mesh& original);

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_SIMPLIFICATION_BUILD_MESH_H
