// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Line_tracer.h"

#include "../differential/vector.h"

#include <algorithm>
#include <cmath>

namespace CGAL::Extremal_mesh_3 {

Line_tracer::Line_tracer(const Arrangement& arrangement, Regions& regions)
    : arrangement_(arrangement), regions_(regions), used_(arrangement.crossings().size(), 0),
      border_vertex_(arrangement.crossings().size(), no_id) {
  for (const Extremal_mesh_cell& cell : regions.cells())
    area_ += cell.area;
  make_vertices();
  trace_from_nodes();
  trace_from_border();
  trace_closed_lines();
  walk_around_cells();
}

Extremal_mesh_vertex Line_tracer::vertex_of(const Node& node) const {
  const Refined_cell& cell = arrangement_.complex().cells()[node.cell];
  const Sample& s = arrangement_.complex().samples()[cell.center];
  const Principal_quantities q = principal_quantities(s.shape);
  Extremal_mesh_vertex v;
  v.point = s.p;
  v.normal = s.shape.n;
  v.k1 = q.k1;
  v.k2 = q.k2;
  v.t1 = q.t1;
  v.t2 = q.t2;
  v.umbilic_index = cell.winding_Q / 2.0;
  v.field_index = -cell.winding_P;
  v.star.assign(node.crossings.size(), no_id);
  switch (cell.content) {
  case Content::extremal_point:
    v.kind = Vertex_kind::extremal_point;
    for (int family = 1; family <= 2; ++family)
      v.extrema[std::size_t(family - 1)] = line_type(q.k1, q.k2, family, node.derivative[std::size_t(family - 1)]);
    break;
  case Content::umbilic: {
    v.kind = Vertex_kind::umbilic;
    v.ridges = int(node.crossings.size() / 2);
    const Umbilic_class c = classify_umbilic(s.shape.A1, s.shape.A3);
    // In a cell taken as it was at the finest level only the index is sure.
    v.umbilic_type = cell.winding_Q < 0 ? Umbilic_type::star : c.index > 0 ? c.type : Umbilic_type::lemon;
    break;
  }
  default:
    v.kind = Vertex_kind::non_generic;
  }
  return v;
}

void Line_tracer::make_vertices() {
  for (const Node& node : arrangement_.nodes())
    vertices.push_back(vertex_of(node));
  const auto& crossings = arrangement_.crossings();
  for (std::uint32_t c = 0; c < crossings.size(); ++c) {
    const Refined_edge& e = arrangement_.complex().edges()[crossings[c].edge];
    if (e.cell[0] != no_id && e.cell[1] != no_id)
      continue;
    Extremal_mesh_vertex v;
    v.kind = Vertex_kind::boundary;
    v.point = crossings[c].p;
    v.normal = crossings[c].n;
    v.k1 = crossings[c].k1;
    v.k2 = crossings[c].k2;
    v.star = {no_id};
    border_vertex_[c] = std::uint32_t(vertices.size());
    vertices.push_back(v);
  }
}

/// goes on until the line ends: at a node (the step that leads into its cell is returned), at the border of the
/// surface, or where it began.
Line_tracer::Step Line_tracer::follow(Step step, std::vector<Step>& met) const {
  const auto& crossings = arrangement_.crossings();
  const auto& edges_of_cells = arrangement_.complex().edges();
  const std::uint32_t start = step.crossing;
  for (;;) {
    met.push_back(step);
    const std::uint32_t cell = edges_of_cells[crossings[step.crossing].edge].cell[step.side];
    if (cell == no_id)
      return step;
    const Segment_end next = crossings[step.crossing].next[step.side];
    if (next.node)
      return step;
    const std::uint32_t side_here = edges_of_cells[crossings[next.id].edge].cell[0] == cell ? 0 : 1;
    step = {next.id, 1 - side_here};
    if (next.id == start)
      return step;
  }
}

void Line_tracer::trace_from_nodes() {
  for (std::uint32_t v = 0; v < arrangement_.nodes().size(); ++v) {
    const Node& node = arrangement_.nodes()[v];
    for (std::size_t i = 0; i < node.crossings.size(); ++i) {
      if (vertices[v].star[i] != no_id)
        continue; // an edge from elsewhere came in here
      const Step first{node.crossings[i], 1U - node.sides[i]};
      std::vector<Step> met;
      const Step last = follow(first, met);
      add_edge(v, i, met, last);
    }
  }
}

void Line_tracer::trace_from_border() {
  const auto& crossings = arrangement_.crossings();
  for (std::uint32_t c = 0; c < crossings.size(); ++c) {
    if (border_vertex_[c] == no_id || used_[c])
      continue;
    const Step first{c, arrangement_.complex().edges()[crossings[c].edge].cell[0] != no_id ? 0U : 1U};
    std::vector<Step> met;
    const Step last = follow(first, met);
    add_edge(border_vertex_[c], 0, met, last);
  }
}

void Line_tracer::trace_closed_lines() {
  const auto& crossings = arrangement_.crossings();
  for (std::uint32_t c = 0; c < crossings.size(); ++c) {
    if (used_[c])
      continue;
    const Step first{c, 0};
    std::vector<Step> met;
    const Step last = follow(first, met);
    met.push_back(first);
    Extremal_mesh_vertex anchor;
    anchor.kind = Vertex_kind::anchor;
    anchor.point = crossings[c].p;
    anchor.normal = crossings[c].n;
    anchor.k1 = crossings[c].k1;
    anchor.k2 = crossings[c].k2;
    anchor.star = {no_id, no_id};
    vertices.push_back(anchor);
    add_edge(std::uint32_t(vertices.size() - 1), 0, met, last);
  }
}

namespace {

/// Where the type changes without a point that was found for it, as in cells that stayed unresolved, it does so at the point
/// between the two segments.
void add_type_changes(Extremal_mesh_edge& edge, const std::vector<double>& derivative) {
  const std::vector<double>& k = edge.family == 1 ? edge.k1 : edge.k2;
  std::vector<Type_change> all;
  std::size_t found = 0;
  for (std::uint32_t i = 1; i + 1 < edge.polyline.size(); ++i) {
    if (found < edge.type_changes.size() && edge.type_changes[found].point == i) {
      all.push_back(edge.type_changes[found++]);
      continue;
    }
    const Line_type before = edge.segment_types[i - 1], after = edge.segment_types[i];
    if (before == after)
      continue;
    const auto largest = [](Line_type type) {
      return type == Line_type::max_largest || type == Line_type::min_largest;
    };
    const bool turns = (derivative[i - 1] + derivative[i] < 0) != (derivative[i] + derivative[i + 1] < 0);
    const bool flat = (k[i - 1] + k[i] > 0) != (k[i] + k[i + 1] > 0);
    all.push_back({i, largest(before) != largest(after) ? Type_change_kind::equal_curvatures
                      : flat && !turns                  ? Type_change_kind::parabolic_point
                                                        : Type_change_kind::turning_point});
  }
  edge.type_changes = std::move(all);
}

} // namespace

void Line_tracer::add_edge(std::uint32_t source, std::size_t source_slot, const std::vector<Step>& met, Step last) {
  const auto& crossings = arrangement_.crossings();
  const Step first = met.front();
  const std::uint32_t id = std::uint32_t(edges.size());
  Extremal_mesh_edge edge;
  edge.id = id;
  edge.source = source;
  edge.family = crossings[first.crossing].family;

  // Where it ends.
  const Segment_end end = crossings[last.crossing].next[last.side];
  if (vertices[source].kind == Vertex_kind::anchor) {
    edge.target = source;
    vertices[source].star[1] = 2 * id + 1;
  } else if (border_vertex_[last.crossing] != no_id && !end.node) {
    edge.target = border_vertex_[last.crossing];
    vertices[edge.target].star[0] = 2 * id + 1;
  } else {
    edge.target = end.id;
    const Node& node = arrangement_.nodes()[end.id];
    for (std::size_t i = 0; i < node.crossings.size(); ++i)
      if (node.crossings[i] == last.crossing && node.sides[i] == last.side)
        vertices[end.id].star[i] = 2 * id + 1;
  }
  vertices[source].star[source_slot] = 2 * id;

  // The cells beside it: going into the cell on the left of a → b, the end a is on the left.
  const Crossing& c = crossings[first.crossing];
  edge.left_cell = regions_.region(c.edge, first.side == 0 ? c.ordinal : c.ordinal + 1);
  edge.right_cell = regions_.region(c.edge, first.side == 0 ? c.ordinal + 1 : c.ordinal);

  for (const Step& step : met)
    used_[step.crossing] = 1;
  std::vector<double> derivative;
  for (const Line_point& x : points_of(source, edge.target, edge.family, met)) {
    if (x.change)
      edge.type_changes.push_back({std::uint32_t(edge.polyline.size()), *x.change});
    edge.polyline.push_back(x.p);
    edge.normals.push_back(x.n);
    edge.k1.push_back(x.k1);
    edge.k2.push_back(x.k2);
    edge.extremality.push_back(x.extremality);
    derivative.push_back(x.derivative);
  }
  measure(edge, derivative);
  add_type_changes(edge, derivative);
  edges.push_back(std::move(edge));
}

/// the points of an edge, in order.
std::vector<Line_point> Line_tracer::points_of(std::uint32_t source, std::uint32_t target, int family,
                                               const std::vector<Step>& met) const {
  std::vector<Line_point> points;
  const auto add = [&](const Line_place& place) { static_cast<Line_place&>(points.emplace_back()) = place; };
  const auto add_between = [&](const Step& step, std::uint32_t side, bool backwards) {
    const Points_between between = arrangement_.points_between(step.crossing, side);
    for (std::uint32_t i = 0; i < between.count; ++i)
      points.push_back(arrangement_.line_points()[between.id(backwards ? between.count - 1 - i : i)]);
  };
  const bool from_node = source < arrangement_.nodes().size(), to_node = target < arrangement_.nodes().size();
  if (from_node)
    add_between(met.front(), 1 - met.front().side, true);
  for (std::size_t i = 0; i < met.size(); ++i) {
    add(arrangement_.crossings()[met[i].crossing]);
    if (i + 1 < met.size() || to_node)
      add_between(met[i], met[i].side, false);
  }
  if (from_node)
    points.insert(points.begin(), Line_point{arrangement_.at_node(source, family, points.front()), std::nullopt});
  if (to_node)
    add(Line_place(arrangement_.at_node(target, family, points.back())));
  return points;
}

void Line_tracer::measure(Extremal_mesh_edge& edge, const std::vector<double>& derivative) const {
  std::array<double, 4> length_of_type{};
  for (std::size_t i = 0; i + 1 < edge.polyline.size(); ++i) {
    const double length = distance(edge.polyline[i], edge.polyline[i + 1]);
    const double k1 = (edge.k1[i] + edge.k1[i + 1]) / 2, k2 = (edge.k2[i] + edge.k2[i + 1]) / 2;
    const double d = (derivative[i] + derivative[i + 1]) / 2;
    const Line_type type = line_type(k1, k2, edge.family, d);
    edge.segment_types.push_back(type);
    length_of_type[std::size_t(type)] += length;
    edge.length += length;
    edge.strength += length * std::abs(edge.family == 1 ? k1 : k2);
    edge.sharpness += area_ * length * (std::abs(derivative[i]) + std::abs(derivative[i + 1])) / 2;
  }
  edge.type = Line_type(std::max_element(length_of_type.begin(), length_of_type.end()) - length_of_type.begin());
}

std::vector<std::uint32_t> Line_tracer::next_on_border() const {
  const Refined_complex& complex = arrangement_.complex();
  const auto& crossings = arrangement_.crossings();
  std::vector<Half_edge> leaving(complex.samples().size(), no_id); // with the surface on its left
  std::vector<std::vector<std::uint32_t>> on_edge(complex.edges().size());
  for (std::uint32_t e = 0; e < complex.edges().size(); ++e) {
    const Refined_edge& edge = complex.edges()[e];
    if (!edge.divided() && (edge.cell[0] == no_id || edge.cell[1] == no_id)) {
      const Half_edge h = 2 * e + (edge.cell[0] == no_id);
      leaving[complex.source(h)] = h;
    }
  }
  for (std::uint32_t c = 0; c < crossings.size(); ++c)
    if (border_vertex_[c] != no_id)
      on_edge[crossings[c].edge].push_back(c); // in the order from a to b
  std::vector<std::uint32_t> next(crossings.size(), no_id);
  for (std::uint32_t c = 0; c < crossings.size(); ++c) {
    if (border_vertex_[c] == no_id)
      continue;
    const std::uint32_t e = crossings[c].edge;
    Half_edge h = 2 * e + (complex.edges()[e].cell[0] == no_id);
    const auto count = on_edge[e].size();
    const std::size_t here = h % 2 == 0 ? crossings[c].ordinal : count - 1 - crossings[c].ordinal;
    if (here + 1 < count) {
      next[c] = on_edge[e][h % 2 == 0 ? here + 1 : count - 2 - here];
      continue;
    }
    do
      h = leaving[complex.target(h)];
    while (on_edge[h / 2].empty());
    next[c] = h % 2 == 0 ? on_edge[h / 2].front() : on_edge[h / 2].back();
  }
  return next;
}

void Line_tracer::walk_around_cells() {
  std::vector<std::size_t> slot(2 * edges.size());
  for (const Extremal_mesh_vertex& v : vertices)
    for (std::size_t i = 0; i < v.star.size(); ++i)
      slot[v.star[i]] = i;
  std::vector<std::uint32_t> after(vertices.size(), no_id); // the next boundary vertex along the border
  const bool has_border = std::any_of(border_vertex_.begin(), border_vertex_.end(), [](auto v) { return v != no_id; });
  if (has_border) {
    const std::vector<std::uint32_t> next = next_on_border();
    for (std::size_t c = 0; c < next.size(); ++c)
      if (next[c] != no_id)
        after[border_vertex_[c]] = border_vertex_[next[c]];
  }
  const auto next_half_edge = [&](Half_edge h) {
    const std::uint32_t v = h % 2 == 0 ? edges[h / 2].target : edges[h / 2].source;
    if (vertices[v].kind == Vertex_kind::boundary)
      return vertices[after[v]].star[0];
    // The branch clockwise of the one that came in has the same region on its left.
    const std::size_t degree = vertices[v].star.size();
    return vertices[v].star[(slot[h ^ 1U] + degree - 1) % degree];
  };
  std::vector<char> walked(2 * edges.size(), 0);
  for (Half_edge start = 0; start < 2 * edges.size(); ++start) {
    if (walked[start])
      continue;
    const Extremal_mesh_edge& e = edges[start / 2];
    auto& walks = regions_.cells()[start % 2 == 0 ? e.left_cell : e.right_cell].boundary;
    walks.emplace_back();
    for (Half_edge h = start; !walked[h]; h = next_half_edge(h)) {
      walked[h] = 1;
      walks.back().push_back(h);
    }
  }
}

} // namespace CGAL::Extremal_mesh_3
