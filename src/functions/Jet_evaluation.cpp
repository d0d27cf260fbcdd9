// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Jet_evaluation.h"

#include <CGAL/Extremal_mesh_3/internal/Taylor_indices.h>
#include <CGAL/Extremal_mesh_3/internal/elementary_functions.h>

#include <algorithm>
#include <cmath>

namespace CGAL::Extremal_mesh_3::internal {
namespace {

using Row = Jet_plan::Row;
using Term = Jet_plan::Term;

template <int Order, std::size_t Lanes> class Evaluator {
public:
  Evaluator(const Jet_program& program, double* scratch) : program_(program), scratch_(scratch) {}

  void run(const double* points) {
    place_leaves(points);
    for (const Jet_instruction& i : program_.instructions)
      if constexpr (Order == 0)
        value(i);
      else
        jet(i);
  }

private:
  double* at(std::uint32_t place) const { return scratch_ + place * Lanes; }
  const Jet_plan& plan(const Jet_instruction& i, std::size_t n) const { return program_.plans[i.plan[n]]; }

  void place_leaves(const double* points) {
    for (std::size_t c = 0; c < program_.constants.size(); ++c)
      std::fill_n(scratch_ + c * Lanes, Lanes, program_.constants[c]);
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (program_.uses_variable[axis]) {
        double* const jet = at(program_.variable[axis]);
        std::copy_n(points + axis * Lanes, Lanes, jet);
        if constexpr (Order > 0)
          std::fill_n(jet + (1 + axis) * Lanes, Lanes, 1.0);
      }
  }

  void value(const Jet_instruction& i) {
    const double* const a = at(i.a);
    const double* const b = at(i.b);
    double* const out = at(i.out);
    with_scalar_operation(i.operation, [&](const auto& f) {
      for (std::size_t l = 0; l < Lanes; ++l)
        out[l] = f(a[l], b[l]);
    });
  }

  void jet(const Jet_instruction& i) {
    const double* const a = at(i.a);
    const double* const b = at(i.b);
    double* const out = at(i.out);
    const auto elementary = [&](const auto& taylor) {
      double f[(Order + 1) * Lanes];
      for (std::size_t l = 0; l < Lanes; ++l)
        set_lane(f, l, taylor(a[l]));
      compose(plan(i, 0), a, f, out);
    };
    switch (i.operation) {
    case Operation::constant:
    case Operation::variable:
      return;
    // clang-format off
    case Operation::negate: return each(plan(i, 0), [&](const Row& r, std::size_t l) { out[r.out * Lanes + l] = -a[r.out * Lanes + l]; });
    case Operation::absolute: return absolute(plan(i, 0), a, out);
    case Operation::sign: return value(i);
    case Operation::sqrt: return elementary(taylor_sqrt);
    case Operation::cbrt: return elementary(taylor_cbrt);
    case Operation::exp: return elementary(taylor_exp);
    case Operation::log: return elementary(taylor_log);
    case Operation::log2: return elementary(taylor_log2);
    case Operation::log10: return elementary(taylor_log10);
    case Operation::sin: return elementary(taylor_sin);
    case Operation::cos: return elementary(taylor_cos);
    case Operation::tan: return elementary(taylor_tan);
    case Operation::asin: return elementary(taylor_asin);
    case Operation::acos: return elementary(taylor_acos);
    case Operation::atan: return elementary(taylor_atan);
    case Operation::sinh: return elementary(taylor_sinh);
    case Operation::cosh: return elementary(taylor_cosh);
    case Operation::tanh: return elementary(taylor_tanh);
    case Operation::add: return add(plan(i, 0), a, b, out);
    case Operation::subtract: return subtract(plan(i, 0), a, b, out);
    case Operation::multiply: return multiply(plan(i, 0), a, b, out);
    case Operation::divide: return divide(plan(i, 0), a, b, out);
    case Operation::minimum: return choose(plan(i, 0), a, b, out, takes_second_as_minimum);
    case Operation::maximum: return choose(plan(i, 0), a, b, out, takes_second_as_maximum);
    case Operation::real_power: return elementary([c = b[0]](double u) { return taylor_power(u, c, std::pow(u, c)); });
    case Operation::power: return power(i, a, b, out);
    case Operation::atan2: return angle(i, a, b, out);
      // clang-format on
    }
  }

  static void set_lane(double* f, std::size_t l, const Univariate& taylor) {
    for (std::size_t k = 0; k <= Order; ++k)
      f[k * Lanes + l] = taylor[k];
  }

  template <class Body> static void each(const Jet_plan& plan, const Body& body) {
    for (const Row& row : plan.rows)
      for (std::size_t l = 0; l < Lanes; ++l)
        body(row, l);
  }

  static void add(const Jet_plan& plan, const double* a, const double* b, double* out) {
    for (const Row& row : plan.rows) {
      const std::size_t k = row.out * Lanes;
      if (row.from_a && row.from_b)
        for (std::size_t l = 0; l < Lanes; ++l)
          out[k + l] = a[k + l] + b[k + l];
      else
        std::copy_n((row.from_a ? a : b) + k, Lanes, out + k);
    }
  }

  static void subtract(const Jet_plan& plan, const double* a, const double* b, double* out) {
    for (const Row& row : plan.rows) {
      const std::size_t k = row.out * Lanes;
      if (row.from_a && row.from_b)
        for (std::size_t l = 0; l < Lanes; ++l)
          out[k + l] = a[k + l] - b[k + l];
      else if (row.from_a)
        std::copy_n(a + k, Lanes, out + k);
      else
        for (std::size_t l = 0; l < Lanes; ++l)
          out[k + l] = -b[k + l];
    }
  }

  static void absolute(const Jet_plan& plan, const double* a, double* out) {
    double sign[Lanes]; // kept, because out may be where a is
    for (std::size_t l = 0; l < Lanes; ++l)
      sign[l] = a[l] < 0 ? -1 : 1;
    each(plan, [&](const Row& row, std::size_t l) { out[row.out * Lanes + l] = sign[l] * a[row.out * Lanes + l]; });
  }

  template <class Takes_second>
  static void choose(const Jet_plan& plan, const double* a, const double* b, double* out, const Takes_second& second) {
    bool takes_b[Lanes];
    for (std::size_t l = 0; l < Lanes; ++l)
      takes_b[l] = second(a[l], b[l]);
    each(plan, [&](const Row& row, std::size_t l) {
      const std::size_t k = row.out * Lanes + l;
      out[k] = takes_b[l] ? (row.from_b ? b[k] : 0) : (row.from_a ? a[k] : 0);
    });
  }

  static void multiply(const Jet_plan& plan, const double* a, const double* b, double* out) {
    const Term* term = plan.terms.data();
    for (const Row& row : plan.rows)
      term = add_products(row, term, a, b, out);
  }

  /// sets the coefficient of a row to its sum of products.
  /// \return the next row's first term
  static const Term* add_products(const Row& row, const Term* term, const double* a, const double* b, double* out) {
    double sum[Lanes];
    for (std::size_t l = 0; l < Lanes; ++l)
      sum[l] = a[term->a * Lanes + l] * b[term->b * Lanes + l];
    for (const Term* const end = term++ + row.terms; term != end; ++term)
      for (std::size_t l = 0; l < Lanes; ++l)
        sum[l] += a[term->a * Lanes + l] * b[term->b * Lanes + l];
    std::copy_n(sum, Lanes, out + row.out * Lanes);
    return term;
  }

  static void divide(const Jet_plan& plan, const double* a, const double* b, double* out) {
    const Term* term = plan.terms.data();
    for (const Row& row : plan.rows) {
      double sum[Lanes]{};
      if (row.from_a)
        std::copy_n(a + row.out * Lanes, Lanes, sum);
      for (const Term* const end = term + row.terms; term != end; ++term)
        for (std::size_t l = 0; l < Lanes; ++l)
          sum[l] -= out[term->a * Lanes + l] * b[term->b * Lanes + l];
      for (std::size_t l = 0; l < Lanes; ++l)
        out[row.out * Lanes + l] = sum[l] / b[l];
    }
  }

  /// the function with Taylor coefficients f at the value of a, of a.
  static void compose(const Jet_plan& plan, const double* a, const double* f, double* out) {
    std::copy_n(f + Order * Lanes, Lanes, out);
    const Term* term = plan.terms.data();
    for (std::size_t k = 1; k <= Order; ++k) {
      for (std::uint32_t r = plan.stage[k - 1]; r < plan.stage[k]; ++r)
        term = add_products(plan.rows[r], term, a, out, out);
      std::copy_n(f + (Order - k) * Lanes, Lanes, out);
    }
  }

  /// a^b = exp(b log a), with the value of std::pow.
  void power(const Jet_instruction& i, const double* a, const double* b, double* out) {
    double* const log_a = at(program_.temporary);
    double* const exponent = log_a + taylor_size(Order) * Lanes;
    double f[(Order + 1) * Lanes];
    for (std::size_t l = 0; l < Lanes; ++l)
      set_lane(f, l, taylor_log(a[l]));
    compose(plan(i, 0), a, f, log_a);
    multiply(plan(i, 1), b, log_a, exponent);
    for (std::size_t l = 0; l < Lanes; ++l)
      set_lane(f, l, taylor_exponential(std::pow(a[l], b[l]), 1));
    compose(plan(i, 2), exponent, f, out);
  }

  /// the angle of (x, y): turned so that the direction of the values is the positive x axis, where it is atan(y/x).
  void angle(const Jet_instruction& i, const double* y, const double* x, double* out) {
    double* const across = at(program_.temporary);
    double* const tangent = across + taylor_size(Order) * Lanes;
    double* const along = out; // until it is divided by
    double f[(Order + 1) * Lanes], c[Lanes], s[Lanes];
    for (std::size_t l = 0; l < Lanes; ++l) {
      const double r = std::hypot(x[l], y[l]);
      c[l] = x[l] / r;
      s[l] = y[l] / r;
      set_lane(f, l, {std::atan2(y[l], x[l]), 1, 0, -1.0 / 3, 0});
    }
    each(plan(i, 0), [&](const Row& row, std::size_t l) {
      const std::size_t k = row.out * Lanes + l;
      const double u = row.from_b ? x[k] : 0, v = row.from_a ? y[k] : 0;
      along[k] = u * c[l] + v * s[l];
      across[k] = v * c[l] - u * s[l];
    });
    divide(plan(i, 1), across, along, tangent);
    compose(plan(i, 2), tangent, f, out);
  }

  const Jet_program& program_;
  double* scratch_;
};

template <std::size_t Lanes>
void evaluate_derivatives(const Jet_program& program, const double* points, double* scratch) {
  switch (program.order) {
  case 1:
    return Evaluator<1, Lanes>(program, scratch).run(points);
  case 2:
    return Evaluator<2, Lanes>(program, scratch).run(points);
  case 3:
    return Evaluator<3, Lanes>(program, scratch).run(points);
  default:
    return Evaluator<4, Lanes>(program, scratch).run(points);
  }
}

} // namespace

void evaluate_jets(const Jet_program& program, std::size_t lanes, const double* points, double* scratch) {
  if (program.order == 0)
    return lanes == 1 ? Evaluator<0, 1>(program, scratch).run(points)
                      : Evaluator<0, value_lanes>(program, scratch).run(points);
  return lanes == 1 ? evaluate_derivatives<1>(program, points, scratch)
                    : evaluate_derivatives<derivative_lanes>(program, points, scratch);
}

} // namespace CGAL::Extremal_mesh_3::internal
