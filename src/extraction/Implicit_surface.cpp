// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Implicit_surface.h"

#include "../differential/vector.h"

#include <cmath>

namespace CGAL::Extremal_mesh_3 {

namespace {

bool finite(const Local_shape& s) {
  return std::isfinite(s.H) && std::isfinite(std::norm(s.Q)) && std::isfinite(std::norm(s.A1)) &&
         std::isfinite(std::norm(s.A3));
}

Sample sample_of(const Point& p, const Local_shape& shape, const Derivatives& d, int order) {
  Sample s(p, shape, true);
  s.has_fourth = order >= 4;
  if (s.has_fourth)
    s.fourth = fourth_order_form(d, shape);
  return s;
}

} // namespace

std::optional<Sample> Implicit_surface::sample(const Point& x, const Vector& direction, double reach, double accuracy,
                                               Detail detail) const {
  // Newton along the line. All derivatives are taken where the step to the surface is within the accuracy; as steps
  // shrink quadratically, the step before tells when that will be. To look the guess x is often good enough by itself.
  Derivatives d;
  double s = 0, expected = accuracy < to_look ? reach : 0, last = reach;
  for (int i = 0; i < 25; ++i) {
    const Point p = x + s * direction;
    const bool all = expected < accuracy * reach;
    f_.derivatives(p, all ? order(detail) : 1, d);
    const double step = -d.value / dot(d.gradient, direction);
    if (!std::isfinite(step) || std::abs(s + step) > reach)
      return std::nullopt;
    // Small steps that do not shrink any more are rounding, which far from the origin is more than what is asked for.
    const bool rounding = std::abs(step) < 1e-6 * reach && std::abs(step) > 0.01 * std::abs(last);
    if (all && (std::abs(step) <= accuracy * reach || rounding)) {
      const Local_shape shape = local_shape(d);
      if (!finite(shape))
        return std::nullopt;
      return sample_of(p + step * direction, shape, d, order(detail));
    }
    s += step;
    last = step;
    expected = i > 8 ? 0 : step * step / reach;
  }
  return std::nullopt;
}

Sample Implicit_surface::sample_at(const Point& p) const {
  Derivatives d;
  const int highest = order(Detail::fourth_order);
  f_.derivatives(p, highest, d);
  return sample_of(p, local_shape(d), d, highest);
}

void Implicit_surface::add_fourth(Sample& s) const {
  if (s.has_fourth || f_.max_order() < 4)
    return;
  Derivatives d;
  f_.derivatives(s.p, 4, d);
  s.fourth = fourth_order_form(d, s.shape);
  s.has_fourth = true;
}

double Implicit_surface::extremality_derivative(const Sample& s, int family, double step) const {
  if (s.has_fourth)
    return CGAL::Extremal_mesh_3::extremality_derivative(s.shape, s.fourth, family);
  // Difference of e along t, the direction being carried along.
  const Principal_quantities here = principal_quantities(s.shape);
  const Vector t = family == 1 ? here.t1 : here.t2;
  double e[2];
  for (int side = 0; side < 2; ++side) {
    const auto other =
        sample(s.p + (side == 0 ? -step : step) * t, s.shape.n, 10 * step, to_place, Detail::third_order);
    if (!other)
      return 0;
    const Principal_quantities q = principal_quantities(other->shape);
    const bool turned = dot(family == 1 ? q.t1 : q.t2, t) < 0;
    e[side] = (turned ? -1 : 1) * (family == 1 ? q.e1 : q.e2);
  }
  return (e[1] - e[0]) / (2 * step);
}

} // namespace CGAL::Extremal_mesh_3
