// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_EXTRACTION_PLACE_ON_LINE_H
#define EXTREMAL_MESH_3_SRC_EXTRACTION_PLACE_ON_LINE_H

#include "refine_segment.h"

#include <optional>

namespace CGAL::Extremal_mesh_3 {

/// Two points of a line.
struct Chord {
  const Line_place &a, &b;
  int family = 1;          ///< of the line
  double sign_on_left = 1; ///< of E_g, going from a to b
};

/// A point of a line.
struct Placed_on_line {
  Sample sample;
  double offset = 0; ///< from the chord, to the left
};

/// the point of a line beside its chord, at the parameter t from a to b, that is next to the chord with E_g of the right sign
/// on the left; nothing if there is none, or the surface cannot be reached.
/// \param guess  of its offset
/// \param wide  how far it may be from the chord, in parts of the way along the chord to the nearer end
/// \pre the surface does not interpolate
std::optional<Placed_on_line> place_on_line(const Surface& surface, const Chord& chord, double t, double guess,
                                            double wide);

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_EXTRACTION_PLACE_ON_LINE_H
