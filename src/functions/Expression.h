// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_SRC_EXPRESSION_H
#define CGAL_EXTREMAL_MESH_3_SRC_EXPRESSION_H

#include "Operation.h"

#include <cstddef>
#include <optional>
#include <unordered_map>
#include <vector>

namespace CGAL::Extremal_mesh_3::internal {

/// An expression as a directed acyclic graph: equal subexpressions are one node, constants are folded, operands come
/// before what uses them.
class Expression {
public:
  using Id = std::uint32_t;

  struct Node {
    Operation operation;
    Id a = 0, b = 0;  ///< operands; for a variable, a is its axis
    double value = 0; ///< of a constant
    bool operator==(const Node&) const;
  };

  Id constant(double value);
  Id variable(Id axis);
  Id unary(Operation op, Id a);
  /// Folds what leaves every value as it is: x·1, x/1, x+0, x−0, 0−x. Not x·0, which is NaN where x is not finite.
  Id binary(Operation op, Id a, Id b);
  /// a^b: products for a small integer b, exp for the base e, a square root for ½.
  Id power(Id a, Id b);

  const std::vector<Node>& nodes() const { return nodes_; }
  std::optional<double> constant_value(Id a) const;

private:
  struct Hash {
    std::size_t operator()(const Node& node) const;
  };

  Id find_or_add(const Node& node);

  std::vector<Node> nodes_;
  std::unordered_map<Node, Id, Hash> ids_;
};

} // namespace CGAL::Extremal_mesh_3::internal

#endif // CGAL_EXTREMAL_MESH_3_SRC_EXPRESSION_H
