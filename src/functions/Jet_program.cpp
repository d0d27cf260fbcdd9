// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Jet_program.h"

#include "Jet_plans.h"

#include <CGAL/Extremal_mesh_3/internal/Taylor_indices.h>

#include <algorithm>
#include <utility>

namespace CGAL::Extremal_mesh_3::internal {
namespace {

using Id = Expression::Id;
using Node = Expression::Node;

/// coefficient by coefficient, so that the result may take an operand's place.
bool is_elementwise(Operation op) {
  switch (op) {
  case Operation::negate:
  case Operation::absolute:
  case Operation::sign:
  case Operation::add:
  case Operation::subtract:
  case Operation::minimum:
  case Operation::maximum:
    return true;
  default:
    return false;
  }
}

class Program_maker {
public:
  Program_maker(const Expression& expression, Id root, int order)
      : nodes_(expression.nodes()), root_(root), stride_(static_cast<std::uint32_t>(taylor_size(order))),
        place_(nodes_.size()), support_(nodes_.size()), last_use_(nodes_.size(), 0), plans_(order, program_.plans) {
    program_.order = order;
  }

  Jet_program make() {
    find_last_uses();
    place_leaves();
    for (Id i = 0; i <= root_; ++i)
      if (is_live(i) && (is_unary(nodes_[i].operation) || is_binary(nodes_[i].operation)))
        add_instruction(i);
    program_.temporary = end_;
    program_.scratch_size = end_ + 2 * stride_;
    program_.result = place_[root_];
    program_.result_support = support_[root_];
    return std::move(program_);
  }

private:
  bool is_live(Id i) const { return last_use_[i] != 0; }

  void find_last_uses() {
    last_use_[root_] = root_ + 1;
    for (Id i = root_ + 1; i-- > 0;) { // users come after their operands, so the first one seen is the last
      const Node& node = nodes_[i];
      if (!is_live(i))
        continue;
      if (is_unary(node.operation) || is_binary(node.operation))
        last_use_[node.a] = std::max(last_use_[node.a], i);
      if (is_binary(node.operation))
        last_use_[node.b] = std::max(last_use_[node.b], i);
    }
  }

  void place_leaves() {
    for (Id i = 0; i <= root_; ++i)
      if (is_live(i) && nodes_[i].operation == Operation::constant) {
        place_[i] = end_++;
        support_[i] = 1;
        program_.constants.push_back(nodes_[i].value);
      }
    for (Id i = 0; i <= root_; ++i)
      if (is_live(i) && nodes_[i].operation == Operation::variable) {
        const Id axis = nodes_[i].a;
        place_[i] = end_;
        support_[i] = program_.order == 0 ? 1u : 1u | 2u << axis;
        program_.uses_variable[axis] = true;
        program_.variable[axis] = end_;
        end_ += stride_;
      }
  }

  bool is_released_by(Id operand, Id user) const {
    const Operation op = nodes_[operand].operation;
    return last_use_[operand] == user && op != Operation::constant && op != Operation::variable;
  }

  void release_operands(Id user) {
    const Node& node = nodes_[user];
    if (is_binary(node.operation) && node.b != node.a && is_released_by(node.b, user))
      free_.push_back(place_[node.b]);
    if (is_released_by(node.a, user)) // last, to be taken first
      free_.push_back(place_[node.a]);
  }

  void add_instruction(Id i) {
    const Node& node = nodes_[i];
    const bool binary = is_binary(node.operation);
    if (is_elementwise(node.operation))
      release_operands(i);
    if (free_.empty()) {
      place_[i] = end_;
      end_ += stride_;
    } else {
      place_[i] = free_.back();
      free_.pop_back();
    }
    if (!is_elementwise(node.operation))
      release_operands(i);
    Jet_instruction instruction{node.operation, place_[node.a], binary ? place_[node.b] : 0, place_[i], {}};
    if (program_.order == 0)
      support_[i] = 1;
    else
      support_[i] = plan(instruction, support_[node.a], binary ? support_[node.b] : 0);
    program_.instructions.push_back(instruction);
  }

  /// makes the plans of an instruction.
  /// \return the support of its result
  Support plan(Jet_instruction& to, Support a, Support b) {
    const int order = program_.order;
    const In_place in_place = to.out == to.a ? In_place::a : to.out == to.b ? In_place::b : In_place::none;
    switch (to.operation) {
    case Operation::add:
      to.plan[0] = plans_.merge(a, b, in_place);
      return a | b;
    case Operation::subtract: // what b has alone changes its sign
      to.plan[0] = plans_.merge(a, b, in_place == In_place::a ? In_place::a : In_place::none);
      return a | b;
    case Operation::negate:
    case Operation::absolute:
    case Operation::minimum:
    case Operation::maximum:
      to.plan[0] = plans_.merge(a, b);
      return a | b;
    case Operation::sign:
      return 1;
    case Operation::multiply:
      to.plan[0] = plans_.product(a, b);
      return product_support(a, b, order);
    case Operation::divide:
      to.plan[0] = plans_.quotient(a, b);
      return product_support(a, composition_support(b, order), order);
    case Operation::power: {
      const Support log_a = composition_support(a, order);
      const Support exponent = product_support(b, log_a, order);
      to.plan = {plans_.composition(a), plans_.product(b, log_a), plans_.composition(exponent)};
      return composition_support(exponent, order);
    }
    case Operation::atan2: {
      const Support tangent = product_support(a | b, composition_support(a | b, order), order);
      to.plan = {plans_.merge(a, b), plans_.quotient(a | b, a | b), plans_.composition(tangent)};
      return composition_support(tangent, order);
    }
    default: // an elementary function, or a power with a constant exponent
      to.plan[0] = plans_.composition(a);
      return composition_support(a, order);
    }
  }

  const std::vector<Node>& nodes_;
  Id root_;
  std::uint32_t stride_;
  Jet_program program_;
  std::vector<std::uint32_t> place_;
  std::vector<Support> support_;
  std::vector<Id> last_use_; ///< 0: not used (node 0 uses nothing)
  std::vector<std::uint32_t> free_;
  std::uint32_t end_ = 0;
  Jet_plans plans_;
};

} // namespace

Jet_program make_jet_program(const Expression& expression, Expression::Id root, int order) {
  return Program_maker(expression, root, order).make();
}

} // namespace CGAL::Extremal_mesh_3::internal
