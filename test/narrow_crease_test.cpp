// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A crease much narrower than the cells: the surface
//     z = −√(x² + ε (1 + 0.2 sin 3y)) − 0.1 y² − 0.05 x y − 0.02 y³
// turns by 90° within about √ε of the plane x = 0. Along the crease e2 goes from one side to the other a million times faster
// than e1 changes, and cells are divided far more often across it than along it.
#include <CGAL/Extremal_mesh_3/Formula.h>

#include "graph_comparison.h"
#include "surfaces.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <string>

using namespace CGAL::Extremal_mesh_3;

namespace {

class Narrow_crease : public testing::TestWithParam<double> {
protected:
  const Formula f{fmt::format("z+sqrt(x^2+{}*(1+0.2*sin(3*y)))+0.1*y^2+0.05*x*y+0.02*y^3", GetParam())};

  Extraction extract(std::size_t resolution) const {
    return extract_extremal_mesh(f, make_lattice({-1, -1, -2}, {1.1, 1.2, 1}, resolution));
  }
};

} // namespace

TEST_P(Narrow_crease, has_one_line_along_it) {
  const double width = std::sqrt(GetParam());
  for (int j = 0; j <= 200; ++j) {
    const double y = -1 + 2.2 * j / 200;
    int changes = 0;
    double before = 0;
    for (int i = -500; i <= 500; ++i) {
      const double x = width * i / 200;
      Derivatives d;
      f.derivatives({x, y, -f.value({x, y, 0})}, 3, d);
      const Principal_quantities q = principal_quantities(local_shape(d));
      ASSERT_LT(q.k2, -std::abs(q.k1));
      const double e2 = q.t2[0] > 0 ? q.e2 : -q.e2;
      changes += i > -500 && (before < 0) != (e2 < 0);
      before = e2;
    }
    EXPECT_EQ(changes, 1) << "y = " << y;
  }
}

TEST_P(Narrow_crease, has_no_other_line_at_any_resolution) {
  std::optional<Extremal_mesh> first;
  for (const std::size_t resolution : {16U, 24U, 36U, 50U}) {
    SCOPED_TRACE(resolution);
    const Extraction extraction = extract(resolution);
    surfaces::expect_all_checks_hold(extraction.mesh);
    EXPECT_EQ(extraction.report.uncertain_cells, 0U);
    EXPECT_EQ(surfaces::vertices_of(extraction.mesh, Vertex_kind::umbilic).size(), 1U);
    EXPECT_EQ(surfaces::vertices_of(extraction.mesh, Vertex_kind::boundary).size(), 8U);
    EXPECT_EQ(extraction.mesh.number_of_vertices(), 9U);
    EXPECT_EQ(extraction.mesh.number_of_edges(), 5U);
    if (first)
      EXPECT_TRUE(graph_comparison::isomorphic(*first, extraction.mesh));
    else
      first = extraction.mesh;
  }
}

INSTANTIATE_TEST_SUITE_P(Widths, Narrow_crease, testing::Values(4e-4, 1e-4, 3e-5),
                         [](const auto& info) { return std::to_string(info.index); });
