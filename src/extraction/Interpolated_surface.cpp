// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Interpolated_surface.h"

#include "../cells/bounding_box.h"
#include "../differential/vector.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace CGAL::Extremal_mesh_3 {

namespace {

bool finite(const Local_shape& s) {
  return std::isfinite(dot(s.n, s.n) + s.H + std::norm(s.Q) + std::norm(s.A1) + std::norm(s.A3)) &&
         std::isfinite(std::norm(s.Phi()));
}

bool finite(const Fourth_order_form& D) {
  return std::isfinite(D.D0 + std::norm(D.D2) + std::norm(D.D4));
}

/// tells whether u and n are the orthonormal vectors that a shape must have, up to rounding of the caller's.
bool has_frame(const Local_shape& s) {
  constexpr double rounding = 1e-6;
  return std::abs(dot(s.n, s.n) - 1) < rounding && std::abs(dot(s.u, s.u) - 1) < rounding &&
         std::abs(dot(s.u, s.n)) < rounding;
}

/// the shape, with what is 0, or so small that its products vanish, made a little larger: the windings of fields around cells
/// need angles everywhere. On planes all fits are 0.
Local_shape never_zero(Local_shape s, double length) {
  constexpr double small = 1e-14; // of what the size of the surface makes of a curvature
  const auto raise = [](Complex& x, double least) {
    if (std::abs(x) < least)
      x = std::polar(least, 1.0);
  };
  raise(s.Q, small / length);
  raise(s.A1, 3 * small / (length * length));
  raise(s.A3, small / (length * length));
  return s;
}

/// the derivatives of C at the points, by least squares over the differences to their neighbours, made symmetric.
std::vector<Fourth_order_form> differences_of_C(const Cell_complex& cells, const std::vector<Sample>& samples) {
  struct Sums { // over the neighbours at z
    double zz = 0;
    Complex z2, A1_z, A1_zbar, A3_z, A3_zbar;
  };
  std::vector<Sums> sums(samples.size());
  const auto add = [&](std::uint32_t i, std::uint32_t j) {
    const Sample &a = samples[i], &b = samples[j];
    const Vector d = b.p - a.p;
    const Complex z(dot(d, a.shape.u), dot(d, a.shape.v())), turn = frame_turn(b, a);
    const Complex A1 = b.shape.A1 * turn - a.shape.A1, A3 = b.shape.A3 * turn * turn * turn - a.shape.A3;
    Sums& s = sums[i];
    s.zz += std::norm(z);
    s.z2 += z * z;
    s.A1_z += A1 * z;
    s.A1_zbar += A1 * std::conj(z);
    s.A3_z += A3 * z;
    s.A3_zbar += A3 * std::conj(z);
  };
  for (const auto& [a, b] : cells.edges) {
    add(a, b);
    add(b, a);
  }
  std::vector<Fourth_order_form> forms(samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    // X ≈ p z + q z̄: the normal equations are |z|² p + z̄² q = X z̄ and z² p + |z|² q = X z, summed.
    const Sums& s = sums[i];
    const double det = s.zz * s.zz - std::norm(s.z2);
    if (!(det > 1e-6 * s.zz * s.zz))
      continue;
    const auto p = [&](Complex Xz, Complex Xzbar) { return (s.zz * Xzbar - std::conj(s.z2) * Xz) / det; };
    const auto q = [&](Complex Xz, Complex Xzbar) { return (s.zz * Xz - s.z2 * Xzbar) / det; };
    // D(θ) is the derivative of e(θ) = Re(Ā3 e^{3iθ} + Ā1 e^{iθ}) along z = r e^{iθ}.
    forms[i].D0 = p(s.A1_z, s.A1_zbar).real();
    forms[i].D2 = p(s.A3_z, s.A3_zbar) + q(s.A1_z, s.A1_zbar);
    forms[i].D4 = q(s.A3_z, s.A3_zbar);
  }
  return forms;
}

void require_as_many(const char* what, std::size_t number, std::size_t points) {
  if (number != points)
    throw std::invalid_argument(fmt::format("there are {} {} for {} points", number, what, points));
}

} // namespace

void Interpolated_surface::require_valid(const Cell_complex& cells, const Vertex_shapes& shapes) const {
  const std::size_t n = cells.points.size();
  require_as_many("shapes", shapes.shapes.size(), n);
  if (!shapes.fourth.empty())
    require_as_many("fourth-order forms", shapes.fourth.size(), n);
  if (!shapes.quality.empty())
    require_as_many("fit qualities", shapes.quality.size(), n);
  for (std::size_t i = 0; i < n; ++i) {
    if (!shapes.quality.empty() && !shapes.quality[i].known())
      continue;
    if (!finite(shapes.shapes[i]) || (!shapes.fourth.empty() && !finite(shapes.fourth[i])))
      throw std::invalid_argument(fmt::format("the shape at point {} is not finite", i));
    if (!has_frame(shapes.shapes[i]))
      throw std::invalid_argument(
          fmt::format("the normal and the tangent of the shape at point {} are not orthonormal", i));
  }
}

std::vector<Sample> Interpolated_surface::samples(const Cell_complex& cells, const Vertex_shapes& shapes) const {
  const std::size_t n = cells.points.size();
  std::vector<Sample> samples;
  samples.reserve(n + n / 8); // the division of cells will add some
  const double length = diagonal_of(cells.points);
  for (std::size_t i = 0; i < n; ++i)
    samples.emplace_back(cells.points[i], never_zero(shapes.shapes[i], length), true);
  // Fourth derivatives of a fit are worth less than the differences between neighbouring fits, which make C smooth.
  const bool exact = !shapes.fourth.empty() && shapes.quality.empty();
  const std::vector<Fourth_order_form>& fourth = exact ? shapes.fourth : differences_of_C(cells, samples);
  for (std::size_t i = 0; i < n; ++i)
    samples[i].fourth = fourth[i];
  return samples;
}

} // namespace CGAL::Extremal_mesh_3
