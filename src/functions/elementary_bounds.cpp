// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "elementary_bounds.h"

#include <cmath>
#include <numbers>

namespace CGAL::Extremal_mesh_3::internal {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr Univariate_bounds nowhere{no_number, no_number, no_number, no_number, no_number};

/// a value bounded on the part of the interval where the function is defined.
Univariate_bounds value_only(const Interval& value) {
  return {value, all_numbers, all_numbers, all_numbers, all_numbers};
}

/// what a relative error of rounding leaves certain of a quotient by the half period. Extrema found where there are none
/// but very near cost nothing.
constexpr double slack = 1e-9;
/// Larger angles lose too many digits when they are reduced.
constexpr double largest_angle = 1e6;

/// tells whether `first + n·period` may lie in the interval for some whole n.
bool may_meet(const Interval& a, double first, double period) {
  return std::floor((a.high - first) / period + slack) >= std::ceil((a.low - first) / period - slack);
}

Interval bound_sine(const Interval& a) {
  using std::numbers::pi;
  if (a.is_empty())
    return no_number;
  if (!(std::abs(a.low) < largest_angle) || !(std::abs(a.high) < largest_angle))
    return {-1, 1};
  const Interval ends = hull(widened(std::sin(a.low), std::sin(a.low)), widened(std::sin(a.high), std::sin(a.high)));
  return {may_meet(a, -pi / 2, 2 * pi) ? -1 : std::max(ends.low, -1.0),
          may_meet(a, pi / 2, 2 * pi) ? 1 : std::min(ends.high, 1.0)};
}

Interval bound_cosine(const Interval& a) {
  using std::numbers::pi;
  if (a.is_empty())
    return no_number;
  if (!(std::abs(a.low) < largest_angle) || !(std::abs(a.high) < largest_angle))
    return {-1, 1};
  const Interval ends = hull(widened(std::cos(a.low), std::cos(a.low)), widened(std::cos(a.high), std::cos(a.high)));
  return {may_meet(a, pi, 2 * pi) ? -1 : std::max(ends.low, -1.0),
          may_meet(a, 0, 2 * pi) ? 1 : std::min(ends.high, 1.0)};
}

Interval bound_hyperbolic_cosine(const Interval& a) {
  const double l = std::cosh(a.low), h = std::cosh(a.high);
  const Interval ends = widened(std::min(l, h), std::max(l, h));
  return {a.contains(0) ? 1 : std::max(1.0, ends.low), ends.high};
}

template <class Logarithm>
Univariate_bounds bound_logarithm(const Interval& a, int order, double log_of_base, const Logarithm& log) {
  if (!(a.high > 0)) // log(0) is infinite, which no surface passes through
    return nowhere;
  const double low = a.low > 0 ? log(a.low) : -infinity;
  const Interval value = widened(low, log(a.high));
  if (!(a.low > 0))
    return value_only(value);
  Univariate_bounds f{value};
  if (order >= 1) {
    const Interval r = 1.0 / a;
    f[1] = log_of_base == 1 ? r : r / widened(log_of_base, log_of_base);
    f[2] = -(f[1] * r) * 0.5;
    f[3] = f[1] * square(r) / 3;
    f[4] = -(f[1] * (square(r) * r)) * 0.25;
  }
  return f;
}

/// a^c for a ≥ 0.
Interval bound_real_power(const Interval& a, double c) {
  if (c == 0)
    return {1, 1};
  const double l = std::pow(a.low, c), h = std::pow(a.high, c);
  const Interval value = widened(std::min(l, h), std::max(l, h));
  return {std::max(0.0, value.low), value.high};
}

} // namespace

// The functions of <cmath> are good to a few units in the last place (the GNU C library documents at most 4 for those
// used here); 8 are taken.
Interval widened(double low, double high) {
  constexpr double share = 8 * std::numeric_limits<double>::epsilon(), least = std::numeric_limits<double>::min();
  const double below = std::isinf(low) && low > 0 ? std::numeric_limits<double>::max() : low;
  const double above = std::isinf(high) && high < 0 ? std::numeric_limits<double>::lowest() : high;
  return valid(below - (std::abs(below) * share + least), above + (std::abs(above) * share + least));
}

