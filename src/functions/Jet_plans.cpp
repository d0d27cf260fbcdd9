// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Jet_plans.h"

#include <CGAL/Extremal_mesh_3/internal/Taylor_indices.h>

#include <array>

namespace CGAL::Extremal_mesh_3::internal {
namespace {

using Terms = std::array<std::vector<Jet_plan::Term>, max_taylor_size>;

Support bit(std::size_t i) {
  return Support{1} << i;
}
bool has(Support s, std::size_t i) {
  return (s >> i & 1u) != 0;
}

/// the products of coefficients that add up to each coefficient of a product, by ascending number of a's.
Terms product_terms(Support a, Support b, int order) {
  Terms terms;
  for (std::size_t i = 0; i < max_taylor_size; ++i)
    for (std::size_t j = 0; j < max_taylor_size; ++j)
      if (has(a, i) && has(b, j) && taylor_tables.degree[i] + taylor_tables.degree[j] <= order)
        terms[taylor_tables.product[i][j]].push_back({static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(j)});
  return terms;
}

void add_row(Jet_plan& plan, std::size_t out, bool from_a, bool from_b, const std::vector<Jet_plan::Term>& terms) {
  plan.rows.push_back({static_cast<std::uint8_t>(out), from_a, from_b, static_cast<std::uint16_t>(terms.size())});
  plan.terms.insert(plan.terms.end(), terms.begin(), terms.end());
}

} // namespace

Support product_support(Support a, Support b, int order) {
  Support support = 0;
  const Terms terms = product_terms(a, b, order);
  for (std::size_t k = 0; k < max_taylor_size; ++k)
    if (!terms[k].empty())
      support |= bit(k);
  return support;
}

Support composition_support(Support a, int order) {
  Support support = 1;
  for (int k = 0; k < order; ++k)
    support = product_support(support, a | 1, order);
  return support;
}

template <class Make> std::uint32_t Jet_plans::find_or_make(const Key& key, const Make& make) {
  const auto [position, is_new] = numbers_.try_emplace(key, static_cast<std::uint32_t>(plans_.size()));
  if (is_new)
    plans_.push_back(make());
  return position->second;
}

std::uint32_t Jet_plans::merge(Support a, Support b, In_place in_place) {
  return find_or_make({static_cast<int>(in_place), a, b}, [&] {
    const Support skipped = in_place == In_place::a ? a & ~b : in_place == In_place::b ? b & ~a : 0;
    Jet_plan plan;
    for (std::size_t k = 0; k < max_taylor_size; ++k)
      if (has((a | b) & ~skipped, k))
        add_row(plan, k, has(a, k), has(b, k), {});
    return plan;
  });
}

std::uint32_t Jet_plans::product(Support a, Support b) {
  return find_or_make({3, a, b}, [&] {
    Jet_plan plan;
    const Terms terms = product_terms(a, b, order_);
    for (std::size_t k = 0; k < max_taylor_size; ++k)
      if (!terms[k].empty())
        add_row(plan, k, false, false, terms[k]);
    return plan;
  });
}

std::uint32_t Jet_plans::quotient(Support a, Support b) {
  return find_or_make({4, a, b}, [&] {
    // q·b = a gives q[k] = (a[k] - Σ q[i]·b[j]) / b[0], the sum over j > 0 having only q of lower degree.
    Jet_plan plan;
    const Support quotient = product_support(a, composition_support(b, order_), order_);
    const Terms terms = product_terms(quotient, b & ~Support{1}, order_);
    for (std::size_t k = 0; k < max_taylor_size; ++k)
      if (has(quotient, k))
        add_row(plan, k, has(a, k), true, terms[k]);
    return plan;
  });
}

std::uint32_t Jet_plans::composition(Support a) {
  return find_or_make({5, a, 0}, [&] {
    // Horner's rule in h = a without its value. As h has no constant term, a coefficient needs only such of lower
    // degree from the step before, and descending degrees can overwrite it. Step k needs no degrees above k.
    Jet_plan plan;
    const Support h = a & ~Support{1};
    Support sum = 1;
    for (int k = 1; k <= order_; ++k) {
      const Terms terms = product_terms(h, sum, k);
      for (std::size_t i = max_taylor_size; i-- > 1;)
        if (!terms[i].empty()) {
          add_row(plan, i, false, false, terms[i]);
          sum |= bit(i);
        }
      plan.stage[static_cast<std::size_t>(k)] = static_cast<std::uint32_t>(plan.rows.size());
    }
    return plan;
  });
}

} // namespace CGAL::Extremal_mesh_3::internal
