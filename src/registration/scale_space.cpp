// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Extremal_mesh_3/register.h>
#include <CGAL/Extremal_mesh_3/scale_space.h>

#include "../cgal/Point_tree.h"
#include "../differential/vector.h"
#include "../queries/require.h"
#include "Segment_finder.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <map>
#include <optional>
#include <stdexcept>

namespace CGAL::Extremal_mesh_3 {

std::string_view to_string(Scale_event_kind kind) {
  switch (kind) {
  case Scale_event_kind::create:
    return "create";
  case Scale_event_kind::cancel:
    return "cancel";
  case Scale_event_kind::merge:
    return "merge";
  case Scale_event_kind::vanish:
    return "vanish";
  }
  return "unknown";
}

namespace {

/// extremal points by index 1 and −1, umbilics by index ½ and −½; −1: other vertices.
int class_of(const Extremal_mesh_vertex& v) {
  if (v.kind == Vertex_kind::extremal_point)
    return v.field_index > 0 ? 0 : 1;
  if (v.kind == Vertex_kind::umbilic)
    return v.umbilic_index > 0 ? 2 : 3;
  return -1;
}
constexpr int classes = 4;
/// the class with which one can cancel.
int opposite(int c) {
  return c ^ 1;
}

/// The vertices of a mesh by class, to be searched.
class Classes {
public:
  explicit Classes(const Extremal_mesh& mesh) : mesh_(mesh) {
    std::array<std::vector<Point>, classes> points;
    for (std::uint32_t v = 0; v < mesh.number_of_vertices(); ++v)
      if (const int c = class_of(mesh.vertex(v)); c >= 0) {
        require_finite(mesh.vertex(v).point);
        points[std::size_t(c)].push_back(mesh.vertex(v).point);
        members_[std::size_t(c)].push_back(v);
      }
    for (const auto& some : points)
      trees_.emplace_back(some);
  }
  /// the nearest vertices of a class on the same side of the surface.
  std::vector<std::uint32_t> near(const Extremal_mesh_vertex& v, int c, double within) const {
    std::vector<std::uint32_t> result;
    for (const auto& n : trees_[std::size_t(c)].nearest(v.point, 8, within)) {
      const std::uint32_t w = members_[std::size_t(c)][n.index];
      if (dot(mesh_.vertex(w).normal, v.normal) > 0.5)
        result.push_back(w);
    }
    return result;
  }

private:
  const Extremal_mesh& mesh_;
  std::array<std::vector<std::uint32_t>, classes> members_;
  std::vector<Point_tree<3>> trees_;
};

/// the vertex of b that each vertex of a becomes: both are nearest to each other.
std::vector<std::uint32_t> successors(const Extremal_mesh& a, const Extremal_mesh& b, const Classes& in_a,
                                      const Classes& in_b, double within) {
  std::vector<std::uint32_t> result(a.number_of_vertices(), no_track);
  for (std::uint32_t v = 0; v < result.size(); ++v) {
    const int c = class_of(a.vertex(v));
    if (c < 0)
      continue;
    const auto there = in_b.near(a.vertex(v), c, within);
    if (there.empty())
      continue;
    const auto back = in_a.near(b.vertex(there.front()), c, within);
    if (!back.empty() && back.front() == v)
      result[v] = there.front();
  }
  return result;
}

/// tells why vertices of a level are not found at the next one.
void explain_ends(Scale_space& space, const Extremal_mesh& mesh, const Classes& vertices, std::size_t level,
                  const std::vector<std::uint32_t>& next, double within) {
  std::vector<bool> told(mesh.number_of_vertices());
  const auto gone = [&](std::uint32_t v) { return next[v] == no_track; };
  for (std::uint32_t v = 0; v < mesh.number_of_vertices(); ++v) {
    const int c = class_of(mesh.vertex(v));
    if (c < 0 || !gone(v) || told[v])
      continue;
    Scale_event event{Scale_event_kind::vanish, level, space.track[level][v], no_track, mesh.vertex(v).point};
    for (const std::uint32_t w : vertices.near(mesh.vertex(v), opposite(c), 2 * within))
      if (gone(w) && !told[w]) {
        told[w] = true;
        event.kind = Scale_event_kind::cancel;
        event.other = space.track[level][w];
        break;
      }
    if (event.kind == Scale_event_kind::vanish)
      for (const std::uint32_t w : vertices.near(mesh.vertex(v), c, 2 * within))
        if (!gone(w)) {
          event.kind = Scale_event_kind::merge;
          event.other = space.track[level][w];
          break;
        }
    told[v] = true;
    space.events.push_back(event);
  }
}

void require_ascending(const std::vector<Extremal_mesh>& meshes, const std::vector<double>& sigmas) {
  if (meshes.size() != sigmas.size())
    throw std::invalid_argument(fmt::format("there are {} meshes, but {} scales", meshes.size(), sigmas.size()));
  for (std::size_t i = 0; i < sigmas.size(); ++i)
    if (!(sigmas[i] > (i == 0 ? 0 : sigmas[i - 1])) || std::isinf(sigmas[i]))
      throw std::invalid_argument(fmt::format("scale {} is {}: scales must be positive and ascend", i, sigmas[i]));
}

/// An edge as it is told at another scale: by its family and the tracks at its ends.
using Edge_name = std::array<std::uint32_t, 3>;
std::optional<Edge_name> name_of(const Scale_space& space, const Extremal_mesh_edge& e, std::size_t level) {
  const std::uint32_t s = space.track[level][e.source], t = space.track[level][e.target];
  if (s == no_track || t == no_track)
    return std::nullopt;
  return Edge_name{std::min(s, t), std::max(s, t), std::uint32_t(e.family)};
}

/// are half of an edge's points within a distance of lines of its family, on the same side of the surface?
bool is_near(const Extremal_mesh_edge& e, const Extremal_mesh& mesh, const Segment_finder& lines, double within) {
  std::size_t near = 0;
  for (std::size_t i = 0; i < e.polyline.size(); ++i) {
    bool found = false;
    lines.for_each(e.polyline[i], within, [&](const Segment_finder::Near& n) {
      const Extremal_mesh_edge& other = mesh.edge(n.edge);
      found = found || (other.family == e.family && dot(other.normals[n.segment], e.normals[i]) > 0.5);
    });
    near += found;
  }
  return 2 * near >= e.polyline.size();
}

} // namespace

Scale_space link_scales(const std::vector<Extremal_mesh>& meshes, std::vector<double> sigmas,
                        const Scale_space_options& options) {
  require_ascending(meshes, sigmas);
  if (!(options.tolerance >= 0) || std::isinf(options.tolerance))
    throw std::invalid_argument(fmt::format("the tolerance is {}, not a positive length or 0", options.tolerance));
  Scale_space space;
  space.sigmas = std::move(sigmas);
  std::vector<Classes> vertices;
  for (const Extremal_mesh& mesh : meshes) {
    vertices.emplace_back(mesh);
    space.track.emplace_back(mesh.number_of_vertices(), no_track);
  }
  std::vector<std::uint32_t> next; // of the level before
  for (std::size_t level = 0; level < meshes.size(); ++level) {
    const Extremal_mesh& mesh = meshes[level];
    for (std::uint32_t v = 0; v < next.size(); ++v)
      if (next[v] != no_track) {
        const std::uint32_t track = space.track[level - 1][v];
        space.track[level][next[v]] = track;
        space.tracks[track].vertices.push_back(next[v]);
      }
    for (std::uint32_t v = 0; v < mesh.number_of_vertices(); ++v)
      if (class_of(mesh.vertex(v)) >= 0 && space.track[level][v] == no_track) {
        const auto track = std::uint32_t(space.tracks.size());
        space.track[level][v] = track;
        space.tracks.push_back({mesh.vertex(v).kind, level, {v}});
        if (level > 0)
          space.events.push_back({Scale_event_kind::create, level - 1, track, no_track, mesh.vertex(v).point});
      }
    if (level + 1 == meshes.size())
      break;
    const double tolerance = options.tolerance > 0 ? options.tolerance : default_tolerance(mesh, meshes[level + 1]);
    const double within = tolerance + 0.5 * (space.sigmas[level + 1] - space.sigmas[level]);
    space.reach.push_back(within);
    next = successors(mesh, meshes[level + 1], vertices[level], vertices[level + 1], within);
    explain_ends(space, mesh, vertices[level], level, next, within);
  }
  std::stable_sort(space.events.begin(), space.events.end(),
                   [](const Scale_event& x, const Scale_event& y) { return x.level < y.level; });
  return space;
}

std::vector<double> Scale_space::vertex_life_times(std::size_t level) const {
  require_element("level", level, track.size());
  std::vector<double> result;
  for (const std::uint32_t t : track[level])
    result.push_back(t == no_track ? 0 : std::log(sigmas[tracks[t].last_level()] / sigmas[tracks[t].first_level]));
  return result;
}

std::vector<double> Scale_space::edge_life_times(const std::vector<Extremal_mesh>& meshes, std::size_t level) const {
  require_element("level", level, std::min(track.size(), meshes.size()));
  std::vector<std::map<Edge_name, bool>> names(meshes.size());
  for (std::size_t l = 0; l < meshes.size(); ++l)
    for (std::size_t e = 0; e < meshes[l].number_of_edges(); ++e)
      if (const auto name = name_of(*this, meshes[l].edge(e), l))
        names[l][*name] = true;
  std::deque<Segment_finder> lines; // they cannot be moved
  for (const Extremal_mesh& mesh : meshes)
    lines.emplace_back(mesh, std::nullopt);
  std::vector<double> result(meshes[level].number_of_edges());
  for (std::size_t e = 0; e < result.size(); ++e) {
    const Extremal_mesh_edge& edge = meshes[level].edge(e);
    const auto name = name_of(*this, edge, level);
    const auto is_there = [&](std::size_t other, double within) {
      return name ? names[other].contains(*name) : is_near(edge, meshes[other], lines[other], within);
    };
    std::size_t first = level, last = level;
    for (double within = 0; first > 0 && is_there(first - 1, within + reach[first - 1]); --first)
      within += reach[first - 1];
    for (double within = 0; last + 1 < names.size() && is_there(last + 1, within + reach[last]); ++last)
      within += reach[last];
    result[e] = std::log(sigmas[last] / sigmas[first]);
  }
  return result;
}

Extremal_mesh with_life_times(const std::vector<Extremal_mesh>& meshes, const Scale_space& space, std::size_t level) {
  const std::vector<double> of_vertices = space.vertex_life_times(level),
                            of_edges = space.edge_life_times(meshes, level);
  const Extremal_mesh& mesh = meshes[level];
  std::vector<Extremal_mesh_vertex> vertices;
  for (std::size_t v = 0; v < mesh.number_of_vertices(); ++v)
    vertices.emplace_back(mesh.vertex(v)).life_time = of_vertices.at(v);
  std::vector<Extremal_mesh_edge> edges;
  for (std::size_t e = 0; e < mesh.number_of_edges(); ++e)
    edges.emplace_back(mesh.edge(e)).life_time = of_edges[e];
  return Extremal_mesh(std::move(vertices), std::move(edges), mesh.cells(), mesh.surface());
}

} // namespace CGAL::Extremal_mesh_3
