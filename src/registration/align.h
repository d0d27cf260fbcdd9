// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_REGISTRATION_ALIGN_H
#define EXTREMAL_MESH_3_SRC_REGISTRATION_ALIGN_H

#include "../cells/parallel.h"
#include "Target.h"

namespace CGAL::Extremal_mesh_3 {

struct Alignment_options {
  bool scale = false;
  double first_gate = 0, last_gate = 0; ///< up to which distance partners are sought, at first and at last
  double block = 0;                     ///< within this distance errors depend on each other
  int rounds = 12;                      ///< at most
};

/// Where a refinement ended.
struct Alignment {
  Similarity motion;
  bool determined = false; ///< there were enough partners, in enough directions
  double surface_rms = 0;  ///< of the distances from the surface that count
  Point centre{};          ///< of the overlap, in the second mesh
  double rotation_error = 0, translation_error = 0, scale_error = 0; ///< see `Registration`
};

/// refines a motion: moves vertices to those of the same kind, lines to lines of the same kind (across them), and the surface at
/// the lines to the other one (along its normal), by robust least squares in which each of these counts as its residuals are small.
/// \param threads  null: on the caller's thread alone
Alignment align(const Features& a, const Target& b, const Similarity& start, const Alignment_options& options,
                Thread_pool* threads);

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_REGISTRATION_ALIGN_H
