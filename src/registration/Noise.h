// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_REGISTRATION_NOISE_H
#define EXTREMAL_MESH_3_SRC_REGISTRATION_NOISE_H

#include "../cells/parallel.h"

#include <CGAL/Extremal_mesh_3/types.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

/// Noise on a surface that depends on itself within a range, as after smoothing.
struct Noise {
  double variance = 0;
  double own = 1;   ///< the share of the variance that each point has of its own
  double range = 0; ///< points farther apart have nothing in common

  /// of the noise at two different points at this distance.
  double correlation(double distance) const;
};

/// estimates the noise from its values at points of a surface.
/// \param longest  range
Noise estimate_noise(const std::vector<Point>& points, const std::vector<double>& values, double longest,
                     Thread_pool& threads);

/// the number of points within a distance of a point, in the mean over some of them.
double mean_number_of_neighbours(const std::vector<Point>& points, double within, Thread_pool& threads);

/// The covariances of noise at points, without those that are 0.
class Covariance_matrix {
public:
  /// \param weights  in (0, 1]: a point's own noise is that of `noise` divided by it
  Covariance_matrix(const std::vector<Point>& points, const std::vector<double>& weights, const Noise& noise,
                    Thread_pool& threads);
  /// solves C x = b for x, by conjugate gradients.
  std::vector<double> solve(const std::vector<double>& b, Thread_pool& threads) const;

private:
  std::vector<double> multiplied(const std::vector<double>& x, Thread_pool& threads) const;

  struct Entry {
    std::uint32_t column;
    float value;
  };
  std::vector<std::vector<Entry>> rows_; ///< without the diagonal
  std::vector<double> diagonal_;
};

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_REGISTRATION_NOISE_H
