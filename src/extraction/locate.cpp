// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "locate.h"

#include "../differential/umbilic_lines.h"
#include "../differential/vector.h"

#include <cmath>
#include <limits>

namespace CGAL::Extremal_mesh_3 {

namespace {

Complex value_of(Field field, const Sample& s) {
  return field == Field::P ? s.P : s.shape.Q;
}

/// the value at a in the basis of b.
Complex value_moved(Field field, const Sample& a, const Sample& b) {
  const Moved_fields m = moved_to(a, b);
  return field == Field::P ? m.P : m.Q;
}

/// the derivatives of P or Q along u and v: those of the sample, or differences over a part of the cell, accurate enough to
/// win three digits a step, and far from rounding.
std::optional<Linear_field> gradient_of(const Surface& surface, Field field, const Sample& s, double size) {
  if (s.has_fourth) {
    const Field_gradients gradients = field_gradients(s);
    return field == Field::P ? gradients.P : gradients.Q;
  }
  const double h = 1e-3 * size;
  const auto su = surface.sample(s.p + h * s.shape.u, s.shape.n, size, Surface::to_place);
  const auto sv = surface.sample(s.p + h * s.shape.v(), s.shape.n, size, Surface::to_place);
  if (!su || !sv)
    return std::nullopt;
  const Complex F = value_of(field, s);
  return Linear_field{(value_moved(field, *su, s) - F) / h, (value_moved(field, *sv, s) - F) / h};
}

/// Newton's method in the triangle a, b, c, for the field F at a + x (b − a) + y (c − a).
std::optional<Sample> zero_in_triangle(const Surface& surface, Field field, const Sample& a, const Sample& b,
                                       const Sample& c) {
  constexpr double outside = 1e-9; // of the triangle, by rounding
  const auto at = [&](double x, double y) { return interpolate(surface, {&a, &b, &c}, {1 - x - y, x, y}); };
  double x = 1.0 / 3, y = 1.0 / 3;
  Sample s = at(x, y);
  for (int i = 0; i < 30; ++i) {
    constexpr double h =
        1e-5; // of the triangle: P and Q are polynomials, and the error of the differences is of this size
    const Complex F = value_of(field, s);
    const Complex fx = (value_moved(field, at(x + h, y), s) - F) / h,
                  fy = (value_moved(field, at(x, y + h), s) - F) / h;
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

std::optional<Sample> locate_zero(const Surface& surface, Field field, const Sample& start, Complex guess, double size,
                                  double reach) {
  const auto beside = [&](const Sample& s, Complex step) {
    return surface.sample(s.p + step.real() * s.shape.u + step.imag() * s.shape.v(), s.shape.n, size,
                          Surface::to_place);
  };
  Sample best = start;
  if (guess != 0.0) {
    const auto there = beside(start, guess);
    if (!there)
      return std::nullopt;
    best = *there;
  }
  double last = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 40; ++i) {
    const auto gradient = gradient_of(surface, field, best, size);
    if (!gradient)
      return std::nullopt;
    const Complex F = value_of(field, best), fu = gradient->x, fv = gradient->y;
    const double det = fu.real() * fv.imag() - fu.imag() * fv.real();
    Complex step((F.imag() * fv.real() - F.real() * fv.imag()) / det,
                 (fu.imag() * F.real() - fu.real() * F.imag()) / det);
    const double length = std::abs(step);
    if (!std::isfinite(length))
      return std::nullopt;
    if (length > 0.5 * size) // far from linear: take it slowly
      step *= 0.5 * size / length;
    const auto next = beside(best, step);
    if (!next || distance(next->p, start.p) > reach)
      return std::nullopt;
    best = *next;
    // Steps end when they are far below what matters, or when they are rounding: tiny, and no longer shrinking fast.
    if (length < 1e-14 * size || (length < 1e-6 * size && length > 0.05 * last))
      return best;
    last = length;
  }
  return std::nullopt;
}

} // namespace CGAL::Extremal_mesh_3
