// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_FUNCTIONS_ROOT_IN_BRACKET_H
#define EXTREMAL_MESH_3_SRC_FUNCTIONS_ROOT_IN_BRACKET_H

#include <cmath>
#include <utility>

namespace CGAL::Extremal_mesh_3 {

/// the root in [0, 1] of a function that has the signs of v0 and v1 at the ends: Newton's method, kept in a bracket. Where the
/// function is not finite, the search ends.
/// \param evaluate  gives the value and the slope at a number
template <class Evaluate> double root_in_bracket(double v0, double v1, const Evaluate& evaluate) {
  double low = 0, high = 1, t = v0 / (v0 - v1);
  const bool rising = v1 >= 0;
  for (int i = 0; i < 100; ++i) {
    const auto [value, slope] = evaluate(t);
    if (!std::isfinite(value) || value == 0)
      return t;
    ((value >= 0) == rising ? high : low) = t;
    double next = t - value / slope;
    if (!(next > low && next < high))
      next = low + (high - low) / 2;
    if (std::abs(next - t) < 4e-16 || high - low < 4e-16)
      return next;
    t = next;
  }
  return t;
}

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_FUNCTIONS_ROOT_IN_BRACKET_H