Univariate_bounds bound_sqrt(const Interval& a, int order) {
  if (!(a.high >= 0))
    return nowhere;
  const double low = std::max(a.low, 0.0);
  const Interval wide = widened(std::sqrt(low), std::sqrt(a.high));
  const Interval value{std::max(0.0, wide.low), wide.high};
  if (!(a.low > 0))
    return value_only(value);
  Univariate_bounds f{value};
  if (order >= 1) {
    const Interval r = 1.0 / a;
    f[1] = 0.5 / value;
    f[2] = -(f[1] * r) * 0.25;
    f[3] = f[1] * square(r) * 0.125;
    f[4] = f[1] * (square(r) * r) * (-5.0 / 64);
  }
  return f;
}

Univariate_bounds bound_cbrt(const Interval& a, int order) {
  if (a.is_empty())
    return nowhere;
  const Interval value = widened(std::cbrt(a.low), std::cbrt(a.high));
  if (a.contains(0))
    return value_only(value);
  Univariate_bounds f{value};
  if (order >= 1) {
    const Interval r = 1.0 / a;
    f[1] = 1.0 / (3.0 * square(value));
    f[2] = -(f[1] * r) / 3;
    f[3] = 5.0 * f[1] * square(r) / 27;
    f[4] = -10.0 * f[1] * (square(r) * r) / 81;
  }
  return f;
}

Univariate_bounds bound_exp(const Interval& a, int) {
  if (a.is_empty())
    return nowhere;
  const Interval wide = widened(std::exp(a.low), std::exp(a.high));
  const Interval value{std::max(0.0, wide.low), wide.high};
  return {value, value, value * 0.5, value / 6, value / 24};
}

Univariate_bounds bound_log(const Interval& a, int order) {
  return bound_logarithm(a, order, 1, [](double x) { return std::log(x); });
}
Univariate_bounds bound_log2(const Interval& a, int order) {
  return bound_logarithm(a, order, std::numbers::ln2, [](double x) { return std::log2(x); });
}
Univariate_bounds bound_log10(const Interval& a, int order) {
  return bound_logarithm(a, order, std::numbers::ln10, [](double x) { return std::log10(x); });
}

Univariate_bounds bound_sin(const Interval& a, int order) {
  const Interval s = bound_sine(a);
  if (order == 0)
    return {s};
  const Interval c = bound_cosine(a);
  return {s, c, s * -0.5, -c / 6, s / 24};
}

Univariate_bounds bound_cos(const Interval& a, int order) {
  const Interval c = bound_cosine(a);
  if (order == 0)
    return {c};
  const Interval s = bound_sine(a);
  return {c, -s, c * -0.5, s / 6, c / 24};
}

Univariate_bounds bound_tan(const Interval& a, int order) {
  using std::numbers::pi;
  if (a.is_empty())
    return nowhere;
  if (!(std::abs(a.low) < largest_angle) || !(std::abs(a.high) < largest_angle) || may_meet(a, pi / 2, pi))
    return value_only(all_numbers);
  const Interval t = widened(std::tan(a.low), std::tan(a.high));
  Univariate_bounds f{t};
  if (order >= 1) {
    const Interval tt = square(t);
    f[1] = 1.0 + tt;
    f[2] = t * f[1];
    f[3] = f[1] * (1.0 + 3.0 * tt) / 3;
    f[4] = f[2] * (2.0 + 3.0 * tt) / 3;
  }
  return f;
}

Univariate_bounds bound_asin(const Interval& a, int order) {
  if (!(a.high >= -1) || !(a.low <= 1))
    return nowhere;
  const Interval value = widened(std::asin(std::max(a.low, -1.0)), std::asin(std::min(a.high, 1.0)));
  if (!(a.low > -1) || !(a.high < 1))
    return value_only(value);
  Univariate_bounds f{value};
  if (order >= 1) {
    const Interval aa = square(a), u = 1.0 / ((1.0 - a) * (1.0 + a));
    f[1] = bound_sqrt(u, 0)[0];
    const Interval f1u = f[1] * u;
    f[2] = a * f1u * 0.5;
    f[3] = (1.0 + 2.0 * aa) * (f1u * u) / 6;
    f[4] = a * (3.0 + 2.0 * aa) * (f1u * square(u)) * 0.125;
  }
  return f;
}

