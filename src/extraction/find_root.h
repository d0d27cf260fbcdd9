// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_EXTRACTION_FIND_ROOT_H
#define EXTREMAL_MESH_3_SRC_EXTRACTION_FIND_ROOT_H

#include <boost/math/tools/toms748_solve.hpp>

#include <cmath>
#include <cstdint>

namespace CGAL::Extremal_mesh_3 {

/// calls f at places between low and high until one is, within the tolerance, where f changes its sign (Alefeld, Potra
/// and Shi, TOMS 748). The last call is the one nearest to the root, or as near to it.
/// \pre low < high, and f_low, f_high are the values there, of different signs. If one is not a number, the middle is taken
template <class Function>
void find_root(const Function& f, double low, double high, double f_low, double f_high, double tolerance) {
  if (f_low == 0 || f_high == 0) {
    f(f_low == 0 ? low : high);
    return;
  }
  if (!(low < high) ||
      !(f_low < 0 ? f_high > 0 : f_low > 0 && f_high < 0)) { // nothing to search by: one is not a number
    f(low + (high - low) / 2);
    return;
  }
  namespace policies = boost::math::policies;
  using Quiet = policies::policy<policies::evaluation_error<policies::ignore_error>>;
  double last = low, value_last = f_low;
  const auto watched = [&](double x) {
    last = x;
    value_last = f(x);
    // Values this small are rounding of phases: an exact 0 ends the search.
    return std::abs(value_last) < 1e-14 ? 0.0 : value_last;
  };
  const auto settled = [&](double a, double b) { return std::abs(b - a) <= tolerance; };
  std::uintmax_t steps = 60;
  const auto [a, b] = boost::math::tools::toms748_solve(watched, low, high, f_low, f_high, settled, steps, Quiet());
  // The bracket may have ended far from the last place that was tried.
  if (last < a - tolerance || last > b + tolerance)
    f(a + (b - a) / 2);
}

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_EXTRACTION_FIND_ROOT_H
