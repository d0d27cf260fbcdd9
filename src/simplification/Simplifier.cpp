// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Simplifier.h"

#include "islands.h"

#include <algorithm>

namespace CGAL::Extremal_mesh_3 {

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
  graph_.remove_disk(b.vertices, b.edges, b.inner, graph_.root(b.outer));
  touch_sides(graph_.root(a.outer));
  touch_sides(graph_.root(b.outer));
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

} // namespace CGAL::Extremal_mesh_3
