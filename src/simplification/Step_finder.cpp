// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Step_finder.h"

#include "../differential/vector.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <tuple>

namespace CGAL::Extremal_mesh_3 {

namespace {

/// by how much k_i differs between a line of its extrema and the middle of the disk within (or beyond it at the border).
/// It is estimated from the slope of e_i at the line (a paraboloid over a disk of that area) and, as that says nothing of a large disk
/// with a rough border, from the mean of √|E_g| inside.
double difference_within(const Embedded_graph::Edge& line, const Embedded_graph::Cell& disk) {
  if (!(line.length > 0 && disk.area > 0))
    return 0;
  // The slope is that along a line of curvature: 2/π of the whole in the mean over all directions.
  const double slope = std::numbers::pi / 2 * line.slope / line.length, radius = 2 * disk.area / line.length;
  double height = slope * radius / 2; // of e_i = height·(1 − r²/radius²)
  const double mean_root = disk.weight / disk.area, other = line.extremality / line.length;
  if (other > 0) // √(1 − r²) has the mean 2/3 over the unit disk
    height = std::min(height, 9.0 / 4 * mean_root * mean_root / other);
  return 2.0 / 3 * height * radius;
}

/// the indices of a bump of the surface, such as two lemons and an extremal point, and of a saddle.
bool is_bump(const Island& island) {
  return island.sum == Indices{2, 1};
}
bool is_saddle(const Island& island) {
  return island.sum == Indices{-2, -1};
}

bool contains(const Island& island, std::uint32_t vertex) {
  return std::find(island.vertices.begin(), island.vertices.end(), vertex) != island.vertices.end();
}

Step_finder::Tree_point tree_point(const Point& p) {
  return {p[0], p[1], p[2]};
}

} // namespace

bool Step_finder::Dearer::operator()(const Candidate& a, const Candidate& b) const {
  if (a.cost != b.cost)
    return a.cost > b.cost;
  if (a.difference != b.difference)
    return a.difference > b.difference;
  if (a.operation != b.operation)
    return a.operation > b.operation;
  return a.first != b.first ? a.first > b.first : a.second > b.second;
}

Step_finder::Step_finder(const Embedded_graph& graph, Simplification_measure measure)
    : graph_(graph), measure_(measure) {
  Union_find components(graph.number_of_cells());
  std::vector<std::uint32_t> cell_at(graph.vertices().size(), Embedded_graph::none);
  for (Half_edge h = 0; h < 2 * graph.edges().size(); ++h) {
    std::uint32_t& cell = cell_at[graph.source(h)];
    if (cell == Embedded_graph::none)
      cell = graph.left_cell(h);
    components.unite(cell, graph.left_cell(h));
  }
  for (std::uint32_t c = 0; c < graph.number_of_cells(); ++c)
    component_.push_back(components.find(c));
  for (std::uint32_t v = 0; v < graph.vertices().size(); ++v)
    look_around(v);
}

void Step_finder::push(const std::optional<Candidate>& candidate) {
  if (candidate)
    queue_.push(*candidate);
}

std::optional<Candidate> Step_finder::next() {
  while (!queue_.empty()) {
    const Candidate top = queue_.top();
    queue_.pop();
    const std::optional<Candidate> now = evaluate(top);
    if (now && std::tie(now->cost, now->difference) <= std::tie(top.cost, top.difference))
      return now;
    push(now);
    if (!now && top.operation == Simplification_operation::cancel_islands) {
      // One of them is no more; the other may find another partner.
      for (const Half_edge h : {top.first, top.second})
        if (graph_.edges()[h / 2].alive)
          push(nearest_partner(graph_.source(h)));
    }
  }
  return std::nullopt;
}

std::optional<Candidate> Step_finder::evaluate(const Candidate& candidate) const {
  using Operation = Simplification_operation;
  if (!graph_.edges()[candidate.first / 2].alive)
    return std::nullopt;
  if (candidate.operation == Operation::drop_closed_line || candidate.operation == Operation::drop_border_line ||
      candidate.operation == Operation::drop_loop)
    return drop(candidate.first);
  if (candidate.second == Embedded_graph::none)
    return pair(candidate.first);
  if (!graph_.edges()[candidate.second / 2].alive)
    return std::nullopt;
  if (candidate.operation == Operation::cancel_islands)
    return islands(graph_.source(candidate.first), graph_.source(candidate.second));
  return triple(candidate.first, candidate.second);
}

void Step_finder::look_around(std::uint32_t vertex) {
  if (!graph_.vertices()[vertex].alive)
    return;
  look_for_island(vertex, true);
  const std::vector<Half_edge> star = graph_.star(vertex);
  for (const Half_edge h : star) {
    push(pair(h));
    push(drop(h));
    push(drop(h ^ 1U));
    // three vertices, this one in the middle or at an end
    for (const Half_edge other : star)
      if (other != h)
        push(triple(h, other));
    if (const std::uint32_t middle = graph_.target(h); middle != vertex)
      for (const Half_edge other : graph_.star(middle)) {
        push(triple(h ^ 1U, other));
        push(triple(other, h ^ 1U));
      }
  }
}

void Step_finder::look_for_island(std::uint32_t vertex, bool around) {
  // The cell around an island is no disk.
  const std::vector<Half_edge> star = graph_.star(vertex);
  if (std::none_of(star.begin(), star.end(),
                   [&](Half_edge h) { return graph_.cell(graph_.left_cell(h)).euler_characteristic < 1; }))
    return;
  const std::optional<Island> island = find_island(graph_, vertex);
  if (!island)
    return;
  const std::uint32_t first = *std::min_element(island->vertices.begin(), island->vertices.end());
  if ((is_bump(*island) || is_saddle(*island)) && registered_.insert(first).second) {
    (is_bump(*island) ? bumps_ : saddles_).insert({tree_point(centre(*island)), first});
    push(nearest_partner(first));
  }
  // What lies around it in a small cell may enclose it, and be an island, too.
  constexpr std::uint32_t small = 64;
  if (around && graph_.cell(island->outer).sides <= small)
    for (const Half_edge h : graph_.sides(island->outer))
      look_for_island(graph_.source(h), false);
}

Point Step_finder::centre(const Island& island) const {
  Point sum{};
  double count = 0;
  for (const std::uint32_t v : island.vertices) {
    const Embedded_graph::Vertex& x = graph_.vertices()[v];
    if (x.kind == Vertex_kind::anchor) // it stands anywhere on its line
      continue;
    ++count;
    for (std::size_t i = 0; i < 3; ++i)
      sum[i] += x.point[i];
  }
  for (double& x : sum)
    x /= count;
  return sum;
}

/// the cheapest of the cancellations with the nearest islands of opposite indices.
std::optional<Candidate> Step_finder::nearest_partner(std::uint32_t vertex) const {
  const std::optional<Island> island = find_island(graph_, vertex);
  if (!island || !(is_bump(*island) || is_saddle(*island)))
    return std::nullopt;
  constexpr unsigned tried = 8;
  const std::uint32_t component = component_[island->outer];
  const auto could_be = [&](const Tree_value& x) {
    const Embedded_graph::Vertex& v = graph_.vertices()[x.second];
    return v.alive && component_[graph_.left_cell(v.first)] == component;
  };
  namespace index = boost::geometry::index;
  std::vector<Tree_value> nearest;
  (is_bump(*island) ? saddles_ : bumps_)
      .query(index::nearest(tree_point(centre(*island)), tried) && index::satisfies(could_be),
             std::back_inserter(nearest));
  std::optional<Candidate> best;
  for (const auto& [point, other] : nearest)
    if (const std::optional<Candidate> c = islands(vertex, other); c && (!best || Dearer()(*best, *c)))
      best = c;
  return best;
}

std::optional<Candidate> Step_finder::islands(std::uint32_t a, std::uint32_t b) const {
  if (!graph_.vertices()[a].alive || !graph_.vertices()[b].alive)
    return std::nullopt;
  const std::optional<Island> x = find_island(graph_, a), y = find_island(graph_, b);
  if (!x || !y || contains(*x, b) || contains(*y, a) || !(x->sum + y->sum == Indices{}) || x->sum == Indices{})
    return std::nullopt;
  // The curvatures at the two must become equal, and what changes on the way between them must be levelled: √|E_g| tells
  // how much that is.
  const auto mean_root = [&](const Island& island) {
    const Embedded_graph::Cell& cell = graph_.cell(island.outer);
    return cell.area > 0 ? cell.weight / cell.area : 0;
  };
  const double slope = std::max(mean_root(*x), mean_root(*y));
  double least = std::numeric_limits<double>::infinity();
  for (const std::uint32_t u : x->vertices)
    for (const std::uint32_t w : y->vertices) {
      const Embedded_graph::Vertex &p = graph_.vertices()[u], &q = graph_.vertices()[w];
      if (p.kind != Vertex_kind::anchor && q.kind != Vertex_kind::anchor)
        least = std::min(least,
                         std::max({std::abs(p.k1 - q.k1), std::abs(p.k2 - q.k2), slope * distance(p.point, q.point)}));
    }
  double longest = 0;
  for (const Island* island : {&*x, &*y})
    for (const std::uint32_t v : island->vertices)
      longest = std::max(longest, life_time(v));
  return priced({Simplification_operation::cancel_islands, 0, least, graph_.vertices()[std::min(a, b)].first,
                 graph_.vertices()[std::max(a, b)].first},
                longest);
}

Candidate Step_finder::priced(Candidate step, double life_time) const {
  step.cost = measure_ == Simplification_measure::life_time ? life_time : step.difference;
  return step;
}

/// by how much k_j, or k1 − k2 where that is less, must change along an edge to take its ends together.
double Step_finder::difference_along(std::uint32_t edge) const {
  const Embedded_graph::Edge& e = graph_.edges()[edge];
  const auto is_umbilic = [&](Half_edge h) { return graph_.vertices()[graph_.source(h)].half_turns != 0; };
  return is_umbilic(2 * edge) || is_umbilic(2 * edge + 1) ? std::min(e.difference, e.split) : e.difference;
}

/// no branch of the vertex is a crest line that must stay.
bool Step_finder::all_free(std::uint32_t vertex) const {
  const std::vector<Half_edge> star = graph_.star(vertex);
  return std::none_of(star.begin(), star.end(), [&](Half_edge h) { return graph_.edges()[h / 2].kept; });
}

std::optional<Candidate> Step_finder::pair(Half_edge h) const {
  using Operation = Simplification_operation;
  h &= ~1U;
  const std::uint32_t u = graph_.source(h), w = graph_.target(h);
  const Embedded_graph::Vertex &x = graph_.vertices()[u], &y = graph_.vertices()[w];
  if (u == w || x.frozen || y.frozen)
    return std::nullopt;
  const Indices a = indices(x), b = indices(y);
  if (!(a + b).is_empty_or_generic())
    return std::nullopt;
  Candidate c{Operation::merge_vertices, 0, difference_along(h / 2), h, Embedded_graph::none};
  const bool generic = x.kind != Vertex_kind::non_generic && y.kind != Vertex_kind::non_generic;
  if (generic && a + b == Indices{})
    c.operation = a.half_turns == 0 ? Operation::cancel_extremal_points : Operation::cancel_umbilics;
  if (c.operation == Operation::cancel_extremal_points) {
    // The line that h is part of stays; those of the other family that cross it at its ends do not.
    for (const std::uint32_t v : {u, w})
      for (const Half_edge branch : graph_.star(v))
        if (graph_.family(branch) != graph_.family(h) && graph_.edges()[branch / 2].kept)
          return std::nullopt;
  } else if (!all_free(u) || !all_free(w)) {
    return std::nullopt;
  }
  // Of two that are merged one stays, at its place: that which lives longer, if that counts.
  if (measure_ == Simplification_measure::life_time && x.life_time < y.life_time)
    c.first ^= 1U;
  return priced(c, a + b == Indices{} ? std::max(x.life_time, y.life_time) : std::min(x.life_time, y.life_time));
}

std::optional<Candidate> Step_finder::triple(Half_edge first, Half_edge second) const {
  const std::uint32_t middle = graph_.source(first), u = graph_.target(first), w = graph_.target(second);
  if (graph_.source(second) != middle || u == middle || w == middle || u == w || first > second)
    return std::nullopt;
  const Embedded_graph::Vertex &x = graph_.vertices()[u], &m = graph_.vertices()[middle], &y = graph_.vertices()[w];
  if (x.frozen || m.frozen || y.frozen)
    return std::nullopt;
  const Indices a = indices(x), b = indices(m), c = indices(y);
  if ((a + b).is_empty_or_generic() || (b + c).is_empty_or_generic() || !(a + b + c).is_empty_or_generic())
    return std::nullopt;
  if (!all_free(u) || !all_free(middle) || !all_free(w))
    return std::nullopt;
  std::array<double, 3> life_times{x.life_time, m.life_time, y.life_time};
  std::sort(life_times.begin(), life_times.end());
  return priced({Simplification_operation::merge_vertices, 0,
                 std::max(difference_along(first / 2), difference_along(second / 2)), first, second},
                a + b + c == Indices{} ? life_times[2] : life_times[1]);
}

std::optional<Candidate> Step_finder::drop(Half_edge h) const {
  using Operation = Simplification_operation;
  const Embedded_graph::Edge& e = graph_.edges()[h / 2];
  const Embedded_graph::Cell& inside = graph_.cell(graph_.left_cell(h));
  if (e.kept || !inside.is_disk_with_one_side())
    return std::nullopt;
  const std::uint32_t u = graph_.source(h), w = graph_.target(h);
  Candidate c{Operation::drop_closed_line, 0, difference_within(e, inside), h, Embedded_graph::none};
  if (graph_.vertices()[u].kind == Vertex_kind::boundary && graph_.vertices()[w].kind == Vertex_kind::boundary)
    c.operation = Operation::drop_border_line;
  else if (inside.touches_border || graph_.vertices()[u].frozen)
    return std::nullopt;
  else if (graph_.vertices()[u].kind != Vertex_kind::anchor) {
    if (graph_.vertices()[u].degree <= 2 || !indices(graph_.vertices()[u]).is_empty_or_generic() || !all_free(u))
      return std::nullopt;
    c.operation = Operation::drop_loop;
  }
  return priced(c, e.life_time);
}

} // namespace CGAL::Extremal_mesh_3
