// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_FITTING_CHANGE_WITH_RADIUS_H
#define EXTREMAL_MESH_3_SRC_FITTING_CHANGE_WITH_RADIUS_H

#include "fit_jets.h"

namespace CGAL::Extremal_mesh_3 {

/// fits again, in wider neighbourhoods, where an extremality is so small that it may be the error of the fit alone, and
/// records by how much C changes: `Fit_quality::C_change`.
void find_change_with_radius(const Fit_input& input, Thread_pool& pool, Vertex_shapes& shapes);

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_FITTING_CHANGE_WITH_RADIUS_H
