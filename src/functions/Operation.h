// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_SRC_OPERATION_H
#define CGAL_EXTREMAL_MESH_3_SRC_OPERATION_H

// What a node of a formula can do, and its value in double precision.

#include <cmath>
#include <cstdint>
#include <limits>

namespace CGAL::Extremal_mesh_3::internal {

enum class Operation : std::uint8_t {
  constant,
  variable,
  // of one operand
  negate,
  absolute,
  sign,
  sqrt,
  cbrt,
  exp,
  log,
  log2,
  log10,
  sin,
  cos,
  tan,
  asin,
  acos,
  atan,
  sinh,
  cosh,
  tanh,
  // of two operands
  add,
  subtract,
  multiply,
  divide,
  minimum,
  maximum,
  real_power, ///< with a constant exponent
  power,
  atan2,
};

constexpr bool is_binary(Operation op) {
  return op >= Operation::add;
}
constexpr bool is_unary(Operation op) {
  return op >= Operation::negate && !is_binary(op);
}
/// one of the functions that are composed from Taylor coefficients in one variable.
constexpr bool is_elementary(Operation op) {
  return op >= Operation::sqrt && op <= Operation::tanh;
}

/// true if `min(a, b)` is `b`; NaN prevails.
inline bool takes_second_as_minimum(double a, double b) {
  return b < a || b != b;
}
inline bool takes_second_as_maximum(double a, double b) {
  return b > a || b != b;
}
inline double sign(double a) {
  return a > 0 ? 1. : a < 0 ? -1. : a;
}

/// calls `use` with the operation as a function of one or two doubles. The switch is outside of loops over points.
template <class Use> void with_scalar_operation(Operation op, const Use& use) {
  switch (op) {
  case Operation::constant:
  case Operation::variable:
    return;
  // clang-format off
  case Operation::negate: return use([](double a, double) { return -a; });
  case Operation::absolute: return use([](double a, double) { return a < 0 ? -a : a; });
  case Operation::sign: return use([](double a, double) { return sign(a); });
  case Operation::sqrt: return use([](double a, double) { return std::sqrt(a); });
  case Operation::cbrt: return use([](double a, double) { return std::cbrt(a); });
  case Operation::exp: return use([](double a, double) { return std::exp(a); });
  case Operation::log: return use([](double a, double) { return std::log(a); });
  case Operation::log2: return use([](double a, double) { return std::log2(a); });
  case Operation::log10: return use([](double a, double) { return std::log10(a); });
  case Operation::sin: return use([](double a, double) { return std::sin(a); });
  case Operation::cos: return use([](double a, double) { return std::cos(a); });
  case Operation::tan: return use([](double a, double) { return std::tan(a); });
  case Operation::asin: return use([](double a, double) { return std::asin(a); });
  case Operation::acos: return use([](double a, double) { return std::acos(a); });
  case Operation::atan: return use([](double a, double) { return std::atan(a); });
  case Operation::sinh: return use([](double a, double) { return std::sinh(a); });
  case Operation::cosh: return use([](double a, double) { return std::cosh(a); });
  case Operation::tanh: return use([](double a, double) { return std::tanh(a); });
  case Operation::add: return use([](double a, double b) { return a + b; });
  case Operation::subtract: return use([](double a, double b) { return a - b; });
  case Operation::multiply: return use([](double a, double b) { return a * b; });
  case Operation::divide: return use([](double a, double b) { return a / b; });
  case Operation::minimum: return use([](double a, double b) { return takes_second_as_minimum(a, b) ? b : a; });
  case Operation::maximum: return use([](double a, double b) { return takes_second_as_maximum(a, b) ? b : a; });
  case Operation::real_power:
  case Operation::power: return use([](double a, double b) { return std::pow(a, b); });
  case Operation::atan2: return use([](double a, double b) { return std::atan2(a, b); });
    // clang-format on
  }
}

inline double apply(Operation op, double a, double b) {
  double result = std::numeric_limits<double>::quiet_NaN();
  with_scalar_operation(op, [&](const auto& f) { result = f(a, b); });
  return result;
}

} // namespace CGAL::Extremal_mesh_3::internal

#endif // CGAL_EXTREMAL_MESH_3_SRC_OPERATION_H
