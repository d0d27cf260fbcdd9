// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_CGAL_SURFACE_MESH_H
#define EXTREMAL_MESH_3_SRC_CGAL_SURFACE_MESH_H

#include "Triangles.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <stdexcept>
#include <string>

namespace CGAL::Extremal_mesh_3 {

using Surface_kernel = CGAL::Simple_cartesian<double>;
using Surface_of_triangles = CGAL::Surface_mesh<Surface_kernel::Point_3>;

/// the triangles as a mesh of CGAL's, points and triangles with the same numbers.
/// \throws std::invalid_argument if they are no oriented manifold
inline Surface_of_triangles surface_mesh_of(const Triangles& triangles) {
  Surface_of_triangles mesh;
  using Size = Surface_of_triangles::size_type;
  mesh.reserve(Size(triangles.points.size()), Size(3 * triangles.corners.size() / 2), Size(triangles.corners.size()));
  for (const auto& [x, y, z] : triangles.points)
    mesh.add_vertex({x, y, z});
  using Vertex = Surface_of_triangles::Vertex_index;
  for (std::size_t i = 0; i < triangles.corners.size(); ++i) {
    const auto& [a, b, c] = triangles.corners[i];
    if (mesh.add_face(Vertex(a), Vertex(b), Vertex(c)) == Surface_of_triangles::null_face())
      throw std::invalid_argument("triangle " + std::to_string(i) +
                                  " of the surface cannot be added: it is no manifold");
  }
  return mesh;
}

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_CGAL_SURFACE_MESH_H
