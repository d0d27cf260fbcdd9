// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A search across the chord for the zero of the phase of Φ that the line is: the same root as along the edges of the cells,
// so a point of the line is as good wherever it lies.
#include "place_on_line.h"

#include "../differential/vector.h"
#include "find_root.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL::Extremal_mesh_3 {

namespace {

/// The root is found when it is known to this part of the chord.
constexpr double settled = 1e-12;

} // namespace

std::optional<Placed_on_line> place_on_line(const Surface& surface, const Chord& chord_of_line, double t, double guess,
                                            double wide) {
  const Line_place &a = chord_of_line.a, &b = chord_of_line.b;
  const Vector chord = b.p - a.p, sum = (1 - t) * a.n + t * b.n;
  const double size = norm(chord), length = norm(sum);
  if (!(length > 0.1) || !(size > 0))
    return std::nullopt;
  const Vector n = (1 / length) * sum;
  constexpr double least_cosine = 0.4; // as for all new samples
  const double na = dot(n, a.n), nb = dot(n, b.n);
  if (na < least_cosine || nb < least_cosine)
    return std::nullopt;
  // The height above the chord, by Hermite interpolation, as in `sample_between()`.
  const double slope_a = -dot(chord, a.n) / na, slope_b = -dot(chord, b.n) / nb;
  const Point x = (1 - t) * a.p + t * b.p + (t * (1 - t) * ((1 - t) * slope_a - t * slope_b)) * n;
  const Vector left = normalized(cross(n, chord));
  const double turned = chord_of_line.family == 1 ? -1 : 1, rising = turned * chord_of_line.sign_on_left;
  std::optional<Sample> s;
  // The phase above that of the line, made to rise to the left; NaN where the surface is not reached.
  const auto height = [&](double offset) {
    s = surface.sample(x + offset * left, n, 0.5 * size, Surface::to_place, Detail::third_order);
    if (!s || dot(s->shape.n, n) < least_cosine)
      return std::numeric_limits<double>::quiet_NaN();
    return rising * std::arg(turned * s->shape.Phi());
  };
  constexpr double zero = 1e-14; // of a phase
  const double limit = wide * std::min(t, 1 - t) * size;
  double h0 = std::clamp(guess, -limit, limit), g0 = height(h0);
  if (std::abs(g0) < zero)
    return Placed_on_line{*s, h0};

  // Across the line: steps grow until the line lies between.
  double step = std::max(1e-3 * limit, 0.03 * std::abs(guess)), h1 = h0, g1 = g0;
  for (int i = 0; (g1 < 0) == (g0 < 0); ++i) {
    if (i == 20 || std::isnan(g1) || std::abs(h1) >= limit)
      return std::nullopt;
    const double last = h1, g_last = g1;
    h1 = std::clamp(h1 + (g0 < 0 ? step : -step), -limit, limit);
    g1 = height(h1);
    // A little farther than where it would be if the phase were linear.
    const double expected = 1.2 * std::abs(g1 * (h1 - last) / (g1 - g_last));
    step = std::isfinite(expected) ? std::clamp(expected, 2 * step, 32 * step) : 4 * step;
    h0 = last;
    g0 = g_last;
  }
  if (std::isnan(g1))
    return std::nullopt;
  bool lost = false;
  double h = h1, g = g1;
  const auto value = [&](double offset) {
    h = offset;
    g = height(offset);
    lost = lost || std::isnan(g);
    return lost ? 0 : g; // a root ends the search
  };
  if (h0 < h1)
    find_root(value, h0, h1, g0, g1, settled * size);
  else
    find_root(value, h1, h0, g1, g0, settled * size);
  if (lost)
    return std::nullopt;
  constexpr double jump = 1e-3; // where the phase goes from π to −π it does not come near to 0
  if (!s || !(std::abs(g) < jump))
    return std::nullopt;
  return Placed_on_line{*s, h};
}

} // namespace CGAL::Extremal_mesh_3
