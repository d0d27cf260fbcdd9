// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_FUNCTION_3_H
#define CGAL_EXTREMAL_MESH_3_FUNCTION_3_H

#include <CGAL/Extremal_mesh_3/Derivative_bounds.h>
#include <CGAL/Extremal_mesh_3/Derivatives.h>
#include <CGAL/Extremal_mesh_3/Lattice.h>

#include <array>
#include <cstddef>
#include <optional>
#include <span>

namespace CGAL::Extremal_mesh_3 {

/// A function of R³ with exact derivatives anywhere, whose zero set is a surface. Its gradient gives the surface's
/// normal `n = ∇f/|∇f|`: an `f` that is negative inside has its normal outwards.
///
/// All member functions may be called from several threads at once, and give the same bits for the same arguments.
/// Where the function is not defined they give NaN.
class Function_3 {
public:
  virtual ~Function_3() = default;

  /// the value at `p`.
  /// \param p  a point
  /// \return the value; NaN where the function is not defined
  virtual double value(const Point& p) const = 0;

  /// fills the value and the derivatives up to `order` at `p`.
  /// \param p  a point
  /// \param order  1 to `max_order()`
  /// \param d  gets them
  virtual void derivatives(const Point& p, int order, Derivatives& d) const = 0;

  /// the highest order of derivatives that is exact: 3 or 4. With 3, the sign of the derivative of an
  /// extremality along its line of curvature (maximum or minimum) is estimated by differences.
  /// \return 3 or 4
  virtual int max_order() const { return 4; }

  /// the values at the nodes (·,·,k) of a lattice.
  /// \param lattice  the lattice
  /// \param k  which slice of it
  /// \param out  `size[0]·size[1]` values, i fastest. The default calls `value()`; models that can do better override it.
  ///             A value may differ from `value()` by rounding.
  virtual void lattice_values(const Lattice& lattice, std::size_t k, double* out) const;

  /// the values at some of the nodes (·,·,k) of a lattice.
  /// \param lattice  the lattice
  /// \param k  which slice of it
  /// \param parts  which nodes of the slice
  /// \param out  `size[0]·size[1]` values, i fastest, of which those at the nodes of `parts` are set. The default calls `value()`.
  virtual void lattice_values(const Lattice& lattice, std::size_t k, std::span<const Row_part> parts,
                              double* out) const;

  /// the values at the corners of a cube of a lattice and half way between them.
  /// \param lattice  the lattice
  /// \param cube  its corner with the smallest numbers
  /// \param out  `out[a + 3·b + 9·c]` at (a, b, c)/2 of the steps
  /// \return whether the model has a faster way than `value()`, and may differ from that by rounding; the default has none
  virtual bool half_step_values(const Lattice& lattice, const std::array<std::size_t, 3>& cube,
                                std::array<double, 27>& out) const;

  /// the root on an edge of a lattice at whose ends the values v0 and v1 have different signs, in parts of the edge.
  /// \param lattice  the lattice
  /// \param node  where the edge begins, which goes along `lattice.step[axis]`
  /// \param axis  along which it goes: 0, 1 or 2
  /// \param v0,v1  the values at its ends
  /// \return nothing if the model has no faster way than `derivatives()`; the default has none
  virtual std::optional<double> root_on_edge(const Lattice& lattice, const std::array<std::size_t, 3>& node,
                                             std::size_t axis, double v0, double v1) const;

  /// tells whether `bounds()` can be had, and at what price.
  /// \return the price
  virtual Bounds_cost bounds_cost() const { return Bounds_cost::unknown; }

  /// bounds the value and the derivatives up to `order` over a box: the ground for proofs about the surface. Bounds
  /// need not be tight, but get so as the box gets small. At a kink, such as that of `abs`, the bounds of the first derivatives
  /// hold those of all branches.
  /// \param box  where
  /// \param order  0 to 4
  /// \param d  gets them
  /// \return whether they are known. They are unless `bounds_cost()` is `unknown`; those that are not known in this box
  ///         are infinite.
  virtual bool bounds(const Box_3& box, int order, Derivative_bounds& d) const;

protected:
  Function_3() = default;
  Function_3(const Function_3&) = default; ///< for models
  /// for models.
  /// \return this one
  Function_3& operator=(const Function_3&) = default;
};

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_FUNCTION_3_H
