// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Extremal_mesh_3/paths.h>

#include "require.h"

#include <boost/graph/connected_components.hpp>
#include <boost/graph/dijkstra_shortest_paths.hpp>

#include <algorithm>
#include <limits>

namespace CGAL::Extremal_mesh_3 {

namespace {

constexpr Half_edge none = std::numeric_limits<Half_edge>::max();

/// Remembers by which half-edge each vertex is reached: two vertices can be joined by several edges.
class Record_half_edges : public boost::default_dijkstra_visitor {
public:
  explicit Record_half_edges(std::vector<Half_edge>& reached_by) : reached_by_(&reached_by) {}

  template <class Edge, class Graph> void edge_relaxed(const Edge& e, const Graph& graph) const {
    const Extremal_mesh_edge& edge = graph[e];
    (*reached_by_)[target(e, graph)] = 2 * edge.id + (source(e, graph) == edge.source ? 0 : 1);
  }

private:
  std::vector<Half_edge>* reached_by_;
};

} // namespace

std::optional<Path> shortest_path(const Extremal_mesh& mesh, std::uint32_t from, std::uint32_t to) {
  require_vertex(mesh, from);
  require_vertex(mesh, to);
  const auto& graph = mesh.graph();
  for (std::size_t e = 0; e < mesh.number_of_edges(); ++e)
    if (!(mesh.edge(e).length >= 0))
      throw std::invalid_argument(fmt::format("edge {} has the length {}", e, mesh.edge(e).length));

  std::vector<Half_edge> reached_by(mesh.number_of_vertices(), none);
  std::vector<double> distance(mesh.number_of_vertices());
  boost::dijkstra_shortest_paths(graph, from,
                                 boost::weight_map(boost::get(&Extremal_mesh_edge::length, graph))
                                     .distance_map(distance.data())
                                     .visitor(Record_half_edges(reached_by)));
  if (from != to && reached_by[to] == none)
    return std::nullopt;
  Path path;
  path.length = distance[to];
  for (std::uint32_t v = to; v != from; v = mesh.source(reached_by[v]))
    path.half_edges.push_back(reached_by[v]);
  std::reverse(path.half_edges.begin(), path.half_edges.end());
  return path;
}

Connected_components connected_components(const Extremal_mesh& mesh) {
  Connected_components components;
  components.of_vertex.resize(mesh.number_of_vertices());
  components.number = boost::connected_components(mesh.graph(), components.of_vertex.data());
  return components;
}

} // namespace CGAL::Extremal_mesh_3
