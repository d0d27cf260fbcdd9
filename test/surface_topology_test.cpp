// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Surfaces with parts that are small or thin against the cubes of the lattice.
#include <CGAL/Extremal_mesh_3/Formula.h>
#include <CGAL/Extremal_mesh_3/Functor_function.h>

#include "surfaces.h"

#include <fmt/format.h>

#include <chrono>
#include <numeric>

using namespace CGAL::Extremal_mesh_3;

namespace {

Lattice cubes(double half, std::size_t resolution) {
  return make_lattice({-half, -half, -half}, {half, half, half}, resolution);
}

bool is_closed(const Cell_complex& c) {
  return std::all_of(c.edge_cells.begin(), c.edge_cells.end(), [](const auto& x) { return x[0] >= 0 && x[1] >= 0; });
}

std::size_t components(const Cell_complex& c) {
  std::vector<std::uint32_t> parent(c.points.size());
  std::iota(parent.begin(), parent.end(), 0U);
  const auto find = [&](std::uint32_t p) {
    while (parent[p] != p)
      p = parent[p] = parent[parent[p]];
    return p;
  };
  std::size_t n = c.points.size();
  for (const auto& [a, b] : c.edges) {
    const std::uint32_t p = find(a), q = find(b);
    parent[p] = q;
    n -= p != q;
  }
  return n;
}

struct Topology {
  std::size_t components = 0;
  std::int64_t euler_characteristic = 0;
  bool closed = false;

  friend bool operator==(const Topology&, const Topology&) = default;
  friend std::ostream& operator<<(std::ostream& out, const Topology& t) {
    return out << t.components << " components, Euler characteristic " << t.euler_characteristic
               << (t.closed ? ", closed" : ", with border");
  }
};

Topology topology_of(const Cell_complex& c) {
  return {components(c), c.euler_characteristic(), is_closed(c)};
}

Topology topology(const Function_3& f, const Lattice& lattice, Surface_report& report) {
  return topology_of(make_implicit_cells(f, lattice, {}, &report));
}

/// asserts that a surface in the cube [−half, half]³ is proved to have its topology at all resolutions.
void expect_proved(const std::string& formula, double half, const std::vector<std::size_t>& resolutions,
                   const Topology& expected) {
  const Formula f(formula);
  for (const std::size_t resolution : resolutions) {
    SCOPED_TRACE(formula + " at " + std::to_string(resolution));
    Surface_report report;
    EXPECT_EQ(topology(f, cubes(half, resolution), report), expected);
    EXPECT_EQ(report.certainty, Surface_certainty::proved);
    EXPECT_EQ(report.undecided_cubes, 0U);
  }
}

/// a formula with all the powers of random_surfaces.h, for surfaces of a random genus.
std::string wavy(unsigned seed) {
  std::mt19937 random(seed);
  const auto uniform = [&](double low, double high) { return low + (high - low) * (double(random()) / 4294967295.0); };
  std::string f = "x^2+y^2+z^2-1.2";
  for (int i = 0; i < 6; ++i)
    f += fmt::format("{:+.4f}*sin({:.4f}*x{:+.4f}*y{:+.4f}*z{:+.4f})", uniform(-0.5, 0.5), uniform(1, 4),
                     uniform(-4, 4), uniform(-4, 4), uniform(-3, 3));
  return f;
}

} // namespace

TEST(Surface_topology, of_known_surfaces_is_proved_at_every_resolution) {
  const std::vector<std::size_t> resolutions{5, 6, 7, 8, 9, 10, 11, 12, 20, 33};
  expect_proved("x^2+y^2+z^2-1", 1.3, resolutions, {1, 2, true});
  expect_proved("(x^2+y^2+z^2+0.75)^2-4*(x^2+y^2)", 1.9, resolutions, {1, 0, true});
  expect_proved("x^4+y^4+z^4-5*x^2-5*y^2-5*z^2+11.8", 3, resolutions, {1, -8, true});
  // Genus 5 as well, and 8 separate balls.
  expect_proved("x^4+y^4+z^4-5*x^2-5*y^2-5*z^2+17", 3, resolutions, {8, 16, true});
}

TEST(Surface_topology, of_random_surfaces_is_the_same_at_coarse_and_fine_resolutions) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Formula f(wavy(seed));
    Surface_report report;
    const Topology fine = topology(f, cubes(2.2, 48), report);
    EXPECT_EQ(report.undecided_cubes, 0U);
    for (const std::size_t resolution : {5U, 8U, 12U}) {
      EXPECT_EQ(topology(f, cubes(2.2, resolution), report), fine) << "at resolution " << resolution;
      EXPECT_EQ(report.undecided_cubes, 0U);
    }
  }
}

