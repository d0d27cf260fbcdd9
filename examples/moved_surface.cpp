// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Does the extremal mesh change when the surface is moved? Boost's isomorphism() tells; its other algorithms work on the
// graph as it is, too.

#include <CGAL/Extremal_mesh_3/Formula.h>
#include <CGAL/Extremal_mesh_3/extract_extremal_mesh.h>

#include <boost/graph/connected_components.hpp>
#include <boost/graph/depth_first_search.hpp>
#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/graph/isomorphism.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <vector>

using namespace CGAL::Extremal_mesh_3;
using Graph = Extremal_mesh::Graph;

/// counts the edges of a depth-first search's forest.
struct Count_tree_edges : boost::default_dfs_visitor {
  std::size_t* count = nullptr;
  template <class Edge> void tree_edge(const Edge&, const Graph&) const { ++*count; }
};

/// the greatest distance along the lines between two vertices.
double diameter(const Graph& graph) {
  double greatest = 0;
  std::vector<double> distance(boost::num_vertices(graph));
  for (std::size_t v = 0; v < distance.size(); ++v) {
    boost::dijkstra_shortest_paths(
        graph, v, boost::weight_map(boost::get(&Extremal_mesh_edge::length, graph)).distance_map(distance.data()));
    greatest = std::max(greatest, *std::max_element(distance.begin(), distance.end()));
  }
  return greatest;
}

int main() {
  const Formula ellipsoid("x^2/9 + y^2/4 + z^2 = 1"), moved("(x-1)^2/4 + (y-1)^2 + (z-1)^2/9 = 1");
  const Extremal_mesh mesh = extract_extremal_mesh(ellipsoid, make_lattice({-4, -3, -2}, {4, 3, 2}, 48)).mesh;
  const Extremal_mesh copy = extract_extremal_mesh(moved, make_lattice({-2, -1, -3}, {4, 3, 5}, 48)).mesh;
  const Graph &a = mesh.graph(), &b = copy.graph();

  std::vector<std::size_t> image(boost::num_vertices(a));
  bool good = boost::isomorphism(a, b, boost::isomorphism_map(image.data()));
  std::cout << "the moved surface has " << (good ? "the same" : "another") << " graph\n";
  for (std::size_t v = 0; good && v < image.size(); ++v)
    good = a[v].kind == b[image[v]].kind; // all extremal points have four branches, all umbilics here two

  std::vector<std::size_t> component(boost::num_vertices(a));
  const std::size_t components = boost::connected_components(a, component.data());
  std::size_t tree_edges = 0;
  Count_tree_edges visitor;
  visitor.count = &tree_edges;
  boost::depth_first_search(a, boost::visitor(visitor));
  std::cout << components << " component, spanned by " << tree_edges << " of " << boost::num_edges(a) << " edges\n";
  good = good && tree_edges + components == boost::num_vertices(a);

  std::cout << "no two vertices are farther apart along the lines than " << diameter(a) << '\n';
  good = good && std::abs(diameter(a) - diameter(b)) < 1e-3; // polylines have other points
  return good ? 0 : 1;
}
