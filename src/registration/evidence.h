// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_REGISTRATION_EVIDENCE_H
#define EXTREMAL_MESH_3_SRC_REGISTRATION_EVIDENCE_H

#include "../cells/parallel.h"
#include "align.h"

#include <CGAL/Extremal_mesh_3/register.h>

namespace CGAL::Extremal_mesh_3 {

struct Evidence_options {
  double tolerance = 0;
  double reach = 0; ///< the second mesh has lines within this distance of any point of its surface
  double tried = 1; ///< motions, of which this one was chosen
  unsigned seed = 1;
};

/// tests a motion. By chance matches what matches after each vertex was moved along the surface, in any direction, by a few
/// tolerances: so it counts how dense the second mesh is there, and not how well the surfaces fit.
Registration_evidence gather_evidence(const Features& a, const Target& b, const Similarity& motion,
                                      const Evidence_options& options, Thread_pool& threads);

/// are there enough vertices in their places, much more than by chance?
bool speaks_by_vertices(const Registration_evidence& evidence);

/// \return why the evidence for a motion is not enough; empty if it is
std::string objection(const Registration_evidence& evidence, const Alignment& alignment, double tolerance);

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_REGISTRATION_EVIDENCE_H