TEST(Surface_topology, keeps_apart_spheres_with_a_gap_far_smaller_than_a_cube) {
  // Of radius 1, the gap between them a fifteenth of a cube.
  const auto spheres = [](double gap) {
    return fmt::format("min((x-{0})^2+y^2+z^2, (x+{0})^2+y^2+z^2) - 1", 1 + gap / 2);
  };
  expect_proved(spheres(0.04), 2.3, {8, 9, 10}, {2, 4, true});
  // Smaller than the smallest cubes: that it is not known is told.
  for (const std::size_t resolution : {8U, 9U}) {
    Surface_report report;
    topology(Formula(spheres(0.001)), cubes(2.3, resolution), report);
    EXPECT_GT(report.undecided_cubes, 0U);
    EXPECT_LT(surfaces::length(report.first_undecided), 0.5);
  }
  // The same as a product, whose gradient vanishes in between.
  expect_proved("((x-1.02)^2+y^2+z^2-1)*((x+1.02)^2+(y-0.1)^2+z^2-1)", 2.3, {8, 9, 10, 16}, {2, 4, true});
}

TEST(Surface_topology, finds_an_ellipsoid_that_lies_within_one_cube) {
  // The cube from 0 to 0.5 holds the whole of it; beside it there is a sphere that anyone finds.
  const std::string small = "((x-0.23)^2/0.09^2+(y-0.27)^2/0.07^2+(z-0.25)^2/0.05^2-1)";
  expect_proved(small, 2, {4, 8}, {1, 2, true});
  expect_proved("min((x+1)^2+y^2+z^2-0.5, " + small + ")", 2, {4, 8}, {2, 4, true});
}

TEST(Surface_topology, finds_a_thin_tunnel_and_a_thin_handle) {
  // A ball of radius 1 with a hole along a skew line, a fifth of a cube wide; two balls joined by such a neck or not.
  const std::string along = "((y-0.1*x-0.03)^2+(z+0.07*x-0.02)^2)";
  expect_proved("x^2+y^2+z^2-1+0.001/(0.0001+" + along + ")", 1.3, {8, 9, 13}, {1, 0, true});
  expect_proved("(x^2-1)^2+3*y^2+3*z^2-1.001", 1.7, {8, 10, 15}, {1, 2, true});
  expect_proved("(x^2-1)^2+3*y^2+3*z^2-0.999", 1.7, {8, 10, 15}, {2, 4, true});
}

TEST(Surface_topology, finds_a_sheet_whose_two_sides_lie_within_one_cube) {
  // A disk, half a cube thick and sharp at its rim.
  expect_proved("x^2+y^2+(12*(z-0.03))^2-1", 1.3, {8, 9, 10}, {1, 2, true});
  // A hollow sphere with a thin wall.
  expect_proved("(x^2+y^2+z^2-1)^2-0.1^2", 1.4, {8, 12}, {2, 4, true});
}

TEST(Surface_topology, is_not_proved_where_the_surface_touches_itself_and_the_place_is_told) {
  struct Singular {
    std::string formula;
    Point where;
  };
  const std::vector<Singular> all = {{"x^2+y^2-z^2", {0, 0, 0}},                             // a cone's apex
                                     {"((x-1)^2+y^2+z^2-1)*((x+1)^2+y^2+z^2-1)", {0, 0, 0}}, // spheres that touch
                                     {"(x-0.3)^2+(y-0.2)^2+(z-0.1)^2", {0.3, 0.2, 0.1}}};    // a point
  for (const Singular& s : all)
    for (const std::size_t resolution : {7U, 12U}) {
      SCOPED_TRACE(s.formula);
      const Formula f(s.formula);
      Surface_report report;
      try {
        make_implicit_cells(f, cubes(2.2, resolution), {}, &report);
      } catch (const Extraction_error& error) { // the point, which has no inside
        EXPECT_NE(std::string(error.what()).find("decided"), std::string::npos) << error.what();
      }
      EXPECT_GT(report.undecided_cubes, 0U);
      EXPECT_LT(report.undecided_cubes, 5000U);
      EXPECT_LT(surfaces::distance(report.first_undecided, s.where), 4.4 / double(resolution));
    }
}

