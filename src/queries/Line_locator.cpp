// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The cell that holds a point, from the graph alone: the straight way from the point to the nearest point of the lines
// crosses no other line, so the point is in the cell on that side of it. After a simplification lines can run along the
// same points, beside each other, and back and forth. Then each of them tells a cell, and all but one of these are
// between two of the lines.
#include <CGAL/Extremal_mesh_3/Line_locator.h>

#include "../cgal/Box_tree.h"
#include "../differential/vector.h"
#include "require.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

Bounding_box box_around(const Point& a, const Point& b) {
  Bounding_box box;
  for (std::size_t i = 0; i < 3; ++i)
    std::tie(box.low[i], box.high[i]) = std::minmax({a[i], b[i]});
  return box;
}

/// the parameter, from 0 to 1, of the point of a segment that is nearest to p.
double nearest_parameter(const Point& p, const Point& a, const Point& b) {
  const Vector ab = b - a;
  const double length2 = dot(ab, ab);
  return length2 > 0 ? std::clamp(dot(p - a, ab) / length2, 0.0, 1.0) : 0;
}

/// v of length 1, or 0 if it is 0.
Vector direction(const Vector& v) {
  const double length = norm(v);
  return length > 0 ? (1 / length) * v : Vector{};
}

/// Where a point is, seen from a line beside it, or from a vertex.
struct Beside {
  std::uint32_t here = 0;            ///< the cell on its own side of the line
  std::vector<std::uint32_t> beyond; ///< the cells on the other side; of a vertex those beside that one
};

} // namespace

struct Line_locator::Data {
  struct Segment {
    std::uint32_t edge, index;
  };

  explicit Data(Extremal_mesh m)
      : mesh(std::move(m)), segments(all_segments(mesh)), line_tree(boxes_of_segments()),
        vertex_tree(boxes_of_vertices()) {}

  static std::vector<Segment> all_segments(const Extremal_mesh& mesh);
  std::vector<Bounding_box> boxes_of_segments() const;
  std::vector<Bounding_box> boxes_of_vertices() const;

  Line_point point_of(std::uint32_t s, const Point& p) const;
  Vector normal_at(const Line_point& q) const;
  std::vector<Line_point> nearest(const Point& p, const std::optional<Vector>& normal) const;
  std::optional<std::uint32_t> vertex_at(const Line_point& q) const;
  Beside in_star(const Point& p, std::uint32_t v) const;
  std::optional<Beside> beside(const Point& p, const Line_point& q) const;
  std::vector<Beside> all_beside(const Point& p, const std::vector<Line_point>& nearest) const;

  Extremal_mesh mesh;
  std::vector<Segment> segments;
  Box_tree line_tree, vertex_tree;
};

std::vector<Line_locator::Data::Segment> Line_locator::Data::all_segments(const Extremal_mesh& mesh) {
  std::vector<Segment> segments;
  for (std::uint32_t e = 0; e < mesh.number_of_edges(); ++e) {
    const auto& line = mesh.edge(e).polyline;
    if (!std::all_of(line.begin(), line.end(), is_finite))
      throw std::invalid_argument(fmt::format("edge {} has a coordinate that is not finite", e));
    for (std::uint32_t i = 0; i + 1 < line.size(); ++i)
      segments.push_back({e, i});
  }
  require_number(segments.size());
  return segments;
}

std::vector<Bounding_box> Line_locator::Data::boxes_of_segments() const {
  std::vector<Bounding_box> boxes;
  for (const Segment& s : segments)
    boxes.push_back(box_around(mesh.edge(s.edge).polyline[s.index], mesh.edge(s.edge).polyline[s.index + 1]));
  return boxes;
}

std::vector<Bounding_box> Line_locator::Data::boxes_of_vertices() const {
  std::vector<Bounding_box> boxes;
  for (std::size_t v = 0; v < mesh.number_of_vertices(); ++v) {
    if (!is_finite(mesh.vertex(v).point))
      throw std::invalid_argument(fmt::format("vertex {} has a coordinate that is not finite", v));
    boxes.push_back({mesh.vertex(v).point, mesh.vertex(v).point});
  }
  return boxes;
}

