// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "degeneracy.h"

#include "../differential/vector.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <queue>
#include <utility>

namespace CGAL::Extremal_mesh_3 {

namespace {

enum class State : std::uint8_t { generic, umbilic, canal };

/// How large the components of L and C can be and still be 0.
struct Tolerance {
  double L, C;
};

State state_of(const Sample& s, const Tolerance& zero) {
  const double R2 = std::norm(s.shape.Q);
  if (R2 < zero.L * zero.L && std::abs(s.shape.A1) + std::abs(s.shape.A3) < zero.C)
    return State::umbilic;
  // The smaller extremality is at least |e1 e2|/√(e1² + e2²) = |Im Φ|/(2R²|P|): mostly that is enough, and needs no directions.
  const double product = s.shape.Phi().imag();
  if (product * product > 4 * R2 * R2 * std::norm(s.P) * zero.C * zero.C)
    return State::generic;
  const Principal_quantities q = principal_quantities(s.shape);
  return std::min(std::abs(q.e1), std::abs(q.e2)) < zero.C ? State::canal : State::generic;
}

/// The mean squares, around a vertex, of both extremalities and of the change of C with the radius.
struct Mean_squares {
  double e1 = 0, e2 = 0, change = 0;
};

/// takes them over about the neighbourhoods of the fits, by diffusion along the edges.
std::vector<Mean_squares> mean_squares(const Cell_complex& cells, const std::vector<Sample>& samples,
                                       const std::vector<Fit_quality>& quality) {
  const std::size_t n = samples.size();
  std::vector<Mean_squares> mean(n), sum(n);
  if (std::all_of(quality.begin(), quality.end(), [](const Fit_quality& q) { return q.C_change == 0; }))
    return mean;
  std::vector<double> degree(n, 0);
  for (std::size_t v = 0; v < n; ++v) {
    const Principal_quantities q = principal_quantities(samples[v].shape);
    mean[v] = {q.e1 * q.e1, q.e2 * q.e2, quality[v].C_change * quality[v].C_change};
  }
  double edges_in_radius = 0;
  for (const auto& [a, b] : cells.edges) {
    ++degree[a];
    ++degree[b];
    edges_in_radius += (quality[a].radius + quality[b].radius) / 2 / distance(cells.points[a], cells.points[b]);
  }
  edges_in_radius /= double(cells.edges.size());
  const int steps = int(std::min(25.0, edges_in_radius * edges_in_radius / 4)); // 4 bring it half an edge further
  for (int step = 0; step < steps; ++step) {
    std::fill(sum.begin(), sum.end(), Mean_squares());
    for (const auto& [a, b] : cells.edges)
      for (const auto& [i, j] : {std::pair{a, b}, std::pair{b, a}}) {
        sum[i].e1 += mean[j].e1;
        sum[i].e2 += mean[j].e2;
        sum[i].change += mean[j].change;
      }
    for (std::size_t v = 0; v < n; ++v) {
      mean[v].e1 = (mean[v].e1 + sum[v].e1 / degree[v]) / 2;
      mean[v].e2 = (mean[v].e2 + sum[v].e2 / degree[v]) / 2;
      mean[v].change = (mean[v].change + sum[v].change / degree[v]) / 2;
    }
  }
  return mean;
}

/// tells whether the normal hardly turns in the neighbourhood of a fit.
bool is_flat(const Sample& s, const Fit_quality& quality) {
  constexpr double flat = 0.02;
  return (std::abs(s.shape.H) + std::abs(s.shape.Q)) * quality.radius < flat;
}

/// \param quality  of the fit that gave the sample
State state_of(const Sample& s, const Tolerance& rounding, const Fit_quality& quality, const Mean_squares& mean) {
  // On spheres and planes C is the error of the fit alone, of the order k² (kR)³, R being the radius of the
  // neighbourhood: up to 0.5 times that. On a surface of revolution an extremality is far less than C changes by when the radius
  // grows. Noise is no reason to call a surface degenerate, unless it is flat.
  constexpr double error_of_A = 1, error_of_Q = 0.1, of_change = 0.5, standard_errors = 3;
  constexpr double bent = 0.5; // how far the normal turns in a neighbourhood for that order to hold
  const bool flat = is_flat(s, quality);
  const double k = std::abs(s.shape.H) + std::abs(s.shape.Q), kR = std::min(k * quality.radius, bent);
  Tolerance zero = rounding;
  zero.L = std::max({zero.L, error_of_Q * k * kR * kR * kR * kR, flat ? standard_errors * quality.L_error : 0});
  zero.C = std::max({zero.C, error_of_A * k * k * kR * kR * kR, flat ? standard_errors * quality.C_error : 0});
  if (state_of(s, zero) == State::umbilic)
    return State::umbilic;
  zero.C = flat ? standard_errors * quality.C_error : rounding.C;
  if (std::min(mean.e1, mean.e2) < of_change * of_change * mean.change)
    return State::canal;
  return state_of(s, zero) == State::generic ? State::generic : State::canal;
}

/// Third derivatives carry a relative error of some 1e-13 when the function is a formula; 1e-9 is far above
/// that and far below anything that a surface shows by chance over a whole cell.
/// \param least_curvature  below this a curvature is rounding (a plane has no curvature to compare with)
Tolerance rounding_of(const Sample& s, double least_curvature) {
  constexpr double rounding = 1e-9;
  const double k = std::max(std::abs(s.shape.H) + std::abs(s.shape.Q), least_curvature);
  return {rounding * k, rounding * k * k};
}

double least_curvature_of(const std::vector<Sample>& samples) {
  Point low = samples[0].p, high = samples[0].p;
  for (const Sample& s : samples)
    for (std::size_t a = 0; a < 3; ++a) {
      low[a] = std::min(low[a], s.p[a]);
      high[a] = std::max(high[a], s.p[a]);
    }
  return 1e-6 / distance(low, high);
}

/// of each point the length of the shortest way along edges to one of the sources.
std::vector<double> distances_from(const Cell_complex& cells, const std::vector<char>& is_source) {
  std::vector<std::size_t> begin(cells.points.size() + 1, 0);
  for (const auto& [a, b] : cells.edges) {
    ++begin[a + 1];
    ++begin[b + 1];
  }
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<std::uint32_t> neighbour(begin.back());
  std::vector<std::size_t> end(begin.begin(), begin.end() - 1);
  for (const auto& [a, b] : cells.edges) {
    neighbour[end[a]++] = b;
    neighbour[end[b]++] = a;
  }
  std::vector<double> length(cells.points.size(), std::numeric_limits<double>::infinity());
  using Entry = std::pair<double, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (std::uint32_t v = 0; v < length.size(); ++v)
    if (is_source[v]) {
      length[v] = 0;
      queue.push({0, v});
    }
  while (!queue.empty()) {
    const auto [d, v] = queue.top();
    queue.pop();
    if (d > length[v])
      continue;
    for (std::size_t i = begin[v]; i < begin[v + 1]; ++i) {
      const std::uint32_t w = neighbour[i];
      const double through = d + distance(cells.points[v], cells.points[w]);
      if (through < length[w]) {
        length[w] = through;
        queue.push({through, w});
      }
    }
  }
  return length;
}

/// makes strips generic that are not wider than the given lengths (an opening, as image processing calls it).
void open(const Cell_complex& cells, const std::vector<double>& width, std::vector<State>& state) {
  // Most surfaces have no point with degenerate neighbours only, and need no distances.
  std::vector<char> inner(state.size());
  for (std::size_t v = 0; v < state.size(); ++v)
    inner[v] = state[v] != State::generic;
  for (const auto& [a, b] : cells.edges) {
    inner[a] = inner[a] && state[b] != State::generic;
    inner[b] = inner[b] && state[a] != State::generic;
  }
  if (std::none_of(inner.begin(), inner.end(), [](char c) { return c; })) {
    std::fill(state.begin(), state.end(), State::generic);
    return;
  }
  std::vector<char> generic(state.size()), core(state.size());
  for (std::size_t v = 0; v < state.size(); ++v)
    generic[v] = state[v] == State::generic;
  const std::vector<double> from_generic = distances_from(cells, generic);
  for (std::size_t v = 0; v < state.size(); ++v)
    core[v] = from_generic[v] > width[v];
  const std::vector<double> from_core = distances_from(cells, core);
  for (std::size_t v = 0; v < state.size(); ++v)
    if (!(from_core[v] <= width[v]))
      state[v] = State::generic;
}

Degeneracy summary(const Cell_complex& cells, const std::vector<State>& cell_state) {
  Degeneracy result;
  std::array<double, 3> area_of_state{};
  for (std::size_t c = 0; c < cells.number_of_cells(); ++c) {
    const auto corner = [&](std::size_t h) -> const Point& { return cells.points[cells.source(cells.half_edges[h])]; };
    const std::size_t first = cells.cell_begin[c];
    double area = 0;
    for (std::size_t h = first + 1; h + 1 < cells.cell_begin[c + 1]; ++h)
      area += norm(cross(corner(h) - corner(first), corner(h + 1) - corner(first))) / 2;
    result.total_area += area;
    area_of_state[std::size_t(cell_state[c])] += area;
    result.cells.push_back(cell_state[c] != State::generic);
  }
  result.area = area_of_state[1] + area_of_state[2];
  result.name = area_of_state[1] > area_of_state[2] ? "all its points are umbilics, as on a sphere or a plane"
                                                    : "a principal curvature is constant along its own lines, as on "
                                                      "a cylinder, a cone, a torus or another surface of revolution";
  return result;
}

} // namespace

Degeneracy find_degeneracy(const Surface& surface, const Cell_complex& cells, const std::vector<Sample>& samples,
                           Thread_pool& pool) {
  const double least_curvature = least_curvature_of(samples);
  const auto state_at = [&](const Sample& s) { return state_of(s, rounding_of(s, least_curvature)); };
  std::vector<State> state(samples.size());
  pool.for_each(samples.size(), 256, [&](std::size_t i) { state[i] = state_at(samples[i]); });

  std::vector<State> cell_state(cells.number_of_cells(), State::generic);
  pool.for_each(cell_state.size(), 256, [&](std::size_t c) {
    std::vector<const Sample*> corners;
    bool degenerate = true;
    for (std::size_t h = cells.cell_begin[c]; h < cells.cell_begin[c + 1]; ++h) {
      const std::uint32_t v = cells.source(cells.half_edges[h]);
      corners.push_back(&samples[v]);
      degenerate = degenerate && state[v] != State::generic;
    }
    if (degenerate) // corners on a line of symmetry are not yet an area
      cell_state[c] = state_at(sample_amid(surface, corners));
  });
  return summary(cells, cell_state);
}

Degeneracy find_degeneracy(const Cell_complex& cells, const std::vector<Sample>& samples,
                           const std::vector<Fit_quality>& quality, Thread_pool& pool) {
  // A narrower strip is no area, however well the shapes are known: it may lie about an extremal line.
  constexpr double edges = 1.5, radii = 2, flat_radii = 1;
  const double least_curvature = least_curvature_of(samples);
  std::vector<State> state(samples.size());
  const std::vector<Mean_squares> mean =
      quality.empty() ? std::vector<Mean_squares>() : mean_squares(cells, samples, quality);
  pool.for_each(samples.size(), 256, [&](std::size_t i) {
    const Tolerance rounding = rounding_of(samples[i], least_curvature);
    state[i] = quality.empty() ? state_of(samples[i], rounding) : state_of(samples[i], rounding, quality[i], mean[i]);
  });
  std::vector<double> width(samples.size(), 0);
  for (const auto& [a, b] : cells.edges)
    for (const std::uint32_t v : {a, b})
      width[v] = std::max(width[v], edges * distance(cells.points[a], cells.points[b]));
  for (std::size_t v = 0; v < quality.size(); ++v)
    width[v] = std::max(width[v], (is_flat(samples[v], quality[v]) ? flat_radii : radii) * quality[v].radius);
  open(cells, width, state);

  std::vector<State> cell_state(cells.number_of_cells());
  for (std::size_t c = 0; c < cell_state.size(); ++c) {
    cell_state[c] = state[cells.source(cells.half_edges[cells.cell_begin[c]])];
    for (std::size_t h = cells.cell_begin[c]; h < cells.cell_begin[c + 1]; ++h)
      if (state[cells.source(cells.half_edges[h])] == State::generic)
        cell_state[c] = State::generic;
  }
  return summary(cells, cell_state);
}

} // namespace CGAL::Extremal_mesh_3
