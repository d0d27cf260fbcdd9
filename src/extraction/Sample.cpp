// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Sample.h"

#include "../differential/vector.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace CGAL::Extremal_mesh_3 {

namespace {

/// A new sample must face roughly as those around it do: a surface point whose normal has turned by more than this lies
/// on another sheet (cos 66°).
constexpr double least_cosine = 0.4;

std::optional<Sample> accepted(const Surface& surface, const Point& x, const Vector& direction, double reach,
                               double accuracy, Detail detail) {
  auto s = surface.sample(x, direction, reach, accuracy, detail);
  if (s && dot(s->shape.n, direction) < least_cosine)
    return std::nullopt;
  return s;
}

/// the shape of a sample with half of what its derivatives say that it changes by on the way to p. The mean of shapes
/// errs to one side where they are not linear, the mean of what is expected at p by as much to the other side; the mean of both is
/// exact where they are quadratic.
Local_shape half_way(const Sample& sample, const Point& p) {
  const Local_shape& s = sample.shape;
  const Shape_derivatives derivatives = shape_derivatives(s, sample.fourth);
  const Vector d = p - sample.p;
  const Complex z(dot(d, s.u) / 2, dot(d, s.v()) / 2);
  const auto along = [&](const Shape_derivatives::Pair& x) { return x.z * z + x.z_bar * std::conj(z); };
  Local_shape moved = s;
  moved.H += 2.0 / 3 * (std::conj(s.A1) * z).real();
  moved.Q += along(derivatives.Q);
  moved.A1 += along(derivatives.A1);
  moved.A3 += along(derivatives.A3);
  return moved;
}

} // namespace

Shape_derivatives shape_derivatives(const Local_shape& s, const Fourth_order_form& D) {
  // ∂̄H = ∂Q = A1/3 and ∂̄Q = A3 (Codazzi), ∂ and ∂̄ being the derivatives along z and z̄. C's own derivatives are not
  // quite symmetric: ∂∂̄Q − ∂̄∂Q = K Q.
  const Complex KQ = (s.H * s.H - std::norm(s.Q)) * s.Q;
  const Complex dbar_A1 = 0.75 * (D.D2 - KQ);
  return {{s.A1 / 3.0, s.A3}, {D.D0, dbar_A1}, {dbar_A1 / 3.0 + KQ, D.D4}};
}

Field_gradients field_gradients(const Sample& sample) {
  const Local_shape& s = sample.shape;
  const Shape_derivatives d = shape_derivatives(s, sample.fourth);
  const auto along = [](const Shape_derivatives::Pair& x, Complex z) { return x.z * z + x.z_bar * std::conj(z); };
  const auto dQ = [&](Complex z) { return along(d.Q, z); };
  const auto dP = [&](Complex z) {
    return std::conj(along(d.A3, z)) * s.Q + std::conj(s.A3) * dQ(z) + along(d.A1, z) * std::conj(s.Q) +
           s.A1 * std::conj(dQ(z));
  };
  const Complex u(1, 0), v(0, 1);
  return {{dP(u), dP(v)}, {dQ(u), dQ(v)}};
}

Phase_gradient phase_gradient(const Sample& s) {
  const Field_gradients d = field_gradients(s);
  return {(2.0 * d.P.x / s.P + d.Q.x / s.shape.Q).imag(), (2.0 * d.P.y / s.P + d.Q.y / s.shape.Q).imag()};
}

Sample::Sample(const Point& point, const Local_shape& local_shape, bool is_exact)
    : p(point), shape(local_shape), P(local_shape.P()), exact(is_exact) {
  const Complex phi = local_shape.Phi();
  positive = !(phi.imag() < 0);
  phase = std::arg(phi);
  if (positive && (phase < 0 || phase >= std::numbers::pi)) // Im Φ = 0, Re Φ < 0
    phase = std::nextafter(std::numbers::pi, 0.0);
}

Complex frame_turn(const Sample& a, const Sample& b) {
  const Vector u = transport(a.shape.n, b.shape.n, a.shape.u);
  const Complex z(dot(u, b.shape.u), dot(u, b.shape.v()));
  return z / std::sqrt(std::norm(z));
}

