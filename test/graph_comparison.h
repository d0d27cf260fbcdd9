// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_TEST_GRAPH_COMPARISON_H
#define CGAL_EXTREMAL_MESH_3_TEST_GRAPH_COMPARISON_H

#include <CGAL/Extremal_mesh_3/Extremal_mesh.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/isomorphism.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// Comparison of extremal meshes whose elements are numbered differently.
namespace graph_comparison {

using namespace CGAL::Extremal_mesh_3;

/// What is exchanged in the first mesh before it is compared. Each exchanges left and right, too: a mirror does, and so
/// does looking from the other side.
struct Exchange {
  bool families = false; ///< by reversing the normal
  bool signs = false;    ///< of the cells, by a mirror
};

/// What is compared of umbilics, beside their indices.
enum class Umbilics { all, index_only };

using Simple_graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS>;

/// An extremal mesh as a graph without loops and multiple edges, the nodes of which are its vertices, half-edges, edges
/// and cells: a half-edge is joined to its source, its edge and the cell on its left.
struct Incidence_graph {
  Simple_graph graph;
  std::vector<std::string> label;

  explicit Incidence_graph(const Extremal_mesh& mesh, const Exchange& exchange = {}, Umbilics umbilics = Umbilics::all)
      : graph(mesh.number_of_vertices() + 3 * mesh.number_of_edges() + mesh.number_of_cells()) {
    const std::size_t half_edges = mesh.number_of_vertices(), edges = half_edges + 2 * mesh.number_of_edges(),
                      cells = edges + mesh.number_of_edges();
    for (std::size_t v = 0; v < mesh.number_of_vertices(); ++v) {
      const Extremal_mesh_vertex& x = mesh.vertex(v);
      const std::string type = umbilics == Umbilics::all ? std::string(to_string(x.umbilic_type)) : "";
      label.push_back(std::string(to_string(x.kind)) + ' ' + type + ' ' + std::to_string(x.ridges) + ' ' +
                      std::to_string(std::lround(2 * x.umbilic_index)) + ' ' + std::to_string(x.field_index));
    }
    label.insert(label.end(), 2 * mesh.number_of_edges(), "half-edge");
    for (std::size_t e = 0; e < mesh.number_of_edges(); ++e)
      label.push_back("family " + std::to_string(exchange.families ? 3 - mesh.edge(e).family : mesh.edge(e).family));
    for (const Extremal_mesh_cell& c : mesh.cells())
      label.push_back("cell " + std::to_string(exchange.signs ? -c.sign : c.sign) + ' ' +
                      std::to_string(c.euler_characteristic));
    for (Half_edge h = 0; h < 2 * mesh.number_of_edges(); ++h) {
      boost::add_edge(half_edges + h, mesh.source(h), graph);
      boost::add_edge(half_edges + h, edges + h / 2, graph);
      boost::add_edge(half_edges + h, cells + mesh.left_cell(exchange.families != exchange.signs ? h ^ 1U : h), graph);
    }
  }
};

/// refines labels by those of the neighbours until nothing changes, for two graphs in common: nodes of different
/// colours cannot correspond.
inline std::pair<std::vector<std::size_t>, std::vector<std::size_t>> refined_colours(const Incidence_graph& a,
                                                                                     const Incidence_graph& b) {
  std::array<const Incidence_graph*, 2> graphs{&a, &b};
  std::array<std::vector<std::size_t>, 2> colours;
  std::map<std::string, std::size_t> of_label;
  for (std::size_t g = 0; g < 2; ++g)
    for (const std::string& l : graphs[g]->label)
      of_label.emplace(l, 0);
  std::size_t number = 0;
  for (auto& [l, colour] : of_label)
    colour = number++;
  for (std::size_t g = 0; g < 2; ++g)
    for (const std::string& l : graphs[g]->label)
      colours[g].push_back(of_label[l]);
  for (;;) {
    std::map<std::vector<std::size_t>, std::size_t> of_neighbours;
    std::array<std::vector<std::vector<std::size_t>>, 2> keys;
    for (std::size_t g = 0; g < 2; ++g)
      for (std::size_t v = 0; v < colours[g].size(); ++v) {
        std::vector<std::size_t> key;
        for (auto [w, end] = boost::adjacent_vertices(v, graphs[g]->graph); w != end; ++w)
          key.push_back(colours[g][*w]);
        std::sort(key.begin(), key.end());
        key.push_back(colours[g][v]);
        of_neighbours.emplace(key, 0);
        keys[g].push_back(std::move(key));
      }
    std::size_t n = 0;
    for (auto& [key, colour] : of_neighbours)
      colour = n++;
    for (std::size_t g = 0; g < 2; ++g)
      for (std::size_t v = 0; v < colours[g].size(); ++v)
        colours[g][v] = of_neighbours[keys[g][v]];
    if (n == number)
      return {colours[0], colours[1]};
    number = n;
  }
}

struct Colour {
  using argument_type = std::size_t;
  using result_type = std::size_t;
  const std::vector<std::size_t>* colours;
  std::size_t operator()(std::size_t v) const { return (*colours)[v]; }
};

/// tells whether there is an isomorphism of vertices, edges and cells that keeps kinds, classes of umbilics, families
/// and signs (with what is exchanged).
inline bool isomorphic(const Extremal_mesh& a, const Extremal_mesh& b, const Exchange& exchange = {},
                       Umbilics umbilics = Umbilics::all) {
  if (a.number_of_vertices() != b.number_of_vertices() || a.number_of_edges() != b.number_of_edges() ||
      a.number_of_cells() != b.number_of_cells())
    return false;
  const Incidence_graph A(a, exchange, umbilics), B(b, {}, umbilics);
  const auto [colour_a, colour_b] = refined_colours(A, B);
  auto sorted_a = colour_a, sorted_b = colour_b;
  std::sort(sorted_a.begin(), sorted_a.end());
  std::sort(sorted_b.begin(), sorted_b.end());
  if (sorted_a != sorted_b)
    return false;
  const std::size_t most = sorted_a.empty() ? 0 : sorted_a.back() + 1;
  const Colour invariant_a{&colour_a}, invariant_b{&colour_b};
  std::vector<std::size_t> map(boost::num_vertices(A.graph));
  return boost::isomorphism(
      A.graph, B.graph,
      boost::make_iterator_property_map(map.begin(), boost::get(boost::vertex_index, A.graph), map[0]), invariant_a,
      invariant_b, most, boost::get(boost::vertex_index, A.graph), boost::get(boost::vertex_index, B.graph));
}

/// pairs points with points, each with its nearest one.
/// \return the largest distance of a pair; nothing if two points have the same nearest one
inline std::optional<double> largest_distance(const std::vector<Point>& a, const std::vector<Point>& b) {
  if (a.size() != b.size())
    return std::nullopt;
  std::vector<char> taken(b.size(), 0);
  double largest = 0;
  for (const Point& p : a) {
    std::size_t nearest = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < b.size(); ++i) {
      const double d = std::hypot(p[0] - b[i][0], p[1] - b[i][1], p[2] - b[i][2]);
      if (d < least) {
        least = d;
        nearest = i;
      }
    }
    if (taken[nearest]++)
      return std::nullopt;
    largest = std::max(largest, least);
  }
  return largest;
}

/// the positions of the vertices of one kind.
inline std::vector<Point> positions(const Extremal_mesh& mesh, Vertex_kind kind) {
  std::vector<Point> found;
  for (std::size_t v = 0; v < mesh.number_of_vertices(); ++v)
    if (mesh.vertex(v).kind == kind)
      found.push_back(mesh.vertex(v).point);
  return found;
}

} // namespace graph_comparison

#endif // CGAL_EXTREMAL_MESH_3_TEST_GRAPH_COMPARISON_H
