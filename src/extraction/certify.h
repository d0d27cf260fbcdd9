// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_EXTRACTION_CERTIFY_H
#define EXTREMAL_MESH_3_SRC_EXTRACTION_CERTIFY_H

#include "Refined_complex.h"

#include <CGAL/Extremal_mesh_3/Function_3.h>

namespace CGAL::Extremal_mesh_3 {

/// Of how many cells it is proved by interval arithmetic what they hold.
struct Certificate {
  std::size_t without_lines = 0;    ///< no line passes, and none was found
  std::size_t without_vertices = 0; ///< lines may pass; neither P nor Q vanishes, and no vertex was found
};

/// bounds P, Q and Φ over the surface in boxes around the cells, which are divided as long as that may help.
/// \pre f can be bounded; the surface is f = 0
Certificate certify(const Function_3& f, const Refined_complex& complex, int threads);

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_EXTRACTION_CERTIFY_H
