// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_FORMULA_H
#define CGAL_EXTREMAL_MESH_3_FORMULA_H

#include <CGAL/Extremal_mesh_3/Function_3.h>

#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

namespace CGAL::Extremal_mesh_3 {

/// A formula that cannot be understood. The message gives the position and what was expected there.
class Formula_error : public std::invalid_argument {
public:
  /// \param message  one sentence
  /// \param position  offset in characters from the start of the text, from 0
  Formula_error(const std::string& message, std::size_t position)
      : std::invalid_argument(message), position_(position) {}
  /// \return the offset in characters from the start of the text, from 0
  std::size_t position() const { return position_; }

private:
  std::size_t position_;
};

/// A function of x, y and z given as text, such as `x^2/9 + y^2/4 + z^2 - 1`, differentiated exactly.
///
/// - numbers `2`, `.5`, `1e-5`, the variables `x y z`, the constants `pi` and `e`;
/// - `+ - * /`, powers `^` or `**`, parentheses. `-x^2` is `-(x^2)` and `2^3^2` is `2^(3^2)`. A product needs its `*`;
/// - `sqrt cbrt exp log ln log2 log10 sin cos tan asin acos atan sinh cosh tanh abs sign` of one argument, `pow atan2`
/// of two,
///   `min max hypot` of two or more. `log` and `ln` are the natural logarithm, angles are in radians;
/// - an equation `f = g` means `f - g`.
///
/// Powers with a constant integer exponent up to 64 in size are products and exist for every base; other powers are
/// those of `std::pow`, with derivatives where the base is positive.
/// At a kink the derivatives are those of one branch: of `u` for `abs(u)` where `u = 0`, and
/// of `u` for `min(u, v)` and `max(u, v)` where `u = v`. `sign` has derivatives 0.
///
/// The bits of a value or derivative depend on the formula and the point alone: `value()`, `lattice_values()` and
/// `derivatives()` of any order, at one point or many, in any thread, agree exactly. Evaluation does not allocate, but
/// for a scratch memory that each thread keeps. The construction takes time and memory in proportion to the text.
class Formula : public Function_3 {
public:
  /// understands a text.
  /// \param text  the formula
  /// \throws Formula_error if the text is not a formula, is longer than a million characters, or has more than 1000
  /// levels of
  ///         parentheses, signs and operators that wait for their right side
  explicit Formula(std::string_view text);
  ~Formula() override;
  Formula(Formula&&) noexcept; ///< takes over what another one holds

  /// \copydoc Function_3::value()
  double value(const Point& p) const override;

  /// \copydoc Function_3::derivatives()
  /// \throws std::invalid_argument if `order` is not 1 to 4
  void derivatives(const Point& p, int order, Derivatives& d) const override;

  /// fills the derivatives at many points, several times faster than one by one.
  /// \param points  where
  /// \param order  1 to 4
  /// \param d  as many as there are points
  /// \throws std::invalid_argument if `order` is not 1 to 4, or the sizes differ
  void derivatives(std::span<const Point> points, int order, std::span<Derivatives> d) const;

  void lattice_values(const Lattice& lattice, std::size_t k, double* out) const override;
  void lattice_values(const Lattice& lattice, std::size_t k, std::span<const Row_part> parts,
                      double* out) const override;

  /// \copydoc Function_3::bounds_cost()
  Bounds_cost bounds_cost() const override { return Bounds_cost::low; }
  /// bounds by interval arithmetic, valid for real numbers: of the formula with its constants as they are rounded,
  /// and not of what rounding makes of it at a point.
  /// \copydetails Function_3::bounds()
  /// \throws std::invalid_argument if `order` is not 0 to 4
  bool bounds(const Box_3& box, int order, Derivative_bounds& d) const override;

private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_FORMULA_H
