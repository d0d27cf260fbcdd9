// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_FITTING_SHAPE_OF_JET_H
#define EXTREMAL_MESH_3_SRC_FITTING_SHAPE_OF_JET_H

#include "Jet_batch.h"

#include <CGAL/Extremal_mesh_3/Differential_quantities.h>

namespace CGAL::Extremal_mesh_3 {

/// The coordinates in which a jet is fitted, in units of `scale`.
struct Fit_frame {
  Vector x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1}; ///< direct orthonormal
  double scale = 1;
};

/// computes the shape of the graph z = jet(x, y) at x = y = 0, seen from where z points.
void shape_of_jet(const Jet& jet, const Fit_frame& frame, Local_shape& shape, Fourth_order_form& fourth);

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_FITTING_SHAPE_OF_JET_H
