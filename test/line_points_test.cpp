// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The polylines of the lines: their points lie on the lines, the lines are as near to them as asked for, and types change
// where they do. What is true is found from the function alone, by bisection for the sign of E_g.
#include <CGAL/Extremal_mesh_3/Formula.h>
#include <CGAL/Extremal_mesh_3/cell_patches.h>
#include <CGAL/Extremal_mesh_3/fit_vertex_shapes.h>
#include <CGAL/Extremal_mesh_3/read_mesh.h>
#include <CGAL/Extremal_mesh_3/simplify.h>

#include "dense_search.h"
#include "generic_surfaces.h"
#include "graph_comparison.h"
#include "random_surfaces.h"
#include "same_mesh.h"

#include <map>
#include <set>

using namespace CGAL::Extremal_mesh_3;
using dense_search::Place;
using dense_search::place_near;
using surfaces::along;
using surfaces::cross;
using surfaces::distance;
using surfaces::dot;
using surfaces::unit;

namespace {

Vector difference(const Point& a, const Point& b) {
  return along(a, -1, b);
}

/// A surface and its extremal mesh.
struct Case {
  const Function_3& f;
  double size; ///< of the surface
  Extremal_mesh mesh;
};

/// across the line at a point of its polyline, to the left.
Vector to_the_left(const Extremal_mesh_edge& edge, std::size_t point) {
  const std::size_t last = edge.polyline.size() - 1;
  const Vector tangent =
      difference(edge.polyline[std::min(point + 1, last)], edge.polyline[point == 0 ? 0 : point - 1]);
  return unit(cross(edge.normals[point], tangent));
}

/// how much e of the family has of both: 0 on its lines.
double share(const Place& place, int family) {
  const Principal_quantities q = principal_quantities(place.shape);
  return std::abs(family == 1 ? q.e1 : q.e2) / std::hypot(q.e1, q.e2);
}

/// A point is within 1e-9 of the size of the line if there E_g has one sign on one side and the other on the other: that, and
/// not the value of e, which has another scale everywhere, is what tells where the line is.
void expect_points_on_lines(const Case& c) {
  for (std::size_t e = 0; e < c.mesh.number_of_edges(); ++e) {
    const Extremal_mesh_edge& edge = c.mesh.edge(e);
    for (std::size_t i = 1; i + 1 < edge.polyline.size(); ++i) { // vertices have tests of their own
      const Point& p = edge.polyline[i];
      const auto here = place_near(c.f, p);
      ASSERT_TRUE(here);
      ASSERT_LT(distance(here->p, p), 1e-9 * c.size) << "edge " << e << " point " << i;
      ASSERT_LT(share(*here, edge.family), 1e-2) << "edge " << e << " point " << i;
      const Vector left = to_the_left(edge, i);
      const auto a = place_near(c.f, along(p, 1e-9 * c.size, left)),
                 b = place_near(c.f, along(p, -1e-9 * c.size, left));
      ASSERT_TRUE(a && b);
      ASSERT_LT(a->shape.Phi().imag() * b->shape.Phi().imag(), 0) << "edge " << e << " point " << i;
    }
  }
}

double distance_from_segment(const Point& p, const Point& a, const Point& b) {
  const Vector ab = difference(b, a);
  const double t = std::clamp(dot(difference(p, a), ab) / dot(ab, ab), 0.0, 1.0);
  return distance(p, along(a, t, ab));
}

/// the greatest distance of a point of the lines from its polyline, of many, but for those beside vertices, where other lines
/// are as near.
double chord_error(const Case& c, double tolerance) {
  double greatest = 0;
  for (std::size_t e = 0; e < c.mesh.number_of_edges(); ++e) {
    const Extremal_mesh_edge& edge = c.mesh.edge(e);
    const int sign = c.mesh.cell(edge.left_cell).sign;
    for (std::size_t i = 0; i + 1 < edge.polyline.size(); ++i)
      for (int k = 1; k < 8; ++k) {
        const Point &a = edge.polyline[i], &b = edge.polyline[i + 1];
        const Point x = along(a, k / 8.0, difference(b, a));
        if (std::min(distance(x, edge.polyline.front()), distance(x, edge.polyline.back())) < 6 * tolerance)
          continue;
        const Vector left = unit(cross(edge.normals[i], difference(b, a)));
        const auto on_left = [&](double offset) {
          const auto place = place_near(c.f, along(x, offset, left));
          return place && sign * place->shape.Phi().imag() > 0;
        };
        // The line is on the right of points on the left, and the other way round.
        const double direction = on_left(0) ? -1 : 1;
        double inside = 0, outside = 0;
        while (on_left(outside) == on_left(0) && std::abs(outside) < 4 * tolerance) {
          inside = outside;
          outside += direction * tolerance / 4;
        }
        for (int j = 0; j < 40; ++j)
          (on_left((inside + outside) / 2) == on_left(0) ? inside : outside) = (inside + outside) / 2;
        const auto found = place_near(c.f, along(x, inside, left));
        if (!found)
          return std::numeric_limits<double>::infinity();
        greatest = std::max(greatest, distance_from_segment(found->p, a, b));
      }
  }
  return greatest;
}

Line_type true_type(const Function_3& f, const Place& place, int family) {
  Derivatives d;
  f.derivatives(place.p, 4, d);
  const Principal_quantities q = principal_quantities(place.shape);
  return line_type(q.k1, q.k2, family, extremality_derivative(d, place.shape, family));
}

/// what vanishes at a type change, and how large it may be.
std::pair<double, double> vanishing(const Function_3& f, const Place& place, int family, Type_change_kind kind,
                                    double size) {
  Derivatives d;
  f.derivatives(place.p, 4, d);
  const Principal_quantities q = principal_quantities(place.shape);
  // Over the size curvatures change by about themselves, and points are off by 1e-9 of it at most.
  const double k = std::max(std::abs(q.k1), std::abs(q.k2)), e = std::hypot(q.e1, q.e2);
  if (kind == Type_change_kind::turning_point)
    return {extremality_derivative(d, place.shape, family), 1e-7 * (k * k * k + k * e + e / size)};
  const double k_i = family == 1 ? q.k1 : q.k2;
  return {kind == Type_change_kind::equal_curvatures ? q.k1 + q.k2 : k_i, 1e-9 * (k + e * size)};
}

void expect_types_change_where_they_do(const Case& c) {
  for (std::size_t e = 0; e < c.mesh.number_of_edges(); ++e) {
    const Extremal_mesh_edge& edge = c.mesh.edge(e);
    std::set<std::size_t> changes;
    for (const Type_change& change : edge.type_changes) {
      changes.insert(change.point);
      const auto place = place_near(c.f, edge.polyline[change.point]);
      ASSERT_TRUE(place);
      const auto [value, rounding] = vanishing(c.f, *place, edge.family, change.kind, c.size);
      EXPECT_LT(std::abs(value), rounding) << "edge " << e << " " << to_string(change.kind);
    }
    for (std::size_t i = 1; i + 1 < edge.polyline.size(); ++i) {
      if (changes.count(i) != 0)
        continue;
      const auto place = place_near(c.f, edge.polyline[i]);
      ASSERT_TRUE(place);
      const Line_type type = true_type(c.f, *place, edge.family);
      EXPECT_EQ(edge.segment_types[i - 1], type) << "edge " << e << " point " << i;
      EXPECT_EQ(edge.segment_types[i], type) << "edge " << e << " point " << i;
    }
  }
}

std::map<Type_change_kind, std::vector<Point>> type_changes(const Extremal_mesh& mesh) {
  std::map<Type_change_kind, std::vector<Point>> points;
  for (std::size_t e = 0; e < mesh.number_of_edges(); ++e)
    for (const Type_change& change : mesh.edge(e).type_changes)
      points[change.kind].push_back(mesh.edge(e).polyline[change.point]);
  return points;
}

void expect_same_type_changes(const Extremal_mesh& a, const Extremal_mesh& b, double size) {
  auto of_a = type_changes(a), of_b = type_changes(b);
  for (const auto kind :
       {Type_change_kind::turning_point, Type_change_kind::equal_curvatures, Type_change_kind::parabolic_point}) {
    const auto off = graph_comparison::largest_distance(of_a[kind], of_b[kind]);
    ASSERT_TRUE(off) << to_string(kind) << ": " << of_a[kind].size() << " and " << of_b[kind].size();
    EXPECT_LT(*off, 1e-8 * size) << to_string(kind);
  }
}

std::size_t number_of_points(const Extremal_mesh& mesh) {
  std::size_t n = 0;
  for (std::size_t e = 0; e < mesh.number_of_edges(); ++e)
    n += mesh.edge(e).polyline.size();
  return n;
}

class Line_points : public testing::TestWithParam<generic_surfaces::Surface> {
protected:
  const Formula f{GetParam().formula};
  const double size = 2 * GetParam().half_size;

