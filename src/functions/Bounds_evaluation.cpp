// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Bounds_evaluation.h"

#include "elementary_bounds.h"

#include <CGAL/Extremal_mesh_3/internal/Taylor_indices.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace CGAL::Extremal_mesh_3::internal {
namespace {

using Row = Jet_plan::Row;
using Term = Jet_plan::Term;

/// What `Evaluator` of Jet_evaluation.cpp does with doubles, instruction by instruction, for one box instead of points.
class Bounds_evaluator {
public:
  Bounds_evaluator(const Jet_program& program, Interval* scratch)
      : program_(program), order_(program.order), scratch_(scratch) {}

  /// \return up to which order the derivatives exist in all of the box, or are known on both sides of a kink
  int run(const Box_3& box) {
    for (std::size_t c = 0; c < program_.constants.size(); ++c)
      scratch_[c] = {program_.constants[c], program_.constants[c]};
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (program_.uses_variable[axis]) {
        Interval* const jet = scratch_ + program_.variable[axis];
        *jet = {box.low[axis], box.high[axis]};
        if (order_ > 0)
          jet[1 + axis] = {1, 1};
      }
    for (const Jet_instruction& i : program_.instructions)
      jet(i);
    return known_order_;
  }

private:
  const Jet_plan& plan(const Jet_instruction& i, std::size_t n) const { return program_.plans[i.plan[n]]; }

  /// does `body` for each coefficient that a plan names; at order 0, where there are no plans, for the value.
  template <class Body> void each(const Jet_instruction& i, const Body& body) const {
    if (order_ == 0)
      return body(Row{0, true, true, 0});
    for (const Row& row : plan(i, 0).rows)
      body(row);
  }

  void jet(const Jet_instruction& i) {
    const Interval* const a = scratch_ + i.a;
    const Interval* const b = scratch_ + i.b;
    Interval* const out = scratch_ + i.out;
    const auto elementary = [&](const Univariate_bounds& f) { compose(i, 0, a, f, out); };
    switch (i.operation) {
    case Operation::constant:
    case Operation::variable:
      return;
    // clang-format off
    case Operation::negate: return each(i, [&](const Row& r) { out[r.out] = -a[r.out]; });
    case Operation::absolute: return absolute(i, a, out);
    case Operation::sign: return sign(a, out);
    case Operation::sqrt: return elementary(bound_sqrt(*a, order_));
    case Operation::cbrt: return elementary(bound_cbrt(*a, order_));
    case Operation::exp: return elementary(bound_exp(*a, order_));
    case Operation::log: return elementary(bound_log(*a, order_));
    case Operation::log2: return elementary(bound_log2(*a, order_));
    case Operation::log10: return elementary(bound_log10(*a, order_));
    case Operation::sin: return elementary(bound_sin(*a, order_));
    case Operation::cos: return elementary(bound_cos(*a, order_));
    case Operation::tan: return elementary(bound_tan(*a, order_));
    case Operation::asin: return elementary(bound_asin(*a, order_));
    case Operation::acos: return elementary(bound_acos(*a, order_));
    case Operation::atan: return elementary(bound_atan(*a, order_));
    case Operation::sinh: return elementary(bound_sinh(*a, order_));
    case Operation::cosh: return elementary(bound_cosh(*a, order_));
    case Operation::tanh: return elementary(bound_tanh(*a, order_));
    // clang-format on
    case Operation::add:
      return each(i, [&](const Row& r) {
        out[r.out] = r.from_a && r.from_b ? a[r.out] + b[r.out] : (r.from_a ? a : b)[r.out];
      });
    case Operation::subtract:
      return each(i, [&](const Row& r) {
        out[r.out] = r.from_a && r.from_b ? a[r.out] - b[r.out] : r.from_a ? a[r.out] : -b[r.out];
      });
    case Operation::multiply:
      return multiply(i, 0, a, b, out);
    case Operation::divide:
      return divide(i, 0, a, b, out);
    case Operation::minimum:
      return choose(i, a, b, out, a->high < b->low, b->high < a->low, [](const Interval& u, const Interval& v) {
        return Interval{std::min(u.low, v.low), std::min(u.high, v.high)};
      });
    case Operation::maximum:
      return choose(i, a, b, out, a->low > b->high, b->low > a->high, [](const Interval& u, const Interval& v) {
        return Interval{std::max(u.low, v.low), std::max(u.high, v.high)};
      });
    case Operation::real_power:
      return elementary(bound_power(*a, b->low, order_));
    case Operation::power:
      return power(i, a, b, out);
    case Operation::atan2:
      return angle(i, a, b, out);
    }
  }

  /// sets all coefficients but the value.
  void set_derivatives(Interval* out, const Interval& to) const { std::fill(out + 1, out + taylor_size(order_), to); }
  void set(Interval* out, const Interval& to) const {
    *out = to;
    set_derivatives(out, to);
  }

  void absolute(const Jet_instruction& i, const Interval* a, Interval* out) {
    const Interval value = *a;
    if (value.low >= 0)
      return each(i, [&](const Row& r) { out[r.out] = a[r.out]; });
    if (value.high <= 0)
      return each(i, [&](const Row& r) { out[r.out] = -a[r.out]; });
    known_order_ = std::min(known_order_, 1);
    each(i, [&](const Row& r) { out[r.out] = hull(a[r.out], -a[r.out]); });
    *out = value.is_empty() ? no_number : Interval{0, std::max(-value.low, value.high)};
  }

