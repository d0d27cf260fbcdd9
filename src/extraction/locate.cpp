// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "locate.h"

#include "../differential/vector.h"

#include <cmath>
#include <limits>

namespace CGAL::Extremal_mesh_3 {

namespace {

Complex value_of(Field field, const Sample& s) { return field == Field::P ? s.P : s.shape.Q; }

/// the value at a in the basis of b.
Complex value_moved(Field field, const Sample& a, const Sample& b) {
  const Moved_fields m = moved_to(a, b);
  return field == Field::P ? m.P : m.Q;
}

/// Newton's method in the triangle a, b, c, for the field F at a + x (b − a) + y (c − a).
std::optional<Sample> zero_in_triangle(const Surface& surface, Field field, const Sample& a, const Sample& b,
                                       const Sample& c) {
  constexpr double outside = 1e-9; // of the triangle, by rounding
  const auto at = [&](double x, double y) { return interpolate(surface, {&a, &b, &c}, {1 - x - y, x, y}); };
  double x = 1.0 / 3, y = 1.0 / 3;
  Sample s = at(x, y);
  for (int i = 0; i < 30; ++i) {
    constexpr double h = 1e-5; // of the triangle: P and Q are polynomials, and the error of the differences is of this size
    const Complex F = value_of(field, s);
    const Complex fx = (value_moved(field, at(x + h, y), s) - F) / h, fy = (value_moved(field, at(x, y + h), s) - F) / h;
    const double det = fx.real() * fy.imag() - fx.imag() * fy.real();
    const double dx = (F.imag() * fy.real() - F.real() * fy.imag()) / det;
    const double dy = (fx.imag() * F.real() - fx.real() * F.imag()) / det;
    x += dx;
    y += dy;
    if (!(std::abs(x) < 4 && std::abs(y) < 4))
      return std::nullopt;
    s = at(x, y);
    if (std::abs(dx) + std::abs(dy) < 1e-12)
      break;
  }
  if (x < -outside || y < -outside || x + y > 1 + outside || !std::isfinite(std::abs(value_of(field, s))))
    return std::nullopt;
  return s;
}

} // namespace

std::optional<Sample> locate_zero_between(const Surface& surface, Field field, const std::vector<const Sample*>& border,
                                          const Sample& middle) {
  for (std::size_t i = 0; i < border.size(); ++i)
    if (const auto s = zero_in_triangle(surface, field, middle, *border[i], *border[(i + 1) % border.size()]))
      return s;
  return std::nullopt;
}

std::optional<Sample> locate_zero(const Surface& surface, Field field, const Sample& start, double size, double reach) {
  Sample best = start;
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
    const Complex F = value_of(field, best);
    const Complex fu = (value_moved(field, *su, best) - F) / h, fv = (value_moved(field, *sv, best) - F) / h;
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
