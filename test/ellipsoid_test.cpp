// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The triaxial ellipsoid x²/a² + y²/b² + z²/c² = 1, a > b > c, is the surface whose extremal mesh is known in closed
// form [MATHEMATICS 4]: 6 extremal points at the ends of the axes, 4 lemons at
// (±a√((a²−b²)/(a²−c²)), 0, ±c√((b²−c²)/(a²−c²))), 16 edges, 8 cells with an edge of each type.
#include <CGAL/Extremal_mesh_3/Functor_function.h>

#include "graph_comparison.h"
#include "surfaces.h"

#include <set>

using namespace CGAL::Extremal_mesh_3;

namespace {

using graph_comparison::largest_distance;
using graph_comparison::positions;
using surfaces::Motion;
using surfaces::Moved_function;

struct Ellipsoid {
  double a, b, c;

  auto function() const {
    return make_function([p = 1 / (a * a), q = 1 / (b * b), r = 1 / (c * c)](auto x, auto y, auto z) {
      return p * (x * x) + q * (y * y) + r * (z * z) - 1;
    });
  }
  /// the moved ellipsoid's own box.
  surfaces::Box box(const Motion& motion) const {
    surfaces::Box box;
    for (std::size_t i = 0; i < 3; ++i) {
      const double half = std::hypot(motion.R[i][0] * a, motion.R[i][1] * b, motion.R[i][2] * c);
      box.low[i] = motion.translation[i] - half;
      box.high[i] = motion.translation[i] + half;
    }
    return box;
  }
  std::vector<Point> ends(const Motion& motion) const {
    return {motion({a, 0, 0}),  motion({-a, 0, 0}), motion({0, b, 0}),
            motion({0, -b, 0}), motion({0, 0, c}),  motion({0, 0, -c})};
  }
  std::vector<Point> umbilics(const Motion& motion) const {
    const double x = a * std::sqrt((a * a - b * b) / (a * a - c * c));
    const double z = c * std::sqrt((b * b - c * c) / (a * a - c * c));
    return {motion({x, 0, z}), motion({-x, 0, z}), motion({x, 0, -z}), motion({-x, 0, -z})};
  }
};

void expect_mesh_of(const Ellipsoid& ellipsoid, const Motion& motion, const Extraction& extraction) {
  const Extremal_mesh& mesh = extraction.mesh;
  surfaces::expect_all_checks_hold(mesh);
  EXPECT_EQ(extraction.report.uncertain_cells, 0U);
  EXPECT_EQ(surfaces::counts_of(mesh), (surfaces::Counts{6, 4, 0, 16, 8, 0, 2}));

  // Where P or Q vanishes is found by Newton's method; its last step is rounding of P and Q, some 1e-13 of their size,
  // over their gradients, which are small when the ellipsoid is nearly round: 1e-9 covers that.
  const double tolerance = 1e-9 * 2 * ellipsoid.a;
  const auto points = largest_distance(positions(mesh, Vertex_kind::extremal_point), ellipsoid.ends(motion));
  ASSERT_TRUE(points);
  EXPECT_LT(*points, tolerance);
  const auto umbilics = largest_distance(positions(mesh, Vertex_kind::umbilic), ellipsoid.umbilics(motion));
  ASSERT_TRUE(umbilics);
  EXPECT_LT(*umbilics, tolerance);

  for (const std::size_t v : surfaces::vertices_of(mesh, Vertex_kind::umbilic)) {
    EXPECT_EQ(mesh.vertex(v).umbilic_type, Umbilic_type::lemon);
    EXPECT_EQ(mesh.vertex(v).ridges, 1);
  }
  for (const Extremal_mesh_cell& cell : mesh.cells()) {
    ASSERT_EQ(cell.boundary.size(), 1U);
    ASSERT_EQ(cell.boundary[0].size(), 4U);
    std::set<Line_type> types;
    for (const Half_edge h : cell.boundary[0])
      types.insert(mesh.edge(h / 2).type);
    EXPECT_EQ(types.size(), 4U);
  }
}

Extraction extract(const Ellipsoid& ellipsoid, const Motion& motion, std::size_t resolution, double sign = 1) {
  const auto f = ellipsoid.function();
  const surfaces::Box box = ellipsoid.box(motion).widened(0.03);
  return extract_extremal_mesh(Moved_function(f, motion, sign), make_lattice(box.low, box.high, resolution));
}

class Ellipsoids : public testing::TestWithParam<Ellipsoid> {};

} // namespace

