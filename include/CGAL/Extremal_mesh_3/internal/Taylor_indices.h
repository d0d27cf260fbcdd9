// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_INTERNAL_TAYLOR_INDICES_H
#define CGAL_EXTREMAL_MESH_3_INTERNAL_TAYLOR_INDICES_H

// How the coefficients of a Taylor polynomial in three variables are numbered: by total degree, and within a degree
// as the entries of Derivatives (1 | x y z | xx xy xz yy yz zz | xxx ...). A lower order is a prefix of a higher one.

#include <CGAL/Extremal_mesh_3/Derivatives.h>

#include <array>
#include <cstddef>
#include <cstdint>

namespace CGAL::Extremal_mesh_3::internal {

inline constexpr int max_taylor_order = 4;

/// the number of coefficients of total degree at most `order`.
constexpr std::size_t taylor_size(int order) {
  return static_cast<std::size_t>((order + 1) * (order + 2) * (order + 3) / 6);
}

inline constexpr std::size_t max_taylor_size = taylor_size(max_taylor_order);

/// the number of x^a y^b z^c.
constexpr std::size_t taylor_index(int a, int b, int c) {
  const int after_x = b + c;
  return taylor_size(a + b + c - 1) + static_cast<std::size_t>(after_x * (after_x + 1) / 2 + c);
}

struct Taylor_tables {
  std::array<std::uint8_t, max_taylor_size> degree{};
  /// a! b! c! for x^a y^b z^c: the derivative is so many times the coefficient
  std::array<double, max_taylor_size> weight{};
  /// number of the product of two monomials whose degrees add up to at most 4
  std::array<std::array<std::uint8_t, max_taylor_size>, max_taylor_size> product{};
};

constexpr Taylor_tables make_taylor_tables() {
  constexpr std::array<double, 5> factorial{1, 1, 2, 6, 24};
  Taylor_tables t;
  std::array<std::array<int, 3>, max_taylor_size> power{};
  for (int a = 0; a <= max_taylor_order; ++a)
    for (int b = 0; a + b <= max_taylor_order; ++b)
      for (int c = 0; a + b + c <= max_taylor_order; ++c) {
        const std::size_t i = taylor_index(a, b, c);
        power[i] = {a, b, c};
        t.degree[i] = static_cast<std::uint8_t>(a + b + c);
        t.weight[i] = factorial[static_cast<std::size_t>(a)] * factorial[static_cast<std::size_t>(b)] *
                      factorial[static_cast<std::size_t>(c)];
      }
  for (std::size_t i = 0; i < max_taylor_size; ++i)
    for (std::size_t j = 0; j < max_taylor_size; ++j)
      if (t.degree[i] + t.degree[j] <= max_taylor_order)
        t.product[i][j] = static_cast<std::uint8_t>(
            taylor_index(power[i][0] + power[j][0], power[i][1] + power[j][1], power[i][2] + power[j][2]));
  return t;
}

inline constexpr Taylor_tables taylor_tables = make_taylor_tables();

/// fills the derivatives up to `order` (0 to 4) from Taylor coefficients.
/// \param coefficient  gives the coefficient of a number
/// \param d  `Derivatives`, or their bounds
template <class Coefficient, class D> void taylor_to_derivatives(const Coefficient& coefficient, int order, D& d) {
  d.value = coefficient(0);
  const auto fill = [&](auto& block, std::size_t first) {
    for (std::size_t i = 0; i < block.size(); ++i)
      block[i] = coefficient(first + i) * taylor_tables.weight[first + i];
  };
  if (order >= 1)
    fill(d.gradient, taylor_size(0));
  if (order >= 2)
    fill(d.hessian, taylor_size(1));
  if (order >= 3)
    fill(d.third, taylor_size(2));
  if (order >= 4)
    fill(d.fourth, taylor_size(3));
}

} // namespace CGAL::Extremal_mesh_3::internal

#endif // CGAL_EXTREMAL_MESH_3_INTERNAL_TAYLOR_INDICES_H
