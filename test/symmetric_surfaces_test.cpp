// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// x² + y² + z² + x⁴ + y⁴ + z⁴ = 1 has the symmetry of the cube. Curvature is extremal across each of its nine mirror planes,
// so all of them draw lines on the surface: four through each face's centre, three through each corner, two through the
// middle of each edge of the cube. What else there is, is found by searches that share no code with the extraction.
#include <CGAL/Extremal_mesh_3/Formula.h>

#include "dense_search.h"

#include <algorithm>
#include <numbers>

using namespace CGAL::Extremal_mesh_3;

namespace {

const Formula f("x^2+y^2+z^2+x^4+y^4+z^4-1");

/// the absolute values of the coordinates in order: the same for all places that the symmetry exchanges.
Point orbit(Point p) {
  for (double& x : p)
    x = std::abs(x);
  std::sort(p.begin(), p.end());
  return p;
}

/// Where x² + x⁴ = 1/n, the n largest coordinates being equal and the others 0.
Point on_axis(int n) {
  const double a = std::sqrt((std::sqrt(1 + 4.0 / n) - 1) / 2);
  return {n > 2 ? a : 0, n > 1 ? a : 0, a};
}

/// how often E_g changes its sign on a small circle around a place, and whether all lines that cross it are of one
/// family.
struct Around {
  int changes = 0;
  bool one_family = true;
};
Around look_around(const Point& p, double radius) {
  const auto center = dense_search::place_near(f, p);
  Around around;
  constexpr int n = 7200;
  double before = 0;
  int families = 0;
  for (int i = 0; i <= n; ++i) {
    const double angle = 2 * std::numbers::pi * (i + 0.37) / n;
    const auto at = dense_search::place_near(
        f, surfaces::along(surfaces::along(center->p, radius * std::cos(angle), center->shape.u),
                           radius * std::sin(angle), center->shape.v()));
    const std::complex<double> phi = at->shape.Phi();
    if (i > 0 && (phi.imag() < 0) != (before < 0)) {
      ++around.changes;
      families |= phi.real() < 0 ? 1 : 2;
    }
    before = phi.imag();
  }
  around.one_family = families != 3;
  return around;
}

} // namespace

class Cubic_symmetry : public testing::TestWithParam<std::pair<std::size_t, unsigned>> {};

TEST_P(Cubic_symmetry, gives_one_vertex_at_each_place_of_symmetry) {
  const auto [resolution, seed] = GetParam();
  const surfaces::Motion motion = seed == 0 ? surfaces::Motion() : surfaces::random_motion(seed, 0.05);
  const surfaces::Moved_function moved(f, motion);
  const surfaces::Box box = surfaces::moved({{-0.8, -0.8, -0.8}, {0.8, 0.8, 0.8}}, motion);
  const Extremal_mesh mesh = extract_extremal_mesh(moved, surfaces::lattice_around(moved, box, resolution)).mesh;
  surfaces::expect_all_checks_hold(mesh);
  int faces = 0, corners = 0, edges = 0, others = 0, crossings = 0;
  for (std::size_t v = 0; v < mesh.number_of_vertices(); ++v) {
    const Extremal_mesh_vertex& x = mesh.vertex(v);
    const Point p = orbit(motion.back(x.point));
    const auto is = [&](const Point& q) { return surfaces::distance(p, q) < 1e-9; };
    switch (x.kind) {
    case Vertex_kind::extremal_point:
      EXPECT_EQ(x.star.size(), 4U);
      (is(on_axis(2)) ? edges : others) += 1;
      EXPECT_EQ(x.field_index, is(on_axis(2)) ? 1 : -1);
      break;
    case Vertex_kind::umbilic:
      corners += is(on_axis(3));
      EXPECT_EQ(x.ridges, 3);
      EXPECT_EQ(x.umbilic_index, -0.5);
      break;
    case Vertex_kind::non_generic:
      if (is(on_axis(1))) { // an umbilic of four-fold symmetry
        ++faces;
        EXPECT_EQ(x.star.size(), 8U);
        EXPECT_EQ(x.umbilic_index, 1);
      } else { // two lines of one family, one of them in a mirror plane
        ++crossings;
        EXPECT_EQ(x.star.size(), 4U);
        EXPECT_EQ(x.umbilic_index, 0);
        EXPECT_EQ(x.field_index, 0);
        EXPECT_NEAR(p[1], p[2], 1e-8);
      }
      break;
    default:
      ADD_FAILURE() << to_string(x.kind) << " at " << x.point[0] << ' ' << x.point[1] << ' ' << x.point[2];
    }
  }
  EXPECT_EQ(faces, 6);
  EXPECT_EQ(corners, 8);
  EXPECT_EQ(edges, 12);
  EXPECT_EQ(others, 24);    // an extremal point on each mirror line from a face to a corner
  EXPECT_EQ(crossings, 24); // and a crossing on each from an edge to a corner
  EXPECT_EQ(mesh.number_of_edges(), 168U);
  EXPECT_EQ(mesh.number_of_cells(), 96U);
}

