// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_REDUCE_H
#define CGAL_EXTREMAL_MESH_3_REDUCE_H

#include <CGAL/Extremal_mesh_3/extract_extremal_mesh.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

/// How to reduce a surface.
struct Reduction_options {
  /// edges are collapsed until there are at most so many triangles, or none can be collapsed any more; by default a tenth of those of the surface
  std::optional<std::size_t> number_of_faces;
  /// crest lines, as `strongest_crest_lines()` gathers them, of at least this strength are kept; infinity: none
  double keep_crest = 0;
  /// how far a kept line may be from what is left of it, in the input's unit of length; by default a thousandth of the diagonal of the
  /// surface's bounding box; 0: only points are taken out where it is straight
  std::optional<double> line_tolerance;
  int threads = 0; ///< 0: as many as the machine has cores. The result does not depend on it.
  Progress progress;
};

/// A surface of fewer triangles.
struct Reduction {
  Cell_patches
      faces; ///< triangles, each in the cell that has most of it; their normals are means of those of the triangles around
  /// what is left of the kept lines: points of `faces` that edges of it join. They end where lines meet; the last point of a closed one is its
  /// first
  std::vector<std::vector<std::uint32_t>> lines;
  std::size_t faces_before = 0;    ///< triangles of the given surface, cut along all its lines
  std::size_t kept_edges = 0;      ///< of the extremal mesh
  double kept_length = 0;          ///< of these, in the input's unit of length
  std::size_t segments_before = 0; ///< edges of the surface along them
  std::size_t segments = 0;        ///< what is left of those
  double line_deviation = 0;       ///< the largest of a kept line from what is left of it, and the other way round
  /// the largest distance of a vertex, or of the middle of a triangle, of one of both surfaces from the other one
  double surface_deviation = 0;
  std::int64_t euler_characteristic_before = 0, euler_characteristic = 0;
};

/// reduces the number of triangles of a surface, but keeps its crest lines: they are edges of the result. The surface is triangulated, which
/// adds points in the middle of polygons; points are taken out of the kept lines as far as their tolerance allows; then edges of least cost (Lindstrom and
/// Turk) are collapsed by CGAL's Surface_mesh_simplification. Points of kept lines, and no others, stay where they are.
///
/// \param mesh,cells  the extremal mesh and its surface cut along the lines: `Extraction::patches`, `read_cell_patches()`
/// \param options  how far, and which lines are kept
/// \return an oriented manifold, of the same topology as the surface. Nothing rules out that parts of it run through others
/// \throws std::invalid_argument if the cells are not those of the mesh, or do not have its kept lines, naming the edge; if a number of the
///         options is negative or not a number; Cancelled
/// O(n log n) for n points. [Thirion 1993, 6.2: surface reduction]
Reduction reduce(const Extremal_mesh& mesh, const Cell_patches& cells, const Reduction_options& options = {});

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_REDUCE_H
