// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "degenerate_vertex.h"

#include "../differential/vector.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace CGAL::Extremal_mesh_3 {

namespace {

constexpr double pi = std::numbers::pi;
/// What is to vanish at such a point is rounding there: less than this part of what it is around it, or of a radian. On
/// a surface without symmetry it is not, but by a chance of this size.
constexpr double rounding = 1e-8;
/// Steps of differences, in parts of the cell: those of the fourth order are exact to 1e-8 of the cell then, and far above rounding.
constexpr double difference_step = 0.02;
constexpr int most_steps = 40;

std::optional<Sample> beside(const Surface& surface, const Sample& s, Complex z, double size) {
  return surface.sample(s.p + z.real() * s.shape.u + z.imag() * s.shape.v(), s.shape.n, size, Surface::to_place);
}

/// The samples at ±h and ±2h along both axes of the tangent plane.
struct Cross {
  std::array<Sample, 4> x, y; ///< at −2h, −h, h, 2h
};
std::optional<Cross> cross_around(const Surface& surface, const Sample& s, double h, double size) {
  Cross cross;
  constexpr std::array<double, 4> at{-2, -1, 1, 2};
  for (std::size_t i = 0; i < 4; ++i) {
    const auto x = beside(surface, s, at[i] * h, size), y = beside(surface, s, Complex(0, at[i] * h), size);
    if (!x || !y)
      return std::nullopt;
    cross.x[i] = *x;
    cross.y[i] = *y;
  }
  return cross;
}

/// the first derivative in the middle of four values at −2h, −h, h, 2h, to the fourth order.
template <class Value> Value slope(const std::array<Value, 4>& f, double h) {
  return (f[0] - 8.0 * f[1] + 8.0 * f[2] - f[3]) / (12 * h);
}

/// A1 and A3 in the basis of b.
std::array<Complex, 2> moved_third_order(const Sample& a, const Sample& b) {
  const Complex z = frame_turn(a, b);
  return {a.shape.A1 * z, a.shape.A3 * z * z * z};
}

/// the least squares solution d of F + d.x Fx + d.y Fy = 0.
template <std::size_t N>
Complex least_squares_step(const std::array<Complex, N>& F, const std::array<Complex, N>& Fx,
                           const std::array<Complex, N>& Fy) {
  const auto inner = [](const std::array<Complex, N>& a, const std::array<Complex, N>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < N; ++i)
      sum += (a[i] * std::conj(b[i])).real();
    return sum;
  };
  const double xx = inner(Fx, Fx), xy = inner(Fx, Fy), yy = inner(Fy, Fy), x = -inner(Fx, F), y = -inner(Fy, F);
  const double det = xx * yy - xy * xy;
  return {(yy * x - xy * y) / det, (xx * y - xy * x) / det};
}

/// moves on by a step, if that does not lead far away.
bool move(const Surface& surface, Sample& s, Complex step, const Sample& middle, double size) {
  const double length = std::abs(step);
  if (!std::isfinite(length))
    return false;
  const auto next = beside(surface, s, length > 0.5 * size ? 0.5 * size / length * step : step, size);
  if (!next || distance(next->p, middle.p) > 1.5 * size)
    return false;
  s = *next;
  return true;
}

/// the crossings on a copy of the border, made smaller around a point; −1 if the fields turn too far between its samples.
int crossings_of_copy(const Refined_complex& complex, const std::vector<Half_edge>& border, const Sample& center,
                      double factor, double size) {
  constexpr double greatest_turn = 0.8 * pi;
  std::vector<Sample> copy;
  for (const Half_edge h : border) {
    const Vector d = complex.samples()[complex.source(h)].p - center.p;
    const auto s = complex.surface().sample(center.p + factor * d, center.shape.n, size);
    if (!s)
      return -1;
    copy.push_back(*s);
  }
  int crossings = 0;
  for (std::size_t i = 0; i < copy.size(); ++i) {
    const Sample &a = copy[i], &b = copy[(i + 1) % copy.size()];
    const Moved_fields moved = moved_to(a, b);
    const double P = std::arg(b.P * std::conj(moved.P)), Q = std::arg(b.shape.Q * std::conj(moved.Q));
    if (std::abs(P) > greatest_turn || std::abs(Q) > greatest_turn)
      return -1;
    const auto winding = int(std::lround((2 * P + Q - (b.phase - a.phase)) / (2 * pi)));
    crossings += std::abs((b.positive ? 0 : -1) + 2 * winding - (a.positive ? 0 : -1));
  }
  return crossings;
}

