// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface_points.h"

#include "../differential/vector.h"
#include "../functions/root_in_bracket.h"

#include <algorithm>
#include <cmath>

namespace CGAL::Extremal_mesh_3 {

double root_on_edge(const Function_3& f, const Point& p, const Vector& step, double v0, double v1) {
  Derivatives d;
  return root_in_bracket(v0, v1, [&](double t) {
    f.derivatives(p + t * step, 1, d);
    return std::pair(d.value, dot(d.gradient, step));
  });
}

namespace {

double root_on(const Function_3& f, const Lattice& lattice, const Cut_edge& edge, const Point& p, const Vector& step) {
  if (edge.length == 1) {
    const std::array<std::size_t, 3> node{std::size_t(edge.node[0]), std::size_t(edge.node[1]),
                                          std::size_t(edge.node[2])};
    if (const auto t = f.root_on_edge(lattice, node, edge.axis, edge.value0, edge.value1))
      return *t;
  }
  return root_on_edge(f, p, step, edge.value0, edge.value1);
}

} // namespace

std::optional<Point> project(const Function_3& f, const Point& x, const Vector& direction, double reach) {
  Derivatives d;
  double s = 0, step_before = reach;
  for (int i = 0; i < 30; ++i) {
    const Point p = x + s * direction;
    f.derivatives(p, 1, d);
    const double slope = dot(d.gradient, direction);
    const double step = -d.value / slope;
    if (!std::isfinite(step))
      return std::nullopt;
    s += step;
    if (std::abs(s) > reach)
      return std::nullopt;
    // Quadratic convergence: once a step no longer shrinks, it is rounding.
    if (std::abs(step) < 1e-9 * reach && (step == 0 || std::abs(step) >= 0.25 * std::abs(step_before)))
      return x + s * direction;
    step_before = step;
  }
  return std::nullopt;
}

Point surface_point(const Function_3& f, const Lattice& lattice, const Cut_edge& edge) {
  // Nearer to a node than this part of the lattice edge, the cells around the node would become slivers.
  constexpr double margin = 0.02;
  const Point p = lattice.node(edge.node[0], edge.node[1], edge.node[2]);
  const Vector step = edge.length * lattice.step[edge.axis];
  const double t = root_on(f, lattice, edge, p, step);
  const double moved = std::clamp(t, margin, 1 - margin);
  if (moved != t) {
    const Point beside = p + moved * step;
    Derivatives d;
    f.derivatives(beside, 1, d);
    const double length = norm(d.gradient);
    if (std::isfinite(length) && length > 0)
      if (const auto on_surface = project(f, beside, (1 / length) * d.gradient, 4 * margin * norm(step)))
        return *on_surface;
  }
  return p + t * step;
}

} // namespace CGAL::Extremal_mesh_3
