// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "corresponding_edges.h"

#include "../differential/vector.h"
#include "Segment_finder.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace CGAL::Extremal_mesh_3 {

namespace {

/// the parts of an edge's length beside which edges of the same type run in the other mesh.
std::map<std::uint32_t, double> length_beside(const Extremal_mesh_edge& e, const Extremal_mesh& b,
                                              const Segment_finder& finder, const Similarity& motion,
                                              double tolerance) {
  std::map<std::uint32_t, double> beside;
  for (std::size_t s = 0; s + 1 < e.polyline.size(); ++s) {
    const Point p = motion(e.polyline[s]), q = motion(e.polyline[s + 1]);
    const double whole = distance(p, q);
    const auto parts = std::max<std::size_t>(1, std::size_t(std::ceil(whole / (0.5 * tolerance))));
    for (std::size_t part = 0; part < parts; ++part) {
      std::set<std::uint32_t> near; // each edge once
      finder.for_each(p + (double(part) + 0.5) / double(parts) * (q - p), tolerance,
                      [&](const Segment_finder::Near& n) {
                        if (b.edge(n.edge).type == e.type)
                          near.insert(n.edge);
                      });
      for (const std::uint32_t f : near)
        beside[f] += whole / double(parts);
    }
  }
  return beside;
}

bool same_kind(const Extremal_mesh_vertex& v, const Extremal_mesh_vertex& w) {
  return v.kind == w.kind && v.ridges == w.ridges;
}

/// the edges of b that an edge of a corresponds to.
std::vector<std::uint32_t> partners_of(const Extremal_mesh& a, std::uint32_t i, const Extremal_mesh& b,
                                       const Segment_finder& finder, const Similarity& motion, double tolerance) {
  const Extremal_mesh_edge& e = a.edge(i);
  const auto same = [&](std::uint32_t v, std::uint32_t w) {
    const Extremal_mesh_vertex &x = a.vertex(v), &y = b.vertex(w);
    // an anchor may lie anywhere on its line
    return same_kind(x, y) && (x.kind == Vertex_kind::anchor || distance(motion(x.point), y.point) <= tolerance);
  };
  std::vector<std::uint32_t> partners;
  for (const auto& [f, length] : length_beside(e, b, finder, motion, tolerance)) {
    const Extremal_mesh_edge& other = b.edge(f);
    if (length >= 0.9 * motion.scale * e.length && ((same(e.source, other.source) && same(e.target, other.target)) ||
                                                    (same(e.source, other.target) && same(e.target, other.source))))
      partners.push_back(f);
  }
  return partners;
}

std::vector<std::uint32_t> sides_of(const Extremal_mesh_cell& cell) {
  std::vector<std::uint32_t> sides;
  for (const std::vector<Half_edge>& walk : cell.boundary)
    for (const Half_edge h : walk)
      sides.push_back(h / 2);
  return sides;
}

/// do the sides of a cell correspond to those of another one, each to its own? Tried in order, as hardly any has more than one partner.
bool sides_correspond(const Extremal_mesh_cell& cell, const Extremal_mesh_cell& other,
                      const std::vector<std::vector<std::uint32_t>>& partners) {
  std::vector<std::uint32_t> free = sides_of(other);
  const std::vector<std::uint32_t> sides = sides_of(cell);
  if (sides.size() != free.size() || cell.boundary.size() != other.boundary.size())
    return false;
  return std::all_of(sides.begin(), sides.end(), [&](std::uint32_t side) {
    const auto found = std::find_if(free.begin(), free.end(), [&](std::uint32_t f) {
      return std::find(partners[side].begin(), partners[side].end(), f) != partners[side].end();
    });
    if (found == free.end())
      return false;
    free.erase(found);
    return true;
  });
}

} // namespace

Correspondence corresponding_edges_and_cells(const Extremal_mesh& a, const Extremal_mesh& b, const Similarity& motion,
                                             double tolerance, Thread_pool& threads) {
  const Segment_finder finder(b, std::nullopt);
  std::vector<std::vector<std::uint32_t>> partners(a.number_of_edges());
  threads.for_each(partners.size(), 16, [&](std::size_t i) {
    partners[i] = partners_of(a, std::uint32_t(i), b, finder, motion, tolerance);
  });
  const auto edges = std::count_if(partners.begin(), partners.end(), [](const auto& p) { return !p.empty(); });
  std::size_t cells = 0;
  double area = 0, all_area = 0;
  const int mirror = motion.mirrors() ? -1 : 1; // it changes the sign of E_g
  for (std::size_t c = 0; c < a.number_of_cells(); ++c) {
    const Extremal_mesh_cell& cell = a.cell(c);
    all_area += cell.area;
    if (cell.boundary.empty())
      continue;
    std::set<std::uint32_t> candidates;
    for (const std::uint32_t f : partners[cell.boundary.front().front() / 2])
      candidates.insert({b.edge(f).left_cell, b.edge(f).right_cell});
    if (std::any_of(candidates.begin(), candidates.end(), [&](std::uint32_t d) {
          const Extremal_mesh_cell& other = b.cell(d);
          return other.sign == mirror * cell.sign && other.euler_characteristic == cell.euler_characteristic &&
                 sides_correspond(cell, other, partners);
        })) {
      ++cells;
      area += cell.area;
    }
  }
  Correspondence result;
  result.edges = a.number_of_edges() > 0 ? double(edges) / double(a.number_of_edges()) : 0;
  result.cells = a.number_of_cells() > 0 ? double(cells) / double(a.number_of_cells()) : 0;
  result.area_of_cells = all_area > 0 ? area / all_area : 0;
  return result;
}

} // namespace CGAL::Extremal_mesh_3
