// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_ALGORITHMS_PATCHES_H
#define EXTREMAL_MESH_3_SRC_ALGORITHMS_PATCHES_H

#include <CGAL/Extremal_mesh_3/extract_extremal_mesh.h>

#include <span>

namespace CGAL::Extremal_mesh_3 {

/// \throws std::invalid_argument if the arrays do not fit together, or a corner is no point
void require_consistent(const Cell_patches& patches);

/// \throws std::invalid_argument also if a polygon is in a cell that the mesh does not have
void require_patches_of(const Extremal_mesh& mesh, const Cell_patches& patches);

inline std::span<const std::uint32_t> polygon(const Cell_patches& patches, std::size_t i) {
  return std::span(patches.corners).subspan(patches.begin[i], patches.begin[i + 1] - patches.begin[i]);
}

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_ALGORITHMS_PATCHES_H
