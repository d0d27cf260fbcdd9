// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a surface's extremal mesh is registered with: the same surface elsewhere, a part of it, its mirror image, another one.
#include <CGAL/Extremal_mesh_3/compare.h>
#include <CGAL/Extremal_mesh_3/register.h>

#include "changed_mesh.h"
#include "random_surfaces.h"
#include "same_mesh.h"
#include "surfaces.h"

#include <numbers>

using namespace CGAL::Extremal_mesh_3;

namespace {

/// an ellipsoid with waves, without any symmetry: some hundred extremal points.
auto wavy(double phase, double height = 0.01) {
  return make_function([phase, height](auto x, auto y, auto z) {
    using std::cos;
    using std::sin;
    return x * x / 9 + y * y / 4 + z * z + height * sin(4 * x + phase) * cos(5 * y + 1) + 0.05 * x * y * z - 1;
  });
}
const surfaces::Box box_of_wavy{{-3.3, -2.2, -1.2}, {3.3, 2.2, 1.2}};

/// \param part  of the box, along its first axis
Extremal_mesh mesh_of(const Function_3& f, surfaces::Box box, double part = 1) {
  box.high[0] = box.low[0] + part * (box.high[0] - box.low[0]);
  return extract_extremal_mesh(f, make_lattice(box.low, box.high, std::size_t(72 * std::max(part, 0.7)))).mesh;
}

/// the mesh of a surface that was moved; it is made anew, on another lattice.
Extremal_mesh moved_mesh(const Function_3& f, const surfaces::Box& box, const surfaces::Motion& motion, double part = 1,
                         double sign = 1) {
  return mesh_of(surfaces::Moved_function(f, motion, sign), surfaces::moved(box, motion).widened(0.01), part);
}

/// the greatest distance between where a vertex was taken and where it is.
double greatest_error(const Similarity& s, const surfaces::Motion& motion, const Extremal_mesh& mesh) {
  double greatest = 0;
  for (std::size_t v = 0; v < mesh.number_of_vertices(); ++v)
    greatest = std::max(greatest, surfaces::distance(s(mesh.vertex(v).point), motion(mesh.vertex(v).point)));
  return greatest;
}

void expect_found(const Registration& r, const surfaces::Motion& motion, const Extremal_mesh& mesh, double accuracy) {
  EXPECT_TRUE(r.found) << r.reason;
  EXPECT_EQ(r.reason, "");
  EXPECT_LT(greatest_error(r.transform, motion, mesh), accuracy);
}

const Extremal_mesh& wavy_mesh() {
  static const Extremal_mesh mesh = mesh_of(wavy(0), box_of_wavy);
  return mesh;
}

class Motions : public testing::TestWithParam<unsigned> {};

} // namespace

TEST(Similarity, is_undone_by_its_inverse_and_read_back_from_its_matrix) {
  for (const bool mirror : {false, true}) {
    surfaces::Motion motion = surfaces::random_motion(7, 5);
    if (mirror)
      motion = surfaces::mirrored(motion);
    const Similarity s{motion.R, motion.translation, 1.7};
    EXPECT_EQ(s.mirrors(), mirror);
    const Point p{1, -2, 3};
    EXPECT_LT(surfaces::distance((s.inverse() * s)(p), p), 1e-14);
    EXPECT_LT(surfaces::distance(similarity_of_matrix(s.matrix())(p), s(p)), 1e-14);
    EXPECT_LT(rotation_angle(s.inverse() * s), 1e-14);
  }
}

TEST(Similarity, is_not_made_of_any_matrix) {
  const auto with = [](std::size_t i, std::size_t j, double x) {
    auto m = Similarity().matrix();
    m[i][j] = x;
    return m;
  };
  EXPECT_THROW(similarity_of_matrix(with(0, 1, 0.1)), std::invalid_argument);
  EXPECT_THROW(similarity_of_matrix(with(3, 0, 1)), std::invalid_argument);
  EXPECT_THROW(similarity_of_matrix(with(2, 2, 0)), std::invalid_argument);
  EXPECT_THROW(similarity_of_matrix(with(0, 3, std::nan(""))), std::invalid_argument);
}

TEST(Rotation_angle, is_that_of_the_turn) {
  for (const double angle : {1e-9, 0.3, 2.0, std::numbers::pi}) {
    Similarity s;
    s.rotation = {Vector{std::cos(angle), -std::sin(angle), 0}, Vector{std::sin(angle), std::cos(angle), 0},
                  Vector{0, 0, 1}};
    EXPECT_NEAR(rotation_angle(s), angle, 1e-12);
  }
}