  Extraction extract(std::size_t resolution, double tolerance = 0, int threads = 0) const {
    Extraction_options options;
    options.line_tolerance = tolerance;
    options.threads = threads;
    options.patches = true;
    return extract_extremal_mesh(f, surfaces::lattice_around(f, GetParam().box(), resolution), options);
  }
};

} // namespace

TEST_P(Line_points, lie_on_the_surface_and_on_the_line) {
  for (const double tolerance : {0.0, 1e-4})
    expect_points_on_lines({f, size, extract(32, tolerance * size).mesh});
}

TEST_P(Line_points, are_as_near_to_the_line_as_asked_for) {
  std::size_t last = 0;
  for (const double part : {1e-3, 1e-4}) {
    const double tolerance = part * size;
    const Extraction extraction = extract(24, tolerance);
    if (extraction.report.uncertain_cells == 0) {
      EXPECT_EQ(extraction.report.straight_segments, 0U);
    }
    EXPECT_LE(chord_error({f, size, extraction.mesh}, tolerance), tolerance);
    // The error falls with the square of the distance of the points, so a tenth of the tolerance takes three times as many.
    const std::size_t points = number_of_points(extraction.mesh);
    EXPECT_GE(points, last);
    if (last > 0) {
      EXPECT_LT(points, 5 * last);
    }
    last = points;
  }
}

