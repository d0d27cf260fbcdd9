// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_FUNCTOR_FUNCTION_H
#define CGAL_EXTREMAL_MESH_3_FUNCTOR_FUNCTION_H

#include <CGAL/Extremal_mesh_3/Function_3.h>
#include <CGAL/Extremal_mesh_3/Jet.h>

#include <concepts>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

namespace CGAL::Extremal_mesh_3 {

/// A user's functor that computes its own derivatives: `f(p, order, d)` fills the value (order 0) or the value and the
/// derivatives up to `order` at `p`. It is called from several threads at once.
template <std::invocable<const Point&, int, Derivatives&> F> class Functor_function : public Function_3 {
public:
  /// \param f  the functor
  /// \param max_order  the highest order that `f` fills: 3 or 4
  /// \throws std::invalid_argument for another `max_order`
  Functor_function(F f, int max_order) : f_(std::move(f)), max_order_(max_order) {
    if (max_order != 3 && max_order != 4)
      throw std::invalid_argument("Functor_function: max_order is " + std::to_string(max_order) + ", not 3 or 4");
  }

  /// \copydoc Function_3::value()
  double value(const Point& p) const override {
    Derivatives d;
    f_(p, 0, d);
    return d.value;
  }

  void derivatives(const Point& p, int order, Derivatives& d) const override { f_(p, order, d); }

  int max_order() const override { return max_order_; }

private:
  F f_;
  int max_order_;
};

/// A user's generic functor of three numbers, differentiated by calling it with jets:
///
///     auto f = make_function([](auto x, auto y, auto z) { using std::sqrt; return sqrt(x * x + y * y) + z * z - 1; });
///
/// Functions of `<cmath>` are to be called unqualified, so that those of jets are found. The functor is called from
/// several threads at once.
template <std::invocable<double, double, double> F> class Lambda_function : public Function_3 {
public:
  /// \param f  the functor
  explicit Lambda_function(F f) : f_(std::move(f)) {}

  /// \copydoc Function_3::value()
  double value(const Point& p) const override { return static_cast<double>(f_(p[0], p[1], p[2])); }

  /// \copydoc Function_3::derivatives()
  /// Its value may differ from `value()` by rounding.
  /// \throws std::invalid_argument if `order` is not 1 to 4
  void derivatives(const Point& p, int order, Derivatives& d) const override {
    if (order < 1 || order > 4)
      throw std::invalid_argument("Lambda_function: order is " + std::to_string(order) + ", not 1 to 4");
    if (order == 1) // no more than the cost of what is asked for; 2 is rare
      evaluate<1>(p).store(d, order);
    else if (order <= 3)
      evaluate<3>(p).store(d, order);
    else
      evaluate<4>(p).store(d, order);
  }

private:
  template <int Order> Basic_jet<Order> evaluate(const Point& p) const {
    using J = Basic_jet<Order>;
    return J(f_(J::variable(p[0], 0), J::variable(p[1], 1), J::variable(p[2], 2)));
  }

  F f_;
};

/// makes a function from a generic functor of three numbers, such as a lambda with `auto` parameters.
/// \param f  the functor
/// \return the function
template <std::invocable<double, double, double> F> Lambda_function<std::decay_t<F>> make_function(F&& f) {
  return Lambda_function<std::decay_t<F>>(std::forward<F>(f));
}

/// makes a function from a functor `f(const Point&, int order, Derivatives&)` that computes its own derivatives.
/// \param f  the functor
/// \param max_order  the highest order that it fills
/// \return the function
/// \throws std::invalid_argument if `max_order` is not 3 or 4
template <std::invocable<const Point&, int, Derivatives&> F>
Functor_function<std::decay_t<F>> make_function(F&& f, int max_order) {
  return Functor_function<std::decay_t<F>>(std::forward<F>(f), max_order);
}

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_FUNCTOR_FUNCTION_H
