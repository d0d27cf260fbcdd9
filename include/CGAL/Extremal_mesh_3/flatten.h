// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_FLATTEN_H
#define CGAL_EXTREMAL_MESH_3_FLATTEN_H

#include <CGAL/Extremal_mesh_3/extract_extremal_mesh.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

/// What became of a cell.
enum class Flattening_outcome : std::uint8_t {
  flat,           ///< it was mapped to the plane
  not_a_disk,     ///< its part of the surface is not: it has holes or handles, or is closed
  unclear_border, ///< the vertices along its border are not those of the mesh, in their order
  rounding        ///< triangles of it are too small in the plane to be told from flipped ones
};
std::string_view to_string(Flattening_outcome);

/// A cell in the plane.
struct Flat_cell {
  Flattening_outcome outcome = Flattening_outcome::flat;
  /// the vertices of the mesh at its corners, counter-clockwise, anchors left out. Of four, the first two are the ends of the first side of
  /// `quadrilateral()`
  std::vector<std::uint32_t> corners;
  std::size_t first_triangle = 0, triangles = 0; ///< of `Flattening::faces`
  /// exp of the mean over its area of |ln(area in the plane / area on the surface)|, both as shares of the cell: 1 if areas are kept
  double area_distortion = 1;
};

/// The cells of an extremal mesh, each in the plane.
struct Flattening {
  Cell_patches faces; ///< triangles, by the order of their cells; also those of cells that are not flat
  std::vector<std::array<std::array<double, 2>, 3>>
      places;                   ///< u and v from 0 to 1 of the corners of each; 0 where a cell is not flat
  std::vector<Flat_cell> cells; ///< all of the mesh
  std::size_t flipped = 0; ///< triangles of flat cells that are not counter-clockwise in the plane: 0, decided exactly
};

/// maps each cell to the plane, one-to-one: a cell of n corners to a regular polygon in the unit square, four corners to the square itself; of less than
/// three to a disk. Along each side lengths keep their proportions. Inside each point is a mean of its neighbours, with
/// mean value coordinates as weights, or equal ones where rounding makes a triangle flip with those. As the weights are positive, the
/// border is convex and no edge joins two points of it (such edges get a point in their middle), no triangle flips [Floater 2003].
///
/// Cells that are no disks are left as they are, and told by their outcome. What is meant are the parts of the surface: a cell both sides of one of whose
/// lines are in it, as in simplified meshes, is not cut there.
/// \param mesh,cells  the extremal mesh and its surface cut along the lines
/// \param threads  0: as many as the machine has cores. The result does not depend on it
/// \param progress  called with the share of the work that is done; may cancel it
/// \return the cells in the plane, and what became of each
/// \throws std::invalid_argument if the cells are not those of the mesh; Cancelled
/// O(n^1.5) for n points of a cell. [Thirion 1993, 6.2]
Flattening flatten(const Extremal_mesh& mesh, const Cell_patches& cells, int threads = 0,
                   const Progress& progress = {});

/// writes the triangles as OBJ, a group `cell_…` for each cell, with their places as texture coordinates of their corners. Cells that are not flat have
/// none.
/// \param file  its name
/// \param flattening  what `flatten()` returned
/// \throws Io_error if it cannot be written
void write_flat_obj(const std::string& file, const Flattening& flattening);

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_FLATTEN_H
