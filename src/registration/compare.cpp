// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Extremal_mesh_3/compare.h>
#include <CGAL/Extremal_mesh_3/register.h>

#include "../cells/parallel.h"
#include "../cgal/Point_tree.h"
#include "../differential/vector.h"
#include "../queries/require.h"
#include "Segment_finder.h"
#include "corresponding_edges.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <optional>

namespace CGAL::Extremal_mesh_3 {

namespace {

/// A point that is looked for in the other mesh.
struct Probe {
  Point point{};
  Vector normal{};
  double weight = 1;
};

/// The share of weights, and the distances, of what was found.
struct Tally {
  double all = 0, matched = 0, sum = 0, squares = 0, by_chance = 0;

  void add(double weight, std::optional<double> distance) {
    all += weight;
    if (distance) {
      matched += weight;
      sum += weight * *distance;
      squares += weight * *distance * *distance;
    }
  }
  double share() const { return all > 0 ? matched / all : 0; }
  double mean_square() const { return matched > 0 ? squares / matched : 0; }
  double variance() const {
    const double mean = matched > 0 ? sum / matched : 0;
    return std::max(0.0, mean_square() - mean * mean);
  }
};

/// the distance to the nearest of a kind, if it is within the tolerance.
using Lookup = std::function<std::optional<double>(const Point&)>;

/// One way of comparison: which part of one mesh is found in another one.
class Search {
public:
  Search(const Extremal_mesh& to, const Similarity& motion, double tolerance, Thread_pool& threads)
      : to_(to), lines_(to, std::nullopt), motion_(motion), tolerance_(tolerance), threads_(threads) {}

  Tally operator()(const std::vector<Probe>& probes, const Lookup& lookup) const {
    std::vector<std::optional<double>> distances(probes.size());
    std::vector<double> by_chance(probes.size());
    threads_.for_each(probes.size(), 64, [&](std::size_t i) {
      distances[i] = lookup(motion_(probes[i].point));
      for (std::size_t k = 0; k < displacements; ++k)
        by_chance[i] += lookup(displaced(probes[i], i, k)).has_value() ? 1.0 / displacements : 0;
    });
    Tally tally;
    for (std::size_t i = 0; i < probes.size(); ++i) {
      tally.add(probes[i].weight, distances[i]);
      tally.by_chance += probes[i].weight * by_chance[i];
    }
    return tally;
  }

private:
  static constexpr std::size_t displacements = 4;

  /// another point of the second surface, a few tolerances beside the moved one.
  Point displaced(const Probe& probe, std::size_t i, std::size_t k) const {
    const Vector n = motion_.turned(probe.normal), u = any_orthogonal(n), v = cross(n, u);
    // angles by the golden ratio, which are spread evenly wherever one begins
    const double angle = 2.399963229728653 * double(i) + 2 * std::numbers::pi * double(k) / displacements;
    const double length = (3 + double(k)) * tolerance_;
    const Point p = motion_(probe.point) + length * std::cos(angle) * u + length * std::sin(angle) * v;
    const auto near = lines_.nearest(p, 10 * tolerance_);
    if (!near)
      return p;
    const Extremal_mesh_edge& e = to_.edge(near->edge);
    const Vector& normal = e.normals[near->segment];
    return p - dot(p - e.polyline[near->segment], normal) * normal;
  }

