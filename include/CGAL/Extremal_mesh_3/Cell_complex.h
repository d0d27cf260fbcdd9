// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_CELL_COMPLEX_H
#define CGAL_EXTREMAL_MESH_3_CELL_COMPLEX_H

#include <CGAL/Extremal_mesh_3/types.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

/// The polygonal cells of a surface as flat arrays: an oriented 2-manifold, possibly with border, whose cells have
/// any number (≥ 3) of sides.
///
/// Half-edge `2e` runs along edge `e` from `edges[e][0]` to `edges[e][1]`, half-edge `2e+1` runs back. A cell's half-edges
/// go round it counter-clockwise seen from the side to which the normals point.
struct Cell_complex {
  static constexpr std::int32_t no_cell = -1; ///< what is beyond the border

  std::vector<Point> points;                       ///< on the surface
  std::vector<std::array<std::uint32_t, 2>> edges; ///< two points each
  /// the cells on the left of half-edges 2e and 2e+1; `no_cell` at the border
  std::vector<std::array<std::int32_t, 2>> edge_cells;
  std::vector<std::size_t> cell_begin{0}; ///< cell c has half_edges[cell_begin[c] … cell_begin[c+1])
  std::vector<std::uint32_t> half_edges;  ///< around the cells, one cell after the other

  /// \return the number of cells
  std::size_t number_of_cells() const { return cell_begin.size() - 1; }
  /// \return V − E + F
  std::int64_t euler_characteristic() const {
    return std::int64_t(points.size()) - std::int64_t(edges.size()) + std::int64_t(number_of_cells());
  }
  /// \param h  a half-edge
  /// \return the point where it begins
  std::uint32_t source(std::uint32_t h) const { return edges[h / 2][h % 2]; }
  /// \param h  a half-edge
  /// \return the point where it ends
  std::uint32_t target(std::uint32_t h) const { return edges[h / 2][1 - h % 2]; }
};

/// makes a cell complex of polygons given as indices of points.
/// \param polygon_begin  polygon i has corners[polygon_begin[i] … polygon_begin[i+1])
/// \throws std::invalid_argument naming the polygon if one has fewer than 3 sides, repeats a point or names one that does not
///         exist; naming the two points if an edge is used more than once in one direction (non-manifold or badly oriented)
///         or the cells around a point do not form a single fan
/// Points of no polygon are an error too. Edges are numbered in order of their first use. O(n log n).
/// \param points  on the surface
/// \param corners  of all polygons, counter-clockwise seen from the side of the normals
/// \return the polygons with their edges
Cell_complex make_cell_complex(std::vector<Point> points, const std::vector<std::size_t>& polygon_begin,
                               const std::vector<std::uint32_t>& corners);

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_CELL_COMPLEX_H
