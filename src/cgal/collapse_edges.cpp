// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "collapse_edges.h"
#include "surface_mesh.h"

#include "../differential/distance_to_segment.h"

#include <CGAL/Extremal_mesh_3/errors.h>

#include <CGAL/Surface_mesh_simplification/Edge_collapse_visitor_base.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Constrained_placement.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_cost.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_placement.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <tuple>
#include <utility>

namespace CGAL::Extremal_mesh_3 {

namespace {

namespace Simplification_of_surfaces = CGAL::Surface_mesh_simplification;
using Mesh = Surface_of_triangles;
using Vertex = Mesh::Vertex_index;
using Half = Mesh::Halfedge_index;
using Edge = Mesh::Edge_index;
using Is_kept = Mesh::Property_map<Edge, bool>;
using Normal_of = Mesh::Property_map<Vertex, Vector>;
using Given_of = Mesh::Property_map<Vertex, std::uint32_t>;

Point point_of(const Surface_kernel::Point_3& p) {
  return {p.x(), p.y(), p.z()};
}

/// whether a triangle has an area, and does not turn away from the surface's normals at its corners. What triangles were before says nothing, as
/// cutting along lines makes slivers of any direction.
bool faces_outwards(const Point& a, const Point& b, const Point& c, const Vector& normals) {
  constexpr double least_cosine = 0.2, least_height = 1e-4; // of the longest side
  const Vector area = cross(b - a, c - a);
  const double longest2 = std::max({dot(b - a, b - a), dot(c - a, c - a), dot(c - b, c - b)});
  return norm(area) > least_height * longest2 && dot(area, normals) > least_cosine * norm(area) * norm(normals);
}

/// One kept line between points where not two kept edges meet: the given points, and which of them are left.
struct Chain {
  std::vector<std::uint32_t> points; ///< of a closed one the first is also the last
  std::vector<std::size_t> previous, next;
};

/// the kept edges as chains, in the order of their first points.
std::vector<Chain> chains_of(const std::vector<std::array<std::uint32_t, 2>>& edges, std::size_t number_of_points) {
  std::vector<std::vector<std::uint32_t>> at(number_of_points);
  for (std::uint32_t e = 0; e < edges.size(); ++e)
    for (const std::uint32_t end : edges[e])
      at[end].push_back(e);
  std::vector<bool> used(edges.size(), false);
  std::vector<Chain> chains;
  const auto walk = [&](std::uint32_t first, std::uint32_t e) {
    Chain& chain = chains.emplace_back();
    chain.points.push_back(first);
    for (std::uint32_t here = first;;) {
      used[e] = true;
      here = edges[e][0] == here ? edges[e][1] : edges[e][0];
      chain.points.push_back(here);
      if (at[here].size() != 2 || here == first)
        break;
      e = at[here][0] == e ? at[here][1] : at[here][0];
    }
  };
  for (const bool closed : {false, true}) // what is left when all that has ends is gone has none
    for (std::uint32_t p = 0; p < number_of_points; ++p)
      for (const std::uint32_t e : at[p])
        if (!used[e] && (closed || at[p].size() != 2))
          walk(p, e);
  for (Chain& chain : chains)
    for (std::size_t i = 0; i < chain.points.size(); ++i) {
      chain.previous.push_back(i == 0 ? 0 : i - 1);
      chain.next.push_back(i + 1);
    }
  return chains;
}

/// the largest distance of a given point between two of a chain from the segment that joins these.
double deviation(const Triangles& surface, const Chain& chain, std::size_t first, std::size_t last) {
  double largest = 0;
  for (std::size_t i = first + 1; i < last; ++i)
    largest =
        std::max(largest, distance_to_segment(surface.points[chain.points[i]], surface.points[chain.points[first]],
                                              surface.points[chain.points[last]]));
  return largest;
}

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

/// The surface while it gets coarser. Its vertices are numbered anew from time to time; those of kept lines are known by their points.
struct Working_surface {
  Working_surface(const Triangles& triangles, const std::vector<Vector>& normals, const std::vector<Chain>& chains)
      : given(triangles), mesh(surface_mesh_of(triangles)),
        normal_of(mesh.add_property_map<Vertex, Vector>("v:surface_normal").first),
        given_of(mesh.add_property_map<Vertex, std::uint32_t>("v:given", none).first),
        is_kept(mesh.add_property_map<Edge, bool>("e:is_kept", false).first) {
    for (const Vertex v : mesh.vertices()) {
      normal_of[v] = normals[v];
      vertex_of.push_back(v);
    }
    for (const Chain& chain : chains)
      for (const std::uint32_t p : chain.points)
        given_of[Vertex(p)] = p;
  }
  /// forgets what was removed, for CGAL's algorithms take numbers for those of elements that are there.
  void number_anew(const std::vector<Chain>& chains) {
    mesh.collect_garbage();
    std::fill(vertex_of.begin(), vertex_of.end(), Mesh::null_vertex());
    for (const Vertex v : mesh.vertices())
      if (given_of[v] != none)
        vertex_of[given_of[v]] = v;
    // CGAL collapses edges without length beforehand, also between two points of lines: such points are found again by their places, which they keep.
    std::map<Point, Vertex> at;
    for (const Edge e : mesh.edges())
      if (is_kept[e])
        for (const int end : {0, 1})
          at.emplace(point_of(mesh.point(mesh.vertex(e, unsigned(end)))), mesh.vertex(e, unsigned(end)));
    for (const Chain& chain : chains)
      for (std::size_t i = 0; i < chain.points.size(); i = chain.next[i])
        if (const std::uint32_t p = chain.points[i]; vertex_of[p] == Mesh::null_vertex())
          if (const auto found = at.find(given.points[p]); found != at.end()) {
            vertex_of[p] = found->second;
            given_of[found->second] = p;
          }
  }

