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
  /// distance of neighbouring vertices, the larger the noisier the mesh is (see `fit_vertex_shapes()`)
  double radius = 0;
  int rings = 0;   ///< if not 0, the vertices within so many edges are the neighbourhood, and `radius` is not used
  int threads = 0; ///< 0: as many as the machine has cores. The result does not depend on it.
  /// unit normals at the vertices; empty: from the cells. They tell one sheet of the surface from another, and are the
  /// direction in which heights are taken
  std::vector<Vector> normals;
  Progress progress; ///< told how far the work is; may stop it
};

/// What was met on the way.
struct Fit_report {
  double sampling = 0;        ///< median distance of neighbouring vertices, that of an even triangulation with as many
  double multiple = 0;        ///< of the distance of neighbours: the default radius; 0 if that was not asked for
  double radius_min = 0;      ///< the least radius of a neighbourhood
  double radius_median = 0;   ///< the median
  double radius_max = 0;      ///< the greatest
  double noise = 0;           ///< median residual, a length; it has a part of what jets of degree 4 leave out
  std::size_t fitted = 0;     ///< vertices with a jet
  std::size_t grown = 0;      ///< those of them that took a larger radius than asked for
  std::size_t not_fitted = 0; ///< vertices without one
};

/// The shapes at the vertices of a mesh, by jets fitted there.
struct Fit {
  Vertex_shapes shapes; ///< one per point of the cells
  Fit_report report;    ///< radii, noise, and where it failed
};

/// fits a jet of degree 4 (Cazals and Pouget) at each vertex of a mesh: weighted least squares over the vertices that
/// are reached over the surface within the radius. Neighbourhoods with too few vertices, or with vertices on one side
/// only, grow until the fit is sound. Moving the mesh, or numbering it otherwise, changes nothing but rounding.
///
/// The error of C is in proportion to R² on exact meshes, R being the radius, but smooth over the surface; that by
/// noise is in proportion to R⁻⁴. So the default is the smallest radius that makes the noise small: 2.75 times the
/// local distance h of neighbours if residuals show no noise, or if they grow with R as only details of the surface
/// do; else up to 16.4 times the typical h, nearly the same everywhere, until noise is 2.5 % of C, but not more than
/// the surface can be followed for. For the ellipsoid x² + 2y² + 4z² = 1 with 10242 vertices and noise of 0, 0.1 %
/// and 1 % of h it is 2.75 h, 6.7 h and 10.5 h; C then is wrong by 2 %, 10 % and 25 % of its root mean square, but
/// from one vertex to the next only by 0.5 %, 2 % and 5 %.
/// O(n · vertices in a neighbourhood).
/// \param cells  an oriented manifold of polygons
/// \param options  the radius, normals, threads, progress
/// \return shapes, their quality, and a report
/// \throws std::invalid_argument if an option is out of its range or a coordinate is not finite
Fit fit_vertex_shapes(const Cell_complex& cells, const Fit_options& options = {});

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_FIT_VERTEX_SHAPES_H
