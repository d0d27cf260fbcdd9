// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_BENCHMARK_COMPARISON_WAVES_H
#define EXTREMAL_MESH_3_BENCHMARK_COMPARISON_WAVES_H

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

/// A sum of plane waves, of which it is known what a Gaussian makes: to compare derivatives with.
class Waves {
public:
  static constexpr std::size_t size = 64, margin = 20; ///< of the volume; of the part where borders do not matter
  static constexpr double sigma = 1.5;

  /// the derivative of these orders of the smoothed waves.
  double derivative(const std::array<double, 3>& p, const std::array<int, 3>& orders, double with_sigma = sigma) const {
    double sum = 0;
    for (const auto& k : waves_) {
      const double phase = k[0] * p[0] + k[1] * p[1] + k[2] * p[2];
      const double damping = std::exp(-0.5 * with_sigma * with_sigma * (k[0] * k[0] + k[1] * k[1] + k[2] * k[2]));
      double factor = damping;
      for (std::size_t a = 0; a < 3; ++a)
        factor *= std::pow(k[a], orders[a]);
      constexpr double half_pi = 1.5707963267948966;
      sum += factor * std::cos(phase + half_pi * (orders[0] + orders[1] + orders[2]));
    }
    return sum;
  }

  std::vector<float> voxels() const {
    std::vector<float> values;
    for (std::size_t k = 0; k < size; ++k)
      for (std::size_t j = 0; j < size; ++j)
        for (std::size_t i = 0; i < size; ++i)
          values.push_back(float(derivative({double(i), double(j), double(k)}, {0, 0, 0}, 0)));
    return values;
  }

  /// the orders of the third derivatives, in the library's order.
  static constexpr std::array<std::array<int, 3>, 10> third{
      {{3, 0, 0}, {2, 1, 0}, {2, 0, 1}, {1, 2, 0}, {1, 1, 1}, {1, 0, 2}, {0, 3, 0}, {0, 2, 1}, {0, 1, 2}, {0, 0, 3}}};

private:
  std::array<std::array<double, 3>, 4> waves_{
      {{0.42, 0.11, -0.2}, {-0.13, 0.51, 0.24}, {0.31, -0.27, 0.39}, {0.05, 0.33, -0.6}}};
};

/// The root of the mean square of errors over that of exact values.
class Relative_error {
public:
  void add(double value, double exact) {
    errors_ += (value - exact) * (value - exact);
    exact_ += exact * exact;
  }
  double value() const { return std::sqrt(errors_ / exact_); }

private:
  double errors_ = 0, exact_ = 0;
};

#endif // EXTREMAL_MESH_3_BENCHMARK_COMPARISON_WAVES_H
