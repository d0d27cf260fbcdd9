// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_FITTING_MESH_VERTICES_H
#define EXTREMAL_MESH_3_SRC_FITTING_MESH_VERTICES_H

#include "Adjacency.h"

#include <CGAL/Extremal_mesh_3/Cell_complex.h>

#include <vector>

namespace CGAL::Extremal_mesh_3 {

/// What the fit of a jet asks of a vertex, in one line of cache: neighbourhoods are read in no order of memory.
struct alignas(64) Mesh_vertex {
  Point p{};
  Vector n{};      ///< unit normal; zero if the cells around it have none
  double area = 0; ///< its share of the area of the cells around it
};

/// the vertices with their normals: those given, or else the sums of the normals at the corners of the cells,
/// weighted by angle, which does not depend on how a flat area is divided. Where there is none, the neighbours' stand
/// in.
std::vector<Mesh_vertex> mesh_vertices(const Cell_complex& cells, const Adjacency& adjacency,
                                       const std::vector<Vector>& given_normals);

/// the distance between neighbouring vertices that an even triangulation with as many vertices would have around each
/// vertex, averaged over the surface so that it changes slowly.
std::vector<double> sampling_distances(const std::vector<Mesh_vertex>& vertices, const Adjacency& adjacency);

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_FITTING_MESH_VERTICES_H
