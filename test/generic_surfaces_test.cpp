// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Algebraic surfaces without symmetry. Their extremal points and umbilics are found a second time by a search that shares
// no code with the extraction.
#include <CGAL/Extremal_mesh_3/Formula.h>

#include "dense_search.h"
#include "generic_surfaces.h"
#include "graph_comparison.h"
#include "repetitions.h"

using namespace CGAL::Extremal_mesh_3;

namespace {

using generic_surfaces::all_surfaces;
using generic_surfaces::Surface;
using graph_comparison::isomorphic;
using graph_comparison::largest_distance;
using graph_comparison::positions;
using surfaces::Motion;
using surfaces::Moved_function;

class Generic_surfaces : public testing::TestWithParam<Surface> {
protected:
  const Surface& surface() const { return GetParam(); }
  const Formula f{GetParam().formula};

  Extraction extract(const Motion& motion, std::size_t resolution, double sign = 1) const {
    const Moved_function moved(f, motion, sign);
    return extract_extremal_mesh(moved, surfaces::lattice_around(moved, surface().box(motion), resolution));
  }

  /// moves the surface, also mirrored, also with −f: the graph is the same, and so are the positions.
  void expect_the_same_mesh(const Extremal_mesh& first, const Motion& motion, std::size_t resolution) const {
    SCOPED_TRACE("resolution " + std::to_string(resolution) + ", motion to " +
                 std::to_string(motion.translation[0])); // tells the seed
    for (int variant = 0; variant < 3; ++variant) {
      SCOPED_TRACE(variant == 0 ? "as it is" : variant == 1 ? "mirrored" : "with -f");
      const Motion m = variant == 1 ? surfaces::mirrored(motion) : motion;
      const Extraction extraction = extract(m, resolution, variant == 2 ? -1 : 1);
      surfaces::expect_all_checks_hold(extraction.mesh);
      EXPECT_EQ(extraction.report.uncertain_cells, 0U);
      EXPECT_EQ(surfaces::counts_of(extraction.mesh), surface().counts);
      EXPECT_TRUE(isomorphic(first, extraction.mesh, {.families = variant == 2, .signs = variant == 1}));
      for (const auto kind : {Vertex_kind::extremal_point, Vertex_kind::umbilic}) {
        std::vector<Point> expected;
        for (const Point& p : positions(first, kind))
          expected.push_back(m(p));
        const auto off = largest_distance(positions(extraction.mesh, kind), expected);
        ASSERT_TRUE(off);
        EXPECT_LT(*off, 1e-9 * 2 * surface().half_size);
      }
    }
  }
};

} // namespace

TEST_P(Generic_surfaces, have_the_extremal_points_and_umbilics_of_a_dense_search) {
  const Extraction extraction = extract({}, 40);
  const Extremal_mesh& mesh = extraction.mesh;
  const double h = surface().half_size, size = 2 * h;
  const auto starts = make_implicit_cells(f, make_lattice({-h, -h, -h}, {h, h, h}, surface().search_resolution)).points;
  const auto zeros = dense_search::find_zeros(f, starts, size);

  std::vector<Point> points, umbilics;
  int field_index = 0;
  double umbilic_index = 0;
  for (const auto& z : zeros) {
    (z.umbilic ? umbilics : points).push_back(z.point);
    field_index += z.field_index;
    umbilic_index += z.umbilic_class.index;
    if (z.umbilic) {
      EXPECT_EQ(z.umbilic_class.field_index, z.field_index);
    }
  }
  // Poincaré and Hopf say whether the search found all there is.
  ASSERT_EQ(field_index, surface().euler_characteristic);
  ASSERT_EQ(umbilic_index, surface().euler_characteristic);
  EXPECT_EQ(points.size(), surface().counts.extremal_points);
  EXPECT_EQ(umbilics.size(), surface().counts.umbilics);

  // Both methods stop at rounding: some 1e-12 of the size here, 1e-9 with room for weakly determined points.
  const auto off = largest_distance(positions(mesh, Vertex_kind::extremal_point), points);
  ASSERT_TRUE(off);
  EXPECT_LT(*off, 1e-9 * size);
  const auto umbilics_off = largest_distance(positions(mesh, Vertex_kind::umbilic), umbilics);
  ASSERT_TRUE(umbilics_off);
  EXPECT_LT(*umbilics_off, 1e-9 * size);
  for (std::size_t v = 0; v < mesh.number_of_vertices(); ++v) {
    const Extremal_mesh_vertex& x = mesh.vertex(v);
    const auto z = std::min_element(zeros.begin(), zeros.end(), [&](const auto& a, const auto& b) {
      return surfaces::distance(a.point, x.point) < surfaces::distance(b.point, x.point);
    });
    EXPECT_EQ(x.field_index, z->field_index);
    EXPECT_EQ(x.umbilic_index, z->umbilic_class.index);
    EXPECT_EQ(x.umbilic_type, z->umbilic_class.type);
    EXPECT_EQ(x.ridges, z->umbilic_class.ridges);
  }
}

