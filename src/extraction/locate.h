// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Extremal points and umbilics, found on the surface to near machine precision.
#ifndef EXTREMAL_MESH_3_SRC_EXTRACTION_LOCATE_H
#define EXTREMAL_MESH_3_SRC_EXTRACTION_LOCATE_H

#include "Cell_model.h"

namespace CGAL::Extremal_mesh_3 {

/// the zero of P or Q near to `start`, by Newton's method on the surface.
/// \param guess  where it should be, in the tangent plane of `start`
/// \param size  the size of the cell it should lie in
/// \param reach  how far from `start` it may lie
std::optional<Sample> locate_zero(const Surface& surface, Field field, const Sample& start, Complex guess, double size,
                                  double reach);

/// a zero of P or Q on a surface that interpolates: in one of the triangles that join the middle of a cell with its
/// border.
std::optional<Sample> locate_zero_between(const Surface& surface, Field field, const std::vector<const Sample*>& border,
                                          const Sample& middle);

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_EXTRACTION_LOCATE_H
