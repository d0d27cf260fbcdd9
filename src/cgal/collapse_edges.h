// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_CGAL_COLLAPSE_EDGES_H
#define EXTREMAL_MESH_3_SRC_CGAL_COLLAPSE_EDGES_H

#include "Triangles.h"

#include <cstddef>

namespace CGAL::Extremal_mesh_3 {

/// What of a surface is to be kept while its edges are collapsed.
struct Collapse_request {
  std::vector<Vector> normals; ///< of the surface at the points, unit: no triangle may turn away from them
  /// edges that are kept, as pairs of points
  std::vector<std::array<std::uint32_t, 2>> kept_edges;
  double line_tolerance = 0;       ///< how far what becomes of them may be from any of their points
  std::size_t number_of_faces = 0; ///< until there are at most so many
  Progress progress;
};

struct Collapsed {
  Triangles triangles;
  /// what became of the kept edges: polylines of points, that end where not two of them meet; the last point of a closed one is its first
  std::vector<std::vector<std::uint32_t>> lines;
  double line_deviation = 0; ///< the largest of a given end of a kept edge from what became of the line
};

/// decimates a surface by edge collapse, with CGAL's Surface_mesh_simplification and the cost and placement of Lindstrom and Turk
/// (Fast and memory efficient polygonal simplification, 1998). First points are taken out of the kept lines, that which makes the least
/// deviation first, by collapses along them; what is left of the lines then stays as it is.
/// \throws Cancelled
Collapsed collapse_edges(const Triangles& surface, const Collapse_request& request);

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_CGAL_COLLAPSE_EDGES_H