Univariate_bounds bound_acos(const Interval& a, int order) {
  Univariate_bounds f = bound_asin(a, order);
  if (f[0].is_empty())
    return f;
  f[0] = widened(std::acos(std::min(a.high, 1.0)), std::acos(std::max(a.low, -1.0)));
  for (std::size_t k = 1; k < f.size(); ++k)
    f[k] = -f[k];
  return f;
}

Univariate_bounds bound_atan(const Interval& a, int order) {
  if (a.is_empty())
    return nowhere;
  Univariate_bounds f{widened(std::atan(a.low), std::atan(a.high))};
  if (order >= 1) {
    const Interval aa = square(a), u = 1.0 / (1.0 + aa), uu = square(u);
    f[1] = u;
    f[2] = -(a * uu);
    f[3] = (3.0 * aa - 1.0) * (uu * u) / 3;
    f[4] = a * (1.0 - aa) * square(uu);
  }
  return f;
}

Univariate_bounds bound_sinh(const Interval& a, int order) {
  if (a.is_empty())
    return nowhere;
  const Interval s = widened(std::sinh(a.low), std::sinh(a.high));
  if (order == 0)
    return {s};
  const Interval c = bound_hyperbolic_cosine(a);
  return {s, c, s * 0.5, c / 6, s / 24};
}

Univariate_bounds bound_cosh(const Interval& a, int order) {
  if (a.is_empty())
    return nowhere;
  const Interval c = bound_hyperbolic_cosine(a);
  if (order == 0)
    return {c};
  const Interval s = widened(std::sinh(a.low), std::sinh(a.high));
  return {c, s, c * 0.5, s / 6, c / 24};
}

Univariate_bounds bound_tanh(const Interval& a, int order) {
  if (a.is_empty())
    return nowhere;
  const Interval t = widened(std::tanh(a.low), std::tanh(a.high));
  Univariate_bounds f{t};
  if (order >= 1) {
    const Interval tt = square(t);
    f[1] = 1.0 / square(bound_hyperbolic_cosine(a));
    f[2] = -(t * f[1]);
    f[3] = -(f[1] * (1.0 - 3.0 * tt)) / 3;
    f[4] = f[1] * t * (2.0 - 3.0 * tt) / 3;
  }
  return f;
}

Univariate_bounds bound_power(const Interval& a, double c, int order) {
  if (a.is_empty())
    return nowhere;
  if (!(a.low > 0)) {
    if (c == std::floor(c) || a.high == 0) // defined for negative bases
      return value_only(all_numbers);
    if (!(a.high > 0))
      return nowhere;
    return value_only(bound_real_power({0, a.high}, c));
  }
  Univariate_bounds f{bound_real_power(a, c)};
  double factor = 1;
  for (int k = 1; k <= order; ++k) {
    factor *= (c - (k - 1)) / k;
    // The exponent c − k is rounded, which tells where the logarithm of a is large.
    const double e = c - k;
    const Interval powers =
        hull(bound_real_power(a, std::nextafter(e, -infinity)), bound_real_power(a, std::nextafter(e, infinity)));
    f[static_cast<std::size_t>(k)] = widened(factor, factor) * powers;
  }
  return f;
}

Interval bound_atan2(const Interval& y, const Interval& x) {
  // In a box that does not hold the origin the extreme directions are those of corners.
  double low = infinity, high = -infinity;
  for (const double v : {y.low, y.high})
    for (const double u : {x.low, x.high}) {
      low = std::min(low, std::atan2(v, u));
      high = std::max(high, std::atan2(v, u));
    }
  return widened(low, high);
}

} // namespace CGAL::Extremal_mesh_3::internal
