// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The points of lines inside cells. Each segment is looked at once, from the end with the smaller coordinates, so that the
// cells on both sides, and both directions, have the same points.
#include "Arrangement.h"

#include "../cells/parallel.h"
#include "../differential/vector.h"

#include <algorithm>
#include <limits>
#include <tuple>

namespace CGAL::Extremal_mesh_3 {

Points_between Arrangement::points_between(std::uint32_t crossing, std::uint32_t side) const {
  const std::uint32_t end = 2 * crossing + side;
  const auto count = [&](std::uint32_t i) { return first_line_point_[i + 1] - first_line_point_[i]; };
  if (count(end) > 0)
    return {first_line_point_[end], count(end), false};
  const std::uint32_t other = other_end(end);
  if (other != no_id && count(other) > 0)
    return {first_line_point_[other + 1] - 1, count(other), true};
  return {};
}

Line_place Arrangement::at_node(std::uint32_t id, int family, const Line_place& beside) const {
  const Node& node = nodes_[id];
  const Refined_cell& cell = complex_.cells()[node.cell];
  const Sample& s = complex_.samples()[cell.center];
  const Principal_quantities q = principal_quantities(s.shape);
  Line_place place{s.p, s.shape.n, q.k1, q.k2, beside.derivative, beside.extremality, {}};
  if (cell.content == Content::extremal_point) {
    place.derivative = node.derivative[std::size_t(family - 1)];
    place.extremality = 0;
  }
  return place;
}

/// the other end of the segment that starts at an end, if that is a crossing, too.
std::uint32_t Arrangement::other_end(std::uint32_t end) const {
  const Segment_end next = crossings_[end / 2].next[end % 2];
  if (next.node || next.id == no_id)
    return no_id;
  const auto& edges = complex_.edges();
  const std::uint32_t cell = edges[crossings_[end / 2].edge].cell[end % 2];
  const auto& beside = edges[crossings_[next.id].edge].cell;
  return 2 * next.id + (beside[end % 2] == cell ? end % 2 : 1 - end % 2);
}

/// the place on the line behind an end, as one comes out of the segment there.
std::optional<Line_place> Arrangement::behind(std::uint32_t end) const {
  const std::uint32_t outside = end ^ 1U;
  const Segment_end next = crossings_[end / 2].next[outside % 2];
  if (next.id == no_id)
    return std::nullopt;
  if (!next.node)
    return crossings_[next.id];
  if (complex_.cells()[nodes_[next.id].cell].content != Content::extremal_point)
    return std::nullopt;
  return at_node(next.id, crossings_[end / 2].family, crossings_[end / 2]);
}

/// the segment that starts at an end, but for the samples.
Segment Arrangement::segment_from(std::uint32_t end) const {
  const Crossing& from = crossings_[end / 2];
  const Refined_edge& edge = complex_.edges()[from.edge];
  const Segment_end next = from.next[end % 2];
  Segment segment;
  segment.family = from.family;
  segment.ends[0].at = from;
  segment.ends[0].behind = behind(end);
  // Going into the cell on the left of a → b, the part of the edge towards a is on the left. The first part has a's sign.
  const bool other_sign = (from.ordinal + end % 2) % 2 != 0;
  segment.sign_on_left = complex_.samples()[edge.a].positive != other_sign ? 1 : -1;
  const Refined_cell& cell = complex_.cells()[edge.cell[end % 2]];
  segment.may_bend =
      !complex_.surface().interpolates() && !cell.degenerate && cell.content != Content::unresolved && from.placed;
  segment.certain = cell.certain;
  if (next.node) {
    const Node& node = nodes_[next.id];
    segment.ends[1].at = at_node(next.id, from.family, from);
    if (cell.content == Content::extremal_point) {
      // The line goes on on the other side.
      for (std::size_t i = 0; i < node.crossings.size(); ++i)
        if (node.crossings[i] == end / 2 && node.sides[i] == end % 2)
          segment.ends[1].behind = crossings_[node.crossings[(i + node.crossings.size() / 2) % node.crossings.size()]];
    } else if (cell.content == Content::umbilic) {
      segment.ends[1].umbilic = true;
      segment.ends[1].at.derivative = std::numeric_limits<double>::quiet_NaN();
    }
  } else {
    segment.ends[1].at = crossings_[next.id];
    segment.ends[1].behind = behind(other_end(end));
    segment.may_bend = segment.may_bend && crossings_[next.id].placed;
  }
  return segment;
}

/// the greatest distance between corners of a cell.
double Arrangement::size_of(std::uint32_t cell) const {
  const std::vector<Half_edge>& sides = complex_.cells()[cell].sides;
  const auto corner = [&](std::size_t i) -> const Point& { return complex_.samples()[complex_.source(sides[i])].p; };
  double size = 0;
  for (std::size_t i = 0; i < sides.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      size = std::max(size, distance(corner(i), corner(j)));
  return size;
}

Sample Arrangement::sample_of(const Crossing& crossing) const {
  const Refined_edge& edge = complex_.edges()[crossing.edge];
  const Sample *a = &complex_.samples()[edge.a], *b = &complex_.samples()[edge.b];
  if (b->p < a->p)
    std::swap(a, b);
  return sample_between(complex_.surface(), *a, *b, crossing.t, Surface::to_place);
}

void Arrangement::refine_segments(const Extraction_options& options) {
  const Surface& surface = complex_.surface();
  const double tolerance = surface.interpolates() ? 0 : options.line_tolerance;
  Thread_pool pool(options.threads);
  pool.for_each(nodes_.size(), 16, [&](std::size_t i) {
    Node& node = nodes_[i];
    const Refined_cell& cell = complex_.cells()[node.cell];
    const Sample& s = complex_.samples()[cell.center];
    const double step = 1e-3 * distance(s.p, crossings_[node.crossings[0]].p);
    if (cell.content == Content::extremal_point)
      for (int family = 1; family <= 2; ++family)
        node.derivative[std::size_t(family - 1)] = line_place(surface, s, family, step).derivative;
  });

  // Each segment from one of its ends.
  std::vector<std::uint32_t> ends;
  for (std::uint32_t end = 0; end < 2 * crossings_.size(); ++end) {
    const Crossing& c = crossings_[end / 2];
    if (c.next[end % 2].id == no_id) // the border of the surface
      continue;
    const std::uint32_t other = other_end(end);
    if (other == no_id || std::tie(c.p, end) < std::tie(crossings_[other / 2].p, other))
      ends.push_back(end);
  }
  std::vector<Segment_points> found(ends.size());
  pool.for_each(ends.size(), 32, [&](std::size_t i) {
    Segment segment = segment_from(ends[i]);
    if (!may_have_points(segment, tolerance))
      return;
    segment.reach = size_of(complex_.edges()[crossings_[ends[i] / 2].edge].cell[ends[i] % 2]);
    if (surface.interpolates()) {
      const Crossing& from = crossings_[ends[i] / 2];
      const Segment_end next = from.next[ends[i] % 2];
      segment.ends[0].sample = sample_of(from);
      segment.ends[1].sample = next.node ? complex_.samples()[complex_.cells()[nodes_[next.id].cell].center]
                                         : sample_of(crossings_[next.id]);
    }
    found[i] = refine_segment(surface, segment, tolerance);
  });

  number_of_segments_ = ends.size();
  first_line_point_.assign(2 * crossings_.size() + 1, 0);
  for (std::size_t i = 0; i < ends.size(); ++i) {
    number_of_straight_segments_ += found[i].straight;
    first_line_point_[ends[i] + 1] = std::uint32_t(found[i].points.size());
    line_points_.insert(line_points_.end(), found[i].points.begin(), found[i].points.end());
  }
  for (std::size_t i = 1; i < first_line_point_.size(); ++i)
    first_line_point_[i] += first_line_point_[i - 1];
}

} // namespace CGAL::Extremal_mesh_3
