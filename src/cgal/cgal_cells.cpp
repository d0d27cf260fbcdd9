// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Based on CGAL's Surface_mesher: Boissonnat and Oudot, Provably good sampling and meshing of surfaces, 2005. With CGAL 6, which
// no longer has it, only this file is to be written anew, on Mesh_3.
#include <CGAL/Extremal_mesh_3/errors.h>
#include <CGAL/Extremal_mesh_3/extract_extremal_mesh.h>
#include <CGAL/Extremal_mesh_3/make_cgal_cells.h>
#include <CGAL/Extremal_mesh_3/project_onto.h>

#include "../cells/Union_find.h"
#include "../cells/spread_points.h"
#include "../cells/surface_points.h"
#include "../differential/vector.h"

#include <CGAL/Complex_2_in_triangulation_3.h>
#include <CGAL/Surface_mesh_default_criteria_3.h>
#include <CGAL/Surface_mesh_default_triangulation_3.h>
#include <CGAL/exceptions.h>
#include <CGAL/make_surface_mesh.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <optional>
#include <stdexcept>

namespace CGAL::Extremal_mesh_3 {

namespace {

/// Handles of elements with a time stamp are ordered by it, others by address: the order of refinement, and so the
/// result, would differ between calls.
template <class Base> class Time_stamped : public Base {
public:
  template <class Tds> struct Rebind_TDS {
    using Other = Time_stamped<typename Base::template Rebind_TDS<Tds>::Other>;
  };
  using Base::Base;
  using Has_timestamp = CGAL::Tag_true;
  std::size_t time_stamp() const { return stamp_; }
  void set_time_stamp(const std::size_t& stamp) { stamp_ = stamp; }

private:
  std::size_t stamp_ = std::size_t(-1);
};

// CGAL's Surface_mesh_default_triangulation_3, with time stamps.
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Traits = CGAL::Robust_circumcenter_traits_3<Kernel>;
using Vertex_base = Time_stamped<CGAL::Surface_mesh_vertex_base_3<Traits>>;
using Cell_base = Time_stamped<
    CGAL::Delaunay_triangulation_cell_base_with_circumcenter_3<Traits, CGAL::Surface_mesh_cell_base_3<Traits>>>;
using Triangulation =
    CGAL::Delaunay_triangulation_3<Traits, CGAL::Triangulation_data_structure_3<Vertex_base, Cell_base>>;
using Restricted = CGAL::Complex_2_in_triangulation_3<Triangulation>;

Point to_point(const Kernel::Point_3& p) {
  return {p.x(), p.y(), p.z()};
}
Kernel::Point_3 to_cgal(const Point& p) {
  return {p[0], p[1], p[2]};
}

/// The surface in the box of a lattice, and what is to be watched while it is meshed.
class Bounded_surface {
public:
  Bounded_surface(const Function_3& f, const Lattice& lattice, const Triangulation& triangulation,
                  std::size_t expected_points, std::size_t max_points, const Progress& progress)
      : f_(f), lattice_(lattice), triangulation_(triangulation), expected_points_(expected_points),
        max_points_(max_points), progress_(progress) {
    const auto& s = lattice.step;
    const double volume = dot(s[0], cross(s[1], s[2]));
    for (std::size_t a = 0; a < 3; ++a)
      coordinate_[a] = (1 / volume) * cross(s[(a + 1) % 3], s[(a + 2) % 3]);
  }

  /// a point of the surface on p + t·direction, low ≤ t ≤ high, if the function has different signs at the ends of the
  /// part within the box.
  std::optional<Kernel::Point_3> intersection(const Point& p, const Vector& direction, double low, double high) const {
    watch();
    for (std::size_t a = 0; a < 3; ++a) {
      const double from = dot(coordinate_[a], p - lattice_.origin), slope = dot(coordinate_[a], direction),
                   size = double(lattice_.size[a] - 1);
      if (slope != 0) {
        low = std::max(low, (slope > 0 ? -from : size - from) / slope);
        high = std::min(high, (slope > 0 ? size - from : -from) / slope);
      } else if (from < 0 || from > size) {
        return std::nullopt;
      }
    }
    if (!(low < high))
      return std::nullopt;
    const Point a = p + low * direction, b = p + high * direction;
    const double value_a = f_.value(a), value_b = f_.value(b);
    if (!std::isfinite(value_a) || !std::isfinite(value_b) || (value_a >= 0) == (value_b >= 0))
      return std::nullopt;
    return to_cgal(a + root_on_edge(f_, a, b - a, value_a, value_b) * (b - a));
  }

private:
  void watch() const {
    const std::size_t points = triangulation_.number_of_vertices();
    if (points > max_points_)
      throw Extraction_error(
          fmt::format("CGAL's mesher does not come to an end: it has made {} points, where {} were to be expected. The "
                      "surface may be singular or touch the box, the angle be too large, or max_points too small",
                      points, expected_points_));
    if (progress_ && points >= reported_ + 1000) {
      reported_ = points;
      if (!progress_(std::min(0.99, double(points) / double(expected_points_))))
        throw Cancelled();
    }
  }

