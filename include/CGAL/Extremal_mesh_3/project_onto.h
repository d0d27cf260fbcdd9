// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_PROJECT_ONTO_H
#define CGAL_EXTREMAL_MESH_3_PROJECT_ONTO_H

#include <CGAL/Extremal_mesh_3/Cell_complex.h>
#include <CGAL/Extremal_mesh_3/Function_3.h>

namespace CGAL::Extremal_mesh_3 {

/// moves the points of cells that sample the surface `f = 0` onto it, by Newton's method along the gradient, and turns
/// components so that they are oriented as `extract_extremal_mesh(f, cells)` needs them: counter-clockwise seen from where `f`
/// is positive.
/// O(n).
/// \param threads  0: as many as the machine has cores. The result does not depend on it.
/// \param f  the function
/// \param cells  polygons near its zero set
/// \return the same polygons, on it
/// \throws Extraction_error naming the point if no surface is found within the length of the longest edge at it
Cell_complex project_onto(const Function_3& f, Cell_complex cells, int threads = 0);

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_PROJECT_ONTO_H
