// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Points of an implicit surface near given points.
#ifndef EXTREMAL_MESH_3_SRC_CELLS_SURFACE_POINTS_H
#define EXTREMAL_MESH_3_SRC_CELLS_SURFACE_POINTS_H

#include <CGAL/Extremal_mesh_3/Function_3.h>

#include <optional>

namespace CGAL::Extremal_mesh_3 {

/// An edge of a cube at whose ends the function has different signs.
struct Cut_edge {
  std::array<double, 3> node; ///< the end with the smaller coordinates, in steps of the lattice
  std::size_t axis;
  double length;         ///< in steps of the lattice
  double value0, value1; ///< at the two ends
};

/// the root of f on p + t·step, 0 ≤ t ≤ 1, where f has the signs of v0 and v1 at the ends.
double root_on_edge(const Function_3& f, const Point& p, const Vector& step, double v0, double v1);

/// a point of the surface on the edge, found on the function itself. Where it is very near to a node, a
/// neighbouring point of the surface is taken instead: cells must not shrink to a point where the surface goes through
/// a node.
Point surface_point(const Function_3& f, const Lattice& lattice, const Cut_edge& edge);

/// the point x + s·direction of the surface that is nearest to x.
/// \param reach  the greatest |s|
/// \return nothing if Newton's iteration does not find one
std::optional<Point> project(const Function_3& f, const Point& x, const Vector& direction, double reach);

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_CELLS_SURFACE_POINTS_H
