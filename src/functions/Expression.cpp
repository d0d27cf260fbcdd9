// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Expression.h"

#include <CGAL/Extremal_mesh_3/Jet.h>

#include <bit>
#include <cmath>
#include <numbers>
#include <utility>

namespace CGAL::Extremal_mesh_3::internal {
namespace {

/// A node as seen by positive_integer_power().
struct Factor {
  Expression* expression;
  Expression::Id id;
  friend Factor operator*(const Factor& u, const Factor& v) {
    return {u.expression, u.expression->binary(Operation::multiply, u.id, v.id)};
  }
};

} // namespace

// Bits, not values: 0 and -0 differ, NaN equals itself.
bool Expression::Node::operator==(const Node& o) const {
  return operation == o.operation && a == o.a && b == o.b &&
         std::bit_cast<std::uint64_t>(value) == std::bit_cast<std::uint64_t>(o.value);
}

std::size_t Expression::Hash::operator()(const Node& node) const {
  std::uint64_t h = static_cast<std::uint64_t>(node.operation);
  for (const std::uint64_t word :
       {std::uint64_t{node.a}, std::uint64_t{node.b}, std::bit_cast<std::uint64_t>(node.value)})
    h = (std::rotl(h, 23) ^ word) * 0x9E3779B97F4A7C15u; // Fibonacci hashing
  return static_cast<std::size_t>(h ^ (h >> 32));
}

Expression::Id Expression::find_or_add(const Node& node) {
  const auto [position, is_new] = ids_.try_emplace(node, static_cast<Id>(nodes_.size()));
  if (is_new)
    nodes_.push_back(node);
  return position->second;
}

std::optional<double> Expression::constant_value(Id a) const {
  if (nodes_[a].operation == Operation::constant)
    return nodes_[a].value;
  return std::nullopt;
}

Expression::Id Expression::constant(double value) {
  return find_or_add({Operation::constant, 0, 0, value});
}

Expression::Id Expression::variable(Id axis) {
  return find_or_add({Operation::variable, axis, 0, 0});
}

Expression::Id Expression::unary(Operation op, Id a) {
  const Node operand = nodes_[a];
  if (operand.operation == Operation::constant)
    return constant(apply(op, operand.value, 0));
  if (op == Operation::negate && operand.operation == Operation::negate)
    return operand.a;
  return find_or_add({op, a, 0, 0});
}

Expression::Id Expression::binary(Operation op, Id a, Id b) {
  const std::optional<double> u = constant_value(a), v = constant_value(b);
  if (u && v)
    return constant(apply(op, *u, *v));
  switch (op) {
  case Operation::add:
    if (u == 0.0)
      return b;
    if (v == 0.0)
      return a;
    break;
  case Operation::subtract:
    if (u == 0.0)
      return unary(Operation::negate, b);
    if (v == 0.0)
      return a;
    break;
  case Operation::multiply:
    if (u == 1.0)
      return b;
    if (v == 1.0)
      return a;
    break;
  case Operation::divide:
    if (v == 1.0)
      return a;
    break;
  default:
    break;
  }
  // Addition and multiplication commute to the bit, so that x*y and y*x are one node.
  if ((op == Operation::add || op == Operation::multiply) && a > b)
    std::swap(a, b);
  return find_or_add({op, a, b, 0});
}

Expression::Id Expression::power(Id a, Id b) {
  const std::optional<double> base = constant_value(a), exponent = constant_value(b);
  if (base && exponent)
    return constant(apply(Operation::power, *base, *exponent));
  if (base == std::numbers::e)
    return unary(Operation::exp, b);
  if (!exponent)
    return binary(Operation::power, a, b);
  if (*exponent == 0)
    return constant(1);
  if (*exponent == 0.5)
    return unary(Operation::sqrt, a);
  if (std::abs(*exponent) > max_multiplied_power || *exponent != std::floor(*exponent))
    return binary(Operation::real_power, a, b);
  const auto n = static_cast<unsigned>(std::abs(*exponent));
  const Id product = positive_integer_power(Factor{this, a}, n).id;
  return *exponent < 0 ? binary(Operation::divide, constant(1), product) : product;
}

} // namespace CGAL::Extremal_mesh_3::internal
