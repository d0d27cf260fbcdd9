// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Simplifier.h"

#include "../differential/vector.h"
#include "islands.h"

#include <algorithm>
#include <cmath>
#include <numbers>

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

} // namespace

void Simplifier::apply(const Candidate& step) {
  using Operation = Simplification_operation;
  const Half_edge h = step.first;
  if (step.operation == Operation::drop_closed_line || step.operation == Operation::drop_border_line) {
    const Half_edge outside = h ^ 1U;
    if (step.operation == Operation::drop_closed_line)
      graph_.drop_closed_line(h);
    else
      graph_.drop_border_line(h);
    touch_sides(graph_.left_cell(outside));
    return;
  }
  if (step.operation == Operation::cancel_islands)
    return cancel_islands(step);
  if (step.operation == Operation::drop_loop)
    return reduce(graph_.source(h), {});
  const std::uint32_t v = graph_.source(h);
  const Contracted contracted = {step.operation == Operation::cancel_extremal_points ? graph_.family(h) : 0,
                                 step.operation == Operation::cancel_umbilics, graph_.edges()[h / 2].difference};
  graph_.contract(h);
  if (step.second != Embedded_graph::none)
    graph_.contract(step.second);
  reduce(v, contracted);
}

void Simplifier::cancel_islands(const Candidate& step) {
  const Island a = find_island(graph_, graph_.source(step.first)).value();
  const Island b = find_island(graph_, graph_.source(step.second)).value();
  graph_.remove_disk(a.vertices, a.edges, a.inner, a.outer);
  const std::uint32_t outer = graph_.root(a.outer);
  graph_.remove_disk(b.vertices, b.edges, b.inner, outer);
  touch_sides(graph_.root(outer));
}

/// what is beside a small cell that has changed.
void Simplifier::touch_sides(std::uint32_t cell) {
  constexpr std::uint32_t small = 64;
  if (graph_.cell(cell).sides <= small)
    for (const Half_edge h : graph_.sides(cell))
      touched.push_back(graph_.source(h));
}

void Simplifier::touch_ends_of_star(std::uint32_t v) {
  touched.push_back(v);
  for (const Half_edge h : graph_.star(v)) {
    touched.push_back(graph_.target(h));
    for (const Half_edge side : {h, h ^ 1U})
      if (const Embedded_graph::Cell& c = graph_.cell(graph_.left_cell(side)); c.is_disk_with_one_side())
        touched.push_back(graph_.source(c.exclusive_or));
  }
}

double Simplifier::difference(Half_edge a, Half_edge b, const Contracted& contracted) const {
  const double x = graph_.edges()[a / 2].difference, y = graph_.edges()[b / 2].difference;
  if (contracted.umbilics)
    return x + y;
  // On the line of which the contracted edge was part, k_j went up, down and up again: the way down no longer counts.
  // The lines of the other family turned away from it on both sides; they go down as far as they go up.
  return contracted.family == graph_.family(a) ? std::max({x, y, x + y - contracted.difference}) : std::max(x, y);
}

void Simplifier::reduce(std::uint32_t v, const Contracted& contracted) {
  const auto degree = [&] { return graph_.vertices()[v].degree; };
  const auto removable_loop = [&]() -> Half_edge {
    for (const Half_edge h : graph_.star(v))
      if (graph_.target(h) == v && graph_.cell(graph_.left_cell(h)).is_disk_with_one_side())
        return h;
    return Embedded_graph::none;
  };
  // A cell with two sides became a disk within a loop.
  for (Half_edge h; degree() > 2 && (h = removable_loop()) != Embedded_graph::none;) {
    touched.push_back(v);
    graph_.remove_loop(h);
  }
  const Indices sum = indices(graph_.vertices()[v]);
  const std::uint32_t wanted = std::max(sum.number_of_branches(), 2U);
  while (degree() > wanted) {
    // Which two branches go together is not determined if there are more than two of one family: the weakest do.
    Half_edge best = Embedded_graph::none;
    double least = 0;
    for (const Half_edge h : graph_.star(v)) {
      const Half_edge after = graph_.next(h);
      if (graph_.family(h) != graph_.family(after))
        continue;
      const double strength = graph_.edges()[h / 2].strength + graph_.edges()[after / 2].strength;
      if (best == Embedded_graph::none || strength < least) {
        best = h;
        least = strength;
      }
    }
    const Half_edge other = graph_.next(best);
    const Half_edge line = graph_.detach(best, other, difference(best, other, contracted));
    for (const Half_edge h : {line, line ^ 1U}) {
      touched.push_back(graph_.source(h));
      if (const Embedded_graph::Cell& c = graph_.cell(graph_.left_cell(h)); c.is_disk_with_one_side())
        touched.push_back(graph_.source(c.exclusive_or));
    }
  }
  touch_ends_of_star(v);
  if (sum == Indices{}) {
    const Half_edge a = graph_.vertices()[v].first;
    graph_.dissolve(v, difference(a, graph_.next(a), contracted));
    return;
  }
  graph_.become_generic(v);
}

