// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cuts_between_branches.h"

#include "../differential/vector.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace CGAL::Extremal_mesh_3 {

namespace {

constexpr double pi = std::numbers::pi;

/// the zero of a function between two places at which it has different signs.
template <class Function> double zero_between(const Function& f, double low, double high) {
  const bool at_low = f(low) < 0;
  for (int i = 0; i < 60; ++i) {
    const double middle = low + (high - low) / 2;
    ((f(middle) < 0) == at_low ? low : high) = middle;
  }
  return low;
}

/// A sector between two neighbouring branches and the direction in it that is farthest from both, in the sense of the
/// cubic form.
struct Sector {
  double begin = 0, middle = 0, end = 0; ///< angles
};

/// the sectors between the branches, 6 of them; none if there are fewer branches.
///
/// Im Φ is a cubic form g there. With six zeros on the circle it has one extremum between each two of them, which is
/// found with no regard to how near they are.
std::vector<Sector> sectors(const Umbilic_star& star) {
  const auto field = [](const Linear_field& F, double angle) { return std::cos(angle) * F.x + std::sin(angle) * F.y; };
  const auto g = [&](double angle) {
    const Complex P = field(star.P, angle);
    return (P * P * field(star.Q, angle)).imag();
  };
  const auto slope = [&](double angle) {
    const Complex P = field(star.P, angle), Q = field(star.Q, angle);
    const Complex dP = field(star.P, angle + pi / 2), dQ = field(star.Q, angle + pi / 2);
    return (2.0 * P * dP * Q + P * P * dQ).imag();
  };
  constexpr int steps = 180; // of half the circle; the other half is its mirror
  std::vector<double> extrema;
  for (int i = 0; i < steps; ++i) {
    const double low = pi * i / steps, high = pi * (i + 1) / steps;
    if ((slope(low) < 0) != (slope(high) < 0))
      extrema.push_back(zero_between(slope, low, high));
  }
  const std::size_t n = extrema.size();
  for (std::size_t i = 0; i < n; ++i)
    extrema.push_back(extrema[i] + pi);
  std::vector<Sector> result;
  if (n != 3)
    return result;
  std::vector<double> roots; // after each extremum
  for (std::size_t i = 0; i < 2 * n; ++i) {
    const double next = i + 1 < 2 * n ? extrema[i + 1] : extrema[0] + 2 * pi;
    if ((g(extrema[i]) < 0) == (g(next) < 0))
      return result;
    roots.push_back(zero_between(g, extrema[i], next));
  }
  for (std::size_t i = 0; i < 2 * n; ++i)
    result.push_back({i == 0 ? roots.back() - 2 * pi : roots[i - 1], extrema[i], roots[i]});
  return result;
}

} // namespace

std::vector<Edge_cut> cuts_between_branches(const Refined_complex& complex, const std::vector<Half_edge>& border,
                                            const Umbilic_star& star, int most_edge_level) {
  std::vector<Complex> z; // the border in the tangent plane
  for (const Half_edge h : border) {
    const Vector d = complex.samples()[complex.source(h)].p - star.p;
    z.emplace_back(dot(d, star.u), dot(d, star.v));
  }
  std::vector<Edge_cut> cuts;
  for (const Sector& sector : sectors(star)) {
    const Complex direction = std::polar(1.0, sector.middle);
    const bool seen = std::any_of(z.begin(), z.end(), [&](const Complex& p) {
      const double angle = std::arg(p * std::conj(direction));
      return angle > sector.begin - sector.middle && angle < sector.end - sector.middle;
    });
    if (seen)
      continue;
    // The edge through which the ray leaves.
    for (std::size_t i = 0; i < border.size(); ++i) {
      const Complex a = z[i] * std::conj(direction), b = z[(i + 1) % z.size()] * std::conj(direction);
      if (!(a.imag() < 0 && b.imag() >= 0))
        continue;
      const double t = a.imag() / (a.imag() - b.imag());
      if (!(((1 - t) * a + t * b).real() > 0))
        continue;
      const std::uint32_t edge = border[i] / 2;
      if (complex.edges()[edge].level < most_edge_level)
        cuts.push_back({edge, border[i] % 2 == 0 ? t : 1 - t});
      break;
    }
  }
  return cuts;
}

} // namespace CGAL::Extremal_mesh_3
