// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_DERIVATIVE_BOUNDS_H
#define CGAL_EXTREMAL_MESH_3_DERIVATIVE_BOUNDS_H

#include <CGAL/Extremal_mesh_3/types.h>

#include <array>
#include <cstdint>

namespace CGAL::Extremal_mesh_3 {

/// The numbers from `low` to `high`, either of which may be infinite. Both NaN: no number at all.
struct Interval {
  double low = 0;  ///< the least number
  double high = 0; ///< the greatest number

  /// \return whether it holds no number
  bool is_empty() const { return !(low <= high); }
  /// \param x  a number
  /// \return whether it is in the interval
  bool contains(double x) const { return low <= x && x <= high; }
  /// \return the width, not rounded upwards
  double width() const { return high - low; }

  /// compares the ends.
  friend bool operator==(const Interval&, const Interval&) = default;
};

/// An axis-parallel box; it may be flat, down to a point.
struct Box_3 {
  Point low{};  ///< the corner with the smallest coordinates
  Point high{}; ///< the one with the largest
};

/// Bounds of a function and its partial derivatives over a box, arranged as in `Derivatives`: each interval holds what is
/// taken anywhere in the box where the function is defined, rounded outwards. Orders that were not asked for are left as
/// they were.
struct Derivative_bounds {
  Interval value;                     ///< empty if the function is defined nowhere in the box
  std::array<Interval, 3> gradient{}; ///< x y z
  std::array<Interval, 6> hessian{};  ///< as in `Derivatives`
  std::array<Interval, 10> third{};   ///< as in `Derivatives`
  std::array<Interval, 15> fourth{};  ///< as in `Derivatives`
};

/// What it takes to bound a function over a box.
enum class Bounds_cost : std::uint8_t {
  unknown, ///< it cannot be bounded
  high,    ///< much more than derivatives at a point
  low      ///< a few times as much as derivatives at a point
};

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_DERIVATIVE_BOUNDS_H