// --- Step_finder

bool Step_finder::Dearer::operator()(const Candidate& a, const Candidate& b) const {
  if (a.cost != b.cost)
    return a.cost > b.cost;
  if (a.operation != b.operation)
    return a.operation > b.operation;
  return a.first != b.first ? a.first > b.first : a.second > b.second;
}

Step_finder::Step_finder(const Embedded_graph& graph) : graph_(graph), islands_(graph.number_of_cells()) {
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
    if (now && now->cost <= top.cost)
      return now;
    push(now);
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
  std::vector<std::uint32_t>& others = islands_[island->outer];
  if (std::find(others.begin(), others.end(), first) == others.end()) {
    for (const std::uint32_t other : others)
      push(islands(first, other));
    others.push_back(first);
  }
  // What lies around it in a small cell may enclose it, and be an island, too.
  constexpr std::uint32_t small = 64;
  if (around && graph_.cell(island->outer).sides <= small)
    for (const Half_edge h : graph_.sides(island->outer))
      look_for_island(graph_.source(h), false);
}

void Step_finder::merge_islands(std::uint32_t absorbed, std::uint32_t root) {
  std::vector<std::uint32_t> a = std::move(islands_[absorbed]), b = std::move(islands_[root]);
  islands_[absorbed].clear();
  const auto gone = [&](std::uint32_t v) { return !graph_.vertices()[v].alive; };
  std::erase_if(a, gone);
  std::erase_if(b, gone);
  for (const std::uint32_t x : a)
    for (const std::uint32_t y : b)
      push(islands(x, y));
  b.insert(b.end(), a.begin(), a.end());
  islands_[root] = std::move(b);
}

std::optional<Candidate> Step_finder::islands(std::uint32_t a, std::uint32_t b) const {
  if (!graph_.vertices()[a].alive || !graph_.vertices()[b].alive)
    return std::nullopt;
  const std::optional<Island> x = find_island(graph_, a), y = find_island(graph_, b);
  if (!x || !y || x->outer != y->outer || std::find(x->vertices.begin(), x->vertices.end(), b) != x->vertices.end() ||
      !(x->sum + y->sum == Indices{}) || x->sum == Indices{})
    return std::nullopt;
  // The curvatures at the two must become equal, and so must k1 and k2 on a way between them: |E_g| tells how much they
  // change on it.
  const Embedded_graph::Cell& cell = graph_.cell(x->outer);
  const double mean_root = cell.area > 0 ? cell.weight / cell.area : 0;
  double least = std::numeric_limits<double>::infinity();
  for (const std::uint32_t u : x->vertices)
    for (const std::uint32_t w : y->vertices) {
      const Embedded_graph::Vertex &p = graph_.vertices()[u], &q = graph_.vertices()[w];
      if (p.kind != Vertex_kind::anchor && q.kind != Vertex_kind::anchor)
        least = std::min(least, std::max({std::abs(p.k1 - q.k1), std::abs(p.k2 - q.k2),
                                          mean_root * distance(p.point, q.point)}));
    }
  return Candidate{Simplification_operation::cancel_islands, least, graph_.vertices()[std::min(a, b)].first,
                   graph_.vertices()[std::max(a, b)].first};
}

/// by how much k_j, or k1 − k2 where that is less, must change along an edge to take its ends together.
double Step_finder::cost_of(std::uint32_t edge) const {
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
  Candidate c{Operation::merge_vertices, cost_of(h / 2), h, Embedded_graph::none};
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
  return c;
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
  return Candidate{Simplification_operation::merge_vertices, std::max(cost_of(first / 2), cost_of(second / 2)), first,
                   second};
}

std::optional<Candidate> Step_finder::drop(Half_edge h) const {
  using Operation = Simplification_operation;
  const Embedded_graph::Edge& e = graph_.edges()[h / 2];
  const Embedded_graph::Cell& inside = graph_.cell(graph_.left_cell(h));
  if (e.kept || !inside.is_disk_with_one_side())
    return std::nullopt;
  const std::uint32_t u = graph_.source(h), w = graph_.target(h);
  Candidate c{Operation::drop_closed_line, 0, h, Embedded_graph::none};
  if (graph_.vertices()[u].kind == Vertex_kind::boundary && graph_.vertices()[w].kind == Vertex_kind::boundary)
    c.operation = Operation::drop_border_line;
  else if (inside.touches_border || graph_.vertices()[u].frozen)
    return std::nullopt;
  else if (graph_.vertices()[u].kind != Vertex_kind::anchor) {
    if (graph_.vertices()[u].degree <= 2 || !indices(graph_.vertices()[u]).is_empty_or_generic() || !all_free(u))
      return std::nullopt;
    c.operation = Operation::drop_loop;
  }
  c.cost = difference_within(e, inside);
  return c;
}

} // namespace CGAL::Extremal_mesh_3