TEST(Surface_topology, is_given_up_in_time_where_nothing_can_be_decided) {
  // Double sheets, a surface that is an area, poles that look like surfaces: everywhere, so that there is no end to it.
  for (const std::string formula : {"x^2", "max(x^2+y^2+z^2-1, 0)", "1/(x-0.01)+y", "sign(x)+0.5*z"}) {
    SCOPED_TRACE(formula);
    const Formula f(formula);
    Surface_report report;
    const auto start = std::chrono::steady_clock::now();
    try {
      make_implicit_cells(f, cubes(1.4, 24), {}, &report);
    } catch (const Extraction_error&) {
    }
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    EXPECT_GT(report.undecided_cubes, 0U);
    EXPECT_LT(seconds.count(), 100); // far more than it takes, far less than without end
  }
}

TEST(Surface_topology, is_told_to_be_tested_where_f_cannot_be_bounded) {
  const auto f = make_function([](auto x, auto y, auto z) { return x * x + y * y + z * z - 1; });
  Surface_report report;
  EXPECT_EQ(topology(f, cubes(1.3, 12), report), (Topology{1, 2, true}));
  EXPECT_EQ(report.certainty, Surface_certainty::tested);
}

TEST(Surface_topology, of_functors_is_found_where_values_at_nodes_tell_of_more) {
  // As above, an ellipsoid within one cube, beside a sphere or not; and two balls joined by a neck thinner than a cube.
  const auto small = make_function([](auto x, auto y, auto z) {
    return square((x - 0.23) / 0.19) + square((y - 0.27) / 0.17) + square((z - 0.25) / 0.15) - 1;
  });
  const auto both = make_function([](auto x, auto y, auto z) {
    const auto far = square(x + 1) + square(y) + square(z) - 0.5;
    return far * (square((x - 0.23) / 0.19) + square((y - 0.27) / 0.17) + square((z - 0.25) / 0.15) - 1);
  });
  const auto neck = make_function(
      [](auto x, auto y, auto z) { return square(x * x - 1) + 3 * square(y - 0.03) + 3 * square(z + 0.05) - 1.01; });
  for (const std::size_t resolution : {4U, 8U}) {
    Surface_report report;
    EXPECT_EQ(topology(small, cubes(2, resolution), report), (Topology{1, 2, true}));
    EXPECT_EQ(report.certainty, Surface_certainty::tested);
    EXPECT_GT(report.divided_cubes, 0U);
  }
  Surface_report report;
  EXPECT_EQ(topology(both, cubes(2, 8), report), (Topology{2, 4, true}));
  EXPECT_EQ(topology(neck, cubes(1.7, 9), report), (Topology{1, 2, true}));
}

TEST(Surface_topology, needs_no_divided_cubes_where_the_lattice_is_fine) {
  for (const auto& [formula, half] :
       {std::pair{"x^2/9 + y^2/4 + z^2 - 1", 3.2}, std::pair{"(x^2+y^2+z^2+0.75)^2-4*(x^2+y^2)", 1.9},
        std::pair{"x^4+y^4+z^4-5*x^2-5*y^2-5*z^2+11.8", 3.0}}) {
    Surface_report report;
    make_implicit_cells(Formula(formula), cubes(half, 64), {}, &report);
    EXPECT_EQ(report.divided_cubes, 0U) << formula;
  }
}

TEST(Surface_topology, has_cells_that_do_not_depend_on_threads) {
  const Formula f(wavy(3));
  Extraction_options one, two;
  one.threads = 1;
  two.threads = 2;
  Surface_report a_report, b_report;
  const Cell_complex a = make_implicit_cells(f, cubes(2.2, 9), one, &a_report),
                     b = make_implicit_cells(f, cubes(2.2, 9), two, &b_report);
  EXPECT_GT(a_report.divided_cubes, 0U);
  EXPECT_EQ(a_report.divided_cubes, b_report.divided_cubes);
  EXPECT_EQ(a.points, b.points);
  EXPECT_EQ(a.half_edges, b.half_edges);
  EXPECT_EQ(a.edges, b.edges);
}

TEST(Surface_topology, is_proved_on_skew_and_left_handed_lattices) {
  const Formula f("x^4+y^4+z^4-5*x^2-5*y^2-5*z^2+11.8");
  const double s = 0.6;
  const Lattice skew{{-9.6, -9.6, -9.6}, {Vector{s, 0.1, 0}, Vector{0, s, 0.15}, Vector{0.12, 0, s}}, {33, 33, 33}};
  Lattice left = cubes(3, 10);
  left.origin[0] = 3;
  left.step[0][0] *= -1;
  for (const Lattice& lattice : {skew, left}) {
    Surface_report report;
    EXPECT_EQ(topology(f, lattice, report), (Topology{1, -8, true}));
    EXPECT_EQ(report.certainty, Surface_certainty::proved);
    EXPECT_EQ(report.undecided_cubes, 0U);
  }
}