Line_point Line_locator::Data::point_of(std::uint32_t s, const Point& p) const {
  const auto& line = mesh.edge(segments[s].edge).polyline;
  const std::size_t i = segments[s].index;
  const double t = nearest_parameter(p, line[i], line[i + 1]);
  // At the ends the very points, so that all lines that meet there are at the same distance.
  const Point q = t == 0 ? line[i] : t == 1 ? line[i + 1] : line[i] + t * (line[i + 1] - line[i]);
  return {segments[s].edge, i, t, q, distance(p, q)};
}

Vector Line_locator::Data::normal_at(const Line_point& q) const {
  const auto& normals = mesh.edge(q.edge).normals;
  return direction((1 - q.t) * normals[q.segment] + q.t * normals[q.segment + 1]);
}

/// the nearest points of all lines that come as near as any, up to rounding: the first nearest point first, then by edges and
/// segments.
std::vector<Line_point> Line_locator::Data::nearest(const Point& p, const std::optional<Vector>& normal) const {
  constexpr double rounding = 1e-9; // lines along the same points, from one end or the other, differ by less
  constexpr double cos_120_degrees = -0.5;
  std::vector<std::pair<std::uint32_t, Line_point>> found;
  double nearest = infinity;
  const auto bound = [&] { return nearest * (1 + rounding); };
  line_tree.visit_near(p, [&](std::uint32_t s) {
    const Line_point q = point_of(s, p);
    if (q.distance <= bound() && !(normal && dot(normal_at(q), *normal) < cos_120_degrees)) {
      nearest = std::min(nearest, q.distance);
      found.emplace_back(s, q);
    }
    return bound() * bound() * (1 + rounding);
  });
  std::erase_if(found, [&](const auto& each) { return each.second.distance > bound(); });
  std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Line_point> points;
  points.reserve(found.size());
  for (const auto& [s, q] : found)
    points.push_back(q);
  const auto first = std::min_element(points.begin(), points.end(),
                                      [](const auto& a, const auto& b) { return a.distance < b.distance; });
  if (first != points.end())
    std::rotate(points.begin(), first, first + 1);
  return points;
}

/// the vertex in which a point of a line is.
std::optional<std::uint32_t> Line_locator::Data::vertex_at(const Line_point& q) const {
  const Extremal_mesh_edge& edge = mesh.edge(q.edge);
  if (q.segment == 0 && q.t == 0)
    return edge.source;
  if (q.segment + 2 == edge.polyline.size() && q.t == 1)
    return edge.target;
  return std::nullopt;
}

