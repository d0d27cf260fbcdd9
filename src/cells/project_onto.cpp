// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Extremal_mesh_3/errors.h>
#include <CGAL/Extremal_mesh_3/project_onto.h>

#include "../differential/vector.h"
#include "Union_find.h"
#include "parallel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace CGAL::Extremal_mesh_3 {

namespace {

/// A point, and the direction in which f rises there.
struct Projected {
  Point p{};
  Vector normal{};
  bool found = false;
};

Projected projected(const Function_3& f, const Point& start, double reach) {
  Projected result{start};
  Derivatives d;
  double step_before = reach;
  for (int i = 0; i < 30; ++i) {
    f.derivatives(result.p, 1, d);
    const double slope = norm(d.gradient), step = -d.value / slope;
    if (!std::isfinite(step))
      return result;
    result.normal = (1 / slope) * d.gradient;
    result.p = result.p + step * result.normal;
    if (!(distance(result.p, start) <= reach))
      return result;
    // Quadratic convergence: once a step no longer shrinks, it is rounding.
    if (std::abs(step) < 1e-9 * reach && (step == 0 || std::abs(step) >= 0.25 * std::abs(step_before))) {
      result.found = true;
      return result;
    }
    step_before = step;
  }
  return result;
}

/// turns the cells of the components in which more area looks along −normal than along normal.
void orient(Cell_complex& cells, const std::vector<Projected>& at) {
  Union_find components(cells.points.size());
  for (const auto& [a, b] : cells.edges)
    components.unite(a, b);
  const auto component = [&](std::size_t cell) {
    return components.find(cells.source(cells.half_edges[cells.cell_begin[cell]]));
  };
  std::vector<double> along(cells.points.size(), 0); // of each component
  for (std::size_t c = 0; c < cells.number_of_cells(); ++c) {
    const Point& origin = cells.points[cells.source(cells.half_edges[cells.cell_begin[c]])];
    Vector area{}, normal{};
    for (std::size_t i = cells.cell_begin[c]; i < cells.cell_begin[c + 1]; ++i) {
      const std::uint32_t p = cells.source(cells.half_edges[i]), q = cells.target(cells.half_edges[i]);
      area = area + cross(cells.points[p] - origin, cells.points[q] - origin);
      normal = normal + at[p].normal;
    }
    along[component(c)] += dot(area, normal);
  }
  for (std::size_t c = 0; c < cells.number_of_cells(); ++c)
    if (along[component(c)] < 0) {
      const auto begin = cells.half_edges.begin() + std::ptrdiff_t(cells.cell_begin[c]),
                 end = cells.half_edges.begin() + std::ptrdiff_t(cells.cell_begin[c + 1]);
      std::reverse(begin, end);
      std::for_each(begin, end, [](std::uint32_t& h) { h ^= 1U; });
    }
  for (std::size_t e = 0; e < cells.edges.size(); ++e)
    if (along[components.find(cells.edges[e][0])] < 0)
      std::swap(cells.edge_cells[e][0], cells.edge_cells[e][1]);
}

} // namespace

Cell_complex project_onto(const Function_3& f, Cell_complex cells, int threads) {
  std::vector<double> reach(cells.points.size(), 0);
  for (const auto& [a, b] : cells.edges) {
    const double length = distance(cells.points[a], cells.points[b]);
    reach[a] = std::max(reach[a], length);
    reach[b] = std::max(reach[b], length);
  }
  std::vector<Projected> at(cells.points.size());
  Thread_pool(threads).for_each(at.size(), 256,
                                [&](std::size_t i) { at[i] = projected(f, cells.points[i], reach[i]); });
  for (std::size_t i = 0; i < at.size(); ++i) {
    if (!at[i].found)
      throw Extraction_error(
          fmt::format("point {} at ({}, {}, {}) has no point of the function's zero surface within {}, the "
                      "length of its longest edge",
                      i, cells.points[i][0], cells.points[i][1], cells.points[i][2], reach[i]));
    cells.points[i] = at[i].p;
  }
  orient(cells, at);
  return cells;
}

} // namespace CGAL::Extremal_mesh_3