  const Triangles& given;
  Mesh mesh;
  Normal_of normal_of;
  Given_of given_of;             ///< of vertices of kept lines: their points
  Is_kept is_kept;               ///< segments of lines
  std::vector<Vertex> vertex_of; ///< of points of kept lines
};

/// Takes points out of kept lines.
class Line_thinner {
public:
  Line_thinner(Working_surface& surface, std::vector<Chain>& chains, double tolerance)
      : surface_(surface), mesh_(surface.mesh), chains_(chains), tolerance_(tolerance) {}

  void run() {
    for (const Chain& chain : chains_)
      for (std::size_t i = 0; chain.next[i] < chain.points.size(); i = chain.next[i])
        segments_.insert(segment(chain.points[i], chain.points[chain.next[i]]));
    for (std::size_t c = 0; c < chains_.size(); ++c)
      for (std::size_t i = chains_[c].next[0]; i + 1 < chains_[c].points.size(); i = chains_[c].next[i])
        consider(c, i);
    while (!queue_.empty()) {
      const auto [deviation, c, i] = *queue_.begin();
      queue_.erase(queue_.begin());
      Chain& chain = chains_[c];
      const std::size_t before = chain.previous[i], after = chain.next[i];
      // Lines do not fall together, nor closed ones into a point.
      const auto joined = segment(chain.points[before], chain.points[after]);
      if (segments_.contains(joined))
        continue;
      if (!collapse(chain.points[i], chain.points[before]) && !collapse(chain.points[i], chain.points[after]))
        continue; // until there is a change beside it
      segments_.erase(segment(chain.points[before], chain.points[i]));
      segments_.erase(segment(chain.points[i], chain.points[after]));
      segments_.insert(joined);
      chain.next[before] = after;
      chain.previous[after] = before;
      for (const std::size_t beside : {before, after})
        if (beside > 0 && beside + 1 < chain.points.size())
          consider(c, beside);
    }
  }

private:
  static std::array<std::uint32_t, 2> segment(std::uint32_t a, std::uint32_t b) {
    return {std::min(a, b), std::max(a, b)};
  }

  void consider(std::size_t c, std::size_t i) {
    const Chain& chain = chains_[c];
    const double cost = deviation(surface_.given, chain, chain.previous[i], chain.next[i]);
    auto& known = cost_.try_emplace({c, i}, -1).first->second;
    if (known >= 0)
      queue_.erase({known, c, i});
    known = cost;
    if (cost <= tolerance_)
      queue_.insert({cost, c, i});
  }