TEST_P(Generic_surfaces, have_the_same_mesh_in_every_position_and_at_every_resolution) {
  const Extraction first = extract({}, 32);
  EXPECT_EQ(surfaces::counts_of(first.mesh), surface().counts);
  for (unsigned seed = 1; seed <= repetitions(10); ++seed)
    expect_the_same_mesh(first.mesh, surfaces::random_motion(seed), seed % 5 == 1 ? 128 : seed % 2 == 0 ? 64 : 32);
}

// Takes minutes: run it with --gtest_also_run_disabled_tests.
TEST_P(Generic_surfaces, DISABLED_have_the_same_mesh_in_each_of_ten_positions_at_each_resolution) {
  const Extraction first = extract({}, 64);
  for (unsigned seed = 1; seed <= 10; ++seed)
    for (const std::size_t resolution : {32U, 64U, 128U})
      expect_the_same_mesh(first.mesh, surfaces::random_motion(seed), resolution);
}

TEST_P(Generic_surfaces, need_no_guess) {
  for (const std::size_t resolution : {24U, 32U, 48U, 64U}) {
    const Extraction_report report = extract({}, resolution).report;
    EXPECT_EQ(report.uncertain_cells, 0U) << "resolution " << resolution;
  }
}

TEST_P(Generic_surfaces, are_proved_to_have_no_vertices_where_none_was_found) {
  const surfaces::Box box = surface().box({});
  const Lattice lattice = surfaces::lattice_around(f, box, 32);
  Extraction_options options;
  const Extraction plain = extract_extremal_mesh(f, lattice, options);
  options.certify = true;
  const Extraction proved = extract_extremal_mesh(f, lattice, options);
  EXPECT_TRUE(isomorphic(plain.mesh, proved.mesh));
  EXPECT_FALSE(plain.report.certified);
  EXPECT_TRUE(proved.report.certified);
  EXPECT_EQ(plain.report.refined_cells, proved.report.refined_cells);
  // The cells that hold vertices cannot be among them.
  const std::size_t cells = proved.report.proved_empty_cells + proved.report.proved_vertex_free_cells;
  EXPECT_LE(cells + surface().counts.extremal_points + surface().counts.umbilics, proved.report.accepted_cells);
  // How many depends on how tight a formula's bounds are: squares of sums, as in the torus, are bad.
  EXPECT_GT(cells, 0U);
  if (surface().euler_characteristic == 2) {
    EXPECT_GT(double(cells), 0.6 * double(proved.report.accepted_cells));
  }
  // What cannot be bounded is not proved.
  const Moved_function moved(f, {});
  EXPECT_FALSE(extract_extremal_mesh(moved, lattice, options).report.certified);
}

