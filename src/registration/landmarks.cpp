// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Extremal_mesh_3/landmarks.h>

#include "../cgal/Point_tree.h"
#include "../differential/vector.h"
#include "../queries/require.h"
#include "Features.h"
#include "Segment_finder.h"

#include <CGAL/Extremal_mesh_3/measures.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace CGAL::Extremal_mesh_3 {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Vertices of one kind, to be searched.
struct Searched_vertices {
  std::vector<std::uint32_t> vertices;
  Point_tree<3> tree;

  Searched_vertices(const Extremal_mesh& mesh, std::vector<std::uint32_t> of_kind)
      : vertices(std::move(of_kind)), tree(points_of(mesh, vertices)) {}

  double distance_to(const Point& p, std::uint32_t& vertex) const {
    const auto near = tree.nearest(p, 1, infinity);
    if (near.empty())
      return infinity;
    vertex = vertices[near.front().index];
    return near.front().distance;
  }

private:
  static std::vector<Point> points_of(const Extremal_mesh& mesh, const std::vector<std::uint32_t>& vertices) {
    std::vector<Point> points;
    for (const std::uint32_t v : vertices)
      points.push_back(mesh.vertex(v).point);
    return points;
  }
};

double distance_to(const Segment_finder& lines, const Point& p, std::uint32_t& edge) {
  const auto near = lines.nearest(p, infinity);
  if (!near)
    return infinity;
  edge = near->edge;
  return near->distance;
}

/// All that is looked for.
class Surroundings {
public:
  Surroundings(const Extremal_mesh& mesh, const std::vector<Landmark>& among)
      : mesh_(mesh), points_(mesh, vertices_of(mesh, among, Vertex_kind::extremal_point)),
        umbilics_(mesh, vertices_of(mesh, among, Vertex_kind::umbilic)), lines_(mesh, std::nullopt),
        crests_(mesh, Line_type::max_largest) {}

  Landmark_match near(const Point& p, double reach) const {
    Landmark_match m;
    m.to_extremal_point = points_.distance_to(p, m.extremal_point);
    m.to_umbilic = umbilics_.distance_to(p, m.umbilic);
    m.to_line = distance_to(lines_, p, m.line);
    m.to_crest_line = distance_to(crests_, p, m.crest_line);
    constexpr int directions = 8;
    for (int i = 0; i < directions; ++i) {
      const Point q = beside(p, 2 * std::numbers::pi * i / directions, (1 + i % 3) * reach);
      std::uint32_t ignored = 0;
      m.chance_extremal_point += points_.distance_to(q, ignored) / directions;
      m.chance_umbilic += umbilics_.distance_to(q, ignored) / directions;
      m.chance_line += distance_to(lines_, q, ignored) / directions;
      m.chance_crest_line += distance_to(crests_, q, ignored) / directions;
    }
    return m;
  }

private:
  static std::vector<std::uint32_t> vertices_of(const Extremal_mesh& mesh, const std::vector<Landmark>& among,
                                                Vertex_kind kind) {
    std::vector<std::uint32_t> result;
    if (among.empty())
      for (std::uint32_t v = 0; v < mesh.number_of_vertices(); ++v)
        result.push_back(v);
    for (const Landmark& landmark : among)
      result.push_back(landmark.vertex);
    std::erase_if(result, [&](std::uint32_t v) { return mesh.vertex(v).kind != kind; });
    return result;
  }

  /// a point as high above the surface, as the nearest line tells where that is.
  Point beside(const Point& p, double angle, double length) const {
    std::uint32_t ignored = 0;
    if (!std::isfinite(distance_to(lines_, p, ignored)))
      return p;
    const auto normal_at = [&](const Point& x, Point& on_line) {
      const auto near = lines_.nearest(x, infinity);
      on_line = mesh_.edge(near->edge).polyline[near->segment];
      return mesh_.edge(near->edge).normals[near->segment];
    };
    Point on_line{};
    const Vector n = normal_at(p, on_line), u = any_orthogonal(n), v = cross(n, u);
    const double height = dot(p - on_line, n); // a landmark off the surface is compared with points as far off
    const Point q = p + length * std::cos(angle) * u + length * std::sin(angle) * v;
    const Vector m = normal_at(q, on_line);
    return q - (dot(q - on_line, m) - height) * m;
  }

  const Extremal_mesh& mesh_;
  Searched_vertices points_, umbilics_;
  Segment_finder lines_, crests_;
};

} // namespace

std::vector<Landmark> strongest_landmarks(const Extremal_mesh& mesh, const Landmark_options& options) {
  std::vector<Landmark> result;
  const std::vector<Feature> features = vertex_features(mesh);
  const auto add = [&](bool umbilics, const char* prefix) {
    std::vector<Landmark> some;
    for (const Feature& f : features)
      if (f.is_umbilic() == umbilics)
        some.push_back({"", f.vertex, f.persistence, vertex_measures(mesh, f.vertex).strength});
    std::stable_sort(some.begin(), some.end(), [](const Landmark& x, const Landmark& y) {
      return x.persistence > y.persistence || (x.persistence == y.persistence && x.strength > y.strength);
    });
    some.resize(std::min(some.size(), options.most));
    for (std::size_t i = 0; i < some.size(); ++i)
      some[i].id = prefix + std::to_string(i + 1);
    result.insert(result.end(), some.begin(), some.end());
  };
  if (options.extremal_points)
    add(false, "EP");
  if (options.umbilics)
    add(true, "U");
  return result;
}

std::vector<Landmark_match> match_landmarks(const Extremal_mesh& mesh, const std::vector<Given_landmark>& landmarks,
                                            const std::vector<Landmark>& among, double reach) {
  for (const Landmark& landmark : among)
    require_vertex(mesh, landmark.vertex);
  if (!(reach > 0) && mesh.number_of_cells() > 0)
    reach = std::sqrt(std::max(0.0, mesh.surface().area) / double(mesh.number_of_cells()));
  const Surroundings surroundings(mesh, among);
  std::vector<Landmark_match> result;
  for (const Given_landmark& landmark : landmarks) {
    require_finite(landmark.point);
    result.push_back(surroundings.near(landmark.point, reach));
  }
  return result;
}

} // namespace CGAL::Extremal_mesh_3
