// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_TEST_CORRESPONDENCE_H
#define CGAL_EXTREMAL_MESH_3_TEST_CORRESPONDENCE_H

#include <CGAL/Extremal_mesh_3/Extremal_mesh.h>

#include "motion.h"

#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

/// How much of one extremal mesh has a partner in another one, near the same place.
namespace correspondence {

using namespace CGAL::Extremal_mesh_3;
namespace index = boost::geometry::index;

/// Of how many, or of how much length, is told, and how many have a partner.
struct Share {
  double matched = 0, all = 0;
  void add(double amount, bool has_partner) {
    all += amount;
    matched += has_partner ? amount : 0;
  }
  double value() const { return all > 0 ? matched / all : 0; }
};

/// What is counted. Vertices are those where lines meet: neither anchors nor ends at the border.
enum Measure { extremal_points, umbilics_1, umbilics_3, vertices, edges, edges_with_ends, length };
inline constexpr std::array<std::string_view, 7> names{"extremal_points", "umbilics_1",      "umbilics_3", "vertices",
                                                       "edges",           "edges_with_ends", "length"};
using Shares = std::array<Share, names.size()>;

/// which of the first three measures counts a vertex; 3: none of them, but `vertices`; 4, 5: an anchor, an end at the
/// border.
inline std::size_t kind_of(const Extremal_mesh_vertex& v) {
  switch (v.kind) {
  case Vertex_kind::extremal_point:
    return extremal_points;
  case Vertex_kind::umbilic:
    return v.ridges == 1 ? umbilics_1 : v.ridges == 3 ? umbilics_3 : 3;
  case Vertex_kind::anchor:
    return 4;
  case Vertex_kind::boundary:
    return 5;
  case Vertex_kind::non_generic:
    break;
  }
  return 3;
}

inline double distance_to_segment(const Point& p, const Point& a, const Point& b) {
  const Vector ab = surfaces::along(b, -1, a), ap = surfaces::along(p, -1, a);
  const double l2 = surfaces::dot(ab, ab), t = l2 > 0 ? std::clamp(surfaces::dot(ap, ab) / l2, 0.0, 1.0) : 0;
  return surfaces::distance(p, surfaces::along(a, t, ab));
}

/// Finds the vertices and lines of a mesh within a distance from a point.
class Neighbourhoods {
public:
  /// \param mesh  outlives it
  Neighbourhoods(const Extremal_mesh& mesh, double distance) : mesh_(mesh), distance_(distance) {
    std::array<std::vector<Box>, 6> points;
    for (std::size_t v = 0; v < mesh.number_of_vertices(); ++v)
      points[kind_of(mesh.vertex(v))].push_back(box_of(mesh.vertex(v).point, mesh.vertex(v).point));
    for (std::size_t k = 0; k < points.size(); ++k)
      vertices_[k] = decltype(vertices_)::value_type(points[k]);
    std::vector<Piece> pieces;
    for (std::uint32_t e = 0; e < mesh.number_of_edges(); ++e) {
      const auto& line = mesh.edge(e).polyline;
      for (std::uint32_t s = 0; s + 1 < line.size(); ++s)
        pieces.emplace_back(box_of(line[s], line[s + 1]), std::pair(e, s));
    }
    pieces_ = decltype(pieces_)(pieces);
  }

  const Extremal_mesh& mesh() const { return mesh_; }
  double distance() const { return distance_; }

  bool has_vertex(const Point& p, std::size_t kind) const {
    const auto& tree = vertices_[kind];
    const auto near = [&](const Box& b) {
      return surfaces::distance(p, {b.min_corner().get<0>(), b.min_corner().get<1>(), b.min_corner().get<2>()}) <=
             distance_;
    };
    return tree.qbegin(index::intersects(around(p)) && index::satisfies(near)) != tree.qend();
  }

  /// calls `visit(edge, segment of its polyline)` for all that are near.
  template <typename Visit> void for_each_piece(const Point& p, const Visit& visit) const {
    for (auto it = pieces_.qbegin(index::intersects(around(p))); it != pieces_.qend(); ++it) {
      const auto [e, s] = it->second;
      const auto& line = mesh_.edge(e).polyline;
      if (distance_to_segment(p, line[s], line[s + 1]) <= distance_)
        visit(e, s);
    }
  }

private:
  using Corner = boost::geometry::model::point<double, 3, boost::geometry::cs::cartesian>;
  using Box = boost::geometry::model::box<Corner>;
  using Piece = std::pair<Box, std::pair<std::uint32_t, std::uint32_t>>;
  template <typename T> using Tree = index::rtree<T, index::quadratic<16>>;

  static Box box_of(const Point& p, const Point& q) {
    return {Corner(std::min(p[0], q[0]), std::min(p[1], q[1]), std::min(p[2], q[2])),
            Corner(std::max(p[0], q[0]), std::max(p[1], q[1]), std::max(p[2], q[2]))};
  }
  Box around(const Point& p) const {
    const double d = distance_;
    return box_of({p[0] - d, p[1] - d, p[2] - d}, {p[0] + d, p[1] + d, p[2] + d});
  }

