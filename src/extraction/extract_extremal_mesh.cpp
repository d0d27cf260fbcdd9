// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Extremal_mesh_3/extract_extremal_mesh.h>

#include "../cells/parallel.h"
#include "../differential/vector.h"
#include "Arrangement.h"
#include "Implicit_surface.h"
#include "Interpolated_surface.h"
#include "Line_tracer.h"
#include "Refined_complex.h"
#include "Regions.h"
#include "analyse_cell.h"
#include "degeneracy.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace CGAL::Extremal_mesh_3 {

namespace {

/// moves samples at the corners of the cells a little off lines and zeros.
void nudge_corners(const Surface& surface, const Cell_complex& cells, std::vector<Sample>& samples, Thread_pool& pool) {
  const std::size_t n = cells.points.size();
  struct Around {
    double shortest = std::numeric_limits<double>::infinity(), P = 0, Q = 0;
    std::vector<const Sample*> samples;
  };
  std::vector<Around> around(n);
  const std::vector<Sample> given = surface.interpolates() ? samples : std::vector<Sample>();
  for (const auto& [a, b] : cells.edges) {
    const double length = distance(samples[a].p, samples[b].p);
    for (const auto& [i, j] : {std::pair{a, b}, std::pair{b, a}}) {
      around[i].shortest = std::min(around[i].shortest, length);
      around[i].P = std::max(around[i].P, std::abs(samples[j].P));
      around[i].Q = std::max(around[i].Q, std::abs(samples[j].shape.Q));
      if (surface.interpolates())
        around[i].samples.push_back(&given[j]);
    }
  }
  pool.for_each(n, 64, [&](std::size_t i) {
    samples[i] = nudged(surface, samples[i], 0.5 * around[i].shortest, around[i].P, around[i].Q, around[i].samples);
  });
}

/// the samples at points that lie on a surface already.
std::vector<Sample> sample_corners(const Implicit_surface& surface, const Cell_complex& cells, Thread_pool& pool) {
  const std::size_t n = cells.points.size();
  std::vector<Sample> samples(n);
  pool.for_each(n, 64, [&](std::size_t i) { samples[i] = surface.sample_at(cells.points[i]); });
  for (std::size_t i = 0; i < n; ++i)
    if (!std::isfinite(samples[i].phase))
      throw Extraction_error(fmt::format("the derivatives are not finite, or the gradient is 0, at ({}, {}, {})",
                                         samples[i].p[0], samples[i].p[1], samples[i].p[2]));
  nudge_corners(surface, cells, samples, pool);
  return samples;
}

std::size_t count_components(const Cell_complex& cells) {
  std::vector<std::uint32_t> parent(cells.points.size());
  std::iota(parent.begin(), parent.end(), 0U);
  const auto find = [&](std::uint32_t i) {
    while (parent[i] != i)
      i = parent[i] = parent[parent[i]];
    return i;
  };
  std::size_t components = parent.size();
  for (const auto& [a, b] : cells.edges) {
    const std::uint32_t i = find(a), j = find(b);
    components -= i != j;
    parent[i] = j;
  }
  return components;
}

void require_valid(const Extraction_options& options) {
  if (options.max_level < 0 || options.max_level > 40)
    throw std::invalid_argument(fmt::format("max_level is {}, not in 0 … 40", options.max_level));
  if (options.max_line_level < 0)
    throw std::invalid_argument(fmt::format("max_line_level is {}, less than 0", options.max_line_level));
}

void require_generic(const Degeneracy& degeneracy) {
  if (degeneracy.area > 0.5 * degeneracy.total_area)
    throw Degenerate_surface_error(
        fmt::format("E_g is 0 over {:.0f} % of the surface ({}), so its extremal mesh is not defined",
                    100 * degeneracy.area / degeneracy.total_area, degeneracy.name));
}

/// divides the cells, draws the lines across them, and gathers the mesh that they make.
/// \param samples  at the points of the cells
Extraction extract(const Surface& surface, const Cell_complex& cells, std::vector<Sample> samples,
                   const Degeneracy& degeneracy, const Extraction_options& options) {
  Refined_complex complex(surface, cells, std::move(samples), degeneracy.cells, options);
  complex.refine();
  const Arrangement arrangement(complex, options);
  Extraction result;
  Regions regions(arrangement, options.patches ? &result.patches : nullptr);
  Line_tracer lines(arrangement, regions);

  Surface_info info;
  info.euler_characteristic = cells.euler_characteristic();
  info.closed = std::none_of(cells.edge_cells.begin(), cells.edge_cells.end(),
                             [](const auto& c) { return c[0] < 0 || c[1] < 0; });
  info.components = count_components(cells);
  for (const Extremal_mesh_cell& cell : regions.cells())
    info.area += cell.area;
  info.degenerate_area = degeneracy.area;
  result.report = complex.report();
  result.report.degenerate_cells = std::size_t(std::count(degeneracy.cells.begin(), degeneracy.cells.end(), char(1)));
  result.mesh = Extremal_mesh(std::move(lines.vertices), std::move(lines.edges), std::move(regions.cells()), info);
  return result;
}

} // namespace

Extraction extract_extremal_mesh(const Function_3& f, const Cell_complex& cells, const Extraction_options& options) {
  require_valid(options);
  if (cells.number_of_cells() == 0)
    throw Extraction_error("the surface has no cells");
  Thread_pool pool(options.threads);
  const Implicit_surface surface(f);
  std::vector<Sample> samples = sample_corners(surface, cells, pool);
  const Degeneracy degeneracy = find_degeneracy(surface, cells, samples, pool);
  require_generic(degeneracy);
  return extract(surface, cells, std::move(samples), degeneracy, options);
}

Extraction extract_extremal_mesh(const Cell_complex& cells, const Vertex_shapes& shapes,
                                 const Extraction_options& options) {
  require_valid(options);
  if (cells.number_of_cells() == 0)
    throw Extraction_error("the surface has no cells");
  Thread_pool pool(options.threads);
  const Interpolated_surface surface;
  std::vector<Sample> samples = surface.samples(cells, shapes);
  const Degeneracy degeneracy = find_degeneracy(surface, cells, samples, pool);
  require_generic(degeneracy);
  nudge_corners(surface, cells, samples, pool);
  return extract(surface, cells, std::move(samples), degeneracy, options);
}

Extraction extract_extremal_mesh(const Function_3& f, const Lattice& lattice, const Extraction_options& options) {
  return extract_extremal_mesh(f, make_implicit_cells(f, lattice, options), options);
}

} // namespace CGAL::Extremal_mesh_3