TEST_P(Line_points, are_where_types_change) {
  for (const double tolerance : {0.0, 1e-5}) {
    const Extraction extraction = extract(32, tolerance * size);
    if (extraction.report.uncertain_cells == 0) {
      EXPECT_EQ(extraction.report.straight_segments, 0U);
    }
    surfaces::expect_all_checks_hold(extraction.mesh);
    expect_types_change_where_they_do({f, size, extraction.mesh});
  }
}

TEST_P(Line_points, have_the_same_type_changes_at_every_resolution) {
  const Extremal_mesh mesh = extract(32).mesh;
  for (const std::size_t resolution : {24U, 64U})
    expect_same_type_changes(mesh, extract(resolution).mesh, size);
  expect_same_type_changes(mesh, extract(32, 1e-5 * size).mesh, size);
}

TEST_P(Line_points, do_not_depend_on_threads) {
  const Extraction one = extract(24, 1e-4 * size, 1), four = extract(24, 1e-4 * size, 4);
  same_mesh::expect_same(one.mesh, four.mesh);
  EXPECT_EQ(one.patches.points, four.patches.points);
  EXPECT_EQ(one.patches.corners, four.patches.corners);
}

TEST_P(Line_points, change_areas_by_the_error_of_the_polygons_only) {
  const Extraction coarse = extract(40), fine = extract(40, 1e-5 * size);
  ASSERT_EQ(coarse.mesh.number_of_cells(), fine.mesh.number_of_cells());
  const double area = coarse.mesh.surface().area;
  // Polygons lie inside a bent surface by about the square of their size over its radius: on the tube of the torus, of
  // five polygons in radius, by some 1e-3 of the area. More corners take some of that away.
  EXPECT_NEAR(fine.mesh.surface().area, area, 1e-3 * area);
  for (std::size_t i = 0; i < coarse.mesh.number_of_cells(); ++i)
    EXPECT_NEAR(fine.mesh.cell(i).area, coarse.mesh.cell(i).area, 2e-3 * area) << i;
}

INSTANTIATE_TEST_SUITE_P(Algebraic, Line_points, testing::ValuesIn(generic_surfaces::all_surfaces),
                         [](const auto& info) { return info.param.name; });

namespace {

class Line_points_of_random_surfaces : public testing::TestWithParam<unsigned> {};

} // namespace

TEST_P(Line_points_of_random_surfaces, lie_on_the_lines_and_where_types_change) {
  SCOPED_TRACE("seed " + std::to_string(GetParam()));
  const auto f = random_surfaces::ellipsoid(GetParam());
  const surfaces::Box box = random_surfaces::box_of(f);
  Extraction_options options;
  options.line_tolerance = 1e-4 * box.size();
  const Extraction extraction = extract_extremal_mesh(f, make_lattice(box.low, box.high, 32), options);
  if (extraction.report.uncertain_cells == 0) {
    EXPECT_EQ(extraction.report.straight_segments, 0U);
    EXPECT_LE(chord_error({f, box.size(), extraction.mesh}, options.line_tolerance), options.line_tolerance);
    const Extraction fine = extract_extremal_mesh(f, make_lattice(box.low, box.high, 60));
    if (fine.report.uncertain_cells == 0)
      expect_same_type_changes(extraction.mesh, fine.mesh, box.size());
  }
  expect_points_on_lines({f, box.size(), extraction.mesh});
  expect_types_change_where_they_do({f, box.size(), extraction.mesh});
  surfaces::expect_all_checks_hold(extraction.mesh);
}