TEST_P(Generic_surfaces, have_lines_of_their_family_between_cells_of_the_sign_of_E_g) {
  const Extraction extraction = extract({}, 32);
  const Extremal_mesh& mesh = extraction.mesh;
  const double size = 2 * surface().half_size;
  for (std::size_t e = 0; e < mesh.number_of_edges(); ++e) {
    const Extremal_mesh_edge& edge = mesh.edge(e);
    const std::size_t middle = edge.polyline.size() / 2;
    const auto here = dense_search::place_near(f, edge.polyline[middle]);
    ASSERT_TRUE(here);
    // Roots along edges of cells are found to rounding of the position, relative to the size.
    EXPECT_LT(surfaces::distance(here->p, edge.polyline[middle]), 1e-12 * size);
    const Principal_quantities q = principal_quantities(here->shape);
    const double zero = edge.family == 1 ? q.e1 : q.e2, other = edge.family == 1 ? q.e2 : q.e1;
    EXPECT_LT(std::abs(zero), 1e-6 * std::abs(other)) << "edge " << e;
    const double k = std::max(std::abs(q.k1), std::abs(q.k2)); // at a parabolic point one of them is 0
    EXPECT_NEAR(edge.k1[middle], q.k1, 1e-9 * k);
    EXPECT_NEAR(edge.k2[middle], q.k2, 1e-9 * k);

    // A step to the left, far smaller than the distance to other lines in the middle of an edge.
    const Vector forward =
        surfaces::along(edge.polyline[std::min(middle + 1, edge.polyline.size() - 1)], -1, edge.polyline[middle - 1]);
    const Vector left = surfaces::unit(surfaces::cross(here->shape.n, forward));
    const double step = std::min(1e-5 * size, 1e-3 * edge.length);
    for (const double side : {1.0, -1.0}) {
      const auto beside = dense_search::place_near(f, surfaces::along(here->p, side * step, left));
      ASSERT_TRUE(beside);
      const int sign = mesh.cell(side > 0 ? edge.left_cell : edge.right_cell).sign;
      EXPECT_GT(sign * beside->shape.Phi().imag(), 0) << "edge " << e;
    }
  }
}

TEST_P(Generic_surfaces, change_the_signs_of_cells_under_reflection) {
  const Motion motion = surfaces::random_motion(7);
  EXPECT_TRUE(isomorphic(extract(motion, 32).mesh, extract(surfaces::mirrored(motion), 32).mesh, {.signs = true}));
}

TEST_P(Generic_surfaces, exchange_families_when_the_normal_is_reversed) {
  const Motion motion = surfaces::random_motion(8);
  EXPECT_TRUE(isomorphic(extract(motion, 32).mesh, extract(motion, 32, -1).mesh, {.families = true}));
}

TEST_P(Generic_surfaces, scale) {
  Motion large, small;
  large.scale = 1000;
  small.scale = 0.001;
  const Extraction a = extract(large, 32), b = extract(small, 32);
  EXPECT_TRUE(isomorphic(a.mesh, b.mesh));
  // Areas are sums of the same terms up to rounding in other places; strength and sharpness have no unit.
  EXPECT_NEAR(a.mesh.surface().area / b.mesh.surface().area, 1e12, 1e12 * 1e-6);
  double strength_a = 0, strength_b = 0, sharpness_a = 0, sharpness_b = 0;
  for (std::size_t e = 0; e < a.mesh.number_of_edges(); ++e) {
    strength_a += a.mesh.edge(e).strength;
    sharpness_a += a.mesh.edge(e).sharpness;
  }
  for (std::size_t e = 0; e < b.mesh.number_of_edges(); ++e) {
    strength_b += b.mesh.edge(e).strength;
    sharpness_b += b.mesh.edge(e).sharpness;
  }
  // The lines are sampled where the cells are, which rounding may divide differently: integrals along them differ by
  // their discretisation error.
  EXPECT_NEAR(strength_a / strength_b, 1, 1e-2);
  EXPECT_NEAR(sharpness_a / sharpness_b, 1, 5e-2);
}

INSTANTIATE_TEST_SUITE_P(Algebraic, Generic_surfaces, testing::ValuesIn(all_surfaces),
                         [](const auto& info) { return info.param.name; });
