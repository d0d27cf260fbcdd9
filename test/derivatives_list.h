// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_TEST_DERIVATIVES_LIST_H
#define CGAL_EXTREMAL_MESH_3_TEST_DERIVATIVES_LIST_H

#include <CGAL/Extremal_mesh_3/Derivatives.h>

#include <bit>
#include <cstdint>
#include <vector>

/// the value and all derivatives up to an order, one after the other.
inline std::vector<double> list(const CGAL::Extremal_mesh_3::Derivatives& d, int order) {
  std::vector<double> all{d.value};
  const auto append = [&](const auto& block) { all.insert(all.end(), block.begin(), block.end()); };
  if (order >= 1)
    append(d.gradient);
  if (order >= 2)
    append(d.hessian);
  if (order >= 3)
    append(d.third);
  if (order >= 4)
    append(d.fourth);
  return all;
}

/// the bits of numbers: equal where == is not (NaN), and different where == is equal (0 and -0).
inline std::vector<std::uint64_t> bits(const std::vector<double>& numbers) {
  std::vector<std::uint64_t> result;
  for (const double number : numbers)
    result.push_back(std::bit_cast<std::uint64_t>(number));
  return result;
}

#endif // CGAL_EXTREMAL_MESH_3_TEST_DERIVATIVES_LIST_H
