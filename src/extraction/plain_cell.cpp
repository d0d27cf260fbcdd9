// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "plain_cell.h"

#include "../differential/vector.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace CGAL::Extremal_mesh_3 {

namespace {

constexpr double pi = std::numbers::pi;
/// Normals nearer to each other than this (cosine) let transport around the cell turn by less than ½.
constexpr double nearly_flat = 0.9;
/// With more samples around it a cell is to be looked at more closely.
constexpr std::size_t most_samples = 12;

/// tells that no line is near: the phase and the parts of it turn little around the cell, and keep far from its levels. What is
/// interpolated turns inside no further than around: there it is enough to be as far as that.
bool is_plainly_empty(const Refined_complex& complex, const Refined_cell& cell) {
  constexpr double little = 1.5, far = 0.3;
  const Vector& normal = complex.samples()[complex.source(cell.sides[0])].shape.n;
  double turn = 0, gap = pi;
  const bool quiet = complex.visit_border(cell, [&](Half_edge h) {
    const Refined_edge& e = complex.edges()[h / 2];
    const Sample& s = complex.samples()[complex.source(h)];
    turn += 2 * std::abs(e.turn_P) + std::abs(e.turn_Q);
    gap = std::min(gap, std::abs(s.phase - pi * std::round(s.phase / pi)));
    const bool crossed = e.winding != 0 || complex.samples()[e.a].positive != complex.samples()[e.b].positive;
    return !crossed && turn < little && dot(s.shape.n, normal) > nearly_flat;
  });
  return quiet && (gap > far || (complex.surface().interpolates() && gap > turn));
}

/// The samples around a cell, with the gradients of the phase, and how it turns from each to the next.
struct Border {
  std::size_t n = 0;
  std::array<const Sample*, most_samples> sample;
  std::array<Vector, most_samples> gradient;
  std::array<double, most_samples> turn;
  int crossings = 0;

  /// \return whether the border is short, flat and crossed twice or not at all
  bool gather(const Refined_complex& complex, const Refined_cell& cell) {
    const Vector& normal = complex.samples()[complex.source(cell.sides[0])].shape.n;
    double turn_P = 0, turn_Q = 0;
    const bool few = complex.visit_border(cell, [&](Half_edge h) {
      const Refined_edge& e = complex.edges()[h / 2];
      const Sample& s = complex.samples()[complex.source(h)];
      if (n == most_samples || !s.has_fourth || !(dot(s.shape.n, normal) > nearly_flat))
        return false;
      turn_P += std::abs(e.turn_P);
      turn_Q += std::abs(e.turn_Q);
      const Phase_gradient g = phase_gradient(s);
      sample[n] = &s;
      gradient[n] = g.x * s.shape.u + g.y * s.shape.v();
      turn[n] = (h % 2 == 0 ? 1 : -1) * (2 * e.turn_P + e.turn_Q);
      crossings += e.winding != 0 || complex.samples()[e.a].positive != complex.samples()[e.b].positive;
      ++n;
      return true;
    });
    return few && (crossings == 0 || crossings == 2) && turn_P < pi && turn_Q < pi; // then P and Q do not wind around 0
  }

  /// How the phase changes along the sides, against what its gradients say.
  struct Linearity {
    Vector mean{};         ///< of the gradients
    double greatest = 0;   ///< of them
    double difference = 0; ///< the greatest from their mean
    double off = 0;        ///< the greatest difference of the turn along a side from what the gradients say
    double error = 0;      ///< the same, in parts of `greatest` times the length of the side
    double bend = 0;       ///< the greatest difference of the gradients at the ends of a side, times its length
    double gap = pi;       ///< from the nearest level
  };
  Linearity linearity() const {
    Linearity l;
    for (std::size_t i = 0; i < n; ++i) {
      l.mean = l.mean + (1 / double(n)) * gradient[i];
      l.greatest = std::max(l.greatest, norm(gradient[i]));
      l.gap = std::min(l.gap, std::abs(sample[i]->phase - pi * std::round(sample[i]->phase / pi)));
    }
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t j = i + 1 < n ? i + 1 : 0;
      const Vector side = sample[j]->p - sample[i]->p;
      const double length = norm(side), off = std::abs(turn[i] - 0.5 * dot(gradient[i] + gradient[j], side));
      l.difference = std::max(l.difference, norm(gradient[i] - l.mean));
      l.bend = std::max(l.bend, length * norm(gradient[i] - gradient[j]));
      l.off = std::max(l.off, off);
      l.error = std::max(l.error, off / (l.greatest * length));
    }
    return l;
  }

  /// tells whether a side is crossed as its ends tell: the phase only rises or falls along it, or keeps off the levels
  /// beyond those between its ends.
  bool is_crossed_as_seen(std::size_t i, const Linearity& l) const {
    const std::size_t j = i + 1 < n ? i + 1 : 0;
    const Vector side = sample[j]->p - sample[i]->p;
    const double here = dot(gradient[i], side), there = dot(gradient[j], side);
    const double wrong = (0.05 + 2 * l.error) * l.greatest * norm(side);
    if (std::min(here, there) > wrong || std::max(here, there) < -wrong)
      return true;
    const double beyond = std::abs(there - here) / 8 + wrong;
    const double from = sample[i]->phase, to = from + turn[i];
    const auto level = [](double phase) { return std::floor(phase / pi); };
    return level(std::min(from, to) - beyond) == level(std::min(from, to)) &&
           level(std::max(from, to) + beyond) == level(std::max(from, to));
  }
};

} // namespace

std::optional<int> crossings_of_plain_cell(const Refined_complex& complex, const Refined_cell& cell) {
  if (is_plainly_empty(complex, cell))
    return 0;
  Border border;
  if (complex.surface().interpolates() || !border.gather(complex, cell))
    return std::nullopt;
  constexpr double alike = 0.5, greatest_error = 0.15;
  const Border::Linearity l = border.linearity();
  if (!std::isfinite(norm(l.mean)) || !(l.error < greatest_error)) // P or Q is 0 at a sample
    return std::nullopt;
  if (border.crossings == 0 && l.gap > 0.5 * l.bend + 3 * l.off)
    return 0;
  if (!(l.difference < alike * norm(l.mean)))
    return std::nullopt;
  for (std::size_t i = 0; i < border.n; ++i)
    if (!border.is_crossed_as_seen(i, l))
      return std::nullopt;
  return border.crossings;
}

} // namespace CGAL::Extremal_mesh_3