/// for a point whose nearest point is a vertex: beside the branch that leaves in the most similar direction.
Beside Line_locator::Data::in_star(const Point& p, std::uint32_t v) const {
  const Extremal_mesh_vertex& vertex = mesh.vertex(v);
  const auto& star = vertex.star;
  const Vector x = any_orthogonal(vertex.normal), y = cross(vertex.normal, x);
  const auto angle = [&](const Point& q) { return std::atan2(dot(q - vertex.point, y), dot(q - vertex.point, x)); };
  const double angle_of_p = angle(p);
  std::vector<double> turns; // from each branch to p
  for (const Half_edge h : star) {
    const auto& line = mesh.edge(h / 2).polyline;
    turns.push_back(
        std::remainder(angle_of_p - angle(h % 2 == 0 ? line[1] : line[line.size() - 2]), 2 * std::numbers::pi));
  }
  const auto nearest =
      std::min_element(turns.begin(), turns.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
  const double turn = *nearest;
  // Of branches that leave along the same points it is the last one on that side.
  auto i = std::size_t(nearest - turns.begin());
  const std::size_t n = star.size(), step = turn >= 0 ? 1 : n - 1;
  for (std::size_t k = 1; k < n && turns[(i + step) % n] == turn; ++k)
    i = (i + step) % n;
  const Half_edge this_side = turn >= 0 ? star[i] : star[i] ^ 1U;
  const Half_edge other_side = turn >= 0 ? star[(i + step) % n] ^ 1U : star[(i + step) % n];
  return {mesh.left_cell(this_side), {mesh.left_cell(this_side ^ 1U), mesh.left_cell(other_side ^ 1U)}};
}

/// nothing if the line turns back there: all around is on one side of it, and only its course elsewhere tells on which.
std::optional<Beside> Line_locator::Data::beside(const Point& p, const Line_point& q) const {
  const Extremal_mesh_edge& edge = mesh.edge(q.edge);
  const auto& line = edge.polyline;
  Vector tangent = direction(line[q.segment + 1] - line[q.segment]);
  // At a corner the sides are told by the bisector; where the line is straight it makes no difference.
  if (q.t == 0 && q.segment > 0)
    tangent = tangent + direction(line[q.segment] - line[q.segment - 1]);
  if (q.t == 1 && q.segment + 2 < line.size())
    tangent = tangent + direction(line[q.segment + 2] - line[q.segment + 1]);
  constexpr double turns_back = 1e-6; // far less than at any corner of a line on a surface, far more than rounding
  if (norm(tangent) < turns_back)
    return std::nullopt;
  const bool left = dot(cross(normal_at(q), tangent), p - q.point) >= 0;
  return left ? Beside{edge.left_cell, {edge.right_cell}} : Beside{edge.right_cell, {edge.left_cell}};
}

/// what each vertex, and each line as often as it comes along, tells.
std::vector<Beside> Line_locator::Data::all_beside(const Point& p, const std::vector<Line_point>& nearest) const {
  std::vector<Beside> all;
  std::set<std::uint32_t> vertices;
  std::set<std::pair<std::uint32_t, std::size_t>> places; // the end of a segment is the start of the next
  for (const Line_point& q : nearest) {
    if (const auto v = vertex_at(q)) {
      if (vertices.insert(*v).second && !mesh.vertex(*v).star.empty())
        all.push_back(in_star(p, *v));
    } else if (places.emplace(q.edge, 2 * q.segment + (q.t == 0 ? 0 : q.t == 1 ? 2 : 1)).second) {
      if (const auto cells = beside(p, q))
        all.push_back(*cells);
    }
  }
  return all;
}

Line_locator::Line_locator(Extremal_mesh mesh) : data_(std::make_unique<Data>(std::move(mesh))) {}
Line_locator::~Line_locator() = default;
Line_locator::Line_locator(Line_locator&&) noexcept = default;
Line_locator& Line_locator::operator=(Line_locator&&) noexcept = default;

std::optional<Nearest_vertex> Line_locator::nearest_vertex(const Point& p) const {
  require_finite(p);
  std::optional<Nearest_vertex> nearest;
  data_->vertex_tree.visit_near(p, [&](std::uint32_t v) {
    const Nearest_vertex here{v, distance(p, data_->mesh.vertex(v).point)};
    if (!nearest || std::pair(here.distance, v) < std::pair(nearest->distance, nearest->vertex))
      nearest = here;
    return nearest->distance * nearest->distance * (1 + 1e-12); // as the tree's own distances are rounded, too
  });
  return nearest;
}

std::optional<Line_point> Line_locator::nearest_line(const Point& p) const {
  require_finite(p);
  const std::vector<Line_point> nearest = data_->nearest(p, std::nullopt);
  if (nearest.empty())
    return std::nullopt;
  return nearest.front();
}

std::optional<std::uint32_t> Line_locator::cell_at(const Point& p, const std::optional<Vector>& normal) const {
  require_finite(p);
  std::optional<Vector> unit_normal;
  if (normal) {
    require_finite(*normal);
    unit_normal = direction(*normal);
  }
  const std::vector<Line_point> nearest = data_->nearest(p, unit_normal);
  if (nearest.empty())
    return data_->mesh.number_of_cells() == 1 ? std::optional<std::uint32_t>(0) : std::nullopt;
  // A cell between two lines is told by one and lies beyond the other.
  const std::vector<Beside> all = data_->all_beside(p, nearest);
  if (all.empty())
    return std::nullopt; // all lines turn back there, which those of a surface do not
  std::map<std::uint32_t, int> votes;
  for (const Beside& cells : all) {
    ++votes[cells.here];
    for (const std::uint32_t c : cells.beyond)
      --votes[c];
  }
  std::vector<std::uint32_t> best;
  for (const Beside& cells : all)
    if (best.empty() || votes[cells.here] > votes[best.front()])
      best = {cells.here};
    else if (votes[cells.here] == votes[best.front()] && cells.here != best.front())
      best.push_back(cells.here);
  return best.size() == 1 ? std::optional(best.front()) : std::nullopt;
}

} // namespace CGAL::Extremal_mesh_3
