// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A line without a vertex. On the graph of
//     h = (k1 x² + k2 y²)/2 + k1³ x⁴/8 + b3 y³/6 − δ x³/6 + c (x⁵/60 + x³ y²/12)
// e1 ≈ −δ + c (x² + y²/2) near the origin (the x⁴ makes up for the turning of the tangent) and e2 ≈ b3: {e1 = 0} is a
// small oval on which e2 keeps away from 0.
#include <CGAL/Extremal_mesh_3/Functor_function.h>

#include "dense_search.h"

#include <numbers>

using namespace CGAL::Extremal_mesh_3;

namespace {

const auto patch = make_function([](auto x, auto y, auto z) {
  const double k1 = 1, k2 = -1, b3 = 2, delta = 0.02, c = 8;
  const auto x2 = x * x, y2 = y * y;
  return z - (0.5 * (k1 * x2 + k2 * y2) + k1 * k1 * k1 * x2 * x2 / 8.0 + b3 * y * y2 / 6.0 - delta * x * x2 / 6.0 +
              c * (x * x2 * x2 / 60.0 + x * x2 * y2 / 12.0));
});
constexpr double half = 0.12; // of the box

/// e1 along the direction of +x, and e2, above (x, y).
std::pair<double, double> extremalities(double x, double y) {
  Derivatives d;
  patch.derivatives({x, y, -patch.value({x, y, 0})}, 3, d);
  const Principal_quantities q = principal_quantities(local_shape(d));
  return {q.t1[0] > 0 ? q.e1 : -q.e1, q.t2[1] > 0 ? q.e2 : -q.e2};
}

} // namespace

TEST(Closed_line, exists) {
  // e1 < 0 in the middle, and grows along every ray: it has one zero on each, before the border of the box. e2 > 0.
  EXPECT_LT(extremalities(0, 0).first, 0);
  for (int i = 0; i < 360; ++i) {
    const double angle = i * std::numbers::pi / 180;
    int changes = 0;
    double before = extremalities(0, 0).first;
    for (int k = 1; k <= 100; ++k) {
      const double r = half * k / 100;
      const auto [e1, e2] = extremalities(r * std::cos(angle), r * std::sin(angle));
      EXPECT_GT(e2, 0);
      changes += (before < 0) != (e1 < 0);
      before = e1;
    }
    EXPECT_EQ(changes, 1);
    EXPECT_GT(before, 0);
  }
}

TEST(Closed_line, has_one_anchor_one_edge_and_a_disk_inside) {
  // The lattice reaches farther up and down than the patch, and sideways as far as half < |x|, |y| < 2·half.
  for (const std::size_t resolution : {12U, 15U, 24U, 48U}) {
    SCOPED_TRACE(resolution);
    const Lattice lattice = make_lattice({-half / std::numbers::sqrt2, -half / std::numbers::sqrt2, -half},
                                         {half / std::numbers::sqrt2, half / std::numbers::sqrt2, half}, resolution);
    const Extraction extraction = extract_extremal_mesh(patch, lattice);
    const Extremal_mesh& mesh = extraction.mesh;
    surfaces::expect_all_checks_hold(mesh);
    ASSERT_EQ(mesh.number_of_vertices(), 1U);
    ASSERT_EQ(mesh.number_of_edges(), 1U);
    ASSERT_EQ(mesh.number_of_cells(), 2U);
    EXPECT_EQ(mesh.vertex(0).kind, Vertex_kind::anchor);
    EXPECT_EQ(mesh.vertex(0).star.size(), 2U);
    EXPECT_EQ(mesh.edge(0).source, 0U);
    EXPECT_EQ(mesh.edge(0).target, 0U);
    EXPECT_EQ(mesh.edge(0).family, 1);
    EXPECT_EQ(mesh.edge(0).polyline.front(), mesh.edge(0).polyline.back());
    // Inside a disk where E_g = e1 e2 < 0, outside a ring that has the border of the surface.
    const auto inside = std::size_t(mesh.cell(0).sign < 0 ? 0 : 1);
    EXPECT_EQ(mesh.cell(inside).sign, -1);
    EXPECT_EQ(mesh.cell(inside).euler_characteristic, 1);
    EXPECT_FALSE(mesh.cell(inside).touches_border);
    EXPECT_TRUE(mesh.cell(1 - inside).touches_border);
    EXPECT_EQ(extraction.report.uncertain_cells, 0U);
    for (const Point& p : mesh.edge(0).polyline) {
      // Points of the line are roots along edges of cells: rounding of a function of size 1, over its slope, about
      // c·half.
      EXPECT_NEAR(extremalities(p[0], p[1]).first, 0, 1e-9);
    }
  }
}
