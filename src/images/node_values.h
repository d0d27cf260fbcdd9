// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_SRC_IMAGES_NODE_VALUES_H
#define CGAL_EXTREMAL_MESH_3_SRC_IMAGES_NODE_VALUES_H

#include "spline.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

namespace internal {

/// what `node_values()` does, for whatever processor it is compiled for.
template <int Degree>
[[gnu::always_inline]] inline void node_values_here(const Spline_volume& volume, std::size_t k, double iso,
                                                    double* out) {
  constexpr std::size_t radius = (Degree - 1) / 2;
  const auto [nx, ny, nz] = volume.size;
  std::array<double, radius + 1> w; // w[0] is the centre's
  for (std::size_t r = 0; r <= radius; ++r)
    w[r] = spline_weights<Degree, 0>(0.0)[0][radius - r];

  const auto clamped = [](std::size_t i, std::size_t n) { return std::clamp(i, +radius, radius + n - 1) - radius; };
  std::array<const float*, 2 * radius + 1> slices;
  for (std::size_t r = 0; r < slices.size(); ++r)
    slices[r] = volume.coefficients.data() + clamped(k + r, nz) * nx * ny;

  // The rows of the slice filtered along z, the last few of them in turn: row j − radius + r is lines[(j + r) % n].
  // Lines a multiple of 2 or 4 kB apart would get into each other's way in the first cache.
  const std::size_t stride = (nx + 2 * radius) / 64 * 64 + 64 + 40;
  std::vector<double> buffer((slices.size() + 1) * stride);
  double* const lines = buffer.data();
  double* const padded = lines + slices.size() * stride;
  const auto filter_along_z = [&, nx = nx, ny = ny ](std::size_t r) __attribute__((always_inline)) {
    const std::size_t first = clamped(r, ny) * nx;
    double* const line = lines + r % slices.size() * stride;
#pragma GCC ivdep
    for (std::size_t i = 0; i < nx; ++i) {
      double sum = w[0] * static_cast<double>(slices[radius][first + i]);
      for (std::size_t s = 1; s <= radius; ++s)
        sum += w[s] * (static_cast<double>(slices[radius - s][first + i]) +
                       static_cast<double>(slices[radius + s][first + i]));
      line[i] = sum;
    }
  };
  for (std::size_t r = 0; r < 2 * radius; ++r)
    filter_along_z(r);
  for (std::size_t j = 0; j < ny; ++j) {
    filter_along_z(j + 2 * radius);
    std::array<const double*, 2 * radius + 1> rows;
    for (std::size_t r = 0; r < rows.size(); ++r)
      rows[r] = lines + (j + r) % rows.size() * stride;
#pragma GCC ivdep
    for (std::size_t i = 0; i < nx; ++i) {
      double sum = w[0] * rows[radius][i];
      for (std::size_t s = 1; s <= radius; ++s)
        sum += w[s] * (rows[radius - s][i] + rows[radius + s][i]);
      padded[radius + i] = sum;
    }
    std::fill_n(padded, radius, padded[radius]);
    std::fill_n(padded + radius + nx, radius, padded[radius + nx - 1]);
#pragma GCC ivdep
    for (std::size_t i = 0; i < nx; ++i) {
      double sum = w[0] * padded[radius + i];
      for (std::size_t s = 1; s <= radius; ++s)
        sum += w[s] * (padded[radius + i - s] + padded[radius + i + s]);
      out[nx * j + i] = iso - sum;
    }
  }
}

} // namespace internal

/// computes `iso` minus the spline at all nodes (·,·,k): at a node a spline is a small symmetric filter of its
/// coefficients, [1 26 66 26 1]/120 along each axis for degree 5.
/// \param out  `size[0]·size[1]` values
template <int Degree> void node_values(const Spline_volume& volume, std::size_t k, double iso, double* out) {
  internal::on_widest_vectors([&]() __attribute__((always_inline)) {
    internal::node_values_here<Degree>(volume, k, iso, out);
  });
}

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_SRC_IMAGES_NODE_VALUES_H
