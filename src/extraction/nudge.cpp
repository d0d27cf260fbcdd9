// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "nudge.h"

#include "../differential/vector.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace CGAL::Extremal_mesh_3 {

namespace {

constexpr double pi = std::numbers::pi;
/// Phases this near to 0 or π, and values of P and Q that are less than this part of those around, are trouble.
constexpr double on_line = 1e-4, small = 0.03;

/// less than 1 if the sample lies on a line, or if |P| or |Q| is small against the values around.
double distance_from_trouble(const Sample& s, double P_around, double Q_around) {
  const double off_line = std::abs(std::sin(s.phase)) / on_line;
  return std::min({off_line, std::abs(s.P) / (small * P_around), std::abs(s.shape.Q) / (small * Q_around)});
}

} // namespace

bool should_be_nudged(const Sample& s, double P2_around, double Q2_around) {
  const double off_line = std::min(std::abs(s.phase), pi - std::abs(s.phase));
  return off_line < on_line || std::norm(s.P) < small * small * P2_around ||
         std::norm(s.shape.Q) < small * small * Q2_around;
}

Sample nudged(const Surface& surface, const Sample& s, double size, double room, double P_around, double Q_around,
              const std::vector<const Sample*>& around) {
  constexpr double part = 0.14, golden_angle = 2.399963229728653;
  double best = distance_from_trouble(s, P_around, Q_around);
  if (!(best < 1) || !s.exact)
    return s;
  Sample chosen = s;
  const auto try_one = [&](const std::optional<Sample>& other) {
    const double distance = other ? distance_from_trouble(*other, P_around, Q_around) : 0;
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