INSTANTIATE_TEST_SUITE_P(Resolutions, Cubic_symmetry,
                         testing::Values(std::pair{20U, 0U}, std::pair{20U, 1U}, std::pair{21U, 0U}, std::pair{33U, 2U},
                                         std::pair{40U, 0U}, std::pair{64U, 3U}));

TEST(Cubic_symmetry_by_search, has_the_same_vertices) {
  const auto starts = make_implicit_cells(f, make_lattice({-0.83, -0.82, -0.81}, {0.84, 0.85, 0.86}, 40)).points;
  int extremal_points = 0, corners = 0;
  for (const auto& z : dense_search::find_zeros(f, starts, 1.6)) {
    if (surfaces::distance(orbit(z.point), on_axis(1)) < 1e-2)
      continue; // where V vanishes to a higher order Newton's method ends anywhere near
    (z.umbilic ? corners : extremal_points) += 1;
  }
  EXPECT_EQ(extremal_points, 36);
  EXPECT_EQ(corners, 8);
  // Eight lines leave the centre of a face …
  EXPECT_EQ(look_around({0, 0, on_axis(1)[2]}, 1e-2).changes, 8);
  // … six a corner, four the middle of an edge, of both families.
  EXPECT_EQ(look_around(on_axis(3), 1e-3).changes, 6);
  EXPECT_EQ(look_around(on_axis(2), 1e-3).changes, 4);
  EXPECT_FALSE(look_around(on_axis(2), 1e-3).one_family);
  // On the mirror line from there to the corner four lines of one family meet in one place, and nowhere else do more
  // than two leave.
  int meeting = 0;
  double place = 0;
  for (double x = 0.02; x < 0.50; x += 0.004) {
    const auto on_line = dense_search::place_near(f, {x, 0.55, 0.55});
    const Around around = look_around(on_line->p, 0.004);
    if (around.changes != 4)
      continue;
    EXPECT_TRUE(around.one_family);
    ++meeting;
    place += on_line->p[0];
  }
  ASSERT_GE(meeting, 1);
  EXPECT_LE(meeting, 3); // circles of this radius overlap
  EXPECT_NEAR(place / meeting, 0.471878, 0.004);
}

TEST(Tetrahedral_symmetry, gives_the_same_mesh_in_every_position) {
  const Formula g("x^2+y^2+z^2+x*y*z-1");
  for (unsigned seed = 0; seed <= 2; ++seed) {
    const surfaces::Motion motion = seed == 0 ? surfaces::Motion() : surfaces::random_motion(seed, 0.05);
    const surfaces::Moved_function moved(g, motion);
    const surfaces::Box box = surfaces::moved({{-1.2, -1.2, -1.2}, {1.2, 1.2, 1.2}}, motion);
    const Extremal_mesh mesh = extract_extremal_mesh(moved, surfaces::lattice_around(moved, box, 24)).mesh;
    surfaces::expect_all_checks_hold(mesh);
    EXPECT_EQ(surfaces::counts_of(mesh), (surfaces::Counts{30, 20, 8, 144, 72, 24, 2})) << "seed " << seed;
  }
}
