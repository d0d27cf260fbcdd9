// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_INTERNAL_ELEMENTARY_FUNCTIONS_H
#define CGAL_EXTREMAL_MESH_3_INTERNAL_ELEMENTARY_FUNCTIONS_H

// The Taylor coefficients f(a), f'(a), f''(a)/2, f'''(a)/6, f''''(a)/24 of the elementary functions of one variable,
// in closed form. The first one is what <cmath> gives. Outside of the domain all are NaN; where a derivative does
// not exist (sqrt at 0) it is infinite or NaN.

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace CGAL::Extremal_mesh_3::internal {

using Univariate = std::array<double, 5>;

/// of u^c at a, given its value there.
inline Univariate taylor_power(double a, double c, double value) {
  if (a == 0) // the quotients below would be 0/0 although low derivatives exist when c is large
    return {value, c * std::pow(a, c - 1), c * (c - 1) / 2 * std::pow(a, c - 2),
            c * (c - 1) * (c - 2) / 6 * std::pow(a, c - 3), c * (c - 1) * (c - 2) * (c - 3) / 24 * std::pow(a, c - 4)};
  const double f1 = c * value / a;
  const double f2 = f1 * (c - 1) / (2 * a);
  const double f3 = f2 * (c - 2) / (3 * a);
  return {value, f1, f2, f3, f3 * (c - 3) / (4 * a)};
}

inline Univariate taylor_sqrt(double a) {
  const double v = std::sqrt(a);
  const double f1 = 0.5 / v;
  const double r = 1 / a;
  return {v, f1, -f1 * r / 4, f1 * r * r / 8, -5 * f1 * r * r * r / 64};
}

inline Univariate taylor_cbrt(double a) {
  const double v = std::cbrt(a);
  const double f1 = 1 / (3 * v * v);
  const double r = 1 / a;
  return {v, f1, -f1 * r / 3, 5 * f1 * r * r / 27, -10 * f1 * r * r * r / 81};
}

/// of c^u where the value is known, given log(c).
inline Univariate taylor_exponential(double value, double log_base) {
  const double f1 = value * log_base;
  const double f2 = f1 * log_base / 2;
  const double f3 = f2 * log_base / 3;
  return {value, f1, f2, f3, f3 * log_base / 4};
}

inline Univariate taylor_exp(double a) {
  const double v = std::exp(a);
  return {v, v, v / 2, v / 6, v / 24};
}

/// of a logarithm whose value at a is known.
/// \param scale  1/log(base)
inline Univariate taylor_logarithm(double a, double value, double scale) {
  const double r = a < 0 ? std::numeric_limits<double>::quiet_NaN() : 1 / a;
  const double f1 = scale * r;
  return {value, f1, -f1 * r / 2, f1 * r * r / 3, -f1 * r * r * r / 4};
}

inline Univariate taylor_log(double a) {
  return taylor_logarithm(a, std::log(a), 1);
}
inline Univariate taylor_log2(double a) {
  return taylor_logarithm(a, std::log2(a), std::numbers::log2e);
}
inline Univariate taylor_log10(double a) {
  return taylor_logarithm(a, std::log10(a), std::numbers::log10e);
}

inline Univariate taylor_sin(double a) {
  const double s = std::sin(a), c = std::cos(a);
  return {s, c, -s / 2, -c / 6, s / 24};
}

inline Univariate taylor_cos(double a) {
  const double s = std::sin(a), c = std::cos(a);
  return {c, -s, -c / 2, s / 6, c / 24};
}

inline Univariate taylor_tan(double a) {
  const double t = std::tan(a);
  const double f1 = 1 + t * t;
  return {t, f1, t * f1, f1 * (1 + 3 * t * t) / 3, f1 * t * (2 + 3 * t * t) / 3};
}

inline Univariate taylor_asin(double a) {
  const double u = 1 / ((1 - a) * (1 + a));
  const double f1 = std::sqrt(u); // NaN outside of [-1, 1]
  return {std::asin(a), f1, a * f1 * u / 2, (1 + 2 * a * a) * f1 * u * u / 6, a * (3 + 2 * a * a) * f1 * u * u * u / 8};
}

inline Univariate taylor_acos(double a) {
  const Univariate f = taylor_asin(a);
  return {std::acos(a), -f[1], -f[2], -f[3], -f[4]};
}

inline Univariate taylor_atan(double a) {
  const double u = 1 / (1 + a * a);
  return {std::atan(a), u, -a * u * u, (3 * a * a - 1) * u * u * u / 3, a * (1 - a * a) * u * u * u * u};
}

inline Univariate taylor_sinh(double a) {
  const double s = std::sinh(a), c = std::cosh(a);
  return {s, c, s / 2, c / 6, s / 24};
}

inline Univariate taylor_cosh(double a) {
  const double s = std::sinh(a), c = std::cosh(a);
  return {c, s, c / 2, s / 6, c / 24};
}

inline Univariate taylor_tanh(double a) {
  const double t = std::tanh(a), c = std::cosh(a);
  const double f1 = 1 / c / c; // 1 - t*t would cancel
  return {t, f1, -t * f1, -f1 * (1 - 3 * t * t) / 3, f1 * t * (2 - 3 * t * t) / 3};
}

} // namespace CGAL::Extremal_mesh_3::internal

#endif // CGAL_EXTREMAL_MESH_3_INTERNAL_ELEMENTARY_FUNCTIONS_H
