// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_IO_LINE_POINTS_H
#define EXTREMAL_MESH_3_SRC_IO_LINE_POINTS_H

#include <CGAL/Extremal_mesh_3/Extremal_mesh.h>

#include <cstdint>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

/// The points of all lines, each once: the vertices of the mesh with their numbers, then the inner points of the edges.
struct Line_points {
  std::vector<Point> points;
  std::vector<Vector> normals;
  std::vector<double> k1, k2;
  std::vector<std::vector<std::uint32_t>> edges; ///< the points of each edge, from source to target

  explicit Line_points(const Extremal_mesh& mesh) {
    const auto add = [&](const Point& point, const Vector& normal, double larger, double smaller) {
      points.push_back(point);
      normals.push_back(normal);
      k1.push_back(larger);
      k2.push_back(smaller);
    };
    for (std::size_t v = 0; v < mesh.number_of_vertices(); ++v) {
      const Extremal_mesh_vertex& vertex = mesh.vertex(v);
      add(vertex.point, vertex.normal, vertex.k1, vertex.k2);
    }
    for (std::size_t e = 0; e < mesh.number_of_edges(); ++e) {
      const Extremal_mesh_edge& edge = mesh.edge(e);
      std::vector<std::uint32_t>& indices = edges.emplace_back(1, edge.source);
      for (std::size_t i = 1; i + 1 < edge.polyline.size(); ++i) {
        indices.push_back(std::uint32_t(points.size()));
        add(edge.polyline[i], edge.normals[i], edge.k1[i], edge.k2[i]);
      }
      indices.push_back(edge.target);
    }
  }
};

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_IO_LINE_POINTS_H
