// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_SRC_JET_PLANS_H
#define CGAL_EXTREMAL_MESH_3_SRC_JET_PLANS_H

#include "Jet_program.h"

#include <compare>
#include <map>

namespace CGAL::Extremal_mesh_3::internal {

/// the support of a product, up to an order.
Support product_support(Support a, Support b, int order);
/// the support of any function of a jet.
Support composition_support(Support a, int order);

enum class In_place { none, a, b };

/// Makes plans, each once.
class Jet_plans {
public:
  Jet_plans(int order, std::vector<Jet_plan>& plans) : order_(order), plans_(plans) {}

  /// all coefficients of a or b, for operations that take them one by one.
  /// \param in_place  the operand that already stands where the result goes, if what it has alone stays as it is
  std::uint32_t merge(Support a, Support b, In_place in_place = In_place::none);
  std::uint32_t product(Support a, Support b);
  std::uint32_t quotient(Support a, Support b);
  std::uint32_t composition(Support a);

private:
  struct Key {
    int kind;
    Support a, b;
    auto operator<=>(const Key&) const = default;
  };
  template <class Make> std::uint32_t find_or_make(const Key& key, const Make& make);

  int order_;
  std::vector<Jet_plan>& plans_;
  std::map<Key, std::uint32_t> numbers_;
};

} // namespace CGAL::Extremal_mesh_3::internal

#endif // CGAL_EXTREMAL_MESH_3_SRC_JET_PLANS_H
