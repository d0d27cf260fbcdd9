// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Surfaces without a formula, with the exact shapes at their vertices: what interpolation between these does.
#include <CGAL/Extremal_mesh_3/Formula.h>

#include "graph_comparison.h"
#include "meshes.h"

#include <limits>
#include <set>

using namespace CGAL::Extremal_mesh_3;

namespace {

using graph_comparison::largest_distance;
using graph_comparison::positions;
using meshes::Polygons;

// x² + 2y² + 4z² = 1: the ends of its axes and its umbilics [Thirion 1993; MATHEMATICS 4].
const Formula ellipsoid("x^2+2*y^2+4*z^2-1");
const double a = 1, b = std::sqrt(0.5), c = 0.5;
const surfaces::Counts truth{6, 4, 0, 16, 8, 0, 2};

Polygons ellipsoid_mesh(int levels) {
  return meshes::on_ellipsoid(meshes::icosphere(levels), a, b, c);
}

std::vector<Point> ends() {
  return {{a, 0, 0}, {-a, 0, 0}, {0, b, 0}, {0, -b, 0}, {0, 0, c}, {0, 0, -c}};
}
std::vector<Point> umbilics() {
  const double x = std::sqrt(2.0 / 3), z = c * std::sqrt(1.0 / 3);
  return {{x, 0, z}, {-x, 0, z}, {x, 0, -z}, {-x, 0, -z}};
}

Extraction extract(const Polygons& mesh, const Function_3& f, const Extraction_options& options = {}) {
  return extract_extremal_mesh(mesh.cells(), meshes::exact_shapes(f, mesh.points), options);
}

/// every third triangle joined with a neighbour, and some of those with another one: cells of 3, 4 and 5 sides.
Polygons joined(const Polygons& mesh) {
  Polygons result;
  result.points = mesh.points;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> owner; // of directed sides
  std::vector<std::vector<std::uint32_t>> cells = mesh.polygons;
  std::vector<char> merged(cells.size(), 0), gone(cells.size(), 0);
  for (std::size_t f = 0; f < cells.size(); ++f)
    for (std::size_t i = 0; i < cells[f].size(); ++i)
      owner[{cells[f][i], cells[f][(i + 1) % cells[f].size()]}] = f;
  for (std::size_t f = 0; f < cells.size(); f += 3) {
    const std::size_t sides = cells[f].size();
    for (std::size_t i = 0; i < sides && !merged[f]; ++i) {
      const std::uint32_t u = cells[f][i], v = cells[f][(i + 1) % sides];
      const std::size_t g = owner.at({v, u});
      if (merged[g] || gone[g] || gone[f] || g == f)
        continue;
      for (const std::uint32_t w : mesh.polygons[g])
        if (w != u && w != v)
          cells[f].insert(cells[f].begin() + std::ptrdiff_t(i + 1), w);
      merged[f] = merged[g] = gone[g] = 1;
    }
  }
  for (std::size_t f = 0; f < cells.size(); ++f)
    if (!gone[f])
      result.polygons.push_back(cells[f]);
  return result;
}

} // namespace

TEST(Interpolated_surface, has_the_mesh_of_the_ellipsoid_from_162_vertices_on) {
  for (int levels = 2; levels <= 5; ++levels) {
    SCOPED_TRACE(levels);
    const Polygons mesh = ellipsoid_mesh(levels);
    const Extraction extraction = extract(mesh, ellipsoid);
    surfaces::expect_all_checks_hold(extraction.mesh);
    EXPECT_EQ(surfaces::counts_of(extraction.mesh), truth);
    EXPECT_EQ(extraction.report.uncertain_cells, 0U);
    EXPECT_EQ(extraction.report.interpolated_points, 0U); // what is interpolated is the surface
    const double edge = meshes::mean_edge_length(mesh);
    EXPECT_LT(largest_distance(positions(extraction.mesh, Vertex_kind::extremal_point), ends()).value_or(1), edge);
    EXPECT_LT(largest_distance(positions(extraction.mesh, Vertex_kind::umbilic), umbilics()).value_or(1), edge);
  }
}

