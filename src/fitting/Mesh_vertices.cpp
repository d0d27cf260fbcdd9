// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh_vertices.h"

#include "../differential/vector.h"

#include <cmath>

namespace CGAL::Extremal_mesh_3 {

namespace {

/// adds the normals at the corners of a cell to its vertices, and its area in equal parts.
void add_cell(const Cell_complex& cells, std::size_t c, bool normals, std::vector<Mesh_vertex>& vertices) {
  const std::size_t first = cells.cell_begin[c], sides = cells.cell_begin[c + 1] - first;
  const auto vertex = [&](std::size_t i) { return cells.source(cells.half_edges[first + i % sides]); };
  const Point& origin = cells.points[vertex(0)];
  Vector area{};
  for (std::size_t i = 1; i + 1 < sides; ++i)
    area = area + cross(cells.points[vertex(i)] - origin, cells.points[vertex(i + 1)] - origin);
  const double share = norm(area) / 2 / double(sides);
  for (std::size_t i = 0; i < sides; ++i) {
    Mesh_vertex& v = vertices[vertex(i)];
    v.area += share;
    if (!normals)
      continue;
    const Vector next = cells.points[vertex(i + 1)] - v.p, previous = cells.points[vertex(i + sides - 1)] - v.p;
    const Vector n = cross(next, previous);
    const double sine = norm(n);
    if (sine > 0)
      v.n = v.n + (std::atan2(sine, dot(next, previous)) / sine) * n;
  }
}

/// tells whether n has a direction. Otherwise it becomes zero.
bool make_unit(Vector& n) {
  const double length = norm(n);
  n = length > 0 ? (1 / length) * n : Vector{};
  return length > 0;
}

} // namespace

std::vector<Mesh_vertex> mesh_vertices(const Cell_complex& cells, const Adjacency& adjacency,
                                       const std::vector<Vector>& given_normals) {
  std::vector<Mesh_vertex> vertices(cells.points.size());
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    vertices[v].p = cells.points[v];
    if (!given_normals.empty())
      vertices[v].n = given_normals[v];
  }
  for (std::size_t c = 0; c < cells.number_of_cells(); ++c)
    add_cell(cells, c, given_normals.empty(), vertices);
  std::vector<std::uint32_t> without;
  for (std::size_t v = 0; v < vertices.size(); ++v)
    if (!make_unit(vertices[v].n))
      without.push_back(std::uint32_t(v));
  std::vector<Vector> stand_in(without.size(), Vector{});
  for (std::size_t i = 0; i < without.size(); ++i) {
    for (const std::uint32_t w : adjacency[without[i]])
      stand_in[i] = stand_in[i] + vertices[w].n;
    make_unit(stand_in[i]);
  }
  for (std::size_t i = 0; i < without.size(); ++i)
    vertices[without[i]].n = stand_in[i];
  return vertices;
}

std::vector<double> sampling_distances(const std::vector<Mesh_vertex>& vertices, const Adjacency& adjacency) {
  constexpr double triangular = 1.0745699318235418; // √(2/√3): an even triangulation has the area √3/2 h² a vertex
  constexpr int rounds = 8;
  std::vector<double> h(vertices.size()), average(vertices.size());
  for (std::size_t v = 0; v < h.size(); ++v)
    h[v] = triangular * std::sqrt(vertices[v].area);
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t v = 0; v < h.size(); ++v) {
      double sum = h[v];
      for (const std::uint32_t w : adjacency[v])
        sum += h[w];
      average[v] = sum / double(1 + adjacency[v].size());
    }
    h.swap(average);
  }
  return h;
}

} // namespace CGAL::Extremal_mesh_3
