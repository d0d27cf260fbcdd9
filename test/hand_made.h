// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_TEST_HAND_MADE_H
#define CGAL_EXTREMAL_MESH_3_TEST_HAND_MADE_H

#include <CGAL/Extremal_mesh_3/Extremal_mesh.h>
#include <CGAL/Extremal_mesh_3/extract_extremal_mesh.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

/// Extremal meshes drawn by hand on the unit sphere: their topology is what matters, their curvatures are invented.
namespace hand_made {

using namespace CGAL::Extremal_mesh_3;

inline Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline double dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Vector unit(const Vector& a) {
  const double length = std::sqrt(dot(a, a));
  return {a[0] / length, a[1] / length, a[2] / length};
}

inline Extremal_mesh_vertex vertex(Vertex_kind kind, const Point& p) {
  Extremal_mesh_vertex v;
  v.kind = kind;
  v.point = v.normal = p;
  v.k1 = -0.1 - p[2] * p[2];
  v.k2 = kind == Vertex_kind::umbilic ? v.k1 : v.k1 - 1.0 / 3;
  v.t1 = unit(cross(std::abs(p[2]) < 0.9 ? Vector{0, 0, 1} : Vector{1, 0, 0}, p));
  v.t2 = cross(p, v.t1);
  if (kind == Vertex_kind::umbilic) {
    v.umbilic_index = 0.5;
    v.field_index = 1;
    v.umbilic_type = Umbilic_type::lemon;
    v.ridges = 1;
  }
  if (kind == Vertex_kind::extremal_point) {
    v.field_index = -1;
    v.extrema = {Line_type::max_largest, Line_type::min_second};
  }
  return v;
}

/// an edge along a curve `p(t)`, 0 ≤ t ≤ 1, from vertex `source` to vertex `target`.
inline Extremal_mesh_edge edge(std::uint32_t source, std::uint32_t target, int family, Line_type type,
                               const std::function<Point(double)>& p, int segments = 12) {
  Extremal_mesh_edge e;
  e.source = source;
  e.target = target;
  e.family = family;
  e.type = type;
  for (int i = 0; i <= segments; ++i) {
    e.polyline.push_back(p(double(i) / segments));
    e.normals.push_back(unit(e.polyline.back()));
    e.k1.push_back(-0.1 - 0.01 * i);
    e.k2.push_back(-0.5 - 0.03 * i);
    e.extremality.push_back(0.1 * i * (segments - i));
  }
  e.segment_types.assign(std::size_t(segments), type);
  for (std::size_t i = 0; i + 1 < e.polyline.size(); ++i) {
    const Point &a = e.polyline[i], &b = e.polyline[i + 1];
    e.length += std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
  }
  e.strength = e.length / 3;
  e.sharpness = 0.1 * e.length;
  return e;
}

/// the arc of a great circle from `a` to `b`.
inline std::function<Point(double)> arc(const Point& a, const Point& b) {
  return [=](double t) -> Point {
    if (t == 0 || t == 1)
      return t == 0 ? a : b;
    const double angle = std::acos(dot(a, b));
    const double s = std::sin((1 - t) * angle) / std::sin(angle), c = std::sin(t * angle) / std::sin(angle);
    return {s * a[0] + c * b[0], s * a[1] + c * b[1], s * a[2] + c * b[2]};
  };
}

/// completes vertices and edges on the unit sphere by ids, stars, cells on both sides and boundary walks.
/// \param cell_of  the number of the cell in which a point lies
inline Extremal_mesh complete(std::vector<Extremal_mesh_vertex> vertices, std::vector<Extremal_mesh_edge> edges,
                              std::vector<Extremal_mesh_cell> cells,
                              const std::function<std::uint32_t(const Point&)>& cell_of, Surface_info surface) {
  for (std::uint32_t e = 0; e < edges.size(); ++e) {
    Extremal_mesh_edge& edge = edges[e];
    edge.id = e;
    const std::size_t i = edge.polyline.size() / 2;
    const Point m = edge.polyline[i], next = edge.polyline[i - 1];
    const Vector left = unit(cross(m, {m[0] - next[0], m[1] - next[1], m[2] - next[2]}));
    const auto at = [&](double s) { return cell_of({m[0] + s * left[0], m[1] + s * left[1], m[2] + s * left[2]}); };
    edge.left_cell = at(0.01);
    edge.right_cell = at(-0.01);
    vertices[edge.source].star.push_back(2 * e);
    vertices[edge.target].star.push_back(2 * e + 1);
  }
  for (Extremal_mesh_vertex& v : vertices) {
    const auto angle = [&](Half_edge h) {
      const std::vector<Point>& line = edges[h / 2].polyline;
      const Point& p = h % 2 == 0 ? line[1] : line[line.size() - 2];
      return std::atan2(dot(p, v.t2), dot(p, v.t1));
    };
    std::sort(v.star.begin(), v.star.end(), [&](Half_edge a, Half_edge b) { return angle(a) < angle(b); });
  }
  std::vector<bool> seen(2 * edges.size());
  for (Half_edge first = 0; first < seen.size(); ++first) {
    if (seen[first])
      continue;
    const auto& left = edges[first / 2];
    auto& walk = cells[first % 2 == 0 ? left.left_cell : left.right_cell].boundary.emplace_back();
    for (Half_edge h = first; !seen[h];) {
      seen[h] = true;
      walk.push_back(h);
      const Extremal_mesh_vertex& target = vertices[h % 2 == 0 ? edges[h / 2].target : edges[h / 2].source];
      if (target.kind == Vertex_kind::boundary)
        break; // along the border back to the other end, in the one mesh of this file that has a border
      const auto& star = target.star;
      const auto back = std::find(star.begin(), star.end(), h ^ 1U) - star.begin();
      h = star[std::size_t(back == 0 ? std::ptrdiff_t(star.size()) - 1 : back - 1)];
    }
  }
  return Extremal_mesh(std::move(vertices), std::move(edges), std::move(cells), std::move(surface));
}

inline Surface_info sphere() {
  return {2, true, 1, 4 * std::numbers::pi, 0, "x^2+y^2+z^2-1 <drawn> & \"lined\"", R"({"resolution":20})", ""};
}

/// the extremal mesh of a triaxial ellipsoid: 6 extremal points, 4 lemons, 16 edges, 8 cells (the octants).
inline Extremal_mesh ellipsoid() {
  const double c = 0.8, s = 0.6;
  const std::vector<Point> points = {{1, 0, 0},  {-1, 0, 0}, {0, 1, 0},  {0, -1, 0},  {0, 0, 1},
                                     {0, 0, -1}, {s, 0, c},  {-s, 0, c}, {-s, 0, -c}, {s, 0, -c}};
  std::vector<Extremal_mesh_vertex> vertices;
  for (std::size_t v = 0; v < points.size(); ++v)
    vertices.push_back(vertex(v < 6 ? Vertex_kind::extremal_point : Vertex_kind::umbilic, points[v]));
  vertices[2].field_index = vertices[3].field_index = 1;
  std::vector<Extremal_mesh_edge> edges;
  const auto path = [&](std::vector<std::uint32_t> corners, int family, Line_type type) {
    for (std::size_t i = 0; i + 1 < corners.size(); ++i)
      edges.push_back(edge(corners[i], corners[i + 1], family, type, arc(points[corners[i]], points[corners[i + 1]])));
  };
  path({0, 2, 1, 3, 0}, 1, Line_type::max_largest);
  path({2, 4, 3, 5, 2}, 2, Line_type::min_second);
  path({6, 4, 7}, 1, Line_type::max_second);
  path({8, 5, 9}, 1, Line_type::max_second);
  path({7, 1, 8}, 2, Line_type::min_largest);
  path({9, 0, 6}, 2, Line_type::min_largest);
  std::vector<Extremal_mesh_cell> cells(8);
  const auto octant = [](const Point& p) { return (p[0] < 0 ? 1U : 0U) + (p[1] < 0 ? 2U : 0U) + (p[2] < 0 ? 4U : 0U); };
  for (unsigned i = 0; i < 8; ++i) {
    cells[i].sign = (i ^ (i >> 1) ^ (i >> 2)) % 2 == 0 ? 1 : -1;
    cells[i].area = std::numbers::pi / 2;
    cells[i].weight = 0.1 * i;
  }
  return complete(vertices, edges, cells, octant, sphere());
}

/// two circles of latitude, each a loop at an anchor: the cell between them is an annulus with two boundary walks.
inline Extremal_mesh two_loops() {
  const double z = 0.5, r = std::sqrt(1 - z * z);
  std::vector<Extremal_mesh_vertex> vertices;
  std::vector<Extremal_mesh_edge> edges;
  for (const double height : {z, -z}) {
    const auto circle = [=](double t) -> Point {
      const double angle = t == 1 ? 0 : 2 * std::numbers::pi * t;
      return {r * std::cos(angle), r * std::sin(angle), height};
    };
    const auto v = std::uint32_t(vertices.size());
    vertices.push_back(vertex(Vertex_kind::anchor, circle(0)));
    edges.push_back(edge(v, v, height > 0 ? 1 : 2, Line_type::max_largest, circle, 24));
    edges.back().segment_types[3] = Line_type::min_largest;
  }
  std::vector<Extremal_mesh_cell> cells(3);
  cells[1].sign = -1;
  cells[1].euler_characteristic = 0;
  return complete(
      vertices, edges, cells, [=](const Point& p) { return p[2] > z    ? 0U
                                                           : p[2] > -z ? 1U
                                                                       : 2U; }, sphere());
}

/// four meridians: the poles are joined by four edges.
inline Extremal_mesh meridians() {
  const Point north = {0, 0, 1}, south = {0, 0, -1};
  std::vector<Extremal_mesh_edge> edges;
  for (int i = 0; i < 4; ++i)
    edges.push_back(edge(0, 1, 1 + i % 2, Line_type::max_second, [=](double t) -> Point {
      const double a = i * std::numbers::pi / 2, b = t * std::numbers::pi;
      return t == 0 ? north : t == 1 ? south : Point{std::cos(a) * std::sin(b), std::sin(a) * std::sin(b), std::cos(b)};
    }));
  std::vector<Extremal_mesh_cell> cells(4);
  cells[1].sign = cells[3].sign = -1;
  return complete(
      {vertex(Vertex_kind::extremal_point, north), vertex(Vertex_kind::extremal_point, south)}, edges, cells,
      [](const Point& p) { return p[1] > 0 ? (p[0] > 0 ? 0U : 1U) : (p[0] < 0 ? 2U : 3U); }, sphere());
}

/// a hemisphere cut by one line from border to border.
inline Extremal_mesh hemisphere() {
  std::vector<Extremal_mesh_cell> cells(2);
  cells[1].sign = -1;
  cells[0].touches_border = cells[1].touches_border = true;
  Surface_info surface = sphere();
  surface.euler_characteristic = 1;
  surface.closed = false;
  surface.source.clear();
  surface.frame = "LPS";
  const auto line = [](double t) -> Point {
    const double angle = t * std::numbers::pi;
    return t == 0 ? Point{1, 0, 0} : t == 1 ? Point{-1, 0, 0} : Point{std::cos(angle), 0, std::sin(angle)};
  };
  return complete(
      {vertex(Vertex_kind::boundary, {1, 0, 0}), vertex(Vertex_kind::boundary, {-1, 0, 0})},
      {edge(0, 1, 2, Line_type::min_second, line)}, cells, [](const Point& p) { return p[1] > 0 ? 0U : 1U; }, surface);
}

/// the unit sphere cut along the lines of `ellipsoid()`: each octant in n² quadrilaterals and triangles.
inline Cell_patches octants(int n = 16) {
  Cell_patches patches;
  for (std::uint32_t octant = 0; octant < 8; ++octant) {
    const Vector side = {octant & 1U ? -1.0 : 1.0, octant & 2U ? -1.0 : 1.0, octant & 4U ? -1.0 : 1.0};
    const bool mirrored = side[0] * side[1] * side[2] < 0;
    const auto first = std::uint32_t(patches.points.size());
    const auto index = [&](int i, int j) { return first + std::uint32_t(i * (i + 1) / 2 + j); };
    for (int i = 0; i <= n; ++i)
      for (int j = 0; j <= i; ++j) {
        const Vector p = unit({side[0] * (i - j), side[1] * j, side[2] * (n - i)});
        patches.points.push_back(p);
        patches.normals.push_back(p);
      }
    const auto polygon = [&](std::vector<std::uint32_t> corners) {
      if (mirrored)
        std::reverse(corners.begin(), corners.end());
      patches.corners.insert(patches.corners.end(), corners.begin(), corners.end());
      patches.begin.push_back(patches.corners.size());
      patches.cell.push_back(octant);
    };
    for (int i = 0; i < n; ++i)
      for (int j = 0; j <= i; ++j)
        if (j < i)
          polygon({index(i, j), index(i + 1, j), index(i + 1, j + 1), index(i, j + 1)});
        else
          polygon({index(i, j), index(i + 1, j), index(i + 1, j + 1)});
  }
  return patches;
}

} // namespace hand_made

#endif // CGAL_EXTREMAL_MESH_3_TEST_HAND_MADE_H
