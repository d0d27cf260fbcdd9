// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "nudge.h"

#include "../differential/vector.h"

#include <algorithm>
#include <cmath>

namespace CGAL::Extremal_mesh_3 {

namespace {

/// Phases this near to 0 or π, and values of P and Q that are less than this part of those around, may be trouble …
constexpr double on_line = 1e-4, small = 0.03;
/// … but not if the derivatives tell that the line, or the zero, is farther away than these parts of the size: where one extremality is
/// far less than the other the phase is near a level everywhere, and beside a crease P is less than around it anywhere in its middle.
constexpr double near_line = 1e-3, near_zero = 0.1;
/// What is smaller than these is rounding, wherever the line or the zero may be.
constexpr double rounding = 1e-9;

/// how far away, by its derivatives, a field is 0; not finite if it has none.
double distance_to_zero(const Linear_field& f, Complex value) {
  const double det = (std::conj(f.x) * f.y).imag();
  return std::hypot((std::conj(value) * f.y).imag(), (std::conj(f.x) * value).imag()) / std::abs(det);
}

/// less than 1 if the sample lies on a line, or beside a zero of P or Q.
double distance_from_trouble(const Sample& s, double size, double P_around, double Q_around) {
  const double off_line = std::abs(std::sin(s.phase));
  double line = off_line / on_line, P = std::abs(s.P) / (small * P_around),
         Q = std::abs(s.shape.Q) / (small * Q_around);
  if (s.has_fourth && std::min({line, P, Q}) < 1) {
    const auto unless_far = [&](double& trouble, double value, double distance) {
      trouble = std::max(trouble, std::min(distance / size, value / rounding)); // stays if the distance is not a number
    };
    const Phase_gradient slope = phase_gradient(s);
    const Field_gradients d = field_gradients(s);
    unless_far(line, off_line, off_line / std::hypot(slope.x, slope.y) / near_line);
    unless_far(P, std::abs(s.P) / P_around, distance_to_zero(d.P, s.P) / near_zero);
    unless_far(Q, std::abs(s.shape.Q) / Q_around, distance_to_zero(d.Q, s.shape.Q) / near_zero);
  }
  return std::min({line, P, Q});
}

} // namespace

bool should_be_nudged(const Sample& s, double size, double P_around, double Q_around) {
  return distance_from_trouble(s, size, P_around, Q_around) < 1;
}

Sample nudged(const Surface& surface, const Sample& s, double size, double room, double P_around, double Q_around,
              const std::vector<const Sample*>& around) {
  constexpr double part = 0.14, golden_angle = 2.399963229728653;
  double best = distance_from_trouble(s, size, P_around, Q_around);
  if (!(best < 1) || !s.exact)
    return s;
  Sample chosen = s;
  const auto try_one = [&](const std::optional<Sample>& other) {
    const double distance = other ? distance_from_trouble(*other, size, P_around, Q_around) : 0;
    if (distance > best) {
      best = distance;
      chosen = *other;
    }
  };
  if (surface.interpolates()) {
    // Not straight towards another sample: what lies here would then lie on the edge from the opposite one.
    const std::size_t n = around.size();
    for (std::size_t i = 0; i < n && best < 1; ++i)
      try_one(interpolate(surface, {&s, around[i], around[(i + 1) % n], around[(i + 2) % n]},
                          {1 - part, 0.6 * part, 0.3 * part, 0.1 * part}));
    return chosen;
  }
  const double step = std::min(part * size, 0.5 * room);
  for (int i = 0; i < 5 && best < 1; ++i) {
    const double angle = golden_angle * (i + 1);
    const Vector d = std::cos(angle) * s.shape.u + std::sin(angle) * s.shape.v();
    try_one(surface.sample(s.p + step * d, s.shape.n, size));
  }
  return chosen;
}

} // namespace CGAL::Extremal_mesh_3
