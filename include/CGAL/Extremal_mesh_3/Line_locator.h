// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_LINE_LOCATOR_H
#define CGAL_EXTREMAL_MESH_3_LINE_LOCATOR_H

#include <CGAL/Extremal_mesh_3/Extremal_mesh.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>

namespace CGAL::Extremal_mesh_3 {

/// A point of a line.
struct Line_point {
  std::uint32_t edge = 0;  ///< of the mesh
  std::size_t segment = 0; ///< of the edge's polyline
  double t = 0;            ///< where on the segment: 0 at its start, 1 at its end
  Point point{};           ///< where it is
  double distance = 0;     ///< from the point asked for
};

/// A vertex near to a point.
struct Nearest_vertex {
  std::uint32_t vertex = 0; ///< its number
  double distance = 0;      ///< from the point asked for
};

/// Finds what is near to points, from the graph alone. Building it takes O(n log n) for n points of polylines, a query about
/// O(log n). Queries can be made from many threads at a time.
class Line_locator {
public:
  /// prepares for queries.
  /// \param mesh  the mesh, of which a copy is kept
  /// \throws std::invalid_argument naming the edge or vertex if a coordinate is not finite
  explicit Line_locator(Extremal_mesh mesh);
  ~Line_locator();
  Line_locator(Line_locator&&) noexcept; ///< takes over what another one holds
  /// takes over what another one holds.
  /// \return this one
  Line_locator& operator=(Line_locator&&) noexcept;

  /// \name Queries
  /// Distances are those of space. Of several at the same distance, the first one is given. All throw
  /// `std::invalid_argument` if a coordinate is not finite.
  /// @{

  /// finds the nearest vertex, if there is one.
  /// \param p  a point
  /// \return the vertex; nothing if the mesh has none
  std::optional<Nearest_vertex> nearest_vertex(const Point& p) const;

  /// finds the nearest point of the lines, if there is one.
  /// \param p  a point
  /// \return the point; nothing if the mesh has no line
  std::optional<Line_point> nearest_line(const Point& p) const;

  /// finds the cell that holds a point of the surface: the one on the point's side of the nearest line.
  ///
  /// This is right if the way on the surface to the nearest point of the lines is about the straight one. It can be wrong far from all lines,
  /// where the surface bends by more than a right angle on the way or another sheet of it is nearer than the cell's
  /// own lines, and on a component of the surface that has no line. `Patch_locator` has no such exceptions.
  /// \param p  a point of the surface
  /// \param normal  of the surface at `p`, of any length, if it is known: lines on sheets with another normal (by more than
  ///                120°) are then passed over
  /// \return nothing if there are no lines (with such a normal), unless there is but one cell; nor if after a simplification two
  ///         lines run along the same points with one cell outside on both sides and another between them: then the lines
  ///         do not tell which is which
  std::optional<std::uint32_t> cell_at(const Point& p, const std::optional<Vector>& normal = std::nullopt) const;
  /// @}

private:
  struct Data;
  std::unique_ptr<Data> data_;
};

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_LINE_LOCATOR_H
