// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Samples that lie on lines, or beside zeros, are moved a little: there phases, and how far they turn, are rounding.
#ifndef EXTREMAL_MESH_3_SRC_EXTRACTION_NUDGE_H
#define EXTREMAL_MESH_3_SRC_EXTRACTION_NUDGE_H

#include "Sample.h"

#include <vector>

namespace CGAL::Extremal_mesh_3 {

/// tells whether a sample lies on a line, or so near to a zero of P or Q that |P| or |Q| is small against the values
/// around.
/// \param size  the distance of what is around
bool should_be_nudged(const Sample& s, double size, double P_around, double Q_around);

/// the sample, or one moved within the surface if it should be: by a small part of `size`, and by no more than half of `room`,
/// the distance from what it must not pass.
/// \param around  samples towards which it may be moved on a surface that interpolates
Sample nudged(const Surface& surface, const Sample& s, double size, double room, double P_around, double Q_around,
              const std::vector<const Sample*>& around);

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_EXTRACTION_NUDGE_H
