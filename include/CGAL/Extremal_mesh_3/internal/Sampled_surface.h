// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_INTERNAL_SAMPLED_SURFACE_H
#define CGAL_EXTREMAL_MESH_3_INTERNAL_SAMPLED_SURFACE_H

#include <CGAL/Extremal_mesh_3/extract_extremal_mesh.h>
#include <CGAL/Extremal_mesh_3/fit_vertex_shapes.h>

namespace CGAL::Extremal_mesh_3::internal {

/// What a caller knows of a surface at the vertices of a mesh, and how it is to be extracted: what the template for face
/// graphs hands over to compiled code.
struct Sampled_surface {
  Cell_complex cells;
  const Function_3* function = nullptr; ///< if given, the points are near its zero surface
  Vertex_shapes given;                  ///< no shapes: none are given
  Fit_options fit_options;
  Extraction_options extraction_options;
  Fit* fit = nullptr; ///< if given, takes the shapes that were used
};

/// extracts with the function if there is one, else with the given shapes, else with fitted ones.
/// \throws std::invalid_argument if both a function and shapes are given, or a normal is 0 or not finite; and what is thrown
///         by the functions named
Extraction extract_extremal_mesh(Sampled_surface surface);

} // namespace CGAL::Extremal_mesh_3::internal

#endif // CGAL_EXTREMAL_MESH_3_INTERNAL_SAMPLED_SURFACE_H
