// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A Bézier patch of bi-degree 4, z = h(u, v) on the unit square: the test surface of F. Cazals, J.-C. Faugère, M. Pouget
// and F. Rouillier, "The implicit structure of ridges of a smooth parametric surface", Computer Aided Geometric Design
// 23 (2006). They compute its ridges with exact algebra: 8 umbilics, of which 3 have three ridges, and 17 extremal points
// ("purple points") inside the square. One umbilic has two branches in nearly the same direction, with an extremal
// point 2.2e-4 away.
#include <CGAL/Extremal_mesh_3/Formula.h>

#include "dense_search.h"
#include "graph_comparison.h"

using namespace CGAL::Extremal_mesh_3;

namespace {

const Formula patch("z-(116*x^4*y^4-200*x^4*y^3+108*x^4*y^2-24*x^4*y-312*x^3*y^4+592*x^3*y^3-360*x^3*y^2+80*x^3*y"
                    "+252*x^2*y^4-504*x^2*y^3+324*x^2*y^2-72*x^2*y-56*x*y^4+112*x*y^3-72*x*y^2+16*x*y)");

Extraction extract(std::size_t resolution) {
  // h lies between -0.1602 and 0.2198 on the square.
  return extract_extremal_mesh(patch, make_lattice({0, 0, -0.18}, {1, 1, 0.24}, resolution));
}

} // namespace

TEST(Bezier_patch, has_the_umbilics_and_extremal_points_of_the_literature) {
  const Extremal_mesh mesh = extract(64).mesh;
  surfaces::expect_all_checks_hold(mesh);
  const surfaces::Counts counts = surfaces::counts_of(mesh);
  EXPECT_EQ(counts.extremal_points, 17U);
  EXPECT_EQ(counts.umbilics, 8U);
  EXPECT_EQ(counts.three_ridge, 3U);
  EXPECT_EQ(counts.others, surfaces::vertices_of(mesh, Vertex_kind::boundary).size());
  double nearest = 1;
  for (const std::size_t v : surfaces::vertices_of(mesh, Vertex_kind::extremal_point))
    for (const std::size_t w : surfaces::vertices_of(mesh, Vertex_kind::umbilic))
      nearest = std::min(nearest, surfaces::distance(mesh.vertex(v).point, mesh.vertex(w).point));
  EXPECT_NEAR(nearest, 2.2e-4, 0.2e-4);
}

TEST(Bezier_patch, has_the_same_mesh_at_two_resolutions) {
  const Extraction coarse = extract(64), fine = extract(100);
  EXPECT_TRUE(graph_comparison::isomorphic(coarse.mesh, fine.mesh));
  // What is left undecided, if anything, lies in the strip between that umbilic and that extremal point.
  EXPECT_LE(coarse.report.uncertain_cells, coarse.report.refined_cells / 500);
  EXPECT_LE(fine.report.uncertain_cells, fine.report.refined_cells / 500);
}

TEST(Bezier_patch, has_its_vertices_where_a_search_finds_them) {
  const Extremal_mesh mesh = extract(64).mesh;
  std::vector<Point> starts;
  for (int i = 0; i <= 120; ++i)
    for (int j = 0; j <= 120; ++j)
      starts.push_back({i / 120.0, j / 120.0, -patch.value({i / 120.0, j / 120.0, 0})});
  for (const auto& z : dense_search::find_zeros(patch, starts, 1)) {
    if (!(z.point[0] > 0 && z.point[0] < 1 && z.point[1] > 0 && z.point[1] < 1))
      continue;
    double nearest = 1;
    for (std::size_t v = 0; v < mesh.number_of_vertices(); ++v)
      if ((mesh.vertex(v).kind == Vertex_kind::umbilic) == z.umbilic)
        nearest = std::min(nearest, surfaces::distance(mesh.vertex(v).point, z.point));
    EXPECT_LT(nearest, 1e-8) << z.point[0] << ' ' << z.point[1];
  }
}
