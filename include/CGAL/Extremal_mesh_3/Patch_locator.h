// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_PATCH_LOCATOR_H
#define CGAL_EXTREMAL_MESH_3_PATCH_LOCATOR_H

#include <CGAL/Extremal_mesh_3/extract_extremal_mesh.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>

namespace CGAL::Extremal_mesh_3 {

/// A point of the cut surface.
struct Patch_point {
  std::uint32_t cell = 0;  ///< that holds it
  std::size_t polygon = 0; ///< of the patches
  Point point{};           ///< where it is
  double distance = 0;     ///< from the point asked for
};

/// Finds the nearest point of the surface that was cut along the lines, and so the cell that holds a point, also far
/// from all lines. Building it takes O(n log n) for n polygons, a query about O(log n). Queries can be made from many
/// threads at a time.
class Patch_locator {
public:
  /// prepares for queries.
  /// \param patches  the surface cut along the lines
  /// \throws std::invalid_argument if the arrays of the patches do not fit together, or a coordinate is not finite
  explicit Patch_locator(const Cell_patches& patches);
  ~Patch_locator();
  Patch_locator(Patch_locator&&) noexcept; ///< takes over what another one holds
  /// takes over what another one holds.
  /// \return this one
  Patch_locator& operator=(Patch_locator&&) noexcept;

  /// finds the nearest point of the surface, if there is one; of several at the same distance that of the first polygon.
  /// Polygons with more than three corners are triangulated from their middle.
  /// \param p  a point
  /// \return the nearest point of the surface; nothing if there is no polygon
  /// \throws std::invalid_argument if a coordinate is not finite
  std::optional<Patch_point> nearest(const Point& p) const;

private:
  struct Data;
  std::unique_ptr<Data> data_;
};

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_PATCH_LOCATOR_H
