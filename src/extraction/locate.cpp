// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "locate.h"

#include "../differential/vector.h"

#include <cmath>
#include <limits>

namespace CGAL::Extremal_mesh_3 {

std::optional<Sample> locate_zero(const Surface& surface, Field field, const Sample& start, double size, double reach) {
  Sample best = start;
  const auto value = [&](const Sample& s) { return field == Field::P ? s.P : s.shape.Q; };
  // The Jacobian by differences over a part of the cell: accurate enough to win three digits a step, and far from
  // rounding.
  const double h = 1e-3 * size;
  double last = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 40; ++i) {
    const Vector u = best.shape.u, v = best.shape.v(), n = best.shape.n;
    const auto su = surface.sample(best.p + h * u, n, size, Surface::to_place);
    const auto sv = surface.sample(best.p + h * v, n, size, Surface::to_place);
    if (!su || !sv)
      return std::nullopt;
    const Complex F = value(best);
    const auto moved = [&](const Sample& s) {
      const Moved_fields m = moved_to(s, best);
      return field == Field::P ? m.P : m.Q;
    };
    const Complex fu = (moved(*su) - F) / h, fv = (moved(*sv) - F) / h;
    const double det = fu.real() * fv.imag() - fu.imag() * fv.real();
    double x = (F.imag() * fv.real() - F.real() * fv.imag()) / det;
    double y = (fu.imag() * F.real() - fu.real() * F.imag()) / det;
    const double step = std::hypot(x, y);
    if (!std::isfinite(step))
      return std::nullopt;
    if (step > 0.5 * size) { // far from linear: take it slowly
      x *= 0.5 * size / step;
      y *= 0.5 * size / step;
    }
    const auto next = surface.sample(best.p + x * u + y * v, n, size, Surface::to_place);
    if (!next || distance(next->p, start.p) > reach)
      return std::nullopt;
    best = *next;
    // Steps end when they are far below what matters, or when they are rounding: tiny, and no longer shrinking fast.
    if (step < 1e-14 * size || (step < 1e-6 * size && step > 0.05 * last))
      return best;
    last = step;
  }
  return std::nullopt;
}

} // namespace CGAL::Extremal_mesh_3
