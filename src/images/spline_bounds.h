// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_SRC_IMAGES_SPLINE_BOUNDS_H
#define CGAL_EXTREMAL_MESH_3_SRC_IMAGES_SPLINE_BOUNDS_H

#include "spline.h"

#include <CGAL/Extremal_mesh_3/Derivative_bounds.h>

namespace CGAL::Extremal_mesh_3 {

/// Bounds of a spline and its first derivatives over a box, in units of the lattice.
struct Spline_bounds {
  Interval value;
  std::array<Interval, 3> gradient;
};

/// bounds a spline by the convex hull of its coefficients: within a cell of those in Bernstein's form over just the box, which are
/// too wide by the square of its size; over several cells of the B-spline's, by far too wide but soon found.
/// \param degree  5 or 7
/// \param box  in units of the lattice
Spline_bounds bound_spline(const Spline_volume& volume, int degree, const Box_3& box);

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_SRC_IMAGES_SPLINE_BOUNDS_H
