// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Following lines through vertices. The continuation at a vertex is an involution on its branches, so lines can neither
// fork nor join, and following one from both ends gives the same edges.
#include <CGAL/Extremal_mesh_3/lines.h>

#include "require.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace CGAL::Extremal_mesh_3 {

namespace {

/// Follows lines over those edges of which `follow` is true, no edge twice.
class Follower {
public:
  Follower(const Extremal_mesh& mesh, std::vector<bool> follow) : mesh_(mesh), free_(std::move(follow)) {}

  bool is_free(std::uint32_t edge) const { return free_[edge]; }

  /// the line through an edge, in its direction.
  Extremal_line line(std::uint32_t edge) {
    Extremal_line result;
    free_[edge] = false;
    result.half_edges.push_back(2 * edge);
    result.closed = follow(result.half_edges);
    if (result.closed)
      return result;
    std::vector<Half_edge> back = {2 * edge + 1};
    follow(back);
    std::vector<Half_edge> all(back.rbegin(), back.rend() - 1);
    for (Half_edge& h : all)
      h ^= 1U;
    all.insert(all.end(), result.half_edges.begin(), result.half_edges.end());
    result.half_edges = std::move(all);
    return result;
  }

private:
  /// goes on to the end of the line. \return whether that is its beginning
  bool follow(std::vector<Half_edge>& line) {
    for (;;) {
      const std::optional<Half_edge> next = next_on_line(mesh_, line.back());
      if (!next || !free_[*next / 2])
        return next == line.front();
      free_[*next / 2] = false;
      line.push_back(*next);
    }
  }

  const Extremal_mesh& mesh_;
  std::vector<bool> free_;
};

std::vector<Extremal_line> lines_of(const Extremal_mesh& mesh, std::vector<bool> follow) {
  Follower follower(mesh, std::move(follow));
  std::vector<Extremal_line> lines;
  for (std::uint32_t e = 0; e < mesh.number_of_edges(); ++e)
    if (follower.is_free(e))
      lines.push_back(follower.line(e));
  return lines;
}

/// as many opposite branches as lines go on through the vertex.
bool lines_pass(const Extremal_mesh_vertex& vertex) {
  const std::size_t degree = vertex.star.size();
  switch (vertex.kind) {
  case Vertex_kind::extremal_point:
    return degree == 4;
  case Vertex_kind::umbilic:
    return degree == 2 || degree == 6;
  case Vertex_kind::anchor:
    return degree == 2;
  case Vertex_kind::non_generic:
  case Vertex_kind::boundary:
    break;
  }
  return false;
}

} // namespace

std::optional<Half_edge> next_on_line(const Extremal_mesh& mesh, Half_edge h) {
  require_half_edge(mesh, h);
  const Extremal_mesh_vertex& vertex = mesh.vertex(mesh.target(h));
  const auto& star = vertex.star;
  const auto in = std::find(star.begin(), star.end(), h ^ 1U);
  if (!lines_pass(vertex) || in == star.end())
    return std::nullopt;
  const Half_edge out = star[(std::size_t(in - star.begin()) + star.size() / 2) % star.size()];
  if (vertex.kind == Vertex_kind::extremal_point && mesh.edge(out / 2).family != mesh.edge(h / 2).family)
    return std::nullopt; // `check()` calls that a violation
  return out;
}

Extremal_line line_through(const Extremal_mesh& mesh, std::uint32_t edge) {
  require_edge(mesh, edge);
  return Follower(mesh, std::vector<bool>(mesh.number_of_edges(), true)).line(edge);
}

std::vector<Extremal_line> all_lines(const Extremal_mesh& mesh) {
  return lines_of(mesh, std::vector<bool>(mesh.number_of_edges(), true));
}

std::vector<Extremal_line> strongest_crest_lines(const Extremal_mesh& mesh, std::size_t k) {
  std::vector<bool> is_crest(mesh.number_of_edges());
  for (std::size_t e = 0; e < is_crest.size(); ++e)
    is_crest[e] = mesh.edge(e).type == Line_type::max_largest;
  std::vector<Extremal_line> lines = lines_of(mesh, std::move(is_crest));

  std::vector<std::pair<double, std::size_t>> order; // by falling strength
  for (std::size_t i = 0; i < lines.size(); ++i) {
    double strength = 0;
    for (const Half_edge h : lines[i].half_edges)
      strength += mesh.edge(h / 2).strength;
    order.emplace_back(std::isnan(strength) ? 0 : -strength, i);
  }
  std::sort(order.begin(), order.end());
  order.resize(std::min(k, order.size()));
  std::vector<Extremal_line> strongest;
  strongest.reserve(order.size());
  for (const auto& [strength, i] : order)
    strongest.push_back(std::move(lines[i]));
  return strongest;
}

std::vector<Point> polyline(const Extremal_mesh& mesh, const std::vector<Half_edge>& half_edges) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < half_edges.size(); ++i) {
    const Half_edge h = half_edges[i];
    require_half_edge(mesh, h);
    if (i > 0 && mesh.source(h) != mesh.target(half_edges[i - 1]))
      throw std::invalid_argument(fmt::format("half-edge {} starts at vertex {}, but half-edge {} before it ends at {}",
                                              h, mesh.source(h), half_edges[i - 1], mesh.target(half_edges[i - 1])));
    const std::vector<Point>& line = mesh.edge(h / 2).polyline;
    if (h % 2 == 0)
      points.insert(points.end(), line.begin() + (i > 0), line.end());
    else
      points.insert(points.end(), line.rbegin() + (i > 0), line.rend());
  }
  return points;
}

} // namespace CGAL::Extremal_mesh_3
