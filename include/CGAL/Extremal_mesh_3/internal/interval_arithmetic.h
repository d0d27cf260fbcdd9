// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_INTERNAL_INTERVAL_ARITHMETIC_H
#define CGAL_EXTREMAL_MESH_3_INTERNAL_INTERVAL_ARITHMETIC_H

// Intervals that hold every result that numbers of their operands can have. Results are computed in the ordinary
// rounding mode and then moved outwards by at least one unit in the last place: no rounding mode is changed, so code may
// be compiled as always. Infinite bounds are limits, which no number takes: 0 times an unbounded interval is 0.
// The empty interval, where nothing is defined, gives empty results.

#include <CGAL/Extremal_mesh_3/Derivative_bounds.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL::Extremal_mesh_3 {
namespace internal {

inline constexpr Interval all_numbers{-std::numeric_limits<double>::infinity(),
                                      std::numeric_limits<double>::infinity()};
inline constexpr Interval no_number{std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};

/// the next number but one or less below a sum. |x|·ε is one to two units in the last place; a sum that underflows is exact.
/// NaN for x = +∞, which is no lower bound.
inline double below(double x) {
  return x - std::abs(x) * std::numeric_limits<double>::epsilon();
}
inline double above(double x) {
  return x + std::abs(x) * std::numeric_limits<double>::epsilon();
}
/// the same for a product or quotient, which may have underflowed.
inline double below_product(double x) {
  return x - (std::abs(x) * std::numeric_limits<double>::epsilon() + std::numeric_limits<double>::min());
}
inline double above_product(double x) {
  return x + (std::abs(x) * std::numeric_limits<double>::epsilon() + std::numeric_limits<double>::min());
}

/// the interval, or all numbers where rounding or infinities left no valid bounds.
inline Interval valid(double low, double high) {
  return low <= high ? Interval{low, high} : all_numbers;
}

/// the product of two bounds.
inline double product_of_bounds(double a, double b) {
  return a == 0 || b == 0 ? 0 : a * b;
}

} // namespace internal

inline Interval operator-(const Interval& a) {
  return {-a.high, -a.low};
}

inline Interval operator+(const Interval& a, const Interval& b) {
  const double low = internal::below(a.low + b.low), high = internal::above(a.high + b.high);
  if (low <= high)
    return {low, high};
  return a.is_empty() || b.is_empty() ? internal::no_number : internal::all_numbers;
}

inline Interval operator-(const Interval& a, const Interval& b) {
  return a + -b;
}

inline Interval operator*(const Interval& a, const Interval& b) {
  double p = a.low * b.low, q = a.low * b.high, r = a.high * b.low, s = a.high * b.high;
  double low = std::min(std::min(p, q), std::min(r, s)), high = std::max(std::max(p, q), std::max(r, s));
  if (!(low <= high)) { // 0·∞, or empty
    if (a.is_empty() || b.is_empty())
      return internal::no_number;
    p = internal::product_of_bounds(a.low, b.low), q = internal::product_of_bounds(a.low, b.high);
    r = internal::product_of_bounds(a.high, b.low), s = internal::product_of_bounds(a.high, b.high);
    low = std::min(std::min(p, q), std::min(r, s)), high = std::max(std::max(p, q), std::max(r, s));
  }
  low = internal::below_product(low), high = internal::above_product(high);
  if (a.low >= 0 && b.low >= 0) // so that x²/y stays positive although x may be 0
    low = std::max(low, 0.0);
  return internal::valid(low, high);
}

inline Interval operator*(const Interval& a, double s) {
  return a * Interval{s, s};
}
inline Interval operator*(double s, const Interval& a) {
  return a * Interval{s, s};
}
inline Interval operator+(const Interval& a, double s) {
  return a + Interval{s, s};
}
inline Interval operator+(double s, const Interval& a) {
  return a + Interval{s, s};
}
inline Interval operator-(const Interval& a, double s) {
  return a + Interval{-s, -s};
}
inline Interval operator-(double s, const Interval& a) {
  return -a + Interval{s, s};
}

/// the quotient, where it is defined: a divisor that ends at 0 gives a bound on one side.
inline Interval operator/(const Interval& a, const Interval& b) {
  if (a.is_empty() || b.is_empty())
    return internal::no_number;
  if (b.low < 0 && b.high <= 0)
    return -a / -b;
  if (b.low < 0 || b.high == 0)
    return internal::all_numbers;
  if (b.low == 0) {
    if (a.low >= 0)
      return internal::valid(std::max(0.0, internal::below_product(a.low / b.high)), internal::all_numbers.high);
    if (a.high <= 0)
      return internal::valid(internal::all_numbers.low, std::min(0.0, internal::above_product(a.high / b.high)));
    return internal::all_numbers;
  }
  double low = a.low / (a.low >= 0 ? b.high : b.low), high = a.high / (a.high >= 0 ? b.low : b.high);
  if (std::isnan(low)) // ∞/∞
    low = a.low >= 0 ? 0 : internal::all_numbers.low;
  if (std::isnan(high))
    high = a.high >= 0 ? internal::all_numbers.high : 0;
  low = internal::below_product(low), high = internal::above_product(high);
  return internal::valid(a.low >= 0 ? std::max(low, 0.0) : low, high);
}

inline Interval operator/(const Interval& a, double s) {
  return a / Interval{s, s};
}
inline Interval operator/(double s, const Interval& a) {
  return Interval{s, s} / a;
}

/// the squares, which are never negative.
inline Interval square(const Interval& a) {
  if (a.is_empty())
    return a;
  const double l = std::abs(a.low), h = std::abs(a.high), least = a.contains(0) ? 0 : std::min(l, h),
               most = std::max(l, h);
  return internal::valid(std::max(0.0, internal::below_product(least * least)), internal::above_product(most * most));
}

/// the least interval that holds both.
inline Interval hull(const Interval& a, const Interval& b) {
  if (a.is_empty() || b.is_empty())
    return a.is_empty() ? b : a;
  return {std::min(a.low, b.low), std::max(a.high, b.high)};
}

/// what both hold. They are bounds of the same and so have something in common.
inline Interval intersection(const Interval& a, const Interval& b) {
  if (a.is_empty() || b.is_empty())
    return internal::no_number;
  const Interval c{std::max(a.low, b.low), std::min(a.high, b.high)};
  return c.is_empty() ? a : c;
}

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_INTERNAL_INTERVAL_ARITHMETIC_H
