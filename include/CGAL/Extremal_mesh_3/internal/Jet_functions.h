// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_INTERNAL_JET_FUNCTIONS_H
#define CGAL_EXTREMAL_MESH_3_INTERNAL_JET_FUNCTIONS_H

// The elementary functions of jets; included by Jet.h.

#include <CGAL/Extremal_mesh_3/Jet.h>
#include <CGAL/Extremal_mesh_3/internal/elementary_functions.h>

#include <concepts>
#include <type_traits>

namespace CGAL::Extremal_mesh_3 {
namespace internal {

/// f(u) by Horner's rule in `h = u - u.value()`. Having no constant term, h lifts degrees: step k needs degrees up to
/// k of what is there, and an infinite f'' does not reach the first derivatives.
template <int N> Basic_jet<N> compose(const Basic_jet<N>& u, const Univariate& f) {
  Basic_jet<N> w(f[static_cast<std::size_t>(N)]);
  for (int k = 1; k <= N; ++k) {
    Basic_jet<N> next(f[static_cast<std::size_t>(N - k)]);
    for (std::size_t i = 1; i < taylor_size(k); ++i)
      for (std::size_t j = 0; j < taylor_size(k - taylor_tables.degree[i]); ++j)
        next[taylor_tables.product[i][j]] += u[i] * w[j];
    w = next;
  }
  return w;
}

/// Integer powers up to this size are products, at most 11 of them: exact derivatives of polynomials at 0 too.
inline constexpr int max_multiplied_power = 64;

/// u^n by repeated squaring, n >= 1.
template <class T> T positive_integer_power(T u, unsigned n) {
  T w = u;
  for (--n; n > 0; n >>= 1) {
    if (n & 1u)
      w = w * u;
    if (n > 1)
      u = u * u;
  }
  return w;
}

} // namespace internal

// clang-format off
template <int N> Basic_jet<N> sqrt(const Basic_jet<N>& u) { return internal::compose(u, internal::taylor_sqrt(u.value())); }
template <int N> Basic_jet<N> cbrt(const Basic_jet<N>& u) { return internal::compose(u, internal::taylor_cbrt(u.value())); }
template <int N> Basic_jet<N> exp(const Basic_jet<N>& u) { return internal::compose(u, internal::taylor_exp(u.value())); }
template <int N> Basic_jet<N> log(const Basic_jet<N>& u) { return internal::compose(u, internal::taylor_log(u.value())); }
template <int N> Basic_jet<N> log2(const Basic_jet<N>& u) { return internal::compose(u, internal::taylor_log2(u.value())); }
template <int N> Basic_jet<N> log10(const Basic_jet<N>& u) { return internal::compose(u, internal::taylor_log10(u.value())); }
template <int N> Basic_jet<N> sin(const Basic_jet<N>& u) { return internal::compose(u, internal::taylor_sin(u.value())); }
template <int N> Basic_jet<N> cos(const Basic_jet<N>& u) { return internal::compose(u, internal::taylor_cos(u.value())); }
template <int N> Basic_jet<N> tan(const Basic_jet<N>& u) { return internal::compose(u, internal::taylor_tan(u.value())); }
template <int N> Basic_jet<N> asin(const Basic_jet<N>& u) { return internal::compose(u, internal::taylor_asin(u.value())); }
template <int N> Basic_jet<N> acos(const Basic_jet<N>& u) { return internal::compose(u, internal::taylor_acos(u.value())); }
template <int N> Basic_jet<N> atan(const Basic_jet<N>& u) { return internal::compose(u, internal::taylor_atan(u.value())); }
template <int N> Basic_jet<N> sinh(const Basic_jet<N>& u) { return internal::compose(u, internal::taylor_sinh(u.value())); }
template <int N> Basic_jet<N> cosh(const Basic_jet<N>& u) { return internal::compose(u, internal::taylor_cosh(u.value())); }
template <int N> Basic_jet<N> tanh(const Basic_jet<N>& u) { return internal::compose(u, internal::taylor_tanh(u.value())); }
template <int N> Basic_jet<N> square(const Basic_jet<N>& u) { return u * u; }
// clang-format on
inline double square(double u) {
  return u * u;
}

template <int N> Basic_jet<N> abs(const Basic_jet<N>& u) {
  return u.value() < 0 ? -u : u;
}

template <int N> Basic_jet<N> min(const Basic_jet<N>& u, const Basic_jet<N>& v) {
  return v < u || std::isnan(v.value()) ? v : u;
}
template <int N> Basic_jet<N> max(const Basic_jet<N>& u, const Basic_jet<N>& v) {
  return v > u || std::isnan(v.value()) ? v : u;
}
template <int N> Basic_jet<N> hypot(const Basic_jet<N>& u, const Basic_jet<N>& v) {
  return sqrt(u * u + v * v);
}

/// the angle of (x, y): turned so that the direction of the values is the positive x axis, where it is atan(y/x).
template <int N> Basic_jet<N> atan2(const Basic_jet<N>& y, const Basic_jet<N>& x) {
  const double r = std::hypot(x.value(), y.value());
  const double c = x.value() / r, s = y.value() / r;
  Basic_jet<N> t = (y * c - x * s) / (x * c + y * s);
  return internal::compose(t, {std::atan2(y.value(), x.value()), 1, 0, -1.0 / 3, 0});
}

// With a number on one side. (Conversions would compete with the templates of std.)
template <int N> Basic_jet<N> min(const Basic_jet<N>& u, double s) {
  return min(u, Basic_jet<N>(s));
}
template <int N> Basic_jet<N> min(double s, const Basic_jet<N>& v) {
  return min(Basic_jet<N>(s), v);
}
template <int N> Basic_jet<N> max(const Basic_jet<N>& u, double s) {
  return max(u, Basic_jet<N>(s));
}
template <int N> Basic_jet<N> max(double s, const Basic_jet<N>& v) {
  return max(Basic_jet<N>(s), v);
}
template <int N> Basic_jet<N> hypot(const Basic_jet<N>& u, double s) {
  return hypot(u, Basic_jet<N>(s));
}
template <int N> Basic_jet<N> hypot(double s, const Basic_jet<N>& v) {
  return hypot(Basic_jet<N>(s), v);
}
template <int N> Basic_jet<N> atan2(const Basic_jet<N>& y, double x) {
  return atan2(y, Basic_jet<N>(x));
}
template <int N> Basic_jet<N> atan2(double y, const Basic_jet<N>& x) {
  return atan2(Basic_jet<N>(y), x);
}

/// u^n by repeated multiplication, for a base of any sign and at 0.
template <int N, std::integral I> Basic_jet<N> pow(const Basic_jet<N>& u, I n) {
  if (n == 0)
    return 1;
  if constexpr (std::is_signed_v<I>)
    if (n < 0)
      return 1 / internal::positive_integer_power(u, 0u - static_cast<unsigned>(n));
  return internal::positive_integer_power(u, static_cast<unsigned>(n));
}

/// u^s; `u` may be negative only if `s` is an integer.
template <int N> Basic_jet<N> pow(const Basic_jet<N>& u, double s) {
  if (std::abs(s) <= internal::max_multiplied_power && s == std::floor(s))
    return pow(u, static_cast<int>(s));
  return internal::compose(u, internal::taylor_power(u.value(), s, std::pow(u.value(), s)));
}

/// u^v = exp(v log u), for u > 0.
template <int N> Basic_jet<N> pow(const Basic_jet<N>& u, const Basic_jet<N>& v) {
  const double value = std::pow(u.value(), v.value());
  return internal::compose(v * log(u), internal::taylor_exponential(value, 1));
}
template <int N> Basic_jet<N> pow(double s, const Basic_jet<N>& v) {
  return pow(Basic_jet<N>(s), v);
}

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_INTERNAL_JET_FUNCTIONS_H
