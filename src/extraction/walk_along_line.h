// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_EXTRACTION_WALK_ALONG_LINE_H
#define EXTREMAL_MESH_3_SRC_EXTRACTION_WALK_ALONG_LINE_H

#include "refine_segment.h"

#include <vector>

namespace CGAL::Extremal_mesh_3 {

/// follows a line that winds between the ends of a segment step by step, along its tangent and back across it by Newton's method for
/// the phase of Φ.
/// \param even_if_straight  a line that seems to go straight, by its tangents at the ends, is followed, too
/// \return points of the line from the first end to the second, without these, so near to each other that the line leaves each
///         at a small angle to the way to the next one. None if it does so at the ends already and is not to be followed then, if its tangent is known at
///         neither, or if the second end is not reached
std::vector<Line_place> walk_along_line(const Surface& surface, const Segment& segment, bool even_if_straight = false);

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_EXTRACTION_WALK_ALONG_LINE_H
