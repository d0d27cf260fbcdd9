// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_REGISTRATION_STANDARD_ERRORS_H
#define EXTREMAL_MESH_3_SRC_REGISTRATION_STANDARD_ERRORS_H

#include "align.h"
#include "residuals.h"

#include <vector>

namespace CGAL::Extremal_mesh_3 {

/// What a residual adds to the right-hand side of the normal equations.
struct Contribution {
  Point point{};
  Unknowns sum{};
};

/// sets the errors of an alignment: the greater of what the weights say, if they are one over the variances, and of what the scatter of
/// the contributions of blocks says; residuals beside each other have the same cause.
/// \param inverse  of the normal equations' matrix
void estimate_errors(Alignment& result, const std::vector<Contribution>& contributions, const Change_frame& frame,
                     const Alignment_options& options, const Square_matrix& inverse);

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_REGISTRATION_STANDARD_ERRORS_H
