// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_SRC_IMAGES_CHANGE_OF_COORDINATES_H
#define CGAL_EXTREMAL_MESH_3_SRC_IMAGES_CHANGE_OF_COORDINATES_H

#include "spline.h"

#include <optional>

namespace CGAL::Extremal_mesh_3 {

/// A 3×3 matrix by rows.
using Matrix = std::array<Vector, 3>;

/// The number of entries of a tensor with all indices, or of a symmetric one with only the sorted indices.
constexpr std::size_t tensor_size(int order) {
  return order == 0 ? 1 : 3 * tensor_size(order - 1);
}
constexpr std::size_t symmetric_size(int order) {
  return static_cast<std::size_t>((order + 1) * (order + 2) / 2);
}

/// Where the entries of a tensor with `Order` indices are found.
template <int Order> struct Tensor_entries {
  /// for each entry, how many of its indices are x, y and z
  std::array<std::array<std::size_t, 3>, tensor_size(Order)> powers{};
  /// the entries whose indices are sorted, in lexicographic order
  std::array<std::size_t, symmetric_size(Order)> sorted{};

  constexpr Tensor_entries() {
    std::size_t found = 0;
    for (std::size_t entry = 0; entry < powers.size(); ++entry) {
      bool is_sorted = true;
      std::size_t previous = 2;
      for (std::size_t digits = entry, position = 0; position < Order;
           ++position, digits /= 3) { // the last index first
        is_sorted = is_sorted && digits % 3 <= previous;
        previous = digits % 3;
        ++powers[entry][previous];
      }
      if (is_sorted)
        sorted[found++] = entry;
    }
  }
};

inline bool is_diagonal(const Matrix& J) {
  return J[0][1] == 0 && J[0][2] == 0 && J[1][0] == 0 && J[1][2] == 0 && J[2][0] == 0 && J[2][1] == 0;
}

/// takes the partial derivatives of order `Order` of a function F to those of the function `p ↦ scale · F(J p)`.
/// \param out  the entries with sorted indices, as in `Derivatives`
template <int Order>
void change_coordinates(const Partials& partials, const Matrix& J, double scale,
                        std::array<double, symmetric_size(Order)>& out) {
  static constexpr Tensor_entries<Order> entries;
  constexpr std::size_t n = tensor_size(Order);
  if (is_diagonal(J)) { // most images have their axes along the coordinates
    std::array<std::array<double, Order + 1>, 3> powers;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      powers[axis][0] = 1;
      for (std::size_t i = 1; i <= Order; ++i)
        powers[axis][i] = powers[axis][i - 1] * J[axis][axis];
    }
    for (std::size_t entry = 0; entry < out.size(); ++entry) {
      const auto& [a, b, c] = entries.powers[entries.sorted[entry]];
      out[entry] = scale * partials[a][b][c] * (powers[0][a] * powers[1][b] * powers[2][c]);
    }
    return;
  }
  std::array<double, n> t;
  for (std::size_t entry = 0; entry < n; ++entry) {
    const auto& power = entries.powers[entry];
    t[entry] = scale * partials[power[0]][power[1]][power[2]];
  }
  // Each round transforms the first index and moves it to the end, so that after all rounds they stand as before.
  for (int round = 0; round < Order; ++round) {
    std::array<double, n> next;
    for (std::size_t rest = 0; rest < n / 3; ++rest)
      for (std::size_t i = 0; i < 3; ++i)
        next[3 * rest + i] = J[0][i] * t[rest] + J[1][i] * t[rest + n / 3] + J[2][i] * t[rest + 2 * (n / 3)];
    t = next;
  }
  for (std::size_t entry = 0; entry < out.size(); ++entry)
    out[entry] = t[entries.sorted[entry]];
}

/// inverts the matrix whose columns are given.
/// \return nothing if the columns are not finite or (all but) dependent
std::optional<Matrix> inverse_of_columns(const std::array<Vector, 3>& columns);

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_SRC_IMAGES_CHANGE_OF_COORDINATES_H
