// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The corners, edges and faces of a cube.
#ifndef EXTREMAL_MESH_3_SRC_CELLS_CUBE_H
#define EXTREMAL_MESH_3_SRC_CELLS_CUBE_H

#include <CGAL/Extremal_mesh_3/Function_3.h>

#include <array>

namespace CGAL::Extremal_mesh_3 {

// Corner c of a cube lies at offset (c & 1, c >> 1 & 1, c >> 2 & 1). An edge is given by its two corners; 12 of them.
inline constexpr std::array<std::array<int, 2>, 12> edge_corners{{{0, 1},
                                                                  {2, 3},
                                                                  {4, 5},
                                                                  {6, 7}, // along x
                                                                  {0, 2},
                                                                  {1, 3},
                                                                  {4, 6},
                                                                  {5, 7}, // along y
                                                                  {0, 4},
                                                                  {1, 5},
                                                                  {2, 6},
                                                                  {3, 7}}};
// The corners of the faces, counter-clockwise seen from outside (in a right-handed lattice).
inline constexpr std::array<std::array<int, 4>, 6> face_corners{
    {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};

/// decides an ambiguous face (two diagonal corners + , the others −) by the sign of the function itself at the saddle
/// of its bilinear interpolant: are the + corners joined?
/// \param value  at the corners (0,0), (1,0), (0,1), (1,1) of
/// the face
/// \param base,s,t  the face's corner (0,0) and its two sides, in steps of the lattice
bool plus_corners_joined(const Function_3& f, const Lattice& lattice, const std::array<double, 4>& value,
                         const std::array<double, 3>& base, const std::array<double, 3>& s,
                         const std::array<double, 3>& t);

/// the axis-parallel box around a part of a lattice, rounded outwards.
/// \param low,high  its opposite corners, in steps of the lattice
Box_3 box_around(const Lattice& lattice, const std::array<double, 3>& low, const std::array<double, 3>& high);

bool is_left_handed(const Lattice& lattice);

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_CELLS_CUBE_H
