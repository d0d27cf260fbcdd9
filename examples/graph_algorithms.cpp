// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How do I run the Boost Graph Library's algorithms on an extremal mesh?

#include <CGAL/Extremal_mesh_3/Formula.h>
#include <CGAL/Extremal_mesh_3/extract_extremal_mesh.h>

#include <boost/graph/connected_components.hpp>
#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/graph/filtered_graph.hpp>
#include <boost/range/iterator_range.hpp>

#include <iostream>
#include <vector>

using namespace CGAL::Extremal_mesh_3;
using Graph = Extremal_mesh::Graph;

/// keeps the edges of one family.
struct Of_family {
  const Graph* graph = nullptr;
  int family = 1;
  bool operator()(const Extremal_mesh::edge_descriptor& e) const { return (*graph)[e].family == family; }
};

int main() {
  const Formula ellipsoid("x^2/9 + y^2/4 + z^2 = 1");
  const Extremal_mesh mesh = extract_extremal_mesh(ellipsoid, make_lattice({-4, -3, -2}, {4, 3, 2}, 48)).mesh;
  const Graph& graph = mesh.graph();

  std::vector<int> component(boost::num_vertices(graph));
  std::cout << boost::connected_components(graph, component.data()) << " connected component\n";
  for (int family : {1, 2}) {
    const boost::filtered_graph<Graph, Of_family> lines(graph, Of_family{&graph, family});
    std::cout << boost::connected_components(lines, component.data()) << " of family " << family << " alone\n";
  }

  // The way along the lines from vertex 0 to every other, in the unit of length of the surface.
  std::vector<double> distance(boost::num_vertices(graph));
  boost::dijkstra_shortest_paths(
      graph, boost::vertex(0, graph),
      boost::weight_map(boost::get(&Extremal_mesh_edge::length, graph)).distance_map(distance.data()));
  for (auto v : boost::make_iterator_range(boost::vertices(graph)))
    std::cout << "vertex " << v << " (" << to_string(graph[v].kind) << ") is " << distance[v] << " away\n";
}
