// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_TEST_STRANDS_H
#define CGAL_EXTREMAL_MESH_3_TEST_STRANDS_H

#include <CGAL/Extremal_mesh_3/Extremal_mesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

/// Whether the lines of a simplified mesh, which run along those of the given one and beside each other, cross.
namespace strands {

using namespace CGAL::Extremal_mesh_3;

/// the walk of half-edges of `given` along which an edge of the simplified mesh runs.
inline std::vector<Half_edge> walk_of(const Extremal_mesh_edge& edge,
                                      const std::map<std::pair<Point, Point>, Half_edge>& half_edge_of_segment) {
  std::vector<Half_edge> walk;
  for (std::size_t i = 0; i + 1 < edge.polyline.size(); ++i) {
    const auto found = half_edge_of_segment.find({edge.polyline[i], edge.polyline[i + 1]});
    if (found == half_edge_of_segment.end()) {
      ADD_FAILURE() << "edge " << edge.id << " does not run along a given line";
      return {};
    }
    if (walk.empty() || walk.back() != found->second)
      walk.push_back(found->second);
  }
  return walk;
}

/// where a half-edge stands counter-clockwise after another one of the same star.
inline std::size_t turn(const Extremal_mesh& mesh, Half_edge from, Half_edge to) {
  const auto& star = mesh.vertex(mesh.source(from)).star;
  const auto place = [&](Half_edge h) { return std::size_t(std::find(star.begin(), star.end(), h) - star.begin()); };
  return (place(to) + star.size() - place(from)) % star.size();
}

/// tells whether walk b crosses walk a where both have a vertex in common: they run together from a[i] on for a while
/// (none or more half-edges), having come from different sides. i and j are the half-edges after that vertex.
inline bool cross(const Extremal_mesh& mesh, const std::vector<Half_edge>& a, std::size_t i,
                  const std::vector<Half_edge>& b, std::size_t j) {
  if (i == 0 || j == 0)
    return false; // a walk begins here
  const Half_edge a_in = a[i - 1] ^ 1U, b_in = b[j - 1] ^ 1U;
  if (a_in == b_in || a_in == b[j] || b_in == a[i])
    return false; // they have come together, or one goes back along the other: looked at elsewhere
  if (a[i] != b[j]) {
    // Both only pass: b's ends on different sides of a?
    const std::size_t out = turn(mesh, a_in, a[i]);
    return (turn(mesh, a_in, b_in) < out) != (turn(mesh, a_in, b[j]) < out);
  }
  const bool b_left_before = turn(mesh, a[i], b_in) < turn(mesh, a[i], a_in);
  std::size_t k = i, l = j;
  while (k < a.size() && l < b.size() && a[k] == b[l]) {
    ++k;
    ++l;
  }
  if (k == a.size() || l == b.size())
    return false; // one ends
  const Half_edge back = a[k - 1] ^ 1U;
  const bool b_left_after = turn(mesh, back, b[l]) > turn(mesh, back, a[k]);
  return b_left_before != b_left_after;
}

/// counts the crossings of lines of `simplified` outside their ends.
inline int crossings(const Extremal_mesh& given, const Extremal_mesh& simplified) {
  std::map<std::pair<Point, Point>, Half_edge> half_edge_of_segment;
  for (std::uint32_t e = 0; e < given.number_of_edges(); ++e) {
    const auto& line = given.edge(e).polyline;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      half_edge_of_segment[{line[i], line[i + 1]}] = 2 * e;
      half_edge_of_segment[{line[i + 1], line[i]}] = 2 * e + 1;
    }
  }
  struct Place {
    std::size_t walk, i;
  };
  std::vector<std::vector<Half_edge>> walks;
  std::vector<std::vector<Place>> leaving(given.number_of_vertices()); // every walk in both directions
  for (std::size_t e = 0; e < simplified.number_of_edges(); ++e) {
    std::vector<Half_edge> walk = walk_of(simplified.edge(e), half_edge_of_segment);
    std::vector<Half_edge> back(walk.rbegin(), walk.rend());
    for (Half_edge& h : back)
      h ^= 1U;
    walks.push_back(std::move(walk));
    walks.push_back(std::move(back));
  }
  for (std::size_t w = 0; w < walks.size(); ++w)
    for (std::size_t i = 0; i < walks[w].size(); ++i)
      leaving[given.source(walks[w][i])].push_back({w, i});
  int count = 0;
  for (const auto& places : leaving)
    for (const Place& a : places)
      for (const Place& b : places)
        if (a.walk != b.walk || a.i != b.i)
          count += cross(given, walks[a.walk], a.i, walks[b.walk], b.i);
  return count;
}

} // namespace strands

#endif // CGAL_EXTREMAL_MESH_3_TEST_STRANDS_H