  /// moves a point into a neighbour, if the surface stays what it is.
  bool collapse(std::uint32_t moving, std::uint32_t staying) {
    const Vertex from = surface_.vertex_of[moving], to = surface_.vertex_of[staying];
    if (from == to)
      return false;
    const Half h = mesh_.halfedge(from, to);
    if (h == Mesh::null_halfedge() || !CGAL::Euler::does_satisfy_link_condition(mesh_.edge(h), mesh_))
      return false;
    if (mesh_.is_border(from)) // the border keeps its course
      return false;
    for (const Half around : mesh_.halfedges_around_target(mesh_.opposite(h))) {
      if (mesh_.is_border(around))
        continue;
      const Vertex a = mesh_.target(mesh_.next(around)), b = mesh_.source(around);
      if (a != to && b != to &&
          !faces_outwards(point_of(mesh_.point(to)), point_of(mesh_.point(a)), point_of(mesh_.point(b)),
                          surface_.normal_of[to] + surface_.normal_of[a] + surface_.normal_of[b]))
        return false;
    }
    return CGAL::Euler::collapse_edge(mesh_.edge(h), mesh_) == to;
  }

  Working_surface& surface_;
  Mesh& mesh_;
  std::vector<Chain>& chains_;
  double tolerance_;
  std::map<std::pair<std::size_t, std::size_t>, double> cost_; ///< of a chain's point, if it was looked at
  std::set<std::tuple<double, std::size_t, std::size_t>> queue_;
  std::set<std::array<std::uint32_t, 2>> segments_; ///< of all chains
};

/// Model of CGAL's concept StopPredicate.
struct At_most {
  std::size_t number_of_faces;
  template <class Cost> bool operator()(const Cost&, const auto& profile, std::size_t, std::size_t) const {
    return profile.surface_mesh().number_of_faces() <= number_of_faces;
  }
};

/// A filter of placements: refuses those that turn a triangle away from the surface.
struct Keeps_facing_outwards {
  Normal_of normal_of;

  template <class P>
  boost::optional<typename P::Point> operator()(const P& profile, boost::optional<typename P::Point> placed) const {
    if (!placed)
      return placed;
    const Point at = point_of(*placed);
    const Vector normal = normal_of[profile.v0()] + normal_of[profile.v1()];
    const double length = norm(normal);
    // the triangles on both sides of the edge come first, and vanish
    const auto& triangles = profile.triangles();
    const std::size_t vanishing = (profile.left_face_exists() ? 1U : 0U) + (profile.right_face_exists() ? 1U : 0U);
    for (std::size_t i = vanishing; i < triangles.size(); ++i) {
      const auto& t = triangles[i]; // the second corner is the one that moves
      if (!faces_outwards(point_of(get(profile.vertex_point_map(), t.v0)), at,
                          point_of(get(profile.vertex_point_map(), t.v2)),
                          normal_of[t.v0] + normal_of[t.v2] + (length > 0 ? 1 / length : 0) * normal))
        return {};
    }
    return placed;
  }
};

/// Keeps what is known of vertices, as CGAL may remove the one of a line and move the other one to its place; and asks whether to go on.
struct Visitor : Simplification_of_surfaces::Edge_collapse_visitor_base<Mesh> {
  Visitor(const Working_surface& surface, const Collapse_request& asked)
      : normal_of(surface.normal_of), given_of(surface.given_of), faces_before(double(surface.given.corners.size())),
        request(asked) {}

  template <class P> void OnCollapsing(const P& profile, const boost::optional<typename P::Point>&) {
    constexpr std::size_t often = 1024;
    if (request.progress && ++collapses % often == 0) {
      const auto faces = double(profile.surface_mesh().number_of_faces());
      if (!request.progress(std::clamp(1 - (faces - double(request.number_of_faces)) / faces_before, 0.0, 1.0)))
        throw Cancelled();
    }
  }
  /// all is told here, as edges without length are collapsed without the call above; what is known of the removed vertex is still there.
  template <class P> void OnCollapsed(const P& profile, const Vertex& kept) {
    const Vector sum = normal_of[profile.v0()] + normal_of[profile.v1()];
    normal_of[kept] = norm(sum) > 0 ? normalized(sum) : normal_of[profile.v0()];
    given_of[kept] = std::min(given_of[profile.v0()], given_of[profile.v1()]); // not both are on lines
  }

