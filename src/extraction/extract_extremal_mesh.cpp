// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Extremal_mesh_3/extract_extremal_mesh.h>

#include "../cells/Union_find.h"
#include "../cells/parallel.h"
#include "../cells/remove_cells.h"
#include "../cells/usual_size.h"
#include "../differential/distance_to_segment.h"
#include "Arrangement.h"
#include "Implicit_surface.h"
#include "Interpolated_surface.h"
#include "Line_tracer.h"
#include "Refined_complex.h"
#include "Regions.h"
#include "certify.h"
#include "degeneracy.h"
#include "nudge.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace CGAL::Extremal_mesh_3 {

namespace {

/// how near the corners that have a number come to other sides of their cells, of which some are slivers.
std::vector<double> room_around(const Cell_complex& cells, const std::vector<std::uint32_t>& number,
                                std::size_t numbered) {
  std::vector<double> room(numbered, std::numeric_limits<double>::infinity());
  for (std::size_t c = 0; c < cells.number_of_cells(); ++c) {
    const std::size_t begin = cells.cell_begin[c], sides = cells.cell_begin[c + 1] - begin;
    const auto corner = [&](std::size_t i) {
      const Half_edge h = cells.half_edges[begin + i % sides];
      return cells.edges[h / 2][h % 2];
    };
    for (std::size_t i = 0; i < sides; ++i)
      if (const std::uint32_t k = number[corner(i)]; k != 0)
        for (std::size_t j = i + 1; j + 1 < i + sides; ++j)
          room[k - 1] = std::min(room[k - 1], distance_to_segment(cells.points[corner(i)], cells.points[corner(j)],
                                                                  cells.points[corner(j + 1)]));
  }
  return room;
}

/// moves samples at the corners of the cells a little off lines and zeros.
void nudge_corners(const Surface& surface, const Cell_complex& cells, std::vector<Sample>& samples, Thread_pool& pool) {
  const std::size_t n = cells.points.size();
  struct Around { // the squares of what is around a point, and half of the shortest edge's length in the end
    double size = std::numeric_limits<double>::infinity(), P = 0, Q = 0;
  };
  std::vector<Around> around(n);
  for (const auto& [a, b] : cells.edges) {
    const Vector d = samples[b].p - samples[a].p;
    const double length = dot(d, d);
    for (const auto& [i, j] : {std::pair{a, b}, std::pair{b, a}}) {
      around[i].size = std::min(around[i].size, length);
      around[i].P = std::max(around[i].P, std::norm(samples[j].P));
      around[i].Q = std::max(around[i].Q, std::norm(samples[j].shape.Q));
    }
  }
  for (Around& a : around)
    a = {0.5 * std::sqrt(a.size), std::sqrt(a.P), std::sqrt(a.Q)};
  // Few are to be moved.
  std::vector<std::uint32_t> number(n, 0), moved;
  for (std::uint32_t i = 0; i < n; ++i)
    if (should_be_nudged(samples[i], around[i].size, around[i].P, around[i].Q)) {
      moved.push_back(i);
      number[i] = std::uint32_t(moved.size());
    }
  std::vector<std::vector<const Sample*>> neighbours(moved.size());
  for (const auto& [a, b] : cells.edges)
    for (const auto& [i, j] : {std::pair{a, b}, std::pair{b, a}})
      if (number[i] != 0)
        neighbours[number[i] - 1].push_back(&samples[j]);
  const std::vector<double> room = room_around(cells, number, moved.size());
  std::vector<Sample> nudged_samples(moved.size());
  pool.for_each(moved.size(), 64, [&](std::size_t k) {
    const Around& a = around[moved[k]];
    nudged_samples[k] = nudged(surface, samples[moved[k]], a.size, room[k], a.P, a.Q, neighbours[k]);
  });
  for (std::size_t k = 0; k < moved.size(); ++k)
    samples[moved[k]] = nudged_samples[k];
}

/// the samples at points that lie on a surface already.
std::vector<Sample> sample_corners(const Implicit_surface& surface, const Cell_complex& cells, Thread_pool& pool) {
  const std::size_t n = cells.points.size();
  std::vector<Sample> samples;
  samples.reserve(Refined_complex::room_for(n));
  samples.resize(n);
  pool.for_each(n, 64, [&](std::size_t i) { samples[i] = surface.sample_at(cells.points[i]); });
  for (std::size_t i = 0; i < n; ++i)
    if (!std::isfinite(samples[i].phase))
      throw Extraction_error(fmt::format("the derivatives are not finite, or the gradient is 0, at ({}, {}, {})",
                                         samples[i].p[0], samples[i].p[1], samples[i].p[2]));
  nudge_corners(surface, cells, samples, pool);
  return samples;
}

std::size_t count_components(const Cell_complex& cells) {
  Union_find sets(cells.points.size());
  std::size_t components = cells.points.size();
  for (const auto& [a, b] : cells.edges)
    components -= sets.unite(a, b);
  return components;
}

void require_valid(const Extraction_options& options) {
  if (options.max_level < 0 || options.max_level > 40)
    throw std::invalid_argument(fmt::format("max_level is {}, not in 0 … 40", options.max_level));
  if (options.max_line_level < 0)
    throw std::invalid_argument(fmt::format("max_line_level is {}, less than 0", options.max_line_level));
  if (!(std::isfinite(options.line_tolerance) && options.line_tolerance >= 0))
    throw std::invalid_argument(fmt::format("line_tolerance is {}, not a length of 0 or more", options.line_tolerance));
}

void require_generic(const Degeneracy& degeneracy) {
  if (degeneracy.area > 0.5 * degeneracy.total_area)
    throw Degenerate_surface_error(
        fmt::format("E_g is 0 over {:.0f} % of the surface ({}), so its extremal mesh is not defined",
                    100 * degeneracy.area / degeneracy.total_area, degeneracy.name));
}

template <class T> std::vector<T> chosen(const std::vector<T>& values, const std::vector<std::uint32_t>& which) {
  std::vector<T> result;
  if (values.empty()) // not known for any
    return result;
  result.reserve(which.size());
  for (const std::uint32_t i : which)
    result.push_back(values[i]);
  return result;
}

/// Cells with the shapes at their points.
struct Shaped_cells {
  Cell_complex cells;
  Vertex_shapes shapes;
};

/// the sums of the area vectors of the cells around each point.
std::vector<Vector> area_vectors(const Cell_complex& cells) {
  std::vector<Vector> sums(cells.points.size(), Vector{});
  for (std::size_t c = 0; c < cells.number_of_cells(); ++c) {
    const auto corner = [&](std::size_t h) { return cells.source(cells.half_edges[h]); };
    const std::size_t first = cells.cell_begin[c], end = cells.cell_begin[c + 1];
    const Point& origin = cells.points[corner(first)];
    Vector area{};
    for (std::size_t h = first + 1; h + 1 < end; ++h)
      area = area + cross(cells.points[corner(h)] - origin, cells.points[corner(h + 1)] - origin);
    for (std::size_t h = first; h < end; ++h)
      sums[corner(h)] = sums[corner(h)] + area;
  }
  return sums;
}

/// Φ is of degree −7 in lengths; features may be smaller than the surface.
constexpr double largest_size = 1e35;

/// \throws std::invalid_argument if most of the normals point to the side from which the cells are clockwise
void require_same_side(const Cell_complex& cells, const Vertex_shapes& shapes) {
  const std::vector<Vector> area = area_vectors(cells);
  std::size_t known = 0, behind = 0;
  for (std::size_t i = 0; i < area.size(); ++i)
    if (shapes.quality.empty() || shapes.quality[i].known()) {
      ++known;
      behind += dot(shapes.shapes[i].n, area[i]) < 0 ? 1U : 0U;
    }
  if (2 * behind > known)
    throw std::invalid_argument(
        fmt::format("the normals at {} of {} points are on the side from which the cells around "
                    "them are clockwise; turn the cells or the shapes over",
                    behind, known));
}

/// takes away the cells with a corner at which the shape is not known, or was fitted to something else than the cells around; nothing
/// if there are none.
std::optional<Shaped_cells> without_unknown(const Cell_complex& cells, const Vertex_shapes& shapes) {
  if (shapes.quality.empty())
    return std::nullopt;
  constexpr double least_cosine = 0.2; // between the normal of a fit and that of the cells
  const std::vector<Vector> area = area_vectors(cells);
  const auto unknown = [&](std::uint32_t v) {
    const Fit_quality& q = shapes.quality[v];
    return !q.known() ||
           (q.state == Fit_state::fitted && dot(shapes.shapes[v].n, area[v]) < least_cosine * norm(area[v]));
  };
  std::vector<char> removed(cells.number_of_cells(), 0);
  for (std::size_t c = 0; c < removed.size(); ++c)
    for (std::size_t h = cells.cell_begin[c]; h < cells.cell_begin[c + 1]; ++h)
      removed[c] |= char(unknown(cells.source(cells.half_edges[h])));
  const auto number = std::size_t(std::count(removed.begin(), removed.end(), char(1)));
  if (number == 0)
    return std::nullopt;
  if (2 * number > removed.size())
    throw Extraction_error(fmt::format("{} of {} cells have corners at which no jet of degree 4 could be fitted: the "
                                       "mesh has too few vertices, they lie on a few lines, or it bends too much "
                                       "between them",
                                       number, removed.size()));
  Remaining_cells rest = remove_cells(cells, removed);
  return Shaped_cells{
      std::move(rest.cells),
      {chosen(shapes.shapes, rest.point), chosen(shapes.fourth, rest.point), chosen(shapes.quality, rest.point)}};
}

/// divides the cells, draws the lines across them, and gathers the mesh that they make.
/// \param samples  at the points of the cells
/// \param f  the function whose surface it is, if there is one
Extraction extract(const Surface& surface, const Function_3* f, const Cell_complex& cells, std::vector<Sample> samples,
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
  if (options.certify && f && f->bounds_cost() != Bounds_cost::unknown) {
    const Certificate certificate = certify(*f, complex, options.threads);
    result.report.certified = true;
    result.report.proved_empty_cells = certificate.without_lines;
    result.report.proved_vertex_free_cells = certificate.without_vertices;
  }
  result.report.line_segments = arrangement.number_of_segments();
  result.report.straight_segments = arrangement.number_of_straight_segments();
  result.report.degenerate_cells = std::size_t(std::count(degeneracy.cells.begin(), degeneracy.cells.end(), char(1)));
  result.mesh = Extremal_mesh(std::move(lines.vertices), std::move(lines.edges), std::move(regions.cells()), info);
  return result;
}

} // namespace

