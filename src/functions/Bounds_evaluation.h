// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_SRC_BOUNDS_EVALUATION_H
#define CGAL_EXTREMAL_MESH_3_SRC_BOUNDS_EVALUATION_H

#include "Jet_program.h"

#include <CGAL/Extremal_mesh_3/Derivative_bounds.h>

namespace CGAL::Extremal_mesh_3::internal {

/// evaluates a program on intervals: the Taylor coefficients at all points of a box.
/// \param scratch  `program.scratch_size` intervals. Coefficient k of the result is left at [program.result + k],
///                 for the k in `program.result_support`.
/// \return the order up to which they are valid: 1 if the box meets a kink, 0 if it meets a jump
int evaluate_bounds(const Jet_program& program, const Box_3& box, Interval* scratch);

} // namespace CGAL::Extremal_mesh_3::internal

#endif // CGAL_EXTREMAL_MESH_3_SRC_BOUNDS_EVALUATION_H