  const Function_3& f_;
  const Lattice& lattice_;
  const Triangulation& triangulation_;
  std::size_t expected_points_, max_points_;
  mutable std::size_t reported_ = 0;
  const Progress& progress_;
  std::array<Vector, 3> coordinate_; ///< gradients of the lattice's coordinates
};

/// Model of CGAL's concept SurfaceMeshTraits_3. Its Implicit_surface_oracle_3 meshes in a ball instead of a box, and bisects.
struct Surface_traits {
  using Surface_3 = Bounded_surface;
  using Intersection_point = Kernel::Point_3;

  struct Intersect_3 {
    template <class Linear> CGAL::Object operator()(const Surface_3& surface, const Linear& dual) const {
      constexpr double infinity = std::numeric_limits<double>::infinity();
      constexpr bool is_segment = std::is_same_v<Linear, Kernel::Segment_3>,
                     is_line = std::is_same_v<Linear, Kernel::Line_3>;
      const Point p = to_point(dual.point(0)), q = to_point(dual.point(1));
      const auto found = surface.intersection(p, q - p, is_line ? -infinity : 0, is_segment ? 1 : infinity);
      return found ? CGAL::make_object(*found) : CGAL::Object();
    }
  };
  /// The triangulation has its initial points already.
  struct Construct_initial_points {
    template <class Output> Output operator()(const Surface_3&, Output out, int) const { return out; }
  };
  Intersect_3 intersect_3_object() const { return {}; }
  Construct_initial_points construct_initial_points_object() const { return {}; }
};

/// CGAL prints errors before it throws them, through a handler that all the program has in common.
class Quiet_errors {
public:
  Quiet_errors()
      : handler_(CGAL::set_error_handler([](const char*, const char*, const char*, int, const char*) {})),
        behaviour_(CGAL::set_error_behaviour(CGAL::THROW_EXCEPTION)) {}
  ~Quiet_errors() {
    CGAL::set_error_handler(handler_);
    CGAL::set_error_behaviour(behaviour_);
  }
  Quiet_errors(const Quiet_errors&) = delete;
  Quiet_errors& operator=(const Quiet_errors&) = delete;

