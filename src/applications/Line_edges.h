// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_APPLICATIONS_LINE_EDGES_H
#define EXTREMAL_MESH_3_SRC_APPLICATIONS_LINE_EDGES_H

#include <CGAL/Extremal_mesh_3/extract_extremal_mesh.h>

#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

/// Finds the lines of an extremal mesh on its surface. A file of the surface does not say which edges these are, but has their points to the
/// last bit; where several points are in one place, edges tell which are meant.
class Line_edges {
public:
  /// \param surface  as `internal::manifold_patches()` makes it
  explicit Line_edges(const Cell_patches& surface);

  /// finds the edges of the surface along a polyline: one for each segment, or two where that was halved.
  /// \param edge  of the extremal mesh, for the message
  /// \throws std::invalid_argument naming the edge and the segment if the surface has no such edge
  std::vector<std::array<std::uint32_t, 2>> along(const std::vector<Point>& polyline, std::size_t edge) const;

  /// the points of the surface in a place.
  std::vector<std::uint32_t> points_at(const Point& p) const;

private:
  bool has(std::uint32_t a, std::uint32_t b) const;

  std::multimap<Point, std::uint32_t> point_at_;
  std::set<std::array<std::uint32_t, 2>> edges_;
};

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_APPLICATIONS_LINE_EDGES_H
