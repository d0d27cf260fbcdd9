// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape_of_jet.h"

#include "../differential/vector.h"

namespace CGAL::Extremal_mesh_3 {

void shape_of_jet(const Jet& jet, const Fit_frame& frame, Local_shape& shape, Fourth_order_form& fourth) {
  const auto& c = jet.coefficients;
  const double s = 1 / frame.scale;
  // The graph is the surface f = z − jet(x, y) = 0: the derivatives of f are a! b! times the coefficients.
  Derivatives d;
  d.gradient = {-c[monomial(1, 0)], -c[monomial(0, 1)], 1};
  d.hessian = {-2 * s * c[monomial(2, 0)], -s * c[monomial(1, 1)], 0, -2 * s * c[monomial(0, 2)], 0, 0};
  const double s2 = s * s, s3 = s2 * s;
  d.third[0] = -6 * s2 * c[monomial(3, 0)];
  d.third[1] = -2 * s2 * c[monomial(2, 1)];
  d.third[3] = -2 * s2 * c[monomial(1, 2)];
  d.third[6] = -6 * s2 * c[monomial(0, 3)];
  d.fourth[0] = -24 * s3 * c[monomial(4, 0)];
  d.fourth[1] = -6 * s3 * c[monomial(3, 1)];
  d.fourth[3] = -4 * s3 * c[monomial(2, 2)];
  d.fourth[6] = -6 * s3 * c[monomial(1, 3)];
  d.fourth[10] = -24 * s3 * c[monomial(0, 4)];
  shape = local_shape(d);
  fourth = fourth_order_form(d, shape);
  const auto turned = [&](const Vector& v) { return v[0] * frame.x + v[1] * frame.y + v[2] * frame.z; };
  shape.n = turned(shape.n);
  shape.u = turned(shape.u);
}

} // namespace CGAL::Extremal_mesh_3
