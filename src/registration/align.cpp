// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Iterated closest points with Tukey's biweight, whose scale is the median of the residuals of each sort.
#include "align.h"

#include "residuals.h"
#include "standard_errors.h"

#include <algorithm>
#include <cmath>

namespace CGAL::Extremal_mesh_3 {

namespace {

Normal_equations equations_of(const std::vector<Residual>& residuals, const Change_frame& frame, bool scale) {
  Normal_equations equations;
  for (const Residual& r : residuals)
    if (r.weight > 0)
      equations.add(frame.derivative(r), r.value, r.weight);
  if (!scale)
    equations.hold(6);
  return equations;
}

std::vector<Contribution> contributions_of(const std::vector<Residual>& residuals, const Change_frame& frame) {
  std::vector<Contribution> contributions;
  for (const Residual& r : residuals)
    if (r.weight > 0) {
      Contribution& c = contributions.emplace_back(Contribution{r.point, frame.derivative(r)});
      for (double& x : c.sum)
        x *= r.weight * r.value;
    }
  return contributions;
}

} // namespace

Alignment align(const Features& a, const Target& b, const Similarity& start, const Alignment_options& options,
                Thread_pool* threads) {
  Alignment result;
  result.motion = start;
  // Samples that lie close to each other tell the same: those of a line count less the denser they lie.
  const double dense = options.block > 0 ? std::min(1.0, start.scale * a.spacing / options.block) : 1;
  const std::array<double, residual_sorts> share{dense, dense, 1};
  // rounds from the first gate to the last, each narrower by a fifth
  const double narrowing = std::ceil(std::log(options.first_gate / options.last_gate) / std::log(1.25));
  for (int round = 0; round < options.rounds; ++round) {
    const double t = narrowing > 0 ? std::min(1.0, double(round) / narrowing) : 1;
    const double gate = options.first_gate * std::pow(options.last_gate / options.first_gate, t);
    std::vector<Residual> residuals = find_residuals(a, b, result.motion, gate, threads);
    result.surface_rms = weigh(residuals, 1e-9 * options.last_gate, share);
    const Change_frame frame(residuals);
    result.determined = false;
    if (residuals.size() < unknowns || !(frame.size > 0))
      return result;
    const Normal_equations equations = equations_of(residuals, frame, options.scale);
    const auto inverse = equations.inverse();
    if (!inverse)
      return result;
    result.determined = true;
    const Unknowns by = *inverse * equations.right;
    result.motion = frame.changed(result.motion, by);
    double step = 0;
    for (const double x : by)
      step = std::max(step, std::abs(x));
    const bool converged = t == 1 && step < 1e-5 * options.last_gate;
    if (converged || round + 1 == options.rounds) {
      estimate_errors(result, contributions_of(residuals, frame), frame, options, *inverse);
      result.motion.rotation = nearest_rotation(result.motion.rotation); // without the rounding of all the rounds
      break;
    }
  }
  return result;
}

} // namespace CGAL::Extremal_mesh_3