  const Extremal_mesh& to_;
  Segment_finder lines_;
  Similarity motion_;
  double tolerance_;
  Thread_pool& threads_;
};

/// pieces of the lines of a type, not longer than half the tolerance.
std::vector<Probe> probes_of(const Extremal_mesh& mesh, Line_type type, double tolerance, std::size_t& segments) {
  std::vector<Probe> probes;
  for (std::size_t i = 0; i < mesh.number_of_edges(); ++i) {
    const Extremal_mesh_edge& e = mesh.edge(i);
    for (std::size_t s = 0; s + 1 < e.polyline.size(); ++s) {
      if (e.segment_types[s] != type)
        continue;
      ++segments;
      const Vector step = e.polyline[s + 1] - e.polyline[s];
      const double length = norm(step);
      const auto parts = std::max<std::size_t>(1, std::size_t(std::ceil(length / (0.5 * tolerance))));
      for (std::size_t part = 0; part < parts; ++part)
        probes.push_back(
            {e.polyline[s] + (double(part) + 0.5) / double(parts) * step, e.normals[s], length / double(parts)});
    }
  }
  return probes;
}

struct Vertex_class {
  const char* name;
  Vertex_kind kind;
  int ridges; ///< 0: any
};
constexpr std::array<Vertex_class, 5> vertex_classes{{{"extremal_point", Vertex_kind::extremal_point, 0},
                                                      {"umbilic", Vertex_kind::umbilic, 0},
                                                      {"umbilic_1_ridge", Vertex_kind::umbilic, 1},
                                                      {"umbilic_3_ridge", Vertex_kind::umbilic, 3},
                                                      {"non_generic", Vertex_kind::non_generic, 0}}};

std::vector<Probe> probes_of(const Extremal_mesh& mesh, const Vertex_class& c) {
  std::vector<Probe> probes;
  for (std::size_t v = 0; v < mesh.number_of_vertices(); ++v) {
    const Extremal_mesh_vertex& x = mesh.vertex(v);
    if (x.kind == c.kind && (c.ridges == 0 || x.ridges == c.ridges)) {
      require_finite(x.point);
      probes.push_back({x.point, x.normal, 1});
    }
  }
  return probes;
}

Lookup lookup_of(const std::vector<Probe>& probes, double tolerance) {
  std::vector<Point> points;
  for (const Probe& p : probes)
    points.push_back(p.point);
  return [tree = std::make_shared<Point_tree<3>>(points), tolerance](const Point& p) -> std::optional<double> {
    const auto near = tree->nearest(p, 1, tolerance);
    return near.empty() ? std::nullopt : std::optional(near.front().distance);
  };
}

Lookup lookup_of(const Extremal_mesh& mesh, Line_type type, double tolerance) {
  return [finder = std::make_shared<Segment_finder>(mesh, type), tolerance](const Point& p) -> std::optional<double> {
    const auto near = finder->nearest(p, tolerance);
    return near ? std::optional(near->distance) : std::nullopt;
  };
}

Comparison_row row_of(std::string type, const Tally& there, const Tally& back) {
  Comparison_row row;
  row.type = std::move(type);
  row.matched = there.share();
  row.matched_back = back.share();
  row.chance = there.all > 0 ? there.by_chance / there.all : 0;
  row.deviation = std::sqrt(there.variance());
  row.rms = std::sqrt(there.mean_square());
  return row;
}

} // namespace

Comparison compare_extremal_meshes(const Extremal_mesh& a, const Extremal_mesh& b, const Comparison_options& options) {
  if (!(options.tolerance >= 0) || std::isinf(options.tolerance))
    throw std::invalid_argument(fmt::format("the tolerance is {}, not a positive length or 0", options.tolerance));
  Comparison result;
  result.tolerance = options.tolerance > 0 ? options.tolerance : default_tolerance(a, b);
  Thread_pool threads(options.threads);
  const Similarity back = options.transform.inverse();
  // Back home lengths are those of the first mesh.
  const double tolerance_b = result.tolerance, tolerance_a = tolerance_b * back.scale;
  const Search there(b, options.transform, tolerance_b, threads), home(a, back, tolerance_a, threads);
  for (const Line_type type :
       {Line_type::max_largest, Line_type::min_largest, Line_type::max_second, Line_type::min_second}) {
    std::size_t segments_a = 0, segments_b = 0;
    const std::vector<Probe> of_a = probes_of(a, type, tolerance_a, segments_a),
                             of_b = probes_of(b, type, tolerance_b, segments_b);
    Comparison_row row = row_of(std::string(to_string(type)), there(of_a, lookup_of(b, type, tolerance_b)),
                                home(of_b, lookup_of(a, type, tolerance_a)));
    row.number_a = segments_a;
    row.number_b = segments_b;
    result.rows.push_back(std::move(row));
  }
  for (const Vertex_class& c : vertex_classes) {
    const std::vector<Probe> of_a = probes_of(a, c), of_b = probes_of(b, c);
    Comparison_row row =
        row_of(c.name, there(of_a, lookup_of(of_b, tolerance_b)), home(of_b, lookup_of(of_a, tolerance_a)));
    row.number_a = of_a.size();
    row.number_b = of_b.size();
    result.rows.push_back(std::move(row));
  }
  const Correspondence forth = corresponding_edges_and_cells(a, b, options.transform, tolerance_b, threads),
                       again = corresponding_edges_and_cells(b, a, back, tolerance_a, threads);
  result.edges = forth.edges;
  result.cells = forth.cells;
  result.area_of_cells = forth.area_of_cells;
  result.edges_back = again.edges;
  result.cells_back = again.cells;
  return result;
}

} // namespace CGAL::Extremal_mesh_3
