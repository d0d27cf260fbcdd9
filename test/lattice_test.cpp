// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Extremal_mesh_3/Lattice.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

using namespace CGAL::Extremal_mesh_3;

namespace {

std::string error_of(const Point& low, const Point& high, std::size_t resolution) {
  try {
    make_lattice(low, high, resolution);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "no error";
}

} // namespace

TEST(Lattice, puts_nodes_where_its_steps_lead) {
  const Lattice lattice{{1, 2, 3}, {{{0, 2, 0}, {-1, 0, 0}, {0, 0, 0.5}}}, {2, 2, 2}};
  EXPECT_EQ(lattice.node(1, 1, 1), (Point{0, 4, 3.5}));
  EXPECT_EQ(lattice.node(0.5, 0, 0), (Point{1, 3, 3}));
}

TEST(make_lattice, covers_the_box_with_cubes) {
  const Lattice lattice = make_lattice({-1, 0, 2}, {1, 1, 2.3}, 8);
  EXPECT_EQ(lattice.origin, (Point{-1, 0, 2}));
  EXPECT_EQ(lattice.step, (std::array<Vector, 3>{Vector{0.25, 0, 0}, Vector{0, 0.25, 0}, Vector{0, 0, 0.25}}));
  EXPECT_EQ(lattice.size, (std::array<std::size_t, 3>{9, 5, 3})); // 0.3 takes two cubes of 0.25
}

TEST(make_lattice, adds_no_cube_for_a_rounding_error) {
  for (std::size_t n = 1; n <= 1000; ++n) {
    const Lattice lattice = make_lattice({-1.1, -1.1, 0.1}, {1.1, 1.1, 1.2}, 2 * n); // 1.1 is half of 2.2, nearly
    EXPECT_EQ(lattice.size, (std::array<std::size_t, 3>{2 * n + 1, 2 * n + 1, n + 1})) << n;
  }
}

TEST(make_lattice, has_at_least_one_cube_on_an_axis) {
  EXPECT_EQ(make_lattice({0, 0, 0}, {1, 1e-12, 1e-12}, 4).size, (std::array<std::size_t, 3>{5, 2, 2}));
}

TEST(make_lattice, refuses_what_is_no_box) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  EXPECT_NE(error_of({0, 0, 0}, {1, nan, 1}, 4).find("y range"), std::string::npos);
  EXPECT_NE(error_of({0, 0, -infinity}, {1, 1, 1}, 4).find("z range"), std::string::npos);
  EXPECT_NE(error_of({0, 0, 0}, {1, 1, 0}, 4).find("z range is empty"), std::string::npos);
  EXPECT_NE(error_of({2, 0, 0}, {1, 1, 1}, 4).find("low 2 is not below high 1"), std::string::npos);
  EXPECT_NE(error_of({0, 0, 0}, {1, 1, 1}, 0).find("resolution is 0"), std::string::npos);
  EXPECT_NE(error_of({0, 0, 0}, {1, 1, 1}, 20000).find("more than 2^40 nodes"), std::string::npos);
  EXPECT_NE(error_of({-1e308, 0, 0}, {1e308, 1, 1}, 4).find("too large"), std::string::npos);
  EXPECT_NE(error_of({1e16, 0, 0}, {1e16 + 2, 1, 1}, 4).find("lost to rounding"), std::string::npos);
}