TEST_P(Motions, of_random_ellipsoids_are_found) {
  const auto f = random_surfaces::ellipsoid(GetParam());
  const surfaces::Box box = random_surfaces::box_of(f);
  const surfaces::Motion motion = surfaces::random_motion(GetParam() + 100, 20);
  const Extremal_mesh a = mesh_of(f, box), b = moved_mesh(f, box, motion);
  const Registration r = register_extremal_meshes(a, b);
  // vertices are exact up to rounding of the function's values, lines are not
  expect_found(r, motion, a, 1e-4);
  EXPECT_EQ(r.matched.size(), a.number_of_vertices());
  EXPECT_LT(r.rms, 1e-4);
  EXPECT_LT(r.rotation_error, 1e-3);
  EXPECT_TRUE(r.alternatives.empty());
}
INSTANTIATE_TEST_SUITE_P(Seeds, Motions, testing::Range(1U, 4U));

TEST(Registration, finds_a_surface_with_many_vertices_wherever_it_is) {
  const surfaces::Motion motion = surfaces::random_motion(3, 50);
  const Extremal_mesh b = moved_mesh(wavy(0), box_of_wavy, motion);
  expect_found(register_extremal_meshes(wavy_mesh(), b), motion, wavy_mesh(), 1e-4);
}

TEST(Registration, finds_a_surface_with_its_normals_on_the_other_side) {
  const surfaces::Motion motion = surfaces::random_motion(4, 5);
  const Registration r = register_extremal_meshes(wavy_mesh(), moved_mesh(wavy(0), box_of_wavy, motion, 1, -1));
  expect_found(r, motion, wavy_mesh(), 1e-4);
  EXPECT_TRUE(r.normals_reversed);
}

TEST(Registration, finds_what_two_parts_of_a_surface_have_in_common) {
  // About half a turn around z: what is cut away of one has the least x, of the other one the greatest.
  const double c = std::cos(3.0), s = std::sin(3.0);
  surfaces::Motion motion;
  motion.R = {Vector{c, -s, 0}, Vector{s, c, 0}, Vector{0, 0, 1}};
  motion.translation = {3, 1, -2};
  const Extremal_mesh a = mesh_of(wavy(0), box_of_wavy, 0.66), b = moved_mesh(wavy(0), box_of_wavy, motion, 0.66);
  const Registration r = register_extremal_meshes(a, b);
  expect_found(r, motion, a, 1e-3);
  EXPECT_LT(r.evidence.overlap, 0.8);
}

TEST(Registration, finds_a_mirror_image_only_if_it_is_asked_to) {
  const surfaces::Motion motion = surfaces::mirrored(surfaces::random_motion(6, 5));
  const Extremal_mesh b = moved_mesh(wavy(0), box_of_wavy, motion);
  Registration_options options;
  const Registration without = register_extremal_meshes(wavy_mesh(), b, options);
  EXPECT_FALSE(without.found);
  EXPECT_NE(without.reason, "");
  options.mirror = true;
  const Registration with = register_extremal_meshes(wavy_mesh(), b, options);
  expect_found(with, motion, wavy_mesh(), 1e-4);
  EXPECT_TRUE(with.transform.mirrors());
}

TEST(Registration, finds_a_scale_only_if_it_is_asked_to) {
  surfaces::Motion motion = surfaces::random_motion(8, 5);
  motion.scale = 1.3;
  const Extremal_mesh b = moved_mesh(wavy(0), box_of_wavy, motion);
  Registration_options options;
  EXPECT_FALSE(register_extremal_meshes(wavy_mesh(), b, options).found);
  options.scale = true;
  const Registration r = register_extremal_meshes(wavy_mesh(), b, options);
  expect_found(r, motion, wavy_mesh(), 1e-3);
  EXPECT_NEAR(r.transform.scale, 1.3, 1e-4);
}

TEST(Registration, claims_nothing_of_another_surface) {
  // the same but for where its waves are, which are higher than the tolerance
  const Extremal_mesh a = mesh_of(wavy(0, 0.05), box_of_wavy), b = mesh_of(wavy(2, 0.05), box_of_wavy);
  const Registration r = register_extremal_meshes(a, b);
  EXPECT_FALSE(r.found);
  EXPECT_NE(r.reason, "");
  EXPECT_TRUE(r.matched.empty());
  const auto ellipsoid = random_surfaces::ellipsoid(1), other = random_surfaces::ellipsoid(2);
  EXPECT_FALSE(register_extremal_meshes(mesh_of(ellipsoid, random_surfaces::box_of(ellipsoid)),
                                        mesh_of(other, random_surfaces::box_of(other)))
                   .found);
}

