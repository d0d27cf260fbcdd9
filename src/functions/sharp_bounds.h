// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_SRC_SHARP_BOUNDS_H
#define CGAL_EXTREMAL_MESH_3_SRC_SHARP_BOUNDS_H

#include <CGAL/Extremal_mesh_3/Function_3.h>

namespace CGAL::Extremal_mesh_3::internal {

/// bounds the value and the derivatives up to `order`, tighter than `f.bounds()` in small boxes: what is too much shrinks
/// with the square of the box's size. Takes the bounds of the order above, too, and those at the middle of the box.
/// \param order  0 to 3
/// \return whether they are known
bool sharp_bounds(const Function_3& f, const Box_3& box, int order, Derivative_bounds& d);

/// The centred form alone: bounds of `value` over the box by the mean value theorem.
/// \param at_middle  bounds of the function at the middle of the box, as `middle_of()` has it
/// \param gradient  bounds over the box
Interval by_mean_value(const Box_3& box, const Interval& at_middle, const std::array<Interval, 3>& gradient);

/// the middle of a box, as a box without size.
Box_3 middle_of(const Box_3& box);

} // namespace CGAL::Extremal_mesh_3::internal

#endif // CGAL_EXTREMAL_MESH_3_SRC_SHARP_BOUNDS_H
