// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_JET_H
#define CGAL_EXTREMAL_MESH_3_JET_H

#include <CGAL/Extremal_mesh_3/internal/Taylor_indices.h>

#include <compare>
#include <type_traits>
#include <utility>

namespace CGAL::Extremal_mesh_3 {

/// A number that carries its Taylor polynomial in x, y and z: computing with jets instead of doubles gives a function's
/// derivatives up to a total order, exact to rounding, without a formula for them.
///
/// Arithmetic, mixed with double, is found in this header, and `sqrt exp log log2 log10 sin cos tan asin acos atan
/// atan2 sinh cosh tanh abs min max pow cbrt hypot square` in the same namespace, so that
/// `using std::sqrt; sqrt(u)` serves both. Comparisons look at the value alone. Where a function has a
/// kink (`abs`, `min`, `max`) a jet is that of one branch: at a tie `abs(u)` is `u` and `min(u, v)`, `max(u, v)` are
/// `u`. Outside of a function's domain everything is NaN; at its border (`sqrt` at 0) derivatives are infinite or NaN.
/// A product at order 4 takes 210 multiplications, a function about 260.
/// \tparam Order  highest order of derivatives, 1 to 4
template <int Order> class Basic_jet {
  static_assert(Order >= 1 && Order <= internal::max_taylor_order);

public:
  static constexpr int order = Order; ///< the highest order of derivatives
  /// number of Taylor coefficients: 4, 10, 20 or 35
  static constexpr std::size_t size = internal::taylor_size(Order);

  /// a constant.
  /// \param value  its value
  constexpr Basic_jet(double value = 0) : c_{value} {} // NOLINT: constants mix freely with jets

  /// one of the variables.
  /// \param value  its value
  /// \param axis  0, 1 or 2 for x, y, z
  /// \return the variable at that value
  static constexpr Basic_jet variable(double value, std::size_t axis) {
    Basic_jet u(value);
    u.c_[1 + axis] = 1;
    return u;
  }

  /// \return the function's value
  constexpr double value() const { return c_[0]; }

  /// the Taylor coefficient of number `i`, in the order of `Derivatives` (1, x, y, z, xx, xy, …).
  /// \param i  below `size`
  /// \return the coefficient
  constexpr double operator[](std::size_t i) const { return c_[i]; }
  /// the same, to be changed.
  /// \param i  below `size`
  /// \return the coefficient
  constexpr double& operator[](std::size_t i) { return c_[i]; }

  /// fills the derivatives.
  /// \param d  gets them
  /// \param up_to  the highest order that is filled, at most `Order`
  void store(Derivatives& d, int up_to = Order) const {
    internal::taylor_to_derivatives([this](std::size_t i) { return c_[i]; }, up_to, d);
  }

  /// the derivatives up to `Order`; those above are 0.
  explicit operator Derivatives() const {
    Derivatives d;
    store(d);
    return d;
  }

  /// \name Arithmetic in place
  /// @{

  /// changes the jet by another one, or by a constant.
  /// \param v  the other operand
  /// \return this jet
  constexpr Basic_jet& operator+=(const Basic_jet& v) {
    for (std::size_t i = 0; i < size; ++i)
      c_[i] += v.c_[i];
    return *this;
  }
  constexpr Basic_jet& operator-=(const Basic_jet& v) {
    for (std::size_t i = 0; i < size; ++i)
      c_[i] -= v.c_[i];
    return *this;
  }
  constexpr Basic_jet& operator*=(double v) {
    for (double& c : c_)
      c *= v;
    return *this;
  }
  constexpr Basic_jet& operator/=(double v) {
    for (double& c : c_)
      c /= v;
    return *this;
  }
  constexpr Basic_jet& operator+=(double v) { return c_[0] += v, *this; }
  constexpr Basic_jet& operator-=(double v) { return c_[0] -= v, *this; }
  constexpr Basic_jet& operator*=(const Basic_jet& v) { return *this = *this * v; }
  constexpr Basic_jet& operator/=(const Basic_jet& v) { return *this = *this / v; }

  /// @}

  /// \name Arithmetic
  /// @{

  /// computes with one jet.
  /// \param u  the operand
  /// \return the result, with its derivatives
  friend constexpr Basic_jet operator+(const Basic_jet& u) { return u; }
  friend constexpr Basic_jet operator-(Basic_jet u) {
    for (double& c : u.c_)
      c = -c;
    return u;
  }
  /// @}

  /// \name Arithmetic of two
  /// @{

  /// computes with two jets, or with a jet and a constant.
  /// \param u,v  the operands
  /// \return the result, with its derivatives
  friend constexpr Basic_jet operator+(Basic_jet u, const Basic_jet& v) { return u += v; }
  friend constexpr Basic_jet operator+(Basic_jet u, double v) { return u += v; }
  friend constexpr Basic_jet operator+(double u, Basic_jet v) { return v += u; }
  friend constexpr Basic_jet operator-(Basic_jet u, const Basic_jet& v) { return u -= v; }
  friend constexpr Basic_jet operator-(Basic_jet u, double v) { return u -= v; }
  friend constexpr Basic_jet operator-(double u, const Basic_jet& v) { return -v += u; }
  friend constexpr Basic_jet operator*(Basic_jet u, double v) { return u *= v; }
  friend constexpr Basic_jet operator*(double u, Basic_jet v) { return v *= u; }
  friend constexpr Basic_jet operator/(Basic_jet u, double v) { return u /= v; }
  friend constexpr Basic_jet operator/(double u, const Basic_jet& v) { return Basic_jet(u) / v; }

  friend constexpr Basic_jet operator*(const Basic_jet& u, const Basic_jet& v) {
    Basic_jet w;
    for_each_coefficient([&](auto i) { w.template add_multiple<i, 0>(u.c_[i], v); });
    return w;
  }

  /// The quotient comes from the recurrence that `(u/v)·v = u` gives coefficient by coefficient.
  /// \param u,v  the operands
  /// \return the quotient, with its derivatives
  friend constexpr Basic_jet operator/(const Basic_jet& u, const Basic_jet& v) {
    Basic_jet q = u;
    for_each_coefficient([&](auto i) { // q[i] is complete when its turn comes: its terms have lower degrees
      q.c_[i] /= v.c_[0];
      q.template add_multiple<i, 1>(-q.c_[i], v);
    });
    return q;
  }

  /// @}

  /// \name Comparison
  /// @{

  /// compares the values alone.
  /// \param u,v  the operands
  /// \return how they compare
  friend constexpr bool operator==(const Basic_jet& u, const Basic_jet& v) { return u.c_[0] == v.c_[0]; }
  friend constexpr bool operator==(const Basic_jet& u, double v) { return u.c_[0] == v; }
  friend constexpr std::partial_ordering operator<=>(const Basic_jet& u, const Basic_jet& v) {
    return u.c_[0] <=> v.c_[0];
  }
  friend constexpr std::partial_ordering operator<=>(const Basic_jet& u, double v) { return u.c_[0] <=> v; }
  /// @}

private:
  // Unrolled, with all indices known to the compiler, products are twice as fast as in loops over tables.
  template <class Body> static constexpr void for_each_coefficient(const Body& body) {
    [&]<std::size_t... I>(std::index_sequence<I...>) {
      (body(std::integral_constant<std::size_t, I>()), ...);
    }
    (std::make_index_sequence<size>());
  }

  /// adds s·v, from v's coefficient `First` on, multiplied by the monomial of number `I`.
  template <std::size_t I, std::size_t First> constexpr void add_multiple(double s, const Basic_jet& v) {
    constexpr std::size_t n = internal::taylor_size(Order - internal::taylor_tables.degree[I]);
    [&]<std::size_t... J>(std::index_sequence<J...>) {
      ((c_[internal::taylor_tables.product[I][First + J]] += s * v.c_[First + J]), ...);
    }
    (std::make_index_sequence<n - First>());
  }

  std::array<double, size> c_{};
};

/// A number with all its 35 Taylor coefficients up to order 4.
using Jet = Basic_jet<4>;

} // namespace CGAL::Extremal_mesh_3

#include <CGAL/Extremal_mesh_3/internal/Jet_functions.h>

#endif // CGAL_EXTREMAL_MESH_3_JET_H