Moved_fields moved_to(const Sample& a, const Sample& b) {
  const Complex z = frame_turn(a, b);
  return {a.P * std::conj(z), a.shape.Q * z * z};
}

Sample interpolate(const Surface& surface, const std::vector<const Sample*>& samples,
                   const std::vector<double>& weights) {
  Sample mean;
  Vector n{};
  for (std::size_t i = 0; i < samples.size(); ++i) {
    mean.p = mean.p + weights[i] * samples[i]->p;
    n = n + weights[i] * samples[i]->shape.n;
  }
  const double length = norm(n);
  mean.shape.n = length > 0 ? (1 / length) * n : samples.front()->shape.n;
  mean.shape.u = any_orthogonal(mean.shape.n);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Local_shape s = surface.interpolates() ? half_way(*samples[i], mean.p) : samples[i]->shape;
    const Complex z = frame_turn(*samples[i], mean);
    mean.shape.H += weights[i] * s.H;
    mean.shape.Q += weights[i] * s.Q * z * z;
    mean.shape.A1 += weights[i] * s.A1 * z;
    mean.shape.A3 += weights[i] * s.A3 * z * z * z;
    const Fourth_order_form& D = samples[i]->fourth;
    mean.fourth.D0 += weights[i] * D.D0;
    mean.fourth.D2 += weights[i] * D.D2 * z * z;
    mean.fourth.D4 += weights[i] * D.D4 * z * z * z * z;
  }
  Sample result(mean.p, mean.shape, surface.interpolates());
  result.fourth = mean.fourth;
  return result;
}

Sample sample_between(const Surface& surface, const Sample& a, const Sample& b, double t, double accuracy,
                      Detail detail) {
  if (surface.interpolates())
    return interpolate(surface, {&a, &b}, {1 - t, t});
  const Vector chord = b.p - a.p;
  const Vector sum = (1 - t) * a.shape.n + t * b.shape.n;
  const double length = norm(sum), reach = 0.5 * norm(chord);
  if (length > 0.1) {
    const Vector n = (1 / length) * sum;
    const double na = dot(n, a.shape.n), nb = dot(n, b.shape.n);
    Point x = (1 - t) * a.p + t * b.p;
    if (na > least_cosine && nb > least_cosine) {
      // The height above the chord, by Hermite interpolation: slopes follow from the normals.
      const double slope_a = -dot(chord, a.shape.n) / na, slope_b = -dot(chord, b.shape.n) / nb;
      x = x + (t * (1 - t) * ((1 - t) * slope_a - t * slope_b)) * n;
    }
    if (const auto s = accepted(surface, x, n, reach, accuracy, detail))
      return *s;
  }
  return interpolate(surface, {&a, &b}, {1 - t, t});
}

Sample sample_amid(const Surface& surface, const std::vector<const Sample*>& corners) {
  const double w = 1 / double(corners.size());
  if (surface.interpolates())
    return interpolate(surface, corners, std::vector<double>(corners.size(), w));
  Point x{};
  Vector sum{};
  for (const Sample* s : corners) {
    x = x + w * s->p;
    sum = sum + w * s->shape.n;
  }
  const double length = norm(sum);
  if (length > 0.1) {
    const Vector n = (1 / length) * sum;
    double radius = 0, height = 0;
    bool flat = true;
    for (const Sample* s : corners) {
      const double cosine = dot(n, s->shape.n);
      flat = flat && cosine > least_cosine;
      radius = std::max(radius, distance(s->p, x));
      // On a paraboloid the surface lies half way to the tangent plane of a corner, on average.
      height += 0.5 * w * dot(s->p - x, s->shape.n) / cosine;
    }
    if (const auto s = accepted(surface, flat ? x + height * n : x, n, radius, Surface::to_look, Detail::fourth_order))
      return *s;
  }
  return interpolate(surface, corners, std::vector<double>(corners.size(), w));
}

} // namespace CGAL::Extremal_mesh_3
