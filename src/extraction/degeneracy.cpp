// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "degeneracy.h"

#include "../differential/vector.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL::Extremal_mesh_3 {

namespace {

enum class State : std::uint8_t { generic, umbilic, canal };

/// \param least_curvature  below this a curvature is rounding (a plane has no curvature to compare with)
State state_of(const Sample& s, double least_curvature) {
  // Third derivatives carry a relative error of some 1e-13 when the function is a formula; 1e-9 is far above
  // that and far below anything that a surface shows by chance over a whole cell.
  constexpr double rounding = 1e-9;
  const Principal_quantities q = principal_quantities(s.shape);
  const double k = std::max({std::abs(q.k1), std::abs(q.k2), least_curvature});
  if (std::abs(s.shape.Q) < rounding * k && std::abs(s.shape.A1) + std::abs(s.shape.A3) < rounding * k * k)
    return State::umbilic;
  return std::min(std::abs(q.e1), std::abs(q.e2)) < rounding * k * k ? State::canal : State::generic;
}

} // namespace

Degeneracy find_degeneracy(const Surface& surface, const Cell_complex& cells, const std::vector<Sample>& samples,
                           Thread_pool& pool) {
  Point low = samples[0].p, high = samples[0].p;
  for (const Sample& s : samples)
    for (std::size_t a = 0; a < 3; ++a) {
      low[a] = std::min(low[a], s.p[a]);
      high[a] = std::max(high[a], s.p[a]);
    }
  const double least_curvature = 1e-6 / distance(low, high);
  std::vector<State> state(samples.size());
  pool.for_each(samples.size(), 256, [&](std::size_t i) { state[i] = state_of(samples[i], least_curvature); });

  const std::size_t n = cells.number_of_cells();
  std::vector<State> cell_state(n, State::generic);
  std::vector<double> area(n);
  pool.for_each(n, 256, [&](std::size_t c) {
    std::vector<const Sample*> corners;
    bool degenerate = true;
    for (std::size_t h = cells.cell_begin[c]; h < cells.cell_begin[c + 1]; ++h) {
      const std::uint32_t v = cells.source(cells.half_edges[h]);
      corners.push_back(&samples[v]);
      degenerate = degenerate && state[v] != State::generic;
    }
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
      area[c] += norm(cross(corners[i]->p - corners[0]->p, corners[i + 1]->p - corners[0]->p)) / 2;
    if (degenerate) // corners on a line of symmetry are not yet an area
      cell_state[c] = state_of(sample_amid(surface, corners), least_curvature);
  });

  Degeneracy result;
  std::array<double, 3> area_of_state{};
  for (std::size_t c = 0; c < n; ++c) {
    result.total_area += area[c];
    area_of_state[std::size_t(cell_state[c])] += area[c];
    result.cells.push_back(cell_state[c] != State::generic);
  }
  result.area = area_of_state[1] + area_of_state[2];
  result.name = area_of_state[1] > area_of_state[2] ? "all its points are umbilics, as on a sphere or a plane"
                                                    : "a principal curvature is constant along its own lines, as on "
                                                      "a cylinder, a cone, a torus or another surface of revolution";
  return result;
}

} // namespace CGAL::Extremal_mesh_3
