// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_CELLS_PROVE_SURFACE_H
#define EXTREMAL_MESH_3_SRC_CELLS_PROVE_SURFACE_H

#include "Octree.h"
#include "parallel.h"

#include <CGAL/Extremal_mesh_3/extract_extremal_mesh.h>

namespace CGAL::Extremal_mesh_3 {

/// divides the cubes in which the surface is not proved to be as its signs at the corners tell, until it is: until f has no
/// zero in a cube, or its gradients there make angles below 90° with each other. The surface in such cubes, woven by
/// their corners, is isotopic to f = 0 [Plantinga and Vegter, Isotopic approximation of implicit curves and surfaces, 2004].
/// \pre `f.bounds_cost()` is not `unknown`
/// \param most_divided  no more than about so many cubes are divided
/// \param tree  is divided; neighbouring cubes differ by one level at most
/// \param report  tells what could not be decided
void prove_surface(const Function_3& f, const Lattice& lattice, std::size_t most_divided, Thread_pool& pool,
                   Octree& tree, Surface_report& report);

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_CELLS_PROVE_SURFACE_H
