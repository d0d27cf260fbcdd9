// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_LATTICE_H
#define CGAL_EXTREMAL_MESH_3_LATTICE_H

#include <CGAL/Extremal_mesh_3/types.h>

#include <cstddef>

namespace CGAL::Extremal_mesh_3 {

/// A regular lattice of nodes `origin + i·step[0] + j·step[1] + k·step[2]`, 0 ≤ i < size[0] and so on, node (i,j,k)
/// having index `i + size[0]·(j + size[1]·k)`. The steps are any three independent vectors, in either order of
/// handedness: the voxels of an image with a direction matrix are one, an axis-parallel box is another.
struct Lattice {
  Point origin{};                                                                ///< node (0,0,0)
  std::array<Vector, 3> step{Vector{1, 0, 0}, Vector{0, 1, 0}, Vector{0, 0, 1}}; ///< from a node to the next
  std::array<std::size_t, 3> size{};                                             ///< numbers of nodes

  /// \param i,j,k  numbers of a node, or between nodes
  /// \return where that is
  Point node(double i, double j, double k) const {
    Point p;
    for (std::size_t a = 0; a < 3; ++a)
      p[a] = origin[a] + i * step[0][a] + j * step[1][a] + k * step[2][a];
    return p;
  }
};

/// The nodes (i, j, ·) of a lattice with `first` ≤ i < `last`.
struct Row_part {
  std::size_t j = 0;     ///< the row
  std::size_t first = 0; ///< the first node
  std::size_t last = 0;  ///< behind the last node
};

/// makes the lattice of cubes that covers a box.
/// \param low,high  opposite corners of the box; `high` is moved outwards so that the cubes are whole
/// \param resolution  number of cubes across the longest side of the box
/// \throws std::invalid_argument if an entry is not finite, `low < high` does not hold on an axis, `resolution` is 0, or the lattice
///         would have more than 2^40 nodes
/// \return the lattice
Lattice make_lattice(const Point& low, const Point& high, std::size_t resolution);

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_LATTICE_H