  static std::mutex& one_at_a_time() {
    static std::mutex mutex;
    return mutex;
  }

private:
  std::lock_guard<std::mutex> lock_{one_at_a_time()};
  CGAL::Failure_function handler_;
  CGAL::Failure_behaviour behaviour_;
};

/// Triangles between vertices of the triangulation, which are numbered in the order of their insertion.
struct Triangles {
  std::vector<Point> points;
  std::vector<std::uint32_t> corners;
  std::vector<std::uint32_t> number; ///< by time stamp
};

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

Triangles triangles_of(const Restricted& restricted, const Function_3& f) {
  const Triangulation& triangulation = restricted.triangulation();
  std::vector<Triangulation::Vertex_handle> of_stamp;
  for (auto v = triangulation.finite_vertices_begin(); v != triangulation.finite_vertices_end(); ++v) {
    of_stamp.resize(std::max(of_stamp.size(), v->time_stamp() + 1));
    of_stamp[v->time_stamp()] = v;
  }
  Triangles result;
  result.number.assign(of_stamp.size(), none);
  std::vector<std::size_t> stamps;
  for (auto facet = triangulation.finite_facets_begin(); facet != triangulation.finite_facets_end(); ++facet) {
    const auto [cell, opposite] = *facet;
    if (!cell->is_facet_on_surface(opposite))
      continue;
    std::array<Triangulation::Vertex_handle, 3> v;
    for (int i = 0; i < 3; ++i)
      v[std::size_t(i)] = cell->vertex(triangulation.vertex_triple_index(opposite, i));
    const Point a = to_point(v[0]->point()), b = to_point(v[1]->point()), c = to_point(v[2]->point());
    Derivatives d;
    f.derivatives(to_point(cell->get_facet_surface_center(opposite)), 1, d);
    if (dot(cross(b - a, c - a), d.gradient) < 0)
      std::swap(v[1], v[2]);
    for (const auto& vertex : v) {
      stamps.push_back(vertex->time_stamp());
      result.number[stamps.back()] = 0;
    }
  }
  for (std::size_t s = 0; s < of_stamp.size(); ++s)
    if (result.number[s] != none) {
      result.number[s] = std::uint32_t(result.points.size());
      result.points.push_back(to_point(of_stamp[s]->point()));
    }
  for (const std::size_t s : stamps)
    result.corners.push_back(result.number[s]);
  return result;
}

/// checks that each component found on the lattice is there, and none are joined.
void check_components(const Triangles& triangles,
                      const std::vector<std::vector<Triangulation::Vertex_handle>>& initial) {
  Union_find sets(triangles.points.size());
  for (std::size_t i = 0; i < triangles.corners.size(); i += 3) {
    sets.unite(triangles.corners[i], triangles.corners[i + 1]);
    sets.unite(triangles.corners[i], triangles.corners[i + 2]);
  }
  std::vector<std::size_t> component(triangles.points.size(), initial.size());
  for (std::size_t c = 0; c < initial.size(); ++c) {
    bool found = false;
    for (const auto& v : initial[c]) {
      const std::uint32_t point = triangles.number[v->time_stamp()];
      if (point == none)
        continue;
      found = true;
      std::size_t& here = component[sets.find(point)];
      if (here == initial.size())
        here = c;
      if (here != c)
        throw Extraction_error(
            fmt::format("the triangles are too large: they join the component of the surface through "
                        "({}, {}, {}) with another. A smaller radius is needed",
                        v->point().x(), v->point().y(), v->point().z()));
    }
    if (!found)
      throw Extraction_error(
          fmt::format("the triangles are too large: the component of the surface through ({}, {}, {}) "
                      "has none. A smaller radius is needed",
                      initial[c][0]->point().x(), initial[c][0]->point().y(), initial[c][0]->point().z()));
  }
}

/// the options with their defaults filled in.
Cgal_mesh_options completed(Cgal_mesh_options options, const Lattice& lattice) {
  const auto require = [](bool holds, const char* name, double value, const char* range) {
    if (!holds)
      throw std::invalid_argument(fmt::format("{} is {}, not {}", name, value, range));
  };
  require(options.angle >= 0 && options.angle < 60, "angle", options.angle, "in [0, 60) degrees");
  require(options.radius >= 0 && std::isfinite(options.radius), "radius", options.radius, "0 or a length");
  require(options.distance >= 0 && std::isfinite(options.distance), "distance", options.distance, "0 or a length");
  if (options.radius == 0)
    options.radius = std::max({norm(lattice.step[0]), norm(lattice.step[1]), norm(lattice.step[2])});
  if (options.distance == 0)
    options.distance = options.radius / 10;
  return options;
}

double area(const Cell_complex& cells) {
  double sum = 0;
  for (std::size_t c = 0; c < cells.number_of_cells(); ++c) {
    const Point& origin = cells.points[cells.source(cells.half_edges[cells.cell_begin[c]])];
    Vector twice{};
    for (std::size_t i = cells.cell_begin[c]; i < cells.cell_begin[c + 1]; ++i)
      twice = twice + cross(cells.points[cells.source(cells.half_edges[i])] - origin,
                            cells.points[cells.target(cells.half_edges[i])] - origin);
    sum += norm(twice) / 2;
  }
  return sum;
}

} // namespace

Cell_complex make_cgal_cells(const Function_3& f, const Lattice& lattice, const Cgal_mesh_options& given) {
  const Cgal_mesh_options options = completed(given, lattice);
  Extraction_options lattice_options;
  lattice_options.threads = options.threads;
  const Cell_complex on_lattice = make_implicit_cells(f, lattice, lattice_options);
  const bool closed = std::none_of(on_lattice.edge_cells.begin(), on_lattice.edge_cells.end(), [](const auto& c) {
    return c[0] == Cell_complex::no_cell || c[1] == Cell_complex::no_cell;
  });
  // An equilateral triangle in a circle of radius r has the area 1.3 r²; there are half as many points as triangles.
  const auto expected = std::size_t(area(on_lattice) / (2 * 1.3 * options.radius * options.radius)) + 1000;

  const Quiet_errors quiet;
  Triangulation triangulation;
  // As many as CGAL takes of a surface of one component.
  constexpr std::size_t initial_points = 20;
  std::vector<std::vector<Triangulation::Vertex_handle>> initial;
  for (const std::vector<std::uint32_t>& component : spread_points(on_lattice, initial_points)) {
    initial.emplace_back();
    for (const std::uint32_t p : component)
      initial.back().push_back(triangulation.insert(to_cgal(on_lattice.points[p])));
  }
  const Bounded_surface surface(f, lattice, triangulation, expected,
                                options.max_points ? options.max_points : 100 * expected, options.progress);
  const CGAL::Surface_mesh_default_criteria_3<Triangulation> criteria(options.angle, options.radius, options.distance);
  Restricted restricted(triangulation);
  try {
    if (closed)
      CGAL::make_surface_mesh(restricted, surface, Surface_traits(), criteria, CGAL::Manifold_tag());
    else
      CGAL::make_surface_mesh(restricted, surface, Surface_traits(), criteria, CGAL::Manifold_with_boundary_tag());
  } catch (const CGAL::Failure_exception& error) {
    throw Extraction_error("CGAL's mesher failed: " + error.message());
  }

  Triangles triangles = triangles_of(restricted, f);
  check_components(triangles, initial);
  std::vector<std::size_t> begin(triangles.corners.size() / 3 + 1);
  for (std::size_t i = 0; i < begin.size(); ++i)
    begin[i] = 3 * i;
  try {
    return project_onto(f, make_cell_complex(std::move(triangles.points), begin, triangles.corners), options.threads);
  } catch (const std::invalid_argument& error) {
    throw Extraction_error(
        fmt::format("the triangles are too large: they do not follow the surface ({}). A smaller radius or "
                    "distance is needed",
                    error.what()));
  }
}

} // namespace CGAL::Extremal_mesh_3
