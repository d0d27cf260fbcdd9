// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A surface of fewer triangles, with its crest lines kept.
#include "extracted_femur.h"

#include <CGAL/Extremal_mesh_3/reduce.h>

#include <CGAL/Extremal_mesh_3/Formula.h>
#include <CGAL/Extremal_mesh_3/lines.h>
#include <CGAL/Extremal_mesh_3/segment.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>
#include <vector>

using namespace CGAL::Extremal_mesh_3;

namespace {

Extraction extracted(const std::string& formula, const Point& low, const Point& high) {
  Extraction_options options;
  options.patches = true;
  return extract_extremal_mesh(Formula(formula), make_lattice(low, high, 40), options);
}

const Extraction& ellipsoid() {
  static const Extraction result = extracted("x^2/9 + y^2/4 + z^2 - 1", {-4.1, -3.2, -2.3}, {4, 3, 2});
  return result;
}

const Extraction& torus() {
  static const Extraction result =
      extracted("(sqrt(x^2+1.3*y^2)-1)^2+z^2*(1+0.2*x)+0.03*y*z-0.16", {-1.6, -1.5, -0.7}, {1.6, 1.5, 0.7});
  return result;
}

/// with the default options, on three threads.
const Reduction& reduced_femur() {
  static const Reduction result = [] {
    Reduction_options options;
    options.threads = 3;
    return reduce(femur().mesh, femur().patches, options);
  }();
  return result;
}

double distance_to_segment(const Point& p, const Point& a, const Point& b) {
  double along = 0, length2 = 0, sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    along += (p[i] - a[i]) * (b[i] - a[i]);
    length2 += (b[i] - a[i]) * (b[i] - a[i]);
  }
  const double t = length2 > 0 ? std::clamp(along / length2, 0.0, 1.0) : 0;
  for (std::size_t i = 0; i < 3; ++i)
    sum += std::pow(p[i] - a[i] - t * (b[i] - a[i]), 2);
  return std::sqrt(sum);
}

/// the edges of the triangles; fails if one has more than two triangles, or two in the same direction.
std::set<std::array<std::uint32_t, 2>> edges_of(const Cell_patches& faces) {
  std::set<std::array<std::uint32_t, 2>> sides, edges;
  for (std::size_t i = 0; i < faces.corners.size(); ++i) {
    const std::uint32_t a = faces.corners[i], b = faces.corners[i % 3 == 2 ? i - 2 : i + 1];
    EXPECT_TRUE(sides.insert({a, b}).second);
    edges.insert({std::min(a, b), std::max(a, b)});
  }
  return edges;
}

} // namespace

TEST(Reduce, keeps_the_topology_and_has_no_more_triangles_than_asked_for) {
  for (const auto* given : {&ellipsoid(), &torus(), &femur()}) {
    const Reduction result = given == &femur() ? reduced_femur() : reduce(given->mesh, given->patches);
    EXPECT_LE(result.faces.cell.size(), result.faces_before / 10);
    EXPECT_EQ(result.euler_characteristic, result.euler_characteristic_before);
    EXPECT_EQ(result.euler_characteristic_before, given->mesh.surface().euler_characteristic);
    const auto edges = edges_of(result.faces);
    EXPECT_EQ(std::int64_t(result.faces.points.size()) - std::int64_t(edges.size()) +
                  std::int64_t(result.faces.cell.size()),
              result.euler_characteristic);
  }
}