Extraction extract_extremal_mesh(const Function_3& f, const Cell_complex& cells, const Extraction_options& options) {
  require_valid(options);
  if (cells.number_of_cells() == 0)
    throw Extraction_error("the surface has no cells");
  require_usual_size(cells, largest_size);
  Thread_pool pool(options.threads);
  const Implicit_surface surface(f);
  std::vector<Sample> samples = sample_corners(surface, cells, pool);
  const Degeneracy degeneracy = find_degeneracy(surface, cells, samples, pool);
  require_generic(degeneracy);
  return extract(surface, &f, cells, std::move(samples), degeneracy, options);
}

Extraction extract_extremal_mesh(const Cell_complex& cells, const Vertex_shapes& shapes,
                                 const Extraction_options& options) {
  require_valid(options);
  if (cells.number_of_cells() == 0)
    throw Extraction_error("the surface has no cells");
  require_usual_size(cells, largest_size);
  Thread_pool pool(options.threads);
  const Interpolated_surface surface;
  surface.require_valid(cells, shapes);
  require_same_side(cells, shapes);
  const std::optional<Shaped_cells> known = without_unknown(cells, shapes);
  const Cell_complex* rest = known ? &known->cells : &cells;
  const Vertex_shapes& shapes_of_rest = known ? known->shapes : shapes;
  const std::size_t known_cells = rest->number_of_cells();
  std::vector<Sample> samples = surface.samples(*rest, shapes_of_rest);
  Degeneracy degeneracy = find_degeneracy(*rest, samples, shapes_of_rest.quality, pool);
  require_generic(degeneracy);
  Remaining_cells generic;
  if (degeneracy.area > 0) {
    // What would be found there means nothing: it is cut out, and lines end at its border.
    generic = remove_cells(*rest, degeneracy.cells);
    samples = chosen(samples, generic.point);
    rest = &generic.cells;
    degeneracy.cells.assign(generic.cell.size(), 0);
  }
  nudge_corners(surface, *rest, samples, pool);
  Extraction result = extract(surface, nullptr, *rest, std::move(samples), degeneracy, options);
  result.report.surface_points = cells.points.size();
  result.report.surface_cells = cells.number_of_cells();
  result.report.unknown_cells = cells.number_of_cells() - known_cells;
  result.report.degenerate_cells = known_cells - rest->number_of_cells();
  return result;
}

Extraction extract_extremal_mesh(const Function_3& f, const Lattice& lattice, const Extraction_options& options) {
  Surface_report surface;
  Extraction result = extract_extremal_mesh(f, make_implicit_cells(f, lattice, options, &surface), options);
  result.report.surface = surface;
  return result;
}

} // namespace CGAL::Extremal_mesh_3
