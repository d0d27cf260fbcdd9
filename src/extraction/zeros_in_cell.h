// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_EXTRACTION_ZEROS_IN_CELL_H
#define EXTREMAL_MESH_3_SRC_EXTRACTION_ZEROS_IN_CELL_H

#include "Cell_model.h"
#include "Planar_polygon.h"

namespace CGAL::Extremal_mesh_3 {

/// The zeros of a field in a cell, as far as its model tells.
struct Zeros_in_cell {
  bool certain = false; ///< all are simple, and there are no others, even if the model is wrong by its error
  int inside = 0;
  int beside_border = 0; ///< so near to the border that the model does not tell on which side
  Complex place;         ///< of the last that was found, in the plane of the model

  /// tells whether the field has as many zeros inside as the number of times that it winds around the border, which
  /// decides for one that lies beside it.
  bool agree_with(int winding) const {
    const int turns = winding < 0 ? -winding : winding;
    return certain && turns <= 1 && (beside_border == 0 ? inside == turns : inside == 0 && beside_border == 1);
  }
};

/// finds the zeros of the model of P or Q in the polygon. Squares are divided until in each either the field keeps from
/// 0 by more than its error, or it is one-to-one.
Zeros_in_cell zeros_in_cell(const Cell_model& model, Field field, const Planar_polygon& cell);

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_EXTRACTION_ZEROS_IN_CELL_H
