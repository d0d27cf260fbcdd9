// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Extremal_mesh_3/fit_vertex_shapes.h>

#include <CGAL/Extremal_mesh_3/errors.h>

#include "../cells/usual_size.h"
#include "../differential/vector.h"
#include "change_with_radius.h"
#include "fit_jets.h"
#include "median.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace CGAL::Extremal_mesh_3 {

namespace {

/// Moments are sums of 8th powers of lengths, of which products are taken.
constexpr double largest_size = 1e18;

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
      throw std::invalid_argument(
          fmt::format("point {} is ({}, {}, {}), which is not finite, or too large", v, p[0], p[1], p[2]));
  for (std::size_t v = 0; v < options.normals.size(); ++v)
    if (const Vector& n = options.normals[v]; !(std::abs(dot(n, n) - 1) < 1e-6))
      throw std::invalid_argument(
          fmt::format("normal {} is ({}, {}, {}), which is not a unit vector", v, n[0], n[1], n[2]));
}

/// the size of the last digits of the coordinates. Files often hold floats.
double rounding_of(const std::vector<Point>& points) {
  double largest = 0;
  bool floats = true;
  for (const Point& p : points)
    for (const double x : p) {
      largest = std::max(largest, std::abs(x));
      floats = floats && double(float(x)) == x;
    }
  return std::ldexp(largest, floats ? -24 : -53);
}

Fit_report report_on(const Jets& jets, const std::vector<double>& sampling) {
  Fit_report report;
  std::vector<double> radii, residuals;
  for (const Fit_quality& q : jets.shapes.quality)
    if (q.known()) {
      radii.push_back(q.radius);
      residuals.push_back(q.residual);
    }
  report.sampling = median(sampling);
  report.radius_median = median(radii);
  if (!radii.empty()) {
    const auto [least, largest] = std::minmax_element(radii.begin(), radii.end());
    report.radius_min = *least;
    report.radius_max = *largest;
  }
  report.noise = median(residuals);
  report.fitted = radii.size();
  report.grown = jets.grown;
  report.not_fitted = jets.shapes.quality.size() - radii.size();
  return report;
}

} // namespace

Fit fit_vertex_shapes(const Cell_complex& cells, const Fit_options& options) {
  require_valid(cells, options);
  require_usual_size(cells, largest_size);
  Thread_pool pool(options.threads);
  const auto progress = [&](double part) {
    if (options.progress && !options.progress(part))
      throw Cancelled();
  };

  Fit_input input;
  input.adjacency = options.rings > 0 ? neighbours_along_edges(cells) : neighbours_across_cells(cells);
  input.vertices = mesh_vertices(cells, input.adjacency, options.normals);
  input.sampling = sampling_distances(input.vertices, input.adjacency);
  input.rounding = rounding_of(cells.points);

  if (options.rings == 0 && options.radius == 0) {
    Default_fit fit = fit_jets_with_default_radius(input, pool, progress);
    find_change_with_radius(input, pool, fit.jets.shapes);
    Fit_report report = report_on(fit.jets, input.sampling);
    report.multiple = fit.multiple;
    progress(1);
    return {std::move(fit.jets.shapes), report};
  }
  const std::vector<Extent> extents(cells.points.size(), {options.radius, options.rings});
  Jets jets = fit_jets(input, extents, pool, progress);
  find_change_with_radius(input, pool, jets.shapes);
  const Fit_report report = report_on(jets, input.sampling);
  return {std::move(jets.shapes), report};
}

} // namespace CGAL::Extremal_mesh_3
