// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_REGISTRATION_CORRESPONDING_EDGES_H
#define EXTREMAL_MESH_3_SRC_REGISTRATION_CORRESPONDING_EDGES_H

#include "../cells/parallel.h"

#include <CGAL/Extremal_mesh_3/Extremal_mesh.h>
#include <CGAL/Extremal_mesh_3/Similarity.h>

namespace CGAL::Extremal_mesh_3 {

/// Shares of one mesh that correspond to something in another one; see `Comparison`.
struct Correspondence {
  double edges = 0, cells = 0, area_of_cells = 0;
};

Correspondence corresponding_edges_and_cells(const Extremal_mesh& a, const Extremal_mesh& b, const Similarity& motion,
                                             double tolerance, Thread_pool& threads);

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_REGISTRATION_CORRESPONDING_EDGES_H
