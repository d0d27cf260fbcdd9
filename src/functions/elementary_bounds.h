// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_SRC_ELEMENTARY_BOUNDS_H
#define CGAL_EXTREMAL_MESH_3_SRC_ELEMENTARY_BOUNDS_H

#include <CGAL/Extremal_mesh_3/internal/interval_arithmetic.h>

#include <array>

namespace CGAL::Extremal_mesh_3::internal {

/// Bounds of the Taylor coefficients f(a), f'(a), f''(a)/2, f'''(a)/6, f''''(a)/24 for all a of an interval, as
/// `Univariate` has them at one. Values are bounded over the part of the interval where f is defined (empty if there is
/// none); unless that is all of it, the derivatives are unknown: infinite.
using Univariate_bounds = std::array<Interval, 5>;

// Those of order above `order` are not computed.
Univariate_bounds bound_sqrt(const Interval& a, int order);
Univariate_bounds bound_cbrt(const Interval& a, int order);
Univariate_bounds bound_exp(const Interval& a, int order);
Univariate_bounds bound_log(const Interval& a, int order);
Univariate_bounds bound_log2(const Interval& a, int order);
Univariate_bounds bound_log10(const Interval& a, int order);
Univariate_bounds bound_sin(const Interval& a, int order);
Univariate_bounds bound_cos(const Interval& a, int order);
Univariate_bounds bound_tan(const Interval& a, int order);
Univariate_bounds bound_asin(const Interval& a, int order);
Univariate_bounds bound_acos(const Interval& a, int order);
Univariate_bounds bound_atan(const Interval& a, int order);
Univariate_bounds bound_sinh(const Interval& a, int order);
Univariate_bounds bound_cosh(const Interval& a, int order);
Univariate_bounds bound_tanh(const Interval& a, int order);
/// of a^c.
Univariate_bounds bound_power(const Interval& a, double c, int order);

/// the angles of points (x, y).
/// \pre neither contains NaN, and the box does not meet {y = 0, x ≤ 0}
Interval bound_atan2(const Interval& y, const Interval& x);

/// the numbers from `low` to `high`, values of functions of <cmath>, and a little more on both sides.
Interval widened(double low, double high);

} // namespace CGAL::Extremal_mesh_3::internal

#endif // CGAL_EXTREMAL_MESH_3_SRC_ELEMENTARY_BOUNDS_H
