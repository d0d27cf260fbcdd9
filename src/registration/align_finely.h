// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_REGISTRATION_ALIGN_FINELY_H
#define EXTREMAL_MESH_3_SRC_REGISTRATION_ALIGN_FINELY_H

#include "align.h"

namespace CGAL::Extremal_mesh_3 {

/// One of two meshes that are aligned finely.
struct Fine_features {
  const Features& sparse; ///< whose samples are measured, with all vertices
  const Target& dense;    ///< where partners of the other's samples are sought
};

/// aligns as exactly as the noise allows: by generalised least squares. The noise of the surfaces, which smoothing makes depend on itself, is estimated from the
/// residuals: so what differs over short distances counts for more than what a wide swelling could have done. Distances are measured from the
/// lines of both meshes.
/// \param start  what `align()` found
Alignment align_finely(const Fine_features& a, const Fine_features& b, const Alignment& start,
                       const Alignment_options& options, Thread_pool& threads);

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_REGISTRATION_ALIGN_FINELY_H
