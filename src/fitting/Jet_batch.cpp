// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Jet_batch.h"

#include "../images/lanes.h"

#include <algorithm>
#include <cmath>

namespace CGAL::Extremal_mesh_3 {

namespace {

// Of its own variance a coefficient of an even neighbourhood leaves 1e-1 to 1e-3 to the others. Below this, it is
// rounding.
constexpr double least_pivot = 1e-11;

void sum_up(const Wide_point* points, std::size_t count, Jet_sums& sums) {
#ifdef EXTREMAL_MESH_3_HAS_AVX_SOURCES
  static const bool has_avx2 = __builtin_cpu_supports("avx2"), has_avx512 = internal::has_avx512();
  if (has_avx512)
    return sum_up_with_avx512(points, count, sums);
  if (has_avx2)
    return sum_up_with_avx2(points, count, sums);
#endif
  sum_up_anywhere(points, count, sums);
}

Jet jet_in_lane(const Jet_sums& s, std::size_t l, std::size_t count) {
  Jet jet;
  jet.determined = s.least_pivot[l] > least_pivot;
  if (!jet.determined)
    return jet;
  for (std::size_t m = 0; m < jet_size; ++m)
    jet.coefficients[m] = s.coefficients[m][l];
  jet.condition = std::sqrt(s.inflation[l]);
  jet.residual = std::sqrt(s.square[l] / s.weight[l]);
  if (count == jet_size)
    return jet; // which then meets all points
  jet.noise = jet.residual / std::sqrt(double(count - jet_size) / double(count));
  // Exact for equal weights. With those that fall to 0 at the radius, the errors are too large: by 7 % and by 28 %,
  // measured with noise on even and uneven planes of 30 to 700 points.
  const double unit = s.weight2[l] / s.weight[l];
  jet.second_error = std::sqrt(unit * s.second_variance[l]);
  jet.third_error = std::sqrt(unit * s.third_variance[l]);
  return jet;
}

} // namespace

void Jet_batch::begin(std::size_t points) {
  if (points_.size() < points)
    points_.resize(points);
  counts_[size_++] = points;
}

std::array<Jet, lanes> Jet_batch::fit() {
  const std::size_t most = *std::max_element(counts_.begin(), counts_.begin() + std::ptrdiff_t(size_));
  for (std::size_t l = 0; l < lanes; ++l)
    for (std::size_t k = l < size_ ? counts_[l] : 0; k < most; ++k) // a weight of 0 changes no sum
      points_[k].x[l] = points_[k].y[l] = points_[k].z[l] = points_[k].weight[l] = 0;
  Jet_sums sums;
  sum_up(points_.data(), most, sums);
  std::array<Jet, lanes> jets;
  for (std::size_t l = 0; l < size_; ++l)
    jets[l] = jet_in_lane(sums, l, counts_[l]);
  return jets;
}

} // namespace CGAL::Extremal_mesh_3