  const Extremal_mesh& mesh_;
  double distance_;
  std::array<Tree<Box>, 6> vertices_;
  Tree<Piece> pieces_;
};

/// Where the points of a mesh are to be found in the other one, and whether they count.
struct Way {
  std::function<Point(const Point&)> motion;
  std::function<bool(const Point&)> counts; ///< asked for points that were not moved
};

/// do the ends of two edges correspond, in this or the other order?
inline bool ends_correspond(const Extremal_mesh& a, const Extremal_mesh_edge& e, const Extremal_mesh& b,
                            const Extremal_mesh_edge& f, const Way& way, double distance) {
  const auto same = [&](std::uint32_t v, std::uint32_t w) {
    const std::size_t kind = kind_of(a.vertex(v));
    if (kind != kind_of(b.vertex(w)))
      return false;
    const bool anchor = kind == 4; // which may lie anywhere on its line
    return anchor || surfaces::distance(way.motion(a.vertex(v).point), b.vertex(w).point) <= distance;
  };
  return (same(e.source, f.source) && same(e.target, f.target)) ||
         (same(e.source, f.target) && same(e.target, f.source));
}

/// the shares of mesh `a`, moved, that have a partner in mesh `b` within its distance:
/// - vertices: one of the same kind;
/// - length: a point of a line of the same type (each segment's own);
/// - edges: one edge of the same type that is near on 90 % of the length, for `edges_with_ends` with vertices at both ends that are
///   partners of this one's. All of the edge's points must count.
inline Shares shares(const Extremal_mesh& a, const Neighbourhoods& b, const Way& way) {
  Shares result;
  for (std::size_t v = 0; v < a.number_of_vertices(); ++v) {
    const Extremal_mesh_vertex& x = a.vertex(v);
    const std::size_t kind = kind_of(x);
    if (kind > 3 || !way.counts(x.point))
      continue;
    const bool found = b.has_vertex(way.motion(x.point), kind);
    result[vertices].add(1, found);
    if (kind < 3)
      result[kind].add(1, found);
  }
  for (std::uint32_t i = 0; i < a.number_of_edges(); ++i) {
    const Extremal_mesh_edge& e = a.edge(i);
    bool all_counts = true;
    double total = 0;
    std::map<std::uint32_t, double> near_length; // of the edges of b that have the same type
    for (std::size_t s = 0; s + 1 < e.polyline.size(); ++s) {
      const Point &p = e.polyline[s], &q = e.polyline[s + 1];
      const double whole = surfaces::distance(p, q);
      const auto parts = std::max<std::size_t>(1, std::size_t(std::ceil(whole / (0.5 * b.distance()))));
      for (std::size_t part = 0; part < parts; ++part) {
        const Point x = surfaces::along(p, (double(part) + 0.5) / double(parts), surfaces::along(q, -1, p));
        if (!way.counts(x)) {
          all_counts = false;
          continue;
        }
        const double piece = whole / double(parts);
        bool found = false;
        std::vector<std::uint32_t> near;
        b.for_each_piece(way.motion(x), [&](std::uint32_t f, std::uint32_t segment) {
          found = found || b.mesh().edge(f).segment_types[segment] == e.segment_types[s];
          if (b.mesh().edge(f).type == e.type && std::find(near.begin(), near.end(), f) == near.end())
            near.push_back(f);
        });
        result[length].add(piece, found);
        total += piece;
        for (const std::uint32_t f : near)
          near_length[f] += piece;
      }
    }
    if (!all_counts)
      continue;
    bool found = false, with_ends = false;
    for (const auto& [f, l] : near_length)
      if (l >= 0.9 * total) {
        found = true;
        with_ends = with_ends || ends_correspond(a, e, b.mesh(), b.mesh().edge(f), way, b.distance());
      }
    result[edges].add(1, found);
    result[edges_with_ends].add(1, with_ends);
  }
  return result;
}

/// the shares of vertices and of length that would have a partner in mesh `b` by chance if those of `a` lay anywhere on
/// the surface: the parts of its area that are near to vertices of each kind and to lines of each type.
/// \param surface  points of the surface in b's place, evenly spread; not empty
inline Shares chance(const Extremal_mesh& a, const Neighbourhoods& b, const Way& way,
                     const std::vector<Point>& surface) {
  std::array<Share, 4> by_kind, by_type;
  for (const Point& p : surface) {
    for (std::size_t kind = 0; kind < 4; ++kind)
      by_kind[kind].add(1, b.has_vertex(p, kind));
    std::array<bool, 4> near{};
    b.for_each_piece(
        p, [&](std::uint32_t f, std::uint32_t s) { near[std::size_t(b.mesh().edge(f).segment_types[s])] = true; });
    for (std::size_t type = 0; type < 4; ++type)
      by_type[type].add(1, near[type]);
  }
  Shares result;
  const auto add = [](Share& share, double amount, double probability) {
    share.all += amount;
    share.matched += probability * amount;
  };
  for (std::size_t v = 0; v < a.number_of_vertices(); ++v) {
    const std::size_t kind = kind_of(a.vertex(v));
    if (kind > 3 || !way.counts(a.vertex(v).point))
      continue;
    add(result[vertices], 1, by_kind[kind].value());
    if (kind < 3)
      add(result[kind], 1, by_kind[kind].value());
  }
  for (std::size_t i = 0; i < a.number_of_edges(); ++i) {
    const Extremal_mesh_edge& e = a.edge(i);
    for (std::size_t s = 0; s + 1 < e.polyline.size(); ++s)
      if (way.counts(e.polyline[s]))
        add(result[length], surfaces::distance(e.polyline[s], e.polyline[s + 1]),
            by_type[std::size_t(e.segment_types[s])].value());
  }
  return result;
}

} // namespace correspondence

#endif // CGAL_EXTREMAL_MESH_3_TEST_CORRESPONDENCE_H