TEST(Interpolated_surface, resolves_the_tip_of_a_long_ellipsoid_with_162_vertices) {
  // Along an edge at the tips of 3 : 2 : 1 curvature doubles. With L and C linear in between, 2562 vertices gave ten
  // extremal points.
  const Polygons mesh = meshes::on_ellipsoid(meshes::icosphere(2), 3, 2, 1);
  const Extraction extraction = extract(mesh, Formula("x^2/9+y^2/4+z^2-1"));
  surfaces::expect_all_checks_hold(extraction.mesh);
  EXPECT_EQ(surfaces::counts_of(extraction.mesh), truth);
}

TEST(Interpolated_surface, has_umbilics_as_near_to_the_truth_as_its_edges_are_to_the_surface) {
  for (int levels = 2; levels <= 5; ++levels) {
    const Polygons mesh = ellipsoid_mesh(levels);
    const auto found = positions(extract(mesh, ellipsoid).mesh, Vertex_kind::umbilic);
    // An edge of length h is up to k h²/8 away from the surface, and k ≤ 4; edges differ in length by a factor of 2.
    const double edge = meshes::mean_edge_length(mesh);
    EXPECT_LT(largest_distance(found, umbilics()).value_or(1), 2 * edge * edge) << levels;
  }
}

TEST(Interpolated_surface, takes_cells_of_any_number_of_sides) {
  const Polygons mesh = joined(ellipsoid_mesh(4));
  std::set<std::size_t> sides;
  for (const auto& p : mesh.polygons)
    sides.insert(p.size());
  ASSERT_GE(sides.size(), 2U);
  const Extraction extraction = extract(mesh, ellipsoid);
  surfaces::expect_all_checks_hold(extraction.mesh);
  EXPECT_EQ(surfaces::counts_of(extraction.mesh), truth);
}

TEST(Interpolated_surface, has_the_same_graph_however_it_is_numbered_and_moved) {
  const Polygons mesh = ellipsoid_mesh(4);
  const Extremal_mesh reference = extract(mesh, ellipsoid).mesh;
  for (unsigned seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const surfaces::Motion motion = surfaces::random_motion(seed);
    const Polygons other = meshes::moved(meshes::shuffled(mesh, seed), motion);
    const Extremal_mesh moved = extract(other, surfaces::Moved_function(ellipsoid, motion)).mesh;
    EXPECT_TRUE(graph_comparison::isomorphic(reference, moved));
    std::vector<Point> expected;
    for (const Point& p : positions(reference, Vertex_kind::umbilic))
      expected.push_back(motion(p));
    // Vertices that lie on lines are moved by up to a seventh of an edge, in a direction that depends on their
    // neighbours' order.
    EXPECT_LT(largest_distance(positions(moved, Vertex_kind::umbilic), expected).value_or(1),
              0.3 * meshes::mean_edge_length(mesh));
  }
}

TEST(Interpolated_surface, does_not_depend_on_threads) {
  const Polygons mesh = ellipsoid_mesh(4);
  Extraction_options one, many;
  one.threads = 1;
  many.threads = 4;
  const Extremal_mesh x = extract(mesh, ellipsoid, one).mesh, y = extract(mesh, ellipsoid, many).mesh;
  ASSERT_EQ(x.number_of_edges(), y.number_of_edges());
  for (std::size_t e = 0; e < x.number_of_edges(); ++e)
    EXPECT_EQ(x.edge(e).polyline, y.edge(e).polyline);
}

TEST(Interpolated_surface, takes_differences_of_C_where_the_fourth_order_is_not_known) {
  const Polygons mesh = ellipsoid_mesh(4);
  Vertex_shapes shapes = meshes::exact_shapes(ellipsoid, mesh.points);
  const Extremal_mesh exact = extract_extremal_mesh(mesh.cells(), shapes).mesh;
  shapes.fourth.clear();
  const Extremal_mesh differences = extract_extremal_mesh(mesh.cells(), shapes).mesh;
  EXPECT_TRUE(graph_comparison::isomorphic(exact, differences));
  ASSERT_EQ(exact.number_of_edges(), differences.number_of_edges());
  for (std::size_t e = 0; e < exact.number_of_edges(); ++e)
    EXPECT_EQ(exact.edge(e).type, differences.edge(e).type);
}

