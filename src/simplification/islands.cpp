// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "islands.h"

#include <algorithm>

namespace CGAL::Extremal_mesh_3 {

namespace {

constexpr std::size_t most_edges = 32;

bool contains(const std::vector<std::uint32_t>& list, std::uint32_t x) {
  return std::find(list.begin(), list.end(), x) != list.end();
}

class Island_finder {
public:
  explicit Island_finder(const Embedded_graph& graph) : graph_(graph) {}

  /// adds the connected part of the graph around a vertex.
  /// \return `false` if it is too large or may not be removed
  bool add_part(std::uint32_t vertex) {
    std::size_t next = island_.vertices.size();
    island_.vertices.push_back(vertex);
    for (; next < island_.vertices.size(); ++next) {
      const Embedded_graph::Vertex& v = graph_.vertices()[island_.vertices[next]];
      if (v.frozen || v.degree > most_edges)
        return false;
      island_.sum = island_.sum + indices(v);
      for (const Half_edge h : graph_.star(island_.vertices[next])) {
        if (contains(island_.edges, h / 2))
          continue;
        if (graph_.edges()[h / 2].kept || island_.edges.size() == most_edges)
          return false;
        island_.edges.push_back(h / 2);
        if (!contains(island_.vertices, graph_.target(h)))
          island_.vertices.push_back(graph_.target(h));
      }
    }
    return true;
  }

  /// the cells beside the edges so far.
  std::vector<std::uint32_t> cells() const {
    std::vector<std::uint32_t> result;
    for (const std::uint32_t e : island_.edges)
      for (const Half_edge h : {2 * e, 2 * e + 1})
        if (!contains(result, graph_.left_cell(h)))
          result.push_back(graph_.left_cell(h));
    return result;
  }

  /// adds what lies in the cells on the other sides than `outer`.
  std::optional<Island> enclosed_by(std::uint32_t outer) {
    island_.outer = outer;
    for (bool changed = true; changed;) {
      changed = false;
      for (const std::uint32_t c : cells()) {
        if (c == outer || contains(island_.inner, c))
          continue;
        if (graph_.cell(c).touches_border || graph_.cell(c).sides > 2 * most_edges)
          return std::nullopt;
        island_.inner.push_back(c);
        changed = true;
        for (const Half_edge h : graph_.sides(c))
          if (!contains(island_.vertices, graph_.source(h)) && !add_part(graph_.source(h)))
            return std::nullopt;
      }
    }
    int euler_characteristic = int(island_.vertices.size()) - int(island_.edges.size());
    for (const std::uint32_t c : island_.inner)
      euler_characteristic += graph_.cell(c).euler_characteristic;
    if (euler_characteristic != 1)
      return std::nullopt;
    return island_;
  }

private:
  const Embedded_graph& graph_;
  Island island_;
};

} // namespace

std::optional<Island> find_island(const Embedded_graph& graph, std::uint32_t vertex) {
  Island_finder part(graph);
  if (!part.add_part(vertex))
    return std::nullopt;
  // Outside are the others: try the cell with the most sides first.
  std::vector<std::uint32_t> cells = part.cells();
  std::stable_sort(cells.begin(), cells.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return graph.cell(a).sides > graph.cell(b).sides; });
  for (const std::uint32_t outer : cells) {
    if (Island_finder all = part; std::optional<Island> island = all.enclosed_by(outer))
      return island;
    if (graph.cell(outer).sides > 2 * most_edges)
      break; // it cannot be inside
  }
  return std::nullopt;
}

} // namespace CGAL::Extremal_mesh_3
