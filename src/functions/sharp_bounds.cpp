// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sharp_bounds.h"

#include <CGAL/Extremal_mesh_3/internal/Taylor_indices.h>
#include <CGAL/Extremal_mesh_3/internal/interval_arithmetic.h>

namespace CGAL::Extremal_mesh_3::internal {
namespace {

/// the derivatives of order n + 1 that are the derivatives of entry i of order n along the axes.
std::array<std::size_t, 3> entries_above(std::size_t i) {
  // Entry i of an order has the powers (·, b, c) with i = (b + c)(b + c + 1)/2 + c; one x more leaves i as it is.
  std::size_t sum = 0;
  while ((sum + 1) * (sum + 2) / 2 <= i)
    ++sum;
  return {i, i + sum + 1, i + sum + 2};
}

template <std::size_t N, std::size_t M>
void sharpen(const Box_3& box, const std::array<Interval, N>& middle, const std::array<Interval, M>& above,
             std::array<Interval, N>& entries) {
  for (std::size_t i = 0; i < N; ++i) {
    const auto [x, y, z] = entries_above(i);
    entries[i] = intersection(entries[i], by_mean_value(box, middle[i], {above[x], above[y], above[z]}));
  }
}

} // namespace

Box_3 middle_of(const Box_3& box) {
  Box_3 m;
  for (std::size_t a = 0; a < 3; ++a)
    m.low[a] = m.high[a] = box.low[a] / 2 + box.high[a] / 2;
  return m;
}

Interval by_mean_value(const Box_3& box, const Interval& at_middle, const std::array<Interval, 3>& gradient) {
  if (at_middle.is_empty()) // not defined there, perhaps elsewhere
    return all_numbers;
  Interval sum = at_middle;
  for (std::size_t a = 0; a < 3; ++a) {
    const double m = box.low[a] / 2 + box.high[a] / 2;
    sum = sum + gradient[a] * (Interval{box.low[a], box.high[a]} - m);
  }
  return sum;
}

// Where the function is not defined, or not continuous, on all of the box, derivatives are unbounded, and so are the
// centred forms.
bool sharp_bounds(const Function_3& f, const Box_3& box, int order, Derivative_bounds& d) {
  Derivative_bounds middle;
  if (!f.bounds(box, order + 1, d) || !f.bounds(middle_of(box), order, middle))
    return false;
  if (d.value.is_empty())
    return true;
  if (order >= 3)
    sharpen(box, middle.third, d.fourth, d.third);
  if (order >= 2)
    sharpen(box, middle.hessian, d.third, d.hessian);
  if (order >= 1)
    sharpen(box, middle.gradient, d.hessian, d.gradient);
  d.value = intersection(d.value, by_mean_value(box, middle.value, d.gradient));
  return true;
}

} // namespace CGAL::Extremal_mesh_3::internal
