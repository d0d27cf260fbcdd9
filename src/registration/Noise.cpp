// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Correlations have the form of [Wendland, "Piecewise polynomial, positive definite and compactly supported radial functions of minimal
// degree", 1995]: close to the Gaussian's, but 0 from the range on, so that matrices are sparse, and positive definite.
#include "Noise.h"

#include "../cgal/Point_tree.h"
#include "../differential/vector.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL::Extremal_mesh_3 {

namespace {

double wendland(double r) {
  if (r >= 1)
    return 0;
  const double s = (1 - r) * (1 - r);
  return s * s * (4 * r + 1);
}

/// The mean products of values, by the distance of their points.
struct Correlogram {
  static constexpr std::size_t bins = 24;
  std::array<double, bins> products{}, pairs{};

  void add(const Correlogram& other) {
    for (std::size_t i = 0; i < bins; ++i) {
      products[i] += other.products[i];
      pairs[i] += other.pairs[i];
    }
  }
  double mean(std::size_t bin) const { return pairs[bin] > 0 ? products[bin] / pairs[bin] : 0; }
};

Correlogram correlogram_of(const std::vector<Point>& points, const std::vector<double>& values, double longest,
                           Thread_pool& threads) {
  constexpr std::size_t enough = 2000;
  const std::size_t step = 1 + points.size() / enough, asked = (points.size() + step - 1) / step;
  const Point_tree<3> tree(points);
  std::vector<Correlogram> of_points(asked);
  threads.for_each(asked, 16, [&](std::size_t k) {
    const std::size_t i = k * step;
    for (const std::uint32_t j : tree.all_within(points[i], longest))
      if (j != i) {
        const double r = distance(points[i], points[j]) / longest;
        const std::size_t bin = std::min(Correlogram::bins - 1, std::size_t(r * double(Correlogram::bins)));
        of_points[k].products[bin] += values[i] * values[j];
        of_points[k].pairs[bin] += 1;
      }
  });
  Correlogram sum;
  for (const Correlogram& c : of_points)
    sum.add(c);
  return sum;
}

} // namespace

double mean_number_of_neighbours(const std::vector<Point>& points, double within, Thread_pool& threads) {
  constexpr std::size_t enough = 500;
  const std::size_t step = 1 + points.size() / enough, asked = (points.size() + step - 1) / step;
  const Point_tree<3> tree(points);
  std::vector<std::size_t> numbers(asked);
  threads.for_each(asked, 16,
                   [&](std::size_t k) { numbers[k] = tree.all_within(points[k * step], within).size() - 1; });
  double sum = 0;
  for (const std::size_t number : numbers)
    sum += double(number);
  return asked > 0 ? sum / double(asked) : 0;
}

double Noise::correlation(double distance) const {
  return range > 0 ? (1 - own) * wendland(distance / range) : 0;
}

Noise estimate_noise(const std::vector<Point>& points, const std::vector<double>& values, double longest,
                     Thread_pool& threads) {
  Noise noise;
  for (const double v : values)
    noise.variance += v * v / double(values.size());
  if (!(noise.variance > 0 && longest > 0))
    return noise;
  const Correlogram found = correlogram_of(points, values, longest, threads);
  // Of each range the amplitude that fits best; of these, the best. Without correlation nothing is explained.
  double best = 0, amplitude = 0;
  constexpr int ranges = 24;
  for (int k = 1; k <= ranges; ++k) {
    const double range = longest * k / ranges;
    double product = 0, square = 0;
    for (std::size_t bin = 0; bin < Correlogram::bins; ++bin) {
      const double r = (double(bin) + 0.5) / double(Correlogram::bins) * longest / range, form = wendland(r);
      product += found.pairs[bin] * form * found.mean(bin);
      square += found.pairs[bin] * form * form;
    }
    if (product > 0 && product * product / square > best) {
      best = product * product / square;
      amplitude = product / square;
      noise.range = range;
    }
  }
  // A model of the noise that is a little wrong, and what surfaces differ by beside noise, do harm where neighbours are trusted to differ
  // by less than a part of the noise: so much at least is taken for each point's own.
  constexpr double least_own = 0.2;
  noise.own = std::clamp(1 - amplitude / noise.variance, least_own, 1.0);
  return noise;
}

Covariance_matrix::Covariance_matrix(const std::vector<Point>& points, const std::vector<double>& weights,
                                     const Noise& noise, Thread_pool& threads)
    : rows_(points.size()) {
  for (const double w : weights)
    diagonal_.push_back(noise.variance * (1 - noise.own + noise.own / w));
  if (!(noise.range > 0 && noise.own < 1))
    return;
  const Point_tree<3> tree(points);
  threads.for_each(points.size(), 16, [&](std::size_t i) {
    for (const std::uint32_t j : tree.all_within(points[i], noise.range))
      if (j != i)
        rows_[i].push_back({j, float(noise.variance * noise.correlation(distance(points[i], points[j])))});
  });
}

std::vector<double> Covariance_matrix::multiplied(const std::vector<double>& x, Thread_pool& threads) const {
  std::vector<double> result(x.size());
  threads.for_each(x.size(), 64, [&](std::size_t i) {
    double sum = diagonal_[i] * x[i];
    for (const Entry& e : rows_[i])
      sum += double(e.value) * x[e.column];
    result[i] = sum;
  });
  return result;
}

std::vector<double> Covariance_matrix::solve(const std::vector<double>& b, Thread_pool& threads) const {
  // preconditioned by the diagonal
  const std::size_t n = b.size();
  std::vector<double> x(n), r = b, z(n), p(n);
  const auto product = [n](const std::vector<double>& u, const std::vector<double>& v) {
    double sum = 0;
    for (std::size_t i = 0; i < n; ++i)
      sum += u[i] * v[i];
    return sum;
  };
  double rho = 0, goal = 0;
  constexpr int most_steps = 300; // some thirty are taken
  constexpr double accuracy = 1e-6;
  for (int step = 0; step < most_steps; ++step) {
    for (std::size_t i = 0; i < n; ++i)
      z[i] = r[i] / diagonal_[i];
    const double before = rho;
    rho = product(r, z);
    if (step == 0)
      goal = accuracy * accuracy * rho;
    if (!(rho > goal))
      break;
    const double beta = step == 0 ? 0 : rho / before;
    for (std::size_t i = 0; i < n; ++i)
      p[i] = z[i] + beta * p[i];
    const std::vector<double> q = multiplied(p, threads);
    const double alpha = rho / product(p, q);
    for (std::size_t i = 0; i < n; ++i) {
      x[i] += alpha * p[i];
      r[i] -= alpha * q[i];
    }
  }
  return x;
}

} // namespace CGAL::Extremal_mesh_3
