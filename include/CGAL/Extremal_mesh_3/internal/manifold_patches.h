// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_INTERNAL_MANIFOLD_PATCHES_H
#define CGAL_EXTREMAL_MESH_3_INTERNAL_MANIFOLD_PATCHES_H

#include <CGAL/Extremal_mesh_3/extract_extremal_mesh.h>

namespace CGAL::Extremal_mesh_3::internal {

/// the same surface as an oriented manifold, with the points that polygons use only, in which no two edges join the same
/// points. Where polygons meet in a point but not around it, as those of one cell do on both sides of an extremal point,
/// each fan of them gets a point of its own. Where 2n polygons meet along an edge, these are n edges in the same place: all
/// but one get a point in their middle. Polygons of two corners, which have no area, are left out: their sides
/// coincide. O(n log n).
/// \throws std::invalid_argument if the arrays do not fit together
Cell_patches manifold_patches(const Cell_patches& patches);

} // namespace CGAL::Extremal_mesh_3::internal

#endif // CGAL_EXTREMAL_MESH_3_INTERNAL_MANIFOLD_PATCHES_H