TEST(Registration, tells_of_the_other_motions_of_a_symmetric_surface) {
  const auto ellipsoid = make_function([](auto x, auto y, auto z) { return x * x / 9 + y * y / 4 + z * z - 1; });
  const Extremal_mesh a = mesh_of(ellipsoid, {{-3.1, -2.1, -1.1}, {3.1, 2.1, 1.1}});
  const Registration r = register_extremal_meshes(a, a);
  EXPECT_TRUE(r.found) << r.reason;
  EXPECT_EQ(r.alternatives.size(), 3U); // half-turns about the axes
}

TEST(Registration, does_not_depend_on_the_number_of_threads) {
  const auto f = random_surfaces::ellipsoid(9);
  const surfaces::Box box = random_surfaces::box_of(f);
  const Extremal_mesh a = mesh_of(f, box), b = moved_mesh(f, box, surfaces::random_motion(9, 5));
  Registration_options options;
  options.threads = 1;
  const Registration one = register_extremal_meshes(a, b, options);
  options.threads = 4;
  const Registration four = register_extremal_meshes(a, b, options);
  EXPECT_EQ(one.transform.matrix(), four.transform.matrix());
  EXPECT_EQ(one.rotation_error, four.rotation_error);
  EXPECT_EQ(one.matched.size(), four.matched.size());
}

TEST(Registration, refuses_what_makes_no_sense) {
  Registration_options options;
  options.tolerance = -1;
  EXPECT_THROW(register_extremal_meshes(wavy_mesh(), wavy_mesh(), options), std::invalid_argument);
  const Extremal_mesh broken =
      changed(wavy_mesh(), [](auto& parts) { parts.vertices[0].point[0] = std::numeric_limits<double>::infinity(); });
  EXPECT_THROW(register_extremal_meshes(broken, wavy_mesh()), std::invalid_argument);
}

TEST(Registration, of_nothing_is_not_found) {
  const Extremal_mesh empty({}, {}, std::vector<Extremal_mesh_cell>(1), {});
  EXPECT_FALSE(register_extremal_meshes(empty, empty).found);
  EXPECT_FALSE(register_extremal_meshes(empty, wavy_mesh()).found);
  EXPECT_NE(register_extremal_meshes(wavy_mesh(), empty).reason, "");
}

TEST(Comparison, of_a_mesh_with_itself_finds_everything_in_its_place) {
  const Comparison c = compare_extremal_meshes(wavy_mesh(), wavy_mesh());
  ASSERT_EQ(c.rows.size(), 9U);
  for (const Comparison_row& row : c.rows) {
    EXPECT_EQ(row.number_a, row.number_b) << row.type;
    if (row.number_a > 0) {
      EXPECT_NEAR(row.matched, 1, 1e-12) << row.type;
      EXPECT_NEAR(row.matched_back, 1, 1e-12) << row.type;
      EXPECT_LT(row.rms, 1e-9) << row.type;
      EXPECT_LT(row.chance, 0.9) << row.type;
    }
  }
  EXPECT_EQ(c.edges, 1);
  EXPECT_EQ(c.cells, 1);
  EXPECT_NEAR(c.area_of_cells, 1, 1e-12);
}

TEST(Comparison, after_registration_finds_everything_of_a_moved_surface) {
  for (const bool mirror : {false, true}) {
    surfaces::Motion motion = surfaces::random_motion(11, 5);
    if (mirror)
      motion = surfaces::mirrored(motion);
    Comparison_options options;
    options.transform = {motion.R, motion.translation, 1};
    const Comparison c = compare_extremal_meshes(wavy_mesh(), moved_mesh(wavy(0), box_of_wavy, motion), options);
    for (const Comparison_row& row : c.rows)
      if (row.number_a > 0) {
        EXPECT_GT(row.matched, 0.999) << row.type;
      }
    // Which of two types has the greater part of an edge's length can change with its polyline.
    EXPECT_GT(c.edges, 0.98);
    EXPECT_GT(c.cells, 0.95); // with the other sign where there is a mirror
  }
}

TEST(Comparison, of_different_surfaces_finds_what_chance_finds) {
  const Comparison c = compare_extremal_meshes(wavy_mesh(), mesh_of(wavy(1.5), box_of_wavy));
  for (const Comparison_row& row : c.rows)
    if (row.number_a > 50) {
      EXPECT_LT(row.matched, 0.5) << row.type;
    }
  EXPECT_LT(c.cells, 0.1);
}

TEST(Comparison, takes_no_tolerance_that_is_none) {
  Comparison_options options;
  options.tolerance = -2;
  EXPECT_THROW(compare_extremal_meshes(wavy_mesh(), wavy_mesh(), options), std::invalid_argument);
}
