// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_CELL_PATCHES_H
#define CGAL_EXTREMAL_MESH_3_CELL_PATCHES_H

#include <CGAL/Extremal_mesh_3/extract_extremal_mesh.h>

#include <cstdint>

namespace CGAL::Extremal_mesh_3 {

/// What the colour of a cell tells.
enum class Cell_colouring : std::uint8_t {
  sign, ///< the sign of E_g: ivory or grey-blue
  /// which cell it is. Cells on both sides of a line are of different brightness, and cells that share a vertex of
  /// different hue as long as there are enough of them
  cell
};

/// takes the polygons of one cell, with the points that they have. O(size of the patches).
/// \param patches  the surface cut along the lines
/// \param cell  number of a cell of the extremal mesh
/// \return those of the cell
/// \throws std::invalid_argument if no polygon is of that cell, or the arrays do not fit together
Cell_patches patches_of_cell(const Cell_patches& patches, std::uint32_t cell);

/// divides each polygon of more than three corners into triangles: around the mean of its corners, or of corners alone if it is too
/// concave for that. So, too, `Extremal_mesh_cell::area` is defined. Given points keep their indices. O(size of the patches).
/// \param patches  the surface cut along the lines
/// \return triangles
/// \throws std::invalid_argument if the arrays do not fit together
Cell_patches triangulate(const Cell_patches& patches);

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_CELL_PATCHES_H