TEST(Reduce, keeps_crest_lines_within_the_tolerance) {
  // that of the femur is a thousandth of its diagonal by default, which is about 1.13
  const std::vector<std::pair<const Extraction*, double>> cases{
      {&ellipsoid(), 0.0}, {&ellipsoid(), 0.01}, {&femur(), 0.00114}};
  for (const auto& [given, tolerance] : cases) {
    Reduction_options options;
    options.line_tolerance = tolerance;
    const Reduction result = given == &femur() ? reduced_femur() : reduce(given->mesh, given->patches, options);
    const auto edges = edges_of(result.faces);
    std::size_t segments = 0;
    for (const auto& line : result.lines)
      for (std::size_t i = 0; i + 1 < line.size(); ++i, ++segments)
        EXPECT_TRUE(edges.contains({std::min(line[i], line[i + 1]), std::max(line[i], line[i + 1])}));
    EXPECT_EQ(segments, result.segments);
    EXPECT_LE(result.segments, result.segments_before);
    if (tolerance > 0) {
      EXPECT_LT(result.segments, result.segments_before * 3 / 4);
    }
    EXPECT_LE(result.line_deviation, tolerance);
    // each point of a kept line is near to some segment that is left
    std::size_t kept = 0;
    for (std::size_t e = 0; e < given->mesh.number_of_edges(); ++e) {
      if (given->mesh.edge(e).type != Line_type::max_largest)
        continue;
      ++kept;
      for (const Point& p : given->mesh.edge(e).polyline) {
        double nearest = std::numeric_limits<double>::max();
        for (const auto& line : result.lines)
          for (std::size_t i = 0; i + 1 < line.size(); ++i)
            nearest = std::min(nearest,
                               distance_to_segment(p, result.faces.points[line[i]], result.faces.points[line[i + 1]]));
        EXPECT_LE(nearest, tolerance + 1e-12);
      }
    }
    EXPECT_EQ(kept, result.kept_edges);
  }
}

TEST(Reduce, stays_near_to_the_surface) {
  const Reduction result = reduce(ellipsoid().mesh, ellipsoid().patches);
  // 786 triangles on an area of 48.9 have sides of about 0.4, and the largest curvature is a/c² = 3: the sagitta of a circumcircle of radius
  // 0.4/√3 is 3·0.16/6
  EXPECT_LT(result.surface_deviation, 3 * 0.16 / 6);
  EXPECT_GT(result.surface_deviation, 0);
  for (const Point& p : result.faces.points)
    EXPECT_LT(std::abs(std::sqrt(p[0] * p[0] / 9 + p[1] * p[1] / 4 + p[2] * p[2]) - 1),
              result.surface_deviation + 0.005); // the given surface has polygons
}

TEST(Reduce, keeps_only_what_is_strong_enough) {
  Reduction_options options;
  options.keep_crest = std::numeric_limits<double>::infinity();
  const Reduction none = reduce(ellipsoid().mesh, ellipsoid().patches, options);
  EXPECT_EQ(none.kept_edges, 0U);
  EXPECT_TRUE(none.lines.empty());
  // of the torus's crest lines the strongest one
  const Extremal_mesh& mesh = torus().mesh;
  const std::vector<Extremal_line> lines = strongest_crest_lines(mesh, mesh.number_of_edges());
  ASSERT_GT(lines.size(), 1U);
  options.keep_crest = 0;
  for (const Half_edge h : lines[0].half_edges)
    options.keep_crest += mesh.edge(h / 2).strength;
  const Reduction some = reduce(mesh, torus().patches, options), all = reduce(mesh, torus().patches);
  EXPECT_GE(some.kept_edges, lines[0].half_edges.size());
  EXPECT_LT(some.kept_edges, all.kept_edges);
}

TEST(Reduce, gives_the_same_bits_again) {
  Reduction_options options;
  options.threads = 1;
  const Reduction one = reduce(torus().mesh, torus().patches, options);
  options.threads = 3;
  const Reduction three = reduce(torus().mesh, torus().patches, options);
  EXPECT_EQ(one.faces.points, three.faces.points);
  EXPECT_EQ(one.faces.corners, three.faces.corners);
  EXPECT_EQ(one.faces.cell, three.faces.cell);
}

TEST(Reduce, refuses_what_does_not_belong_together) {
  EXPECT_THROW(reduce(ellipsoid().mesh, torus().patches), std::invalid_argument);
  Cell_patches moved = ellipsoid().patches; // of the same areas
  for (Point& p : moved.points)
    p[0] += 1;
  EXPECT_THROW(reduce(ellipsoid().mesh, moved), std::invalid_argument);
  Reduction_options options;
  options.line_tolerance = -1;
  EXPECT_THROW(reduce(ellipsoid().mesh, ellipsoid().patches, options), std::invalid_argument);
  options = {};
  options.progress = [](double) { return false; };
  EXPECT_THROW(reduce(ellipsoid().mesh, ellipsoid().patches, options), Cancelled);
}
