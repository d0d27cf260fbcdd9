// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One surface, taken in four ways: as cells of a lattice or triangles of CGAL's mesher, with the exact derivatives of the
// function or with jets fitted to the points alone. The graph is the same.
#include <CGAL/Extremal_mesh_3/Formula.h>
#include <CGAL/Extremal_mesh_3/fit_vertex_shapes.h>
#include <CGAL/Extremal_mesh_3/make_cgal_cells.h>

#include "graph_comparison.h"
#include "surfaces.h"

using namespace CGAL::Extremal_mesh_3;

namespace {

struct Named_surface {
  std::string name, formula;
  double half_size;
  std::size_t resolution; ///< at which jets resolve what there is
};

class Same_surface : public testing::TestWithParam<Named_surface> {};

} // namespace

TEST_P(Same_surface, has_the_same_graph_from_either_mesh_with_derivatives_or_jets) {
  const Formula f(GetParam().formula);
  const double h = GetParam().half_size;
  const Lattice lattice = make_lattice({-h, -h, -h}, {h, h, h}, GetParam().resolution);
  const Cell_complex grid = make_implicit_cells(f, lattice), triangles = make_cgal_cells(f, lattice);
  const Extremal_mesh reference = extract_extremal_mesh(f, grid).mesh;
  EXPECT_TRUE(graph_comparison::isomorphic(reference, extract_extremal_mesh(f, triangles).mesh));
  for (const Cell_complex* cells : {&grid, &triangles}) {
    const Extremal_mesh fitted = extract_extremal_mesh(*cells, fit_vertex_shapes(*cells).shapes).mesh;
    surfaces::expect_all_checks_hold(fitted);
    // Kinds, degrees, families, signs, indices and incidences; whether an umbilic of index ½ is a lemon or a monstar turns on small
    // differences of C.
    EXPECT_TRUE(graph_comparison::isomorphic(reference, fitted, {}, graph_comparison::Umbilics::index_only))
        << (cells == &grid ? "lattice: " : "CGAL: ") << surfaces::counts_of(fitted);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Quadrics, Same_surface,
    testing::Values(
        Named_surface{"ellipsoid", "x^2+2*y^2+4*z^2-1", 1.2, 30},
        Named_surface{"fine_ellipsoid", "x^2+2*y^2+4*z^2-1", 1.2, 80},
        Named_surface{"egg", "x^2+2*y^2+4*z^2-1+0.15*x^3+0.1*y^3-0.2*x*y*z+0.1*x^2*z", 1.4, 40},
        Named_surface{"potato", "x^2+1.3*y^2+1.7*z^2+0.2*x^3+0.15*y^3-0.4*x*y*z+0.2*x^2*z+0.1*x*y^2-1", 1.4, 40},
        Named_surface{"cube", "x^2+1.05*y^2+0.96*z^2+x^4+y^4+z^4+0.05*x*y*z+0.03*x^3-0.02*y^3+0.025*y^2*z+0.02*x*y-1",
                      1.1, 60}),
    [](const auto& info) { return info.param.name; });
