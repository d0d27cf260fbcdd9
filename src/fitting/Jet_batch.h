// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_FITTING_JET_BATCH_H
#define EXTREMAL_MESH_3_SRC_FITTING_JET_BATCH_H

#include "Jet_sums.h"

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

/// The polynomial of degree 4 that is closest to the heights of some points, and how close.
struct Jet {
  std::array<double, jet_size> coefficients{};
  bool determined = false; ///< by the points; otherwise nothing else here means anything
  double condition = 0;    ///< √ of the largest variance inflation of a coefficient
  double residual = 0;     ///< root mean square, weighted
  double noise = 0;        ///< standard deviation of the heights that such residuals imply
  /// standard errors for a noise of 1 that is independent from point to point: of the second derivative along a unit
  /// tangent, and of the third; root mean square over all tangents
  double second_error = 0, third_error = 0;
};

/// Some neighbourhoods whose jets are computed at once. No lane has an influence on another, so it does not matter how
/// neighbourhoods are put together.
class Jet_batch {
public:
  std::size_t size() const { return size_; }
  bool full() const { return size_ == lanes; }
  void clear() { size_ = 0; }

  /// begins the next neighbourhood.
  /// \pre not full
  void begin(std::size_t points);
  /// sets a point of it: coordinates, at most about 1 in size, and a weight.
  void set(std::size_t point, double x, double y, double z, double weight) {
    Wide_point& p = points_[point];
    const std::size_t lane = size_ - 1;
    p.x[lane] = x;
    p.y[lane] = y;
    p.z[lane] = z;
    p.weight[lane] = weight;
  }

  /// fits the jets by least squares.
  std::array<Jet, lanes> fit();

private:
  std::vector<Wide_point> points_;
  std::array<std::size_t, lanes> counts_{};
  std::size_t size_ = 0;
};

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_FITTING_JET_BATCH_H
