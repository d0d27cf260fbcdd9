// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_orientation.h"

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>

#include <set>
#include <utility>

namespace CGAL::Extremal_mesh_3 {

namespace {

/// Told by CGAL what it does.
struct Visitor : Polygon_mesh_processing::Default_orientation_visitor {
  Orientation_counts* counts = nullptr;
  std::set<std::pair<std::size_t, std::size_t>>* edges = nullptr; // CGAL visits an edge once per polygon

  void non_manifold_edge(std::size_t a, std::size_t b, std::size_t) { edges->insert(std::minmax(a, b)); }
  void non_manifold_vertex(std::size_t, std::size_t) { ++counts->non_manifold_vertices; }
  void polygon_orientation_reversed(std::size_t polygon) { counts->turned[polygon] = !counts->turned[polygon]; }
};

} // namespace

Orientation_counts orient(Polygon_soup& soup) {
  Orientation_counts counts;
  counts.turned.resize(soup.polygons.size());
  std::set<std::pair<std::size_t, std::size_t>> edges;
  Visitor visitor;
  visitor.counts = &counts;
  visitor.edges = &edges;
  Polygon_mesh_processing::orient_polygon_soup(soup.points, soup.polygons, parameters::visitor(visitor));
  counts.non_manifold_edges = edges.size();
  return counts;
}

} // namespace CGAL::Extremal_mesh_3