  Normal_of normal_of;
  Given_of given_of;
  double faces_before;
  const Collapse_request& request;
  std::size_t collapses = 0;
};

/// tells which edges are segments of lines.
void mark(Working_surface& surface, const std::vector<Chain>& chains) {
  for (const Edge e : surface.mesh.edges())
    surface.is_kept[e] = false;
  for (const Chain& chain : chains)
    for (std::size_t i = 0; chain.next[i] < chain.points.size(); i = chain.next[i]) {
      const Vertex a = surface.vertex_of[chain.points[i]], b = surface.vertex_of[chain.points[chain.next[i]]];
      if (a == b) // in one place
        continue;
      const bool are_there = a != Mesh::null_vertex() && b != Mesh::null_vertex();
      const Half h = are_there ? surface.mesh.halfedge(a, b) : Mesh::null_halfedge();
      if (h == Mesh::null_halfedge())
        throw std::logic_error("a segment of a kept line is lost");
      surface.is_kept[surface.mesh.edge(h)] = true;
    }
}

void collapse_others(Working_surface& surface, const std::vector<Chain>& chains, std::size_t number_of_faces,
                     const Collapse_request& request) {
  using Placement = Simplification_of_surfaces::LindstromTurk_placement<Mesh>;
  Simplification_of_surfaces::edge_collapse(
      surface.mesh, At_most{number_of_faces},
      CGAL::parameters::edge_is_constrained_map(surface.is_kept)
          .get_cost(Simplification_of_surfaces::LindstromTurk_cost<Mesh>())
          .get_placement(Simplification_of_surfaces::Constrained_placement<Placement, Is_kept>(surface.is_kept))
          .filter(Keeps_facing_outwards{surface.normal_of})
          .visitor(Visitor(surface, request)));
  surface.number_anew(chains);
}

/// the surface without what was removed, and its lines.
Collapsed numbered(const Working_surface& surface, const std::vector<Chain>& chains) {
  const Mesh& mesh = surface.mesh;
  Collapsed result;
  std::vector<std::uint32_t> number(mesh.num_vertices(), none);
  for (const Vertex v : mesh.vertices()) {
    if (mesh.is_isolated(v))
      continue;
    number[v] = std::uint32_t(result.triangles.points.size());
    result.triangles.points.push_back(point_of(mesh.point(v)));
  }
  for (const auto f : mesh.faces()) {
    const Half h = mesh.halfedge(f);
    result.triangles.corners.push_back(
        {number[mesh.source(h)], number[mesh.target(h)], number[mesh.target(mesh.next(h))]});
  }
  for (const Chain& chain : chains) {
    auto& line = result.lines.emplace_back();
    for (std::size_t i = 0; i < chain.points.size(); i = chain.next[i])
      line.push_back(number.at(surface.vertex_of[chain.points[i]]));
    for (std::size_t i = 0; chain.next[i] < chain.points.size(); i = chain.next[i])
      result.line_deviation = std::max(result.line_deviation, deviation(surface.given, chain, i, chain.next[i]));
  }
  return result;
}

} // namespace

Collapsed collapse_edges(const Triangles& triangles, const Collapse_request& request) {
  std::vector<Chain> chains = chains_of(request.kept_edges, triangles.points.size());
  Working_surface surface(triangles, request.normals, chains);
  // In turn: where triangles are as small as the segments of the lines, these cannot get longer before those get larger.
  std::size_t faces = triangles.corners.size();
  for (std::size_t target = std::max(faces / 2, request.number_of_faces);;
       target = std::max(target / 2, request.number_of_faces)) {
    Line_thinner(surface, chains, request.line_tolerance).run();
    mark(surface, chains);
    collapse_others(surface, chains, target, request);
    const std::size_t left = surface.mesh.number_of_faces();
    if (left <= request.number_of_faces || (target == request.number_of_faces && left == faces))
      return numbered(surface, chains);
    faces = left;
  }
}

} // namespace CGAL::Extremal_mesh_3
