// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_SRC_IMAGES_SPLINE_H
#define CGAL_EXTREMAL_MESH_3_SRC_IMAGES_SPLINE_H

#include "lanes.h"

#include <CGAL/Extremal_mesh_3/Voxels.h>
#include <CGAL/Extremal_mesh_3/types.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

/// The highest order of derivatives that is computed.
inline constexpr int max_spline_order = 4;

/// The weights of the `Degree + 1` coefficients around a point, `[m]` being those of the m-th derivative.
/// \tparam T  a number, or several in a vector: of that many points
template <int Degree, int Order, class T = double>
using Spline_weights = std::array<std::array<T, Degree + 1>, Order + 1>;

/// computes the values and derivatives up to `Order` of the uniform B-splines at the fraction `t` of a cell.
/// The coefficients are those of the nodes `i − (Degree−1)/2` to `i + (Degree+1)/2`, the point being `i + t`.
template <int Degree, int Order, class T>
[[gnu::always_inline]] inline Spline_weights<Degree, Order, T> spline_weights(const T& t) {
  Spline_weights<Degree, Order, T> weights;
  std::array<T, Degree + 1> b{T() + 1.0}; // of degree 0
#pragma GCC unroll 8
  for (int degree = 0; degree <= Degree; ++degree) {
    if (const int m = Degree - degree; m <= Order) {
      // The m-th derivative is the m-th difference of the B-splines of degree Degree − m.
      std::array<T, Degree + 1>& w = weights[static_cast<std::size_t>(m)];
      w = b;
#pragma GCC unroll 8
      for (int d = degree + 1; d <= Degree; ++d) {
#pragma GCC unroll 8
        for (auto l = static_cast<std::size_t>(d); l > 0; --l)
          w[l] = w[l - 1] - w[l];
        w[0] = -w[0];
      }
    }
    // The next degree, by Cox and de Boor's recursion on uniform knots; after the last one there is no room.
    const double scale = 1.0 / (degree + 1);
#pragma GCC unroll 8
    for (auto l = static_cast<std::size_t>(degree + 1); l > 0; --l)
      if (l <= Degree)
        b[l] = scale * ((t + static_cast<double>(degree) + 1.0 - static_cast<double>(l)) * b[l - 1] +
                        (1.0 - t + static_cast<double>(l)) * b[l]);
    b[0] *= scale * (1.0 - t);
  }
  return weights;
}

/// A volume of B-spline coefficients; beyond the border each is that at the border.
struct Spline_volume {
  Voxels coefficients; ///< the first axis fastest
  std::array<std::size_t, 3> size{};
};

/// The partial derivatives of a spline: `[a][b][c]` is ∂^(a+b+c) / ∂x^a ∂y^b ∂z^c, in units of the lattice.
using Partials =
    std::array<std::array<std::array<double, max_spline_order + 1>, max_spline_order + 1>, max_spline_order + 1>;

namespace internal {

/// what `evaluate_spline()` does, for whatever processor it is compiled for.
template <int Degree, int Order>
[[gnu::always_inline]] inline void evaluate_spline_here(const Spline_volume& volume, const Point& u,
                                                        Partials& partials) {
  constexpr std::size_t width = Degree + 1;
  constexpr std::size_t orders = Order + 1;
  Four_doubles fraction{};
  std::array<std::array<std::size_t, width>, 3> node; // of the coefficients
  for (std::size_t a = 0; a < 3; ++a) {
    // Farther out all coefficients are the same one, so that the spline is constant.
    const auto last = static_cast<double>(volume.size[a] - 1);
    const double x = std::clamp(u[a], -static_cast<double>(width), last + static_cast<double>(width));
    const double cell = std::floor(x);
    fraction[a] = x - cell;
    for (std::size_t l = 0; l < width; ++l)
      node[a][l] = static_cast<std::size_t>(std::clamp(cell + static_cast<double>(l) - (Degree - 1) / 2, 0.0, last));
  }
  const auto w = spline_weights<Degree, Order>(fraction); // [order][node][axis]
  // Rows are loaded as eight coefficients: of degree 5 the last two go into sums that nobody looks at.
  constexpr std::size_t lanes = 8;
  static_assert(width <= lanes);
  const bool within_row = node[0][width - 1] - node[0][0] == width - 1 && node[0][0] + lanes <= volume.size[0];

  // z first, then y, with the row along x side by side in the vector unit; the sums have a fixed order.
  Eight_doubles yz[orders][orders] = {}; // [order in z][order in y]
  for (std::size_t j = 0; j < width; ++j) {
    Eight_doubles z[orders] = {};
    for (std::size_t k = 0; k < width; ++k) {
      const float* row = volume.coefficients.data() + volume.size[0] * (node[1][j] + volume.size[1] * node[2][k]);
      float clamped[lanes] = {};
      if (within_row)
        row += node[0][0];
      else {
        for (std::size_t i = 0; i < width; ++i)
          clamped[i] = row[node[0][i]];
        row = clamped;
      }
      Eight_floats stored;
      std::memcpy(&stored, row, sizeof stored);
      const Eight_doubles c_x = __builtin_convertvector(stored, Eight_doubles);
#pragma GCC unroll 5
      for (std::size_t c = 0; c < orders; ++c)
        z[c] += w[c][k][2] * c_x;
    }
#pragma GCC unroll 5
    for (std::size_t c = 0; c < orders; ++c)
#pragma GCC unroll 5
      for (std::size_t b = 0; b + c < orders; ++b)
        yz[c][b] += w[b][j][1] * z[c];
  }
  for (std::size_t c = 0; c < orders; ++c)
    for (std::size_t b = 0; b + c < orders; ++b)
      for (std::size_t a = 0; a + b + c < orders; ++a) {
        double sum = 0;
#pragma GCC unroll 4
        for (std::size_t i = 0; i < width; i += 2)
          sum += w[a][i][0] * yz[c][b][i] + w[a][i + 1][0] * yz[c][b][i + 1];
        partials[a][b][c] = sum;
      }
}

} // namespace internal

/// computes the spline's derivatives of all orders up to `Order` at `u`, given in units of the lattice.
/// \pre `u` is finite
template <int Degree, int Order> void evaluate_spline(const Spline_volume& volume, const Point& u, Partials& partials) {
  internal::on_widest_vectors([&]() __attribute__((always_inline)) {
    internal::evaluate_spline_here<Degree, Order>(volume, u, partials);
  });
}

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_SRC_IMAGES_SPLINE_H
