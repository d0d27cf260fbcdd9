// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// From the bare points of a mesh to the extremal mesh of x² + 2y² + 4z² = 1: 6 extremal points at the ends of the axes, 4
// lemons, 16 edges, 8 cells with an edge of each type [Thirion 1993].
#include <CGAL/Extremal_mesh_3/fit_vertex_shapes.h>
#include <CGAL/Extremal_mesh_3/read_mesh.h>

#include "graph_comparison.h"
#include "meshes.h"

#include <filesystem>
#include <set>

using namespace CGAL::Extremal_mesh_3;

namespace {

using graph_comparison::largest_distance;
using graph_comparison::positions;
using meshes::Polygons;

const double b = std::sqrt(0.5), c = 0.5;
const surfaces::Counts truth{6, 4, 0, 16, 8, 0, 2};

std::vector<Point> ends() {
  return {{1, 0, 0}, {-1, 0, 0}, {0, b, 0}, {0, -b, 0}, {0, 0, c}, {0, 0, -c}};
}
std::vector<Point> umbilics() {
  const double x = std::sqrt(2.0 / 3), z = c * std::sqrt(1.0 / 3);
  return {{x, 0, z}, {-x, 0, z}, {x, 0, -z}, {-x, 0, -z}};
}
Polygons ellipsoid(int levels) {
  return meshes::on_ellipsoid(meshes::icosphere(levels), 1, b, c);
}

double mean_edge_length(const Cell_complex& cells) {
  double sum = 0;
  for (const auto& [p, q] : cells.edges)
    sum += surfaces::distance(cells.points[p], cells.points[q]);
  return sum / double(cells.edges.size());
}

/// \param radius  in mean lengths of an edge; 0: the default
Extraction extract(const Cell_complex& cells, double radius = 0) {
  Fit_options options;
  options.radius = radius * mean_edge_length(cells);
  return extract_extremal_mesh(cells, fit_vertex_shapes(cells, options).shapes);
}

void expect_truth(const Extremal_mesh& mesh, double edge, const surfaces::Motion& motion = {}) {
  surfaces::expect_all_checks_hold(mesh);
  EXPECT_EQ(surfaces::counts_of(mesh), truth);
  for (const Extremal_mesh_cell& cell : mesh.cells()) {
    ASSERT_EQ(cell.boundary.size(), 1U);
    std::set<Line_type> types;
    for (const Half_edge h : cell.boundary[0])
      types.insert(mesh.edge(h / 2).type);
    EXPECT_EQ(types.size(), 4U);
  }
  const auto moved = [&](std::vector<Point> points) {
    for (Point& p : points)
      p = motion(p);
    return points;
  };
  const double from_ends =
      largest_distance(positions(mesh, Vertex_kind::extremal_point), moved(ends())).value_or(1) / edge;
  const double from_umbilics =
      largest_distance(positions(mesh, Vertex_kind::umbilic), moved(umbilics())).value_or(1) / edge;
  EXPECT_LT(from_ends, 1);
  EXPECT_LT(from_umbilics, 1);
  testing::Test::RecordProperty("largest_distance_of_extremal_points_in_edges", std::to_string(from_ends));
  testing::Test::RecordProperty("largest_distance_of_umbilics_in_edges", std::to_string(from_umbilics));
}

} // namespace

class Fitted_icosphere : public testing::TestWithParam<int> {};

TEST_P(Fitted_icosphere, has_the_mesh_of_the_ellipsoid_by_default) {
  const Cell_complex cells = ellipsoid(GetParam()).cells();
  expect_truth(extract(cells).mesh, mean_edge_length(cells));
}

// 642, 2562, 10242 and 40962 vertices
INSTANTIATE_TEST_SUITE_P(Levels, Fitted_icosphere, testing::Values(3, 4, 5, 6));

TEST(Fitted_polygons, have_the_mesh_of_the_ellipsoid_however_numbered_and_moved) {
  // 3108 vertices, cells of 4 to 9 sides, every vertex exact.
  const Mesh file = read_mesh(EXTREMAL_MESH_3_DATA_DIR "/ellipsoid_exact_poly.off");
  const Cell_complex& cells = file.cells;
  const double edge = mean_edge_length(cells);
  const Extremal_mesh reference = extract(cells).mesh;
  expect_truth(reference, edge);
  Polygons polygons;
  polygons.points = cells.points;
  for (std::size_t f = 0; f < cells.number_of_cells(); ++f) {
    polygons.polygons.emplace_back();
    for (std::size_t h = cells.cell_begin[f]; h < cells.cell_begin[f + 1]; ++h)
      polygons.polygons.back().push_back(cells.source(cells.half_edges[h]));
  }
  for (unsigned seed = 1; seed <= 3; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const surfaces::Motion motion = surfaces::random_motion(seed);
    const Extremal_mesh other = extract(meshes::moved(meshes::shuffled(polygons, seed), motion).cells()).mesh;
    expect_truth(other, edge, motion);
    EXPECT_TRUE(graph_comparison::isomorphic(reference, other));
  }
}

struct Noise {
  double sigma;  ///< of the vertices along the radius, in mean lengths of an edge
  double radius; ///< at which the truth is found, in the same
};

class Noisy_icosphere : public testing::TestWithParam<Noise> {};

TEST_P(Noisy_icosphere, has_the_mesh_of_the_ellipsoid_at_a_larger_radius) {
  const Polygons exact = ellipsoid(5);
  for (unsigned seed = 1; seed <= 3; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Cell_complex cells =
        meshes::with_radial_noise(exact, GetParam().sigma * meshes::mean_edge_length(exact), seed).cells();
    const Extremal_mesh mesh = extract(cells, GetParam().radius).mesh;
    surfaces::expect_all_checks_hold(mesh);
    EXPECT_EQ(surfaces::counts_of(mesh), truth);
  }
}

TEST_P(Noisy_icosphere, has_at_most_three_times_as_many_vertices_by_default) {
  const Polygons exact = ellipsoid(5);
  for (unsigned seed = 1; seed <= 3; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Extremal_mesh mesh =
        extract(meshes::with_radial_noise(exact, GetParam().sigma * meshes::mean_edge_length(exact), seed).cells())
            .mesh;
    surfaces::expect_all_checks_hold(mesh);
    EXPECT_LE(mesh.number_of_vertices(), 30U);
  }
}

INSTANTIATE_TEST_SUITE_P(Sigmas, Noisy_icosphere, testing::Values(Noise{0.001, 8}, Noise{0.01, 14}),
                         [](const auto& info) { return info.param.sigma < 0.005 ? "per_mille" : "per_cent"; });

TEST(Noisy_mesh, of_the_ellipsoid_has_its_mesh_at_a_larger_radius) {
  const Cell_complex cells = read_mesh(EXTREMAL_MESH_3_DATA_DIR "/ellipe0.003.off").cells;
  const Extremal_mesh mesh = extract(cells, 6).mesh;
  surfaces::expect_all_checks_hold(mesh);
  EXPECT_EQ(surfaces::counts_of(mesh), truth);
}

TEST(Noisy_mesh, has_fewer_and_smoother_lines_at_a_larger_radius) {
  const Polygons exact = ellipsoid(4);
  const Cell_complex cells = meshes::with_radial_noise(exact, 0.01 * meshes::mean_edge_length(exact), 1).cells();
  std::size_t before = extract(cells, 3.5).mesh.number_of_vertices();
  for (const double radius : {5.0, 7.0, 10.0}) {
    const std::size_t vertices = extract(cells, radius).mesh.number_of_vertices();
    EXPECT_LT(vertices, before) << radius;
    before = vertices;
  }
}
