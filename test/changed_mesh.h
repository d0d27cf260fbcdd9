// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_TEST_CHANGED_MESH_H
#define CGAL_EXTREMAL_MESH_3_TEST_CHANGED_MESH_H

#include <CGAL/Extremal_mesh_3/Extremal_mesh.h>

#include <functional>
#include <vector>

using namespace CGAL::Extremal_mesh_3;

/// The parts of an extremal mesh, to make another one of.
struct Mesh_parts {
  std::vector<Extremal_mesh_vertex> vertices;
  std::vector<Extremal_mesh_edge> edges;
  std::vector<Extremal_mesh_cell> cells;
  Surface_info surface;
};

/// a copy of a mesh in which something is different.
inline Extremal_mesh changed(const Extremal_mesh& mesh, const std::function<void(Mesh_parts&)>& change) {
  Mesh_parts parts;
  for (std::size_t v = 0; v < mesh.number_of_vertices(); ++v)
    parts.vertices.push_back(mesh.vertex(v));
  for (std::size_t e = 0; e < mesh.number_of_edges(); ++e)
    parts.edges.push_back(mesh.edge(e));
  parts.cells = mesh.cells();
  parts.surface = mesh.surface();
  change(parts);
  return Extremal_mesh(parts.vertices, parts.edges, parts.cells, parts.surface);
}

#endif // CGAL_EXTREMAL_MESH_3_TEST_CHANGED_MESH_H
