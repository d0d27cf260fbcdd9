// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Aitken's generalised least squares: residuals r with the covariance C and the derivatives J are met best by −(Jᵀ C⁻¹ J)⁻¹ Jᵀ C⁻¹ r.
#include "align_finely.h"

#include "../differential/vector.h"
#include "Noise.h"
#include "residuals.h"
#include "standard_errors.h"

#include <algorithm>
#include <cmath>

namespace CGAL::Extremal_mesh_3 {

namespace {

/// The distances between the surfaces that count.
struct Heights {
  std::vector<Point> points;
  std::vector<double> values, weights; ///< weights up to 1
  std::vector<Unknowns> derivatives;

  Heights(const std::vector<Residual>& residuals, const Change_frame& frame) {
    double most = 0;
    for (const Residual& r : residuals)
      if (r.sort == Residual_sort::surface)
        most = std::max(most, r.weight);
    for (const Residual& r : residuals)
      if (r.sort == Residual_sort::surface && r.weight > 0.01 * most) {
        points.push_back(r.point);
        values.push_back(r.value);
        weights.push_back(r.weight / most);
        derivatives.push_back(frame.derivative(r));
      }
  }

  /// leaves every n-th, if without that more than some hundred would lie within a distance of each.
  void thin(double within, Thread_pool& threads);
};

void Heights::thin(double within, Thread_pool& threads) {
  constexpr double most_neighbours = 300;
  const double neighbours = mean_number_of_neighbours(points, within, threads);
  const auto step = std::size_t(std::ceil(neighbours / most_neighbours));
  if (step < 2)
    return;
  const auto keep = [step](auto& all) {
    for (std::size_t i = 0; i * step < all.size(); ++i)
      all[i] = all[i * step];
    all.resize((all.size() + step - 1) / step);
  };
  keep(points);
  keep(values);
  keep(weights);
  keep(derivatives);
}

/// The normal equations, and what each residual adds to them.
struct System {
  Normal_equations equations;
  std::vector<Contribution> contributions;

  void add(const Point& point, const Unknowns& weighted_derivative, double value) {
    Contribution c{point, {}};
    for (std::size_t i = 0; i < unknowns; ++i) {
      c.sum[i] = weighted_derivative[i] * value;
      equations.right[i] -= c.sum[i];
    }
    contributions.push_back(c);
  }
};

/// adds heights by the inverse of their covariance.
void add_heights(System& system, const Heights& heights, const Noise& noise, Thread_pool& threads) {
  const Covariance_matrix covariance(heights.points, heights.weights, noise, threads);
  const std::size_t n = heights.points.size();
  std::vector<Unknowns> weighted(n); // C⁻¹ J
  for (std::size_t i = 0; i < unknowns; ++i) {
    std::vector<double> column(n);
    for (std::size_t k = 0; k < n; ++k)
      column[k] = heights.derivatives[k][i];
    column = covariance.solve(column, threads);
    for (std::size_t k = 0; k < n; ++k)
      weighted[k][i] = column[k];
  }
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t i = 0; i < unknowns; ++i)
      for (std::size_t j = 0; j < unknowns; ++j)
        system.equations.matrix[i][j] +=
            0.5 * (heights.derivatives[k][i] * weighted[k][j] + heights.derivatives[k][j] * weighted[k][i]);
    system.add(heights.points[k], weighted[k], heights.values[k]);
  }
}

/// adds the distances from lines and vertices, which no matrix joins, by their weights.
void add_others(System& system, const std::vector<Residual>& residuals, const Change_frame& frame) {
  for (const Residual& r : residuals)
    if (r.sort != Residual_sort::surface && r.weight > 0) {
      Unknowns derivative = frame.derivative(r);
      for (std::size_t i = 0; i < unknowns; ++i)
        for (std::size_t j = 0; j < unknowns; ++j)
          system.equations.matrix[i][j] += r.weight * derivative[i] * derivative[j];
      for (double& d : derivative)
        d *= r.weight;
      system.add(r.point, derivative, r.value);
    }
}

} // namespace

Alignment align_finely(const Fine_features& a, const Fine_features& b, const Alignment& start,
                       const Alignment_options& options, Thread_pool& threads) {
  Alignment result = start;
  const double dense = std::min(1.0, start.motion.scale * a.sparse.spacing / options.block);
  constexpr int most_rounds = 5; // two, as a rule
  for (int round = 0; round < most_rounds; ++round) {
    std::vector<Residual> residuals = find_residuals(a.sparse, b.dense, result.motion, options.last_gate, &threads);
    const std::vector<Residual> back =
        find_residuals_back(b.sparse, a.dense, result.motion.inverse(), options.last_gate, threads);
    residuals.insert(residuals.end(), back.begin(), back.end());
    const double rms = weigh(residuals, 1e-9 * options.last_gate, {1, dense, 1});
    const Change_frame frame(residuals);
    Heights heights(residuals, frame);
    if (heights.points.size() < unknowns || !(frame.size > 0))
      return result;
    const Noise noise = estimate_noise(heights.points, heights.values, options.block, threads);
    heights.thin(noise.range, threads);
    System system;
    add_heights(system, heights, noise, threads);
    add_others(system, residuals, frame);
    if (!options.scale)
      system.equations.hold(6);
    const auto inverse = system.equations.inverse();
    if (!inverse)
      return result;
    const Unknowns by = *inverse * system.equations.right;
    result.motion = frame.changed(result.motion, by);
    result.motion.rotation = nearest_rotation(result.motion.rotation);
    result.surface_rms = rms;
    estimate_errors(result, system.contributions, frame, options, *inverse);
    const double turn = norm({by[0], by[1], by[2]}) / frame.size, shift = norm({by[3], by[4], by[5]});
    constexpr double little = 0.05; // in standard errors
    if (turn <= little * result.rotation_error && shift <= little * result.translation_error)
      break;
  }
  return result;
}

} // namespace CGAL::Extremal_mesh_3
