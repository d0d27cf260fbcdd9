// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_TEST_DENSE_SEARCH_H
#define CGAL_EXTREMAL_MESH_3_TEST_DENSE_SEARCH_H

#include <CGAL/Extremal_mesh_3/Differential_quantities.h>

#include "surfaces.h"

#include <optional>

/// The extremal points and umbilics of a surface, found without any of the extraction: Newton's method for
/// V = |Q| (e1 t1 − e2 t2) from a dense set of starts. V is smooth, and 0 exactly at those points.
namespace dense_search {

using namespace CGAL::Extremal_mesh_3;
using namespace surfaces;

struct Zero {
  Point point{};
  bool umbilic = false;
  int field_index = 0; ///< sign of the Jacobian of V
  Umbilic_class umbilic_class;
};

/// A point of the surface and what is there.
struct Place {
  Point p{};
  Local_shape shape;
  /// P̄ in the basis (u, v), as a vector of space.
  Vector V() const {
    const std::complex<double> P = shape.P();
    return along(along({0, 0, 0}, P.real(), shape.u), -P.imag(), shape.v());
  }
};

/// follows the gradient to the surface.
inline std::optional<Place> place_near(const Function_3& f, Point p) {
  Derivatives d;
  for (int i = 0; i < 8; ++i) {
    f.derivatives(p, 1, d);
    const double g2 = dot(d.gradient, d.gradient);
    if (!(g2 > 0))
      return std::nullopt;
    p = along(p, -d.value / g2, d.gradient);
    if (std::abs(d.value) < 1e-14 * std::sqrt(g2))
      break;
  }
  f.derivatives(p, 3, d);
  return Place{p, local_shape(d)};
}

/// V and its Jacobian by central differences, in the tangent basis at one place.
struct Linear_model {
  double v0, v1, a, b, c, d;
  double determinant() const { return a * d - b * c; }
};

inline std::optional<Linear_model> linear_model(const Function_3& f, const Place& at, double h) {
  const Vector u = at.shape.u, v = at.shape.v();
  std::array<Vector, 4> V;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto beside = place_near(f, along(at.p, i % 2 == 0 ? h : -h, i < 2 ? u : v));
    if (!beside)
      return std::nullopt;
    V[i] = beside->V();
  }
  const Vector V0 = at.V();
  const auto slope = [&](std::size_t i, const Vector& w) { return (dot(V[i], w) - dot(V[i + 1], w)) / (2 * h); };
  return Linear_model{dot(V0, u), dot(V0, v), slope(0, u), slope(2, u), slope(0, v), slope(2, v)};
}

/// \param size  of the surface
inline std::optional<Zero> newton(const Function_3& f, const Point& start, double size) {
  auto at = place_near(f, start);
  double last = size;
  for (int i = 0; i < 60 && at; ++i) {
    const auto m = linear_model(f, *at, 1e-5 * size);
    if (!m)
      return std::nullopt;
    double x = (m->b * m->v1 - m->d * m->v0) / m->determinant();
    double y = (m->c * m->v0 - m->a * m->v1) / m->determinant();
    const double step = std::hypot(x, y);
    if (!std::isfinite(step))
      return std::nullopt;
    const double part = std::min(1.0, 0.03 * size / step);
    at = place_near(f, along(along(at->p, part * x, at->shape.u), part * y, at->shape.v()));
    if (step < 1e-9 * size && step >= 0.1 * last) { // no longer shrinks: rounding
      if (!at)
        return std::nullopt;
      Zero zero;
      zero.point = at->p;
      // At an umbilic Q is rounding; beside one, at a distance that could be told apart, it is larger by far.
      zero.umbilic = std::abs(at->shape.Q) * size < 1e-6;
      zero.field_index = m->determinant() > 0 ? 1 : -1;
      if (zero.umbilic)
        zero.umbilic_class = classify_umbilic(at->shape.A1, at->shape.A3);
      return zero;
    }
    last = step;
  }
  return std::nullopt;
}

/// \param starts  as dense as one likes
inline std::vector<Zero> find_zeros(const Function_3& f, const std::vector<Point>& starts, double size) {
  std::vector<Zero> zeros;
  for (const Point& start : starts)
    if (const auto zero = newton(f, start, size))
      if (distance(zero->point, start) < 0.3 * size && std::none_of(zeros.begin(), zeros.end(), [&](const Zero& z) {
            return distance(z.point, zero->point) < 1e-6 * size;
          }))
        zeros.push_back(*zero);
  return zeros;
}

} // namespace dense_search

#endif // CGAL_EXTREMAL_MESH_3_TEST_DENSE_SEARCH_H