INSTANTIATE_TEST_SUITE_P(Perturbed_ellipsoids, Line_points_of_random_surfaces, testing::Range(1U, 13U));

TEST(Type_changes, are_carried_along_by_simplification) {
  const generic_surfaces::Surface& surface = generic_surfaces::all_surfaces[2];
  const Formula f(surface.formula);
  const Simplification simplification(extract_extremal_mesh(f, surfaces::lattice_around(f, surface.box(), 32)).mesh);
  const auto given = type_changes(simplification.mesh_at(0));
  for (std::size_t level = 0; level < simplification.number_of_levels(); level += 5) {
    const Extremal_mesh mesh = simplification.mesh_at(level);
    surfaces::expect_all_checks_hold(mesh);
    for (const auto& [kind, points] : type_changes(mesh)) {
      if (kind == Type_change_kind::former_vertex)
        continue;
      const std::set<Point> known(given.at(kind).begin(), given.at(kind).end());
      for (const Point& p : points)
        EXPECT_TRUE(known.count(p)) << to_string(kind) << " on level " << level;
    }
  }
}

TEST(Type_changes, are_found_on_the_lines_of_a_mesh) {
  const Mesh femur = read_mesh(EXTREMAL_MESH_3_DATA_DIR "/femur.off");
  const Fit fit = fit_vertex_shapes(femur.cells);
  Extraction_options options;
  const Extraction plain = extract_extremal_mesh(femur.cells, fit.shapes, options);
  surfaces::expect_all_checks_hold(plain.mesh);
  EXPECT_FALSE(type_changes(plain.mesh).empty());
  for (std::size_t e = 0; e < plain.mesh.number_of_edges(); ++e) {
    const Extremal_mesh_edge& edge = plain.mesh.edge(e);
    std::set<std::size_t> changes;
    for (const Type_change& change : edge.type_changes)
      changes.insert(change.point);
    for (std::size_t i = 1; i < edge.segment_types.size(); ++i)
      EXPECT_TRUE(edge.segment_types[i] == edge.segment_types[i - 1] || changes.count(i)) << "edge " << e;
  }
  // A mesh says no more of a line between its edges: a tolerance changes nothing.
  options.line_tolerance = 1e-6;
  same_mesh::expect_same(plain.mesh, extract_extremal_mesh(femur.cells, fit.shapes, options).mesh);
}

TEST(Triangulation, covers_what_lines_of_many_points_leave_of_a_polygon) {
  // A crescent between two parabolas, of which no point sees all corners. Its area is that of the polygon by Gauss.
  Cell_patches patches;
  constexpr int n = 20;
  for (int i = -n; i <= n; ++i)
    patches.points.push_back({double(i) / n, 2.0 * i * i / (n * n), 0});
  for (int i = n - 1; i > -n; --i)
    patches.points.push_back({double(i) / n, 1.6 * i * i / (n * n) + 0.4, 0});
  double area = 0;
  for (std::uint32_t i = 0; i < patches.points.size(); ++i) {
    const Point &a = patches.points[i], &b = patches.points[(i + 1) % patches.points.size()];
    area += (a[0] * b[1] - a[1] * b[0]) / 2;
    patches.corners.push_back(i);
  }
  patches.normals.assign(patches.points.size(), {0, 0, 1});
  patches.begin.push_back(patches.corners.size());
  patches.cell.push_back(0);
  const Cell_patches triangles = triangulate(patches);
  EXPECT_EQ(triangles.cell.size(), patches.points.size() - 2);
  double covered = 0;
  for (std::size_t i = 0; i < triangles.cell.size(); ++i) {
    ASSERT_EQ(triangles.begin[i + 1] - triangles.begin[i], 3U);
    const auto corner = [&](std::size_t k) { return triangles.points[triangles.corners[triangles.begin[i] + k]]; };
    const double twice = cross(difference(corner(1), corner(0)), difference(corner(2), corner(0)))[2];
    EXPECT_GT(twice, 0);
    covered += twice / 2;
  }
  EXPECT_NEAR(covered, area, 1e-12);
}

TEST(Line_tolerance, must_be_a_length) {
  const Formula f("x^2+2*y^2+3*z^2-1");
  for (const double bad : {-1.0, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    Extraction_options options;
    options.line_tolerance = bad;
    EXPECT_THROW(extract_extremal_mesh(f, make_lattice({-2, -2, -2}, {2, 2, 2}, 10), options), std::invalid_argument);
  }
}
