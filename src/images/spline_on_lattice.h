// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A spline at places that the lattice gives: there weights are the same everywhere, and many points share their sums.
#ifndef CGAL_EXTREMAL_MESH_3_SRC_IMAGES_SPLINE_ON_LATTICE_H
#define CGAL_EXTREMAL_MESH_3_SRC_IMAGES_SPLINE_ON_LATTICE_H

#include "spline.h"

namespace CGAL::Extremal_mesh_3 {

/// The coefficients around a cube, in rows of eight along x of which the first `Degree + 1` are used: [z][y].
template <int Degree> struct Local_coefficients {
  static constexpr std::size_t width = Degree + 1;
  float rows[width][width][8] = {};

  /// \param cube  its first corner; that of a node at the far end of the lattice may be given
  Local_coefficients(const Spline_volume& volume, const std::array<std::size_t, 3>& cube) {
    constexpr std::size_t before = (Degree - 1) / 2;
    const auto node = [&](std::size_t axis, std::size_t l) {
      return std::clamp(cube[axis] + l, before, volume.size[axis] - 1 + before) - before;
    };
    const bool within_row = cube[0] >= before && cube[0] - before + 8 <= volume.size[0];
    for (std::size_t k = 0; k < width; ++k)
      for (std::size_t j = 0; j < width; ++j) {
        const float* const row =
            volume.coefficients.data() + volume.size[0] * (node(1, j) + volume.size[1] * node(2, k));
        if (within_row)
          std::memcpy(rows[k][j], row + (cube[0] - before), sizeof rows[k][j]);
        else
          for (std::size_t i = 0; i < width; ++i)
            rows[k][j][i] = row[node(0, i)];
      }
  }

  /// (A vector returned would depend on what it is compiled for.)
  [[gnu::always_inline]] void add_row(double weight, std::size_t k, std::size_t j, Eight_doubles& sum) const {
    Eight_floats stored;
    std::memcpy(&stored, rows[k][j], sizeof stored);
    sum += weight * __builtin_convertvector(stored, Eight_doubles);
  }
};

/// computes the spline at the corners of a cube and half way between them: `out[a + 3·b + 9·c]` at (a, b, c)/2.
template <int Degree>
[[gnu::always_inline]] inline void half_step_values(const Spline_volume& volume, const std::array<std::size_t, 3>& cube,
                                                    std::array<double, 27>& out) {
  constexpr std::size_t width = Degree + 1;
  const Local_coefficients<Degree> local(volume, cube);
  std::array<std::array<double, width>, 3> w;
  for (std::size_t s = 0; s < 3; ++s)
    w[s] = spline_weights<Degree, 0>(0.5 * static_cast<double>(s))[0];
  Eight_doubles yz[3][3] = {};
  for (std::size_t j = 0; j < width; ++j) {
    Eight_doubles z[3] = {};
    for (std::size_t k = 0; k < width; ++k) {
#pragma GCC unroll 3
      for (std::size_t c = 0; c < 3; ++c)
        local.add_row(w[c][k], k, j, z[c]);
    }
#pragma GCC unroll 3
    for (std::size_t c = 0; c < 3; ++c)
#pragma GCC unroll 3
      for (std::size_t b = 0; b < 3; ++b)
        yz[c][b] += w[b][j] * z[c];
  }
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t b = 0; b < 3; ++b)
      for (std::size_t a = 0; a < 3; ++a) {
        double sum = 0;
#pragma GCC unroll 4
        for (std::size_t i = 0; i < width; i += 2)
          sum += w[a][i] * yz[c][b][i] + w[a][i + 1] * yz[c][b][i + 1];
        out[a + 3 * b + 9 * c] = sum;
      }
}

/// A polynomial, from the constant up.
template <int Degree> using Polynomial = std::array<double, Degree + 1>;

/// makes the polynomial that the spline is on an edge of the lattice, on [0, 1].
/// \param node  where the edge begins
template <int Degree>
[[gnu::always_inline]] inline Polynomial<Degree>
polynomial_on_edge(const Spline_volume& volume, const std::array<std::size_t, 3>& node, std::size_t axis) {
  constexpr std::size_t width = Degree + 1;
  const Local_coefficients<Degree> local(volume, node);
  const Spline_weights<Degree, Degree> at_node = spline_weights<Degree, Degree>(0.0);
  const std::array<double, width>& w =
      at_node[0];                    // the last one is 0: seen from the node, the coefficients lie symmetrically
  std::array<double, width> along{}; // the coefficients of the spline on the line of the edge
  if (axis == 2)
    for (std::size_t k = 0; k < width; ++k) {
      Eight_doubles sum{};
      for (std::size_t j = 0; j + 1 < width; ++j)
        local.add_row(w[j], k, j, sum);
      for (std::size_t i = 0; i + 1 < width; ++i)
        along[k] += w[i] * sum[i];
    }
  else {
    Eight_doubles across[width];
    for (std::size_t j = 0; j < width; ++j) {
      across[j] = Eight_doubles{};
      for (std::size_t k = 0; k + 1 < width; ++k)
        local.add_row(w[k], k, j, across[j]);
    }
    if (axis == 1)
      for (std::size_t j = 0; j < width; ++j)
        for (std::size_t i = 0; i + 1 < width; ++i)
          along[j] += w[i] * across[j][i];
    else {
      Eight_doubles sum{};
      for (std::size_t j = 0; j + 1 < width; ++j)
        sum += w[j] * across[j];
      for (std::size_t i = 0; i < width; ++i)
        along[i] = sum[i];
    }
  }
  // By Taylor's formula at the node.
  Polynomial<Degree> polynomial{};
  double factorial = 1;
  for (std::size_t m = 0; m < width; ++m) {
    for (std::size_t l = 0; l < width; ++l)
      polynomial[m] += at_node[m][l] * along[l];
    polynomial[m] /= factorial;
    factorial *= static_cast<double>(m + 1);
  }
  return polynomial;
}

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_SRC_IMAGES_SPLINE_ON_LATTICE_H