TEST_P(Ellipsoids, have_their_mesh_with_symmetry_planes_on_nodes) {
  const Ellipsoid ellipsoid = GetParam();
  const auto f = ellipsoid.function();
  for (const int resolution : {16, 32, 64}) {
    SCOPED_TRACE(resolution);
    // An odd number of nodes, the middle one at the origin: all symmetry planes consist of nodes.
    const double step = 2.1 * ellipsoid.a / resolution;
    const auto half = std::size_t(resolution / 2);
    const double low = -step * double(half);
    const Lattice lattice{{low, low, low},
                          {Vector{step, 0, 0}, Vector{0, step, 0}, Vector{0, 0, step}},
                          {2 * half + 1, 2 * half + 1, 2 * half + 1}};
    ASSERT_EQ(lattice.node(double(half), double(half), double(half)), (Point{0, 0, 0}));
    expect_mesh_of(ellipsoid, {}, extract_extremal_mesh(f, lattice));
  }
}

TEST_P(Ellipsoids, have_their_mesh_anywhere) {
  for (unsigned seed = 1; seed <= 20; ++seed)
    for (const std::size_t resolution : {16U, 32U, 64U}) {
      SCOPED_TRACE("seed " + std::to_string(seed) + ", resolution " + std::to_string(resolution));
      const Motion motion = surfaces::random_motion(seed);
      expect_mesh_of(GetParam(), motion, extract(GetParam(), motion, resolution));
    }
}

TEST_P(Ellipsoids, change_the_signs_of_cells_under_reflection) {
  // The cells are the octants. In the coordinates of the ellipsoid before the motion, E_g has the sign of xyz or of
  // −xyz everywhere: all rotations must agree in that, and all mirrored ones must say the opposite.
  const auto sign_of_xyz = [](const Extremal_mesh& mesh, const Motion& motion) {
    int sum = 0;
    for (const Extremal_mesh_cell& cell : mesh.cells()) {
      Vector middle{};
      for (const Half_edge h : cell.boundary[0])
        middle = surfaces::along(middle, 1, motion.back(mesh.vertex(mesh.source(h)).point));
      sum += cell.sign * (middle[0] * middle[1] * middle[2] > 0 ? 1 : -1);
    }
    return sum;
  };
  int expected = 0;
  for (unsigned seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Motion motion = surfaces::random_motion(seed), mirror = surfaces::mirrored(motion);
    const Extraction before = extract(GetParam(), motion, 24), after = extract(GetParam(), mirror, 24);
    expect_mesh_of(GetParam(), mirror, after);
    EXPECT_TRUE(graph_comparison::isomorphic(before.mesh, after.mesh, {.signs = true}));
    const int sum = sign_of_xyz(before.mesh, motion);
    EXPECT_EQ(std::abs(sum), 8);
    if (expected != 0) {
      EXPECT_EQ(sum, expected);
    }
    expected = sum;
    EXPECT_EQ(sign_of_xyz(after.mesh, mirror), -sum);
  }
}

TEST_P(Ellipsoids, exchange_families_when_the_normal_is_reversed) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Motion motion = surfaces::random_motion(seed);
    const Extraction before = extract(GetParam(), motion, 24), after = extract(GetParam(), motion, 24, -1);
    expect_mesh_of(GetParam(), motion, after);
    EXPECT_TRUE(graph_comparison::isomorphic(before.mesh, after.mesh, {.families = true}));
  }
}

INSTANTIATE_TEST_SUITE_P(Triaxial, Ellipsoids,
                         testing::Values(Ellipsoid{3, 2, 1}, Ellipsoid{1, 0.7071, 0.5}, Ellipsoid{1, 0.95, 0.9}),
                         [](const auto& info) { return "shape_" + std::to_string(info.index + 1); });
