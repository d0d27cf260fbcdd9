// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_CELL_QUERIES_H
#define CGAL_EXTREMAL_MESH_3_CELL_QUERIES_H

#include <CGAL/Extremal_mesh_3/Extremal_mesh.h>

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

/// An edge seen from the cell on one of its sides.
struct Cell_side {
  Half_edge half_edge = 0;                 ///< with the cell on its left
  int family = 1;                          ///< of the edge
  Line_type type = Line_type::max_largest; ///< of the edge
  std::uint32_t neighbour = 0;             ///< the cell on the other side
};

/// gathers the sides of a cell as its closed boundary walks, counter-clockwise seen from the side of the normal. A cell without any
/// line, such as a closed component of the surface in which E_g keeps its sign, has no walk. O(sides).
/// \param mesh  an extremal mesh
/// \param cell  its number
/// \return one walk of sides per closed boundary
/// \throws std::invalid_argument if there is no such cell
std::vector<std::vector<Cell_side>> cell_sides(const Extremal_mesh& mesh, std::uint32_t cell);

/// A cell beside another.
struct Cell_neighbour {
  std::uint32_t cell = 0; ///< its number
  double length = 0;      ///< of all lines between the two
};

/// gathers the cells beyond the sides of a cell, each once, by their numbers. O(s log s) for s sides.
/// \param mesh  an extremal mesh
/// \param cell  its number
/// \return the cells beside it
/// \throws std::invalid_argument if there is no such cell
std::vector<Cell_neighbour> neighbours(const Extremal_mesh& mesh, std::uint32_t cell);

/// gathers the cells around a vertex, counter-clockwise: the i-th is the one between the i-th branch of the vertex's star
/// and the next. Around a boundary vertex one more comes first: the one clockwise of its first branch. A cell can come more than
/// once. O(degree).
/// \param mesh  an extremal mesh
/// \param vertex  its number
/// \return the cells, in order
/// \throws std::invalid_argument if there is no such vertex
std::vector<std::uint32_t> cells_around(const Extremal_mesh& mesh, std::uint32_t vertex);

/// A cell with four sides.
struct Quadrilateral {
  std::uint32_t cell = 0; ///< its number
  /// counter-clockwise, turned so that the cycle of types is the lexicographically smallest, in the order of `Line_type`, so
  /// that cells with the same cycle of types compare equal; where that leaves a choice, from the smallest half-edge.
  /// A mirror reverses the cycle.
  std::array<Cell_side, 4> sides;
};

/// recognises a cell with four sides: a disk that touches no border, with one boundary walk of four half-edges. O(1).
/// \param mesh  an extremal mesh
/// \param cell  its number
/// \return nothing if it is another cell
/// \throws std::invalid_argument if there is no such cell
std::optional<Quadrilateral> quadrilateral(const Extremal_mesh& mesh, std::uint32_t cell);

/// gathers all cells with four sides, by their numbers. O(F).
/// \param mesh  an extremal mesh
/// \return all of them
std::vector<Quadrilateral> quadrilaterals(const Extremal_mesh& mesh);

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_CELL_QUERIES_H