/// tells whether everything that crosses the border of a cell leads straight to a point in it.
bool is_center_of_star(const Refined_complex& complex, const std::vector<Half_edge>& border,
                       const Border_crossings& met, const Sample& center, const Sample& middle, double size) {
  double turn = 0;
  for (const Half_edge h : border) {
    const auto at = [&](std::uint32_t v) {
      const Vector d = complex.samples()[v].p - center.p;
      return Complex(dot(d, middle.shape.u), dot(d, middle.shape.v()));
    };
    const Complex a = at(complex.source(h)), b = at(complex.target(h));
    if (std::abs((std::conj(a) * b).imag()) < least_distance_of_vertex * size * std::abs(b - a))
      return false;
    turn += std::arg(b * std::conj(a));
  }
  if (turn < pi) // it lies outside
    return false;
  for (const double factor : {0.6, 0.3, 0.1})
    if (crossings_of_copy(complex, border, center, factor, size) != int(met.crossings.size()))
      return false;
  return true;
}

} // namespace

std::optional<Sample> find_flat_umbilic(const Refined_complex& complex, const std::vector<Half_edge>& border,
                                        const Border_crossings& met, const Sample& middle, const Flat_cell& flat) {
  const Surface& surface = complex.surface();
  const double size = flat.points.radius, h = difference_step * size;
  Sample s = middle;
  double last = size;
  for (int i = 0; i < most_steps; ++i) {
    const auto around = cross_around(surface, s, h, size);
    if (!around)
      return std::nullopt;
    std::array<Complex, 2> Fx, Fy;
    const auto slopes = [&](const std::array<Sample, 4>& line, std::array<Complex, 2>& F) {
      std::array<std::array<Complex, 4>, 2> values;
      for (std::size_t k = 0; k < 4; ++k) {
        const auto A = moved_third_order(line[k], s);
        values[0][k] = A[0];
        values[1][k] = A[1];
      }
      F = {slope(values[0], h), slope(values[1], h)};
    };
    slopes(around->x, Fx);
    slopes(around->y, Fy);
    const Complex step = least_squares_step<2>({s.shape.A1, s.shape.A3}, Fx, Fy);
    if (!move(surface, s, step, middle, size))
      return std::nullopt;
    const double length = std::abs(step);
    if (length < 1e-14 * size || (length < 1e-7 * size && length > 0.5 * last))
      break;
    last = length;
  }
  double A_around = 0, Q_around = 0;
  for (const Half_edge edge : border) {
    const Local_shape& shape = complex.samples()[complex.source(edge)].shape;
    A_around = std::max(A_around, std::abs(shape.A1) + std::abs(shape.A3));
    Q_around = std::max(Q_around, std::abs(shape.Q));
  }
  if (std::abs(s.shape.A1) + std::abs(s.shape.A3) > rounding * A_around || std::abs(s.shape.Q) > rounding * Q_around ||
      !is_center_of_star(complex, border, met, s, middle, size))
    return std::nullopt;
  return s;
}

std::optional<Sample> find_crossing_of_lines(const Refined_complex& complex, const std::vector<Half_edge>& border,
                                             const Border_crossings& met, const Sample& middle, const Flat_cell& flat) {
  if (met.crossings.size() != 4)
    return std::nullopt;
  const std::int32_t level = met.crossings[0].level;
  if (std::any_of(met.crossings.begin(), met.crossings.end(), [&](const auto& c) { return c.level != level; }))
    return std::nullopt;
  const Surface& surface = complex.surface();
  const double size = flat.points.radius, h = difference_step * size;
  const double sign = level % 2 == 0 ? 1 : -1;
  const auto height = [&](const Sample& s) { return std::arg(sign * s.shape.Phi()); };
  Sample s = middle;
  double last = size;
  for (int i = 0; i < most_steps; ++i) {
    const auto around = cross_around(surface, s, h, size);
    const auto xy = beside(surface, s, Complex(h, h), size);
    if (!around || !xy)
      return std::nullopt;
    std::array<double, 4> x, y;
    for (std::size_t k = 0; k < 4; ++k) {
      x[k] = height(around->x[k]);
      y[k] = height(around->y[k]);
    }
    const double here = height(s), gx = slope(x, h), gy = slope(y, h);
    const double hxx = (x[1] + x[2] - 2 * here) / (h * h), hyy = (y[1] + y[2] - 2 * here) / (h * h);
    const double hxy = (height(*xy) - x[2] - y[2] + here) / (h * h);
    const double det = hxx * hyy - hxy * hxy;
    if (!(det < 0)) // no saddle
      return std::nullopt;
    const Complex step((hxy * gy - hyy * gx) / det, (hxy * gx - hxx * gy) / det);
    if (!move(surface, s, step, middle, size))
      return std::nullopt;
    const double length = std::abs(step);
    if (length < 1e-14 * size || (length < 1e-6 * size && length > 0.5 * last))
      break;
    last = length;
  }
  if (std::abs(height(s)) > rounding || !is_center_of_star(complex, border, met, s, middle, size))
    return std::nullopt;
  return s;
}

} // namespace CGAL::Extremal_mesh_3
