// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_FIT_VERTEX_SHAPES_H
#define CGAL_EXTREMAL_MESH_3_FIT_VERTEX_SHAPES_H

#include <CGAL/Extremal_mesh_3/Cell_complex.h>
#include <CGAL/Extremal_mesh_3/Vertex_shapes.h>

#include <cstddef>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

/// How to fit.
struct Fit_options {
  /// of the neighbourhoods, in the mesh's unit of length: the scale of the features looked for. 0: some multiple of the
  /// distance of neighbouring vertices, which is larger where that changes, and the larger the noisier the mesh is
  double radius = 0;
  int rings = 0;   ///< if not 0, the vertices within so many edges are the neighbourhood, and `radius` is not used
  int threads = 0; ///< 0: as many as the machine has cores. The result does not depend on it.
  /// unit normals at the vertices; empty: from the cells. They tell one sheet of the surface from another, and are the
  /// direction in which heights are taken
  std::vector<Vector> normals;
  Progress progress;
};

/// What was met on the way.
struct Fit_report {
  double sampling = 0; ///< median distance of neighbouring vertices, that of an even triangulation with as many
  double multiple = 0; ///< of the local distance of neighbours: the default radius; 0 if that was not asked for
  double radius_min = 0, radius_median = 0, radius_max = 0; ///< of the neighbourhoods
  double noise = 0; ///< median residual, a length
  std::size_t fitted = 0, grown = 0, not_fitted = 0; ///< vertices; grown: with a larger radius than asked for
};

struct Fit {
  Vertex_shapes shapes;
  Fit_report report;
};

/// fits a jet of degree 4 (Cazals and Pouget) at each vertex of a mesh: weighted least squares over the vertices that are
/// reached over the surface within the radius. Neighbourhoods with too few vertices grow until the fit is sound.
/// Moving the mesh, or numbering it otherwise, changes nothing but rounding.
/// \throws std::invalid_argument if an option is out of its range or a coordinate is not finite
/// O(n · vertices in a neighbourhood).
Fit fit_vertex_shapes(const Cell_complex& cells, const Fit_options& options = {});

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_FIT_VERTEX_SHAPES_H