TEST(Interpolated_surface, lets_lines_end_at_its_border) {
  Polygons half;
  const Polygons whole = ellipsoid_mesh(4);
  // Without the cells around one end of the first axis, at which two lines cross: four lines now end at the border.
  std::map<std::uint32_t, std::uint32_t> number;
  for (const auto& p : whole.polygons) {
    bool kept = true;
    for (const std::uint32_t v : p)
      kept = kept && whole.points[v][0] < 0.9;
    if (!kept)
      continue;
    half.polygons.emplace_back();
    for (const std::uint32_t v : p) {
      const auto [it, added] = number.try_emplace(v, std::uint32_t(half.points.size()));
      if (added)
        half.points.push_back(whole.points[v]);
      half.polygons.back().push_back(it->second);
    }
  }
  const Extremal_mesh mesh = extract(half, ellipsoid).mesh;
  surfaces::expect_all_checks_hold(mesh);
  EXPECT_FALSE(mesh.surface().closed);
  EXPECT_EQ(mesh.surface().euler_characteristic, 1);
  EXPECT_EQ(positions(mesh, Vertex_kind::extremal_point).size(), 5U);
  EXPECT_EQ(positions(mesh, Vertex_kind::umbilic).size(), 4U);
  EXPECT_EQ(positions(mesh, Vertex_kind::boundary).size(), 4U);
  std::size_t at_border = 0;
  for (const Extremal_mesh_cell& cell : mesh.cells())
    at_border += cell.touches_border;
  EXPECT_EQ(at_border, 4U);
}

TEST(Interpolated_surface, of_revolution_is_degenerate) {
  const Polygons mesh = meshes::on_ellipsoid(meshes::icosphere(3), 1, 1, 0.5);
  EXPECT_THROW(extract(mesh, Formula("x^2+y^2+4*z^2-1")), Degenerate_surface_error);
}

TEST(Interpolated_surface, is_cut_where_no_jet_could_be_fitted) {
  const Polygons mesh = ellipsoid_mesh(4);
  Vertex_shapes shapes = meshes::exact_shapes(ellipsoid, mesh.points);
  shapes.quality.resize(mesh.points.size());
  std::size_t end = 0;
  while (mesh.points[end][0] < 1 - 1e-12)
    ++end;
  shapes.quality[end].state = Fit_state::rank_deficient;
  shapes.shapes[end].H = std::numeric_limits<double>::quiet_NaN(); // what is not known does not matter
  const Extraction extraction = extract_extremal_mesh(mesh.cells(), shapes);
  surfaces::expect_all_checks_hold(extraction.mesh);
  EXPECT_EQ(extraction.report.unknown_cells, 6U); // the end of an axis has six neighbours
  EXPECT_EQ(positions(extraction.mesh, Vertex_kind::boundary).size(), 4U);

  for (Fit_quality& q : shapes.quality)
    q.state = Fit_state::too_few_points;
  EXPECT_THROW(extract_extremal_mesh(mesh.cells(), shapes), Extraction_error);
}

TEST(Interpolated_surface, refuses_shapes_that_cannot_be) {
  const Polygons mesh = ellipsoid_mesh(1);
  const Cell_complex cells = mesh.cells();
  const Vertex_shapes good = meshes::exact_shapes(ellipsoid, mesh.points);
  Vertex_shapes bad = good;
  bad.shapes.pop_back();
  EXPECT_THROW(extract_extremal_mesh(cells, bad), std::invalid_argument);
  bad = good;
  bad.fourth.pop_back();
  EXPECT_THROW(extract_extremal_mesh(cells, bad), std::invalid_argument);
  bad = good;
  bad.shapes[3].A3 = {std::numeric_limits<double>::infinity(), 0};
  EXPECT_THROW(extract_extremal_mesh(cells, bad), std::invalid_argument);
  bad = good;
  bad.shapes[3].u = {0, 0, 0};
  EXPECT_THROW(extract_extremal_mesh(cells, bad), std::invalid_argument);
}
