// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Extremal_mesh_3/fit_vertex_shapes.h>

#include <CGAL/Extremal_mesh_3/errors.h>

#include "../cells/parallel.h"
#include "../differential/vector.h"
#include "Jet_fitter.h"

#include <fmt/format.h>
#include <tbb/enumerable_thread_specific.h>

#include <cmath>
#include <cstdlib>

namespace CGAL::Extremal_mesh_3 {

namespace {

void require_valid(const Cell_complex& cells, const Fit_options& options) {
  if (!(options.radius >= 0) || !std::isfinite(options.radius))
    throw std::invalid_argument(fmt::format("the radius is {}, not 0 or a positive length", options.radius));
  if (options.rings < 0)
    throw std::invalid_argument(fmt::format("the number of rings is {}, not 0 or more", options.rings));
  if (!options.normals.empty() && options.normals.size() != cells.points.size())
    throw std::invalid_argument(
        fmt::format("there are {} normals for {} points", options.normals.size(), cells.points.size()));
  for (std::size_t v = 0; v < cells.points.size(); ++v)
    if (const Point& p = cells.points[v]; !std::isfinite(dot(p, p)))
      throw std::invalid_argument(fmt::format("point {} is ({}, {}, {}), which is not finite", v, p[0], p[1], p[2]));
  for (std::size_t v = 0; v < options.normals.size(); ++v)
    if (const Vector& n = options.normals[v]; !(std::abs(dot(n, n) - 1) < 1e-6))
      throw std::invalid_argument(
          fmt::format("normal {} is ({}, {}, {}), which is not a unit vector", v, n[0], n[1], n[2]));
}

/// the middle one when sorted; 0 if there are none.
double median(std::vector<double> values) {
  if (values.empty())
    return 0;
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

} // namespace

Fit fit_vertex_shapes(const Cell_complex& cells, const Fit_options& options) {
  require_valid(cells, options);
  Thread_pool pool(options.threads);
  const std::size_t n = cells.points.size();
  const std::vector<Mesh_vertex> vertices = mesh_vertices(cells, options.normals);
  const Adjacency adjacency = options.rings > 0 ? neighbours_along_edges(cells) : neighbours_across_cells(cells);
  const std::vector<double> sampling = sampling_distances(vertices, adjacency);

  Fit fit;
  fit.shapes.shapes.resize(n);
  fit.shapes.fourth.resize(n);
  fit.shapes.quality.resize(n);
  const double default_multiple = std::getenv("CM") ? std::atof(std::getenv("CM")) : 4;
  const auto extent = [&](std::size_t v) {
    return Extent{options.radius > 0 ? options.radius : default_multiple * sampling[v], options.rings};
  };
  constexpr std::size_t block = 256;
  tbb::enumerable_thread_specific<Jet_fitter> fitters([&] { return Jet_fitter(vertices, adjacency, 0); });
  pool.for_each((n + block - 1) / block, 1, [&](std::size_t b) {
    Jet_fitter& fitter = fitters.local();
    for (std::size_t v = b * block; v < std::min(n, (b + 1) * block); ++v)
      fitter.fit(std::uint32_t(v), extent(v), fit.shapes);
    fitter.finish(fit.shapes);
  });

  Fit_report& report = fit.report;
  report.sampling = median(sampling);
  std::vector<double> radii, residuals;
  for (std::size_t v = 0; v < n; ++v) {
    const Fit_quality& q = fit.shapes.quality[v];
    if (q.state != Fit_state::fitted) {
      ++report.not_fitted;
      continue;
    }
    ++report.fitted;
    radii.push_back(q.radius);
    residuals.push_back(q.residual);
  }
  if (!radii.empty()) {
    report.radius_min = *std::min_element(radii.begin(), radii.end());
    report.radius_max = *std::max_element(radii.begin(), radii.end());
  }
  for (const Jet_fitter& f : fitters)
    report.grown += f.grown();
  report.radius_median = median(radii);
  report.noise = median(residuals);
  return fit;
}

} // namespace CGAL::Extremal_mesh_3