  void sign(const Interval* a, Interval* out) {
    const Interval value = *a;
    if (value.is_empty())
      return set(out, no_number);
    if (value.low <= 0 && value.high >= 0)
      known_order_ = 0;
    set_derivatives(out, {0, 0});
    *out = {Extremal_mesh_3::internal::sign(value.low), Extremal_mesh_3::internal::sign(value.high)};
  }

  template <class Of_values>
  void choose(const Jet_instruction& i, const Interval* a, const Interval* b, Interval* out, bool takes_a, bool takes_b,
              const Of_values& of_values) {
    const Interval u = *a, v = *b;
    if (!takes_a && !takes_b)
      known_order_ = std::min(known_order_, 1);
    each(i, [&](const Row& r) {
      const Interval from_a = r.from_a ? a[r.out] : Interval{}, from_b = r.from_b ? b[r.out] : Interval{};
      out[r.out] = takes_a ? from_a : takes_b ? from_b : hull(from_a, from_b);
    });
    *out = u.is_empty() || v.is_empty() ? no_number : of_values(u, v);
  }

  /// sets the coefficient of a row to its sum of products.
  /// \return the next row's first term
  static const Term* add_products(const Row& row, const Term* term, const Interval* a, const Interval* b,
                                  Interval* out) {
    const auto product = [&] { return a == b && term->a == term->b ? square(a[term->a]) : a[term->a] * b[term->b]; };
    Interval sum = product();
    for (const Term* const end = term++ + row.terms; term != end; ++term)
      sum = sum + product();
    out[row.out] = sum;
    return term;
  }

  void multiply(const Jet_instruction& i, std::size_t n, const Interval* a, const Interval* b, Interval* out) const {
    if (order_ == 0) {
      *out = a == b ? square(*a) : *a * *b;
      return;
    }
    const Term* term = plan(i, n).terms.data();
    for (const Row& row : plan(i, n).rows)
      term = add_products(row, term, a, b, out);
  }

  void divide(const Jet_instruction& i, std::size_t n, const Interval* a, const Interval* b, Interval* out) const {
    if (order_ == 0) {
      *out = *a / *b;
      return;
    }
    const bool has_pole = !(b->low > 0 || b->high < 0); // derivatives do not tell about the other side of it
    const Term* term = plan(i, n).terms.data();
    for (const Row& row : plan(i, n).rows) {
      Interval sum = row.from_a ? a[row.out] : Interval{};
      for (const Term* const end = term + row.terms; term != end; ++term)
        sum = sum - out[term->a] * b[term->b];
      out[row.out] = has_pole && row.out != 0 && !b->is_empty() ? all_numbers : sum / *b;
    }
  }

  /// the function whose Taylor coefficients at the value of a have the bounds f, of a.
  void compose(const Jet_instruction& i, std::size_t n, const Interval* a, const Univariate_bounds& f,
               Interval* out) const {
    if (order_ > 0) {
      const Jet_plan& p = plan(i, n);
      *out = f[static_cast<std::size_t>(order_)];
      const Term* term = p.terms.data();
      for (std::size_t k = 1; k <= static_cast<std::size_t>(order_); ++k) {
        for (std::uint32_t r = p.stage[k - 1]; r < p.stage[k]; ++r)
          term = add_products(p.rows[r], term, a, out, out);
        *out = f[static_cast<std::size_t>(order_) - k];
      }
    }
    *out = f[0];
  }

  /// a^b = exp(b log a).
  void power(const Jet_instruction& i, const Interval* a, const Interval* b, Interval* out) const {
    if (a->is_empty() || b->is_empty())
      return set(out, no_number);
    if (!(a->low > 0)) // a power of a negative number is defined where the exponent is whole
      return set(out, all_numbers);
    Interval* const log_a = scratch_ + program_.temporary;
    Interval* const exponent = log_a + taylor_size(order_);
    compose(i, 0, a, bound_log(*a, order_), log_a);
    multiply(i, 1, b, log_a, exponent);
    compose(i, 2, exponent, bound_exp(*exponent, order_), out);
  }

  /// the angle of (x, y) as that of the middle of the box plus one that is small, the arc tangent of a quotient.
  void angle(const Jet_instruction& i, const Interval* y, const Interval* x, Interval* out) const {
    if (y->is_empty() || x->is_empty())
      return set(out, no_number);
    if (x->low <= 0 && y->low <= 0 && y->high >= 0) // it jumps by 2π
      return set(out, all_numbers);
    const Interval value = bound_atan2(*y, *x);
    if (order_ > 0) {
      Interval* const across = scratch_ + program_.temporary;
      Interval* const tangent = across + taylor_size(order_);
      Interval* const along = out; // until it is divided by
      const double mx = x->low / 2 + x->high / 2, my = y->low / 2 + y->high / 2, r = std::hypot(mx, my);
      const double c = mx / r, s = my / r; // a turn, up to rounding; any factors give that quotient's angle
      if (!std::isfinite(c) || !std::isfinite(s))
        return set(out, all_numbers);
      each(i, [&](const Row& row) {
        const Interval u = row.from_b ? x[row.out] : Interval{}, v = row.from_a ? y[row.out] : Interval{};
        along[row.out] = u * c + v * s;
        across[row.out] = v * c - u * s;
      });
      divide(i, 1, across, along, tangent);
      compose(i, 2, tangent, bound_atan(*tangent, order_), out);
    }
    *out = value;
  }

  const Jet_program& program_;
  int order_;
  int known_order_ = max_taylor_order;
  Interval* scratch_;
};

} // namespace

int evaluate_bounds(const Jet_program& program, const Box_3& box, Interval* scratch) {
  return Bounds_evaluator(program, scratch).run(box);
}

} // namespace CGAL::Extremal_mesh_3::internal
