// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Extremal_mesh_3/Patch_locator.h>
#include <CGAL/Extremal_mesh_3/internal/manifold_patches.h>
#include <CGAL/Extremal_mesh_3/lines.h>
#include <CGAL/Extremal_mesh_3/reduce.h>
#include <CGAL/Extremal_mesh_3/segment.h>

#include "../cells/bounding_box.h"
#include "../cells/parallel.h"
#include "../cgal/collapse_edges.h"
#include "Line_edges.h"
#include "divide.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <utility>

namespace CGAL::Extremal_mesh_3 {

namespace {

void validate(const Reduction_options& options) {
  if (!(options.keep_crest >= 0))
    throw std::invalid_argument(
        fmt::format("the strength of the crest lines to be kept is {}, not 0 or more", options.keep_crest));
  if (options.line_tolerance && !(std::isfinite(*options.line_tolerance) && *options.line_tolerance >= 0))
    throw std::invalid_argument(
        fmt::format("the tolerance of the lines is {}, not a length of 0 or more", *options.line_tolerance));
}

/// the edges of the crest lines that are strong enough.
std::vector<std::uint32_t> edges_to_keep(const Extremal_mesh& mesh, double least_strength) {
  std::vector<std::uint32_t> edges;
  for (const Extremal_line& line : strongest_crest_lines(mesh, mesh.number_of_edges())) {
    double strength = 0;
    for (const Half_edge h : line.half_edges)
      strength += mesh.edge(h / 2).strength;
    if (strength >= least_strength)
      for (const Half_edge h : line.half_edges)
        edges.push_back(h / 2);
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

Cell_complex complex_of(const Triangles& triangles) {
  std::vector<std::size_t> begin{0};
  std::vector<std::uint32_t> corners;
  for (const auto& triangle : triangles.corners) {
    corners.insert(corners.end(), triangle.begin(), triangle.end());
    begin.push_back(corners.size());
  }
  return make_cell_complex(triangles.points, begin, corners);
}

/// the largest distance of a point, or of the middle of a triangle, of one surface from another one.
double distance_from(const Triangles& surface, const Patch_locator& other, int threads) {
  std::vector<Point> samples = surface.points;
  constexpr double third = 1.0 / 3;
  for (const auto& [a, b, c] : surface.corners)
    samples.push_back(third * (surface.points[a] + surface.points[b] + surface.points[c]));
  std::vector<double> distances(samples.size());
  constexpr std::size_t grain = 256;
  Thread_pool(threads).for_each(samples.size(), grain,
                                [&](std::size_t i) { distances[i] = other.nearest(samples[i])->distance; });
  return *std::max_element(distances.begin(), distances.end());
}

/// each step of the work as a part of the whole.
Progress part_of(const Progress& whole, double first, double last) {
  if (!whole)
    return {};
  return [&whole, first, last](double share) { return whole(first + (last - first) * share); };
}

} // namespace

Reduction reduce(const Extremal_mesh& mesh, const Cell_patches& cells, const Reduction_options& options) {
  validate(options);
  require_cells_of(mesh, cells);
  if (cells.cell.empty())
    throw std::invalid_argument("the surface of the cells has no polygon");
  constexpr double share_of_size = 1e-3;
  const double diagonal = diagonal_of(cells.points);

  Cell_patches surface = divide_into_triangles(internal::manifold_patches(cells));
  const Line_edges lines(surface);
  Reduction result;
  std::set<std::array<std::uint32_t, 2>> kept;
  for (const std::uint32_t e : edges_to_keep(mesh, options.keep_crest)) {
    ++result.kept_edges;
    result.kept_length += mesh.edge(e).length;
    for (const auto& [a, b] : lines.along(mesh.edge(e).polyline, e))
      kept.insert({std::min(a, b), std::max(a, b)});
  }

  const Triangles before = triangles_of(surface);
  result.faces_before = before.corners.size();
  result.segments_before = kept.size();
  result.euler_characteristic_before = complex_of(before).euler_characteristic();

  constexpr std::size_t tenth = 10;
  Collapse_request request;
  request.normals = std::move(surface.normals);
  request.kept_edges.assign(kept.begin(), kept.end());
  request.line_tolerance = options.line_tolerance.value_or(share_of_size * diagonal);
  request.number_of_faces = options.number_of_faces.value_or(before.corners.size() / tenth);
  request.progress = part_of(options.progress, 0, 0.7);
  Collapsed collapsed = collapse_edges(before, request);
  result.line_deviation = collapsed.line_deviation;
  result.lines = std::move(collapsed.lines);
  for (const auto& line : result.lines)
    result.segments += line.size() - 1;

  const Cell_complex reduced = complex_of(collapsed.triangles);
  result.euler_characteristic = reduced.euler_characteristic();
  if (options.progress && !options.progress(0.8))
    throw Cancelled();
  Segmentation_options whatever;
  whatever.tolerance = std::numeric_limits<double>::max();
  whatever.threads = options.threads;
  whatever.progress = part_of(options.progress, 0.8, 1);
  Segmentation segmentation = segment(reduced, mesh, cells, whatever);
  result.faces = std::move(segmentation.faces);
  surface.normals = std::move(request.normals);
  result.surface_deviation = std::max(distance_from(before, Patch_locator(result.faces), options.threads),
                                      distance_from(collapsed.triangles, Patch_locator(surface), options.threads));
  return result;
}

} // namespace CGAL::Extremal_mesh_3
