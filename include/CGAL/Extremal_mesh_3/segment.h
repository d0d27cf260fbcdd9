// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_SEGMENT_H
#define CGAL_EXTREMAL_MESH_3_SEGMENT_H

#include <CGAL/Extremal_mesh_3/extract_extremal_mesh.h>

#include <cstddef>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

/// How to segment a surface.
struct Segmentation_options {
  /// faces that are farther from the surface of the cells are away from it, in the input's unit of length; 0: a hundredth of the diagonal of
  /// its bounding box
  double tolerance = 0;
  int threads = 0; ///< 0: as many as the machine has cores. The result does not depend on it.
  Progress progress;
};

/// What of a surface is in one cell.
struct Cell_share {
  std::size_t faces = 0;
  double area = 0;        ///< of these faces, in the square of the input's unit of length
  std::size_t pieces = 0; ///< connected over edges of the surface
};

/// A surface with a cell for each of its faces.
struct Segmentation {
  Cell_patches faces; ///< those of the surface, in its order; their normals are means of those of the faces around
  std::vector<Cell_share> cells; ///< one for each cell of the extremal mesh
  std::size_t cut_faces = 0;     ///< faces of which samples lie in more than one cell: lines run through them
  double cut_area = 0;           ///< of these
  double area = 0;               ///< of the surface
  std::size_t away_faces =
      0; ///< farther from the cells than the tolerance, as where a degenerate area was cut out of the surface
  double away_area = 0;        ///< of these
  double largest_distance = 0; ///< of a sample of the faces from the surface of the cells
};

/// tells for each face of a surface in which cell of an extremal mesh it is. The surface may be another one than that
/// from which the mesh was extracted, if it only is in the same place: coarser, finer, or not cut along the lines. A face through which a
/// line runs is in the cell that has most of it, by samples: its middle and one near each corner, and where they differ, sixteen in
/// each of its triangles; of several cells with as many, in the one with the least number.
///
/// \param surface  to be segmented
/// \param mesh,cells  the extremal mesh and its surface cut along the lines: `Extraction::patches`, `read_cell_patches()`
/// \param options  what is away from the cells
/// \return the surface with a cell for each face
/// \throws std::invalid_argument if the cells are not those of the mesh (`require_cells_of()`); if more of the surface is away from
///         them than its degenerate area and a tenth of the whole; if the tolerance is negative or not finite; Cancelled
/// O((n + m) log m) for n faces and m polygons of the cells. [Thirion 1993, 6.2]
Segmentation segment(const Cell_complex& surface, const Extremal_mesh& mesh, const Cell_patches& cells,
                     const Segmentation_options& options = {});

/// sums up a surface whose faces have their cells already: the surface cut along the lines itself.
/// \param mesh,cells  the extremal mesh and that surface
/// \return the surface, and what of it is in each cell
/// \throws std::invalid_argument if the cells are not those of the mesh
Segmentation segment(const Extremal_mesh& mesh, const Cell_patches& cells);

/// compares the area of each cell as the mesh has it with that of the surface's polygons, which must agree to 1e-5 of the whole: so a
/// surface of another extraction is found out before it does harm. O(size of the patches).
/// \param mesh,cells  the extremal mesh and its surface cut along the lines
/// \throws std::invalid_argument naming the cell and both areas if they differ; or if the arrays do not fit together
void require_cells_of(const Extremal_mesh& mesh, const Cell_patches& cells);

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_SEGMENT_H
