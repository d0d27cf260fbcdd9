// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "evidence.h"

#include "../differential/vector.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace CGAL::Extremal_mesh_3 {

namespace {

/// log10 of the probability of at least m successes among n.
double log10_tail(std::size_t m, std::size_t n, double p) {
  if (m == 0 || p >= 1)
    return 0;
  const double log_p = std::log(p), log_q = std::log1p(-p);
  const auto log_factorial = [](std::size_t k) { return std::lgamma(double(k) + 1); };
  double sum = 0, first = 0;
  for (std::size_t k = m; k <= n; ++k) {
    const double term =
        log_factorial(n) - log_factorial(k) - log_factorial(n - k) + double(k) * log_p + double(n - k) * log_q;
    if (k == m)
      first = term;
    sum += std::exp(term - first); // the first is the greatest, if m is more than the mean
  }
  return std::min(0.0, (first + std::log(sum)) / std::log(10.0));
}

/// How one vertex does.
struct Trial {
  bool in_overlap = false, matched = false;
  int by_chance = 0;
};
constexpr int displacements = 16;

Trial try_vertex(const Feature& f, const Target& b, const Similarity& motion, const Evidence_options& options,
                 double first_angle) {
  Trial trial;
  const Line_sample place{f.point, f.normal, {}, 0, {}};
  const auto surface = b.surface_near(place, motion, options.reach);
  if (!surface)
    return trial;
  trial.in_overlap = true;
  trial.matched = b.vertex_near(f, motion, options.tolerance).has_value();
  for (int i = 0; i < displacements; ++i) {
    const double angle = first_angle + 2 * std::numbers::pi * i / displacements;
    const double length = (3 + 3 * (i % 4) / 3.0) * options.tolerance / motion.scale;
    const Vector direction = std::cos(angle) * f.t1 + std::sin(angle) * f.t2;
    Feature moved = f;
    moved.point = f.point + length * direction;
    Line_sample there{moved.point, f.normal, {}, 0, {}};
    // onto the second surface, or less would match where the surfaces bend
    if (const auto near = b.surface_near(there, motion, options.reach)) {
      const double off = distance_from_surface(there, motion, b.features().samples[*near]);
      moved.point = moved.point - off / motion.scale * f.normal;
    }
    trial.by_chance += b.vertex_near(moved, motion, options.tolerance).has_value();
  }
  return trial;
}

/// How one point of a line does.
struct Sample_trial {
  bool in_overlap = false, on_surface = false;
  int by_chance = 0;
};
constexpr int shifts = 6;

Sample_trial try_sample(const Line_sample& s, const Target& b, const Similarity& motion,
                        const Evidence_options& options) {
  Sample_trial trial;
  const auto near = b.surface_near(s, motion, options.reach);
  if (!near)
    return trial;
  trial.in_overlap = true;
  const double close = options.tolerance / 4;
  trial.on_surface = std::abs(distance_from_surface(s, motion, b.features().samples[*near])) <= close;
  for (int i = 0; i < shifts; ++i) {
    Similarity wrong = motion;
    wrong.translation[std::size_t(i / 2)] += (i % 2 == 0 ? 2 : -2) * options.tolerance;
    if (const auto other = b.surface_near(s, wrong, options.reach))
      trial.by_chance += std::abs(distance_from_surface(s, wrong, b.features().samples[*other])) <= close;
  }
  return trial;
}

} // namespace

Registration_evidence gather_evidence(const Features& a, const Target& b, const Similarity& motion,
                                      const Evidence_options& options, Thread_pool& threads) {
  std::mt19937 random(options.seed);
  std::vector<double> angles(a.vertices.size());
  for (double& angle : angles)
    angle = 2 * std::numbers::pi * (double(random()) / 4294967296.0);
  std::vector<Trial> trials(a.vertices.size());
  threads.for_each(trials.size(), 8,
                   [&](std::size_t i) { trials[i] = try_vertex(a.vertices[i], b, motion, options, angles[i]); });
  std::vector<Sample_trial> samples(a.samples.size());
  threads.for_each(samples.size(), 32,
                   [&](std::size_t i) { samples[i] = try_sample(a.samples[i], b, motion, options); });

  Registration_evidence evidence;
  double by_chance = 0;
  for (const Trial& t : trials) {
    evidence.vertices += t.in_overlap;
    evidence.matched += t.matched;
    by_chance += t.by_chance;
  }
  // What was not met once may still be.
  const double asked = double(displacements) * double(evidence.vertices);
  evidence.chance = asked > 0 ? std::max(by_chance, 0.5) / asked : 1;
  double near = 0, on_surface = 0, on_surface_by_chance = 0;
  for (const Sample_trial& s : samples) {
    near += s.in_overlap;
    on_surface += s.on_surface;
    on_surface_by_chance += s.by_chance;
  }
  if (near > 0) {
    evidence.overlap = near / double(samples.size());
    evidence.on_surface = on_surface / near;
    evidence.on_surface_by_chance = on_surface_by_chance / near / shifts;
  }
  // Two vertices of each mesh made the motion: that they match says nothing.
  if (evidence.matched > 2)
    evidence.log10_significance =
        std::min(0.0, log10_tail(evidence.matched - 2, evidence.vertices - 2, evidence.chance) +
                          std::log10(std::max(1.0, options.tried)));
  return evidence;
}

namespace {

double share_of(const Registration_evidence& e) {
  return e.vertices > 0 ? double(e.matched) / double(e.vertices) : 0;
}

} // namespace

bool speaks_by_vertices(const Registration_evidence& e) {
  return e.log10_significance < -6 && share_of(e) >= 0.35 && share_of(e) >= 2.5 * e.chance && e.on_surface >= 0.4;
}

std::string objection(const Registration_evidence& e, const Alignment& alignment, double tolerance) {
  if (!alignment.determined)
    return "the vertices and lines that match do not fix a motion";
  // On smooth surfaces noise moves extremal points along flat extrema of the curvature, farther than the tolerance, but lines
  // stay on the surface. That tells a motion too, if the surface cannot slide along itself.
  const bool fixed = alignment.translation_error < 0.2 * tolerance && alignment.rotation_error < 0.02;
  const bool by_surface =
      fixed && e.overlap >= 0.6 && e.on_surface >= 0.85 && e.on_surface >= 2 * e.on_surface_by_chance;
  if (speaks_by_vertices(e) || by_surface)
    return "";
  return fmt::format("of {} vertices where the meshes overlap {:.0f} % match, {:.0f} % by chance, and {:.0f} % of the "
                     "lines there lie on the other surface, {:.0f} % by chance",
                     e.vertices, 100 * share_of(e), 100 * e.chance, 100 * e.on_surface, 100 * e.on_surface_by_chance);
}

} // namespace CGAL::Extremal_mesh_3
