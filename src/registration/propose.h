// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_REGISTRATION_PROPOSE_H
#define EXTREMAL_MESH_3_SRC_REGISTRATION_PROPOSE_H

#include "../cells/parallel.h"
#include "Features.h"

#include <CGAL/Extremal_mesh_3/Similarity.h>

#include <vector>

namespace CGAL::Extremal_mesh_3 {

struct Proposal_options {
  bool scale = false;
  double tolerance = 0; ///< in the unit of the second mesh
  unsigned seed = 1;
  std::size_t most = 30; ///< motions
};

/// Motions that many pairs of vertices propose.
struct Proposals {
  std::vector<Similarity> motions; ///< those that most propose first
  std::size_t tried = 0;           ///< how many were proposed
  double baseline = 0;             ///< the mean distance in a pair, in the unit of the first mesh
};

/// Two vertices with their frames are the same up to a motion if their distance, the angles of the frames with the line that
/// joins them, and the curvatures agree: thirteen numbers, in the space of which the nearest are sought. Each pair that is
/// found proposes a motion, and in the space of motions it is counted which are proposed often.
Proposals propose_motions(const std::vector<Feature>& a, const std::vector<Feature>& b, const Proposal_options& options,
                          Thread_pool& threads);

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_REGISTRATION_PROPOSE_H
