// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// `make_cell_complex()`, through which all cells go, throws unless they form an oriented 2-manifold; what is
// asserted here is the rest.
#include <CGAL/Extremal_mesh_3/Formula.h>
#include <CGAL/Extremal_mesh_3/Functor_function.h>

#include "surfaces.h"

#include <limits>
#include <map>
#include <numbers>
#include <numeric>
#include <set>

using namespace CGAL::Extremal_mesh_3;

namespace {

using namespace surfaces;

bool closed(const Cell_complex& c) {
  return std::all_of(c.edge_cells.begin(), c.edge_cells.end(), [](const auto& x) { return x[0] >= 0 && x[1] >= 0; });
}

Point middle_of(const Cell_complex& c, std::size_t cell) {
  Point m{};
  const double n = double(c.cell_begin[cell + 1] - c.cell_begin[cell]);
  for (std::size_t h = c.cell_begin[cell]; h < c.cell_begin[cell + 1]; ++h)
    m = along(m, 1 / n, c.points[c.source(c.half_edges[h])]);
  return m;
}

Vector normal_of_cell(const Cell_complex& c, std::size_t cell) {
  Vector n{};
  const Point m = middle_of(c, cell);
  for (std::size_t h = c.cell_begin[cell]; h < c.cell_begin[cell + 1]; ++h)
    n = along(
        n, 0.5,
        cross(along(c.points[c.source(c.half_edges[h])], -1, m), along(c.points[c.target(c.half_edges[h])], -1, m)));
  return n;
}

/// The volume inside of a closed surface, positive if its normals point outwards. Cells are cones over their middle.
double volume(const Cell_complex& c) {
  double v = 0;
  for (std::size_t cell = 0; cell < c.number_of_cells(); ++cell)
    v += dot(middle_of(c, cell), normal_of_cell(c, cell)) / 3;
  return v;
}

void expect_distinct_points(const Cell_complex& c) {
  EXPECT_EQ(std::set<Point>(c.points.begin(), c.points.end()).size(), c.points.size());
  for (const auto& [a, b] : c.edges)
    EXPECT_GT(distance(c.points[a], c.points[b]), 0);
}

/// \param slack  the error of a position, relative to coordinates of the size 1
void expect_on_surface(const Function_3& f, const Cell_complex& c, double slack = 1e-14) {
  Derivatives d;
  for (const Point& p : c.points) {
    f.derivatives(p, 1, d);
    EXPECT_LT(std::abs(d.value), slack * (1 + length(p)) * (1 + length(d.gradient)));
  }
}

Lattice cubes(double half, std::size_t resolution) {
  return make_lattice({-half, -half, -half}, {half, half, half}, resolution);
}

struct Known {
  std::string name, formula;
  double half;
  std::int64_t euler_characteristic;
};
const std::vector<Known> known = {{"sphere", "x^2+y^2+z^2-1", 1.3, 2},
                                  {"torus", "(x^2+y^2+z^2+0.75)^2-4*(x^2+y^2)", 1.9, 0},
                                  {"tanglecube", "x^4+y^4+z^4-5*x^2-5*y^2-5*z^2+11.8", 3, -8}};

/// Random values at the nodes of a lattice of cubes of side 1, interpolated by products of cosines: a smooth function
/// with every combination of signs. Its period is twice the lattice's size.
class Random_signs : public Function_3 {
public:
  Random_signs(unsigned seed, std::size_t n) : n_(n) {
    std::mt19937 random(seed);
    for (std::size_t i = 0; i < n * n * n; ++i)
      value_.push_back(2 * (double(random()) / 4294967295.0) - 1);
  }
  double value(const Point& p) const override {
    Derivatives d;
    derivatives(p, 1, d);
    return d.value;
  }
  void derivatives(const Point& p, int, Derivatives& d) const override { // of order 1: no more is asked for
    d = {};
    std::array<std::size_t, 3> base{};
    std::array<std::array<double, 2>, 3> weight{}, slope{};
    for (std::size_t a = 0; a < 3; ++a) {
      const double floor = std::clamp(std::floor(p[a]), 0.0, double(n_ - 2));
      base[a] = std::size_t(floor);
      const double t = std::numbers::pi * std::clamp(p[a] - floor, 0.0, 1.0);
      weight[a] = {(1 + std::cos(t)) / 2, (1 - std::cos(t)) / 2};
      slope[a] = {-std::numbers::pi * std::sin(t) / 2, std::numbers::pi * std::sin(t) / 2};
    }
    for (std::size_t c = 0; c < 8; ++c) {
      const std::size_t i = c & 1, j = c >> 1 & 1, k = c >> 2 & 1;
      const double v = value_[(base[0] + i) + n_ * ((base[1] + j) + n_ * (base[2] + k))];
      d.value += v * weight[0][i] * weight[1][j] * weight[2][k];
      d.gradient[0] += v * slope[0][i] * weight[1][j] * weight[2][k];
      d.gradient[1] += v * weight[0][i] * slope[1][j] * weight[2][k];
      d.gradient[2] += v * weight[0][i] * weight[1][j] * slope[2][k];
    }
  }

private:
  std::size_t n_;
  std::vector<double> value_;
};

} // namespace

TEST(Implicit_cells, have_the_euler_characteristic_of_the_surface_at_every_resolution) {
  for (const Known& k : known) {
    const Formula f(k.formula);
    for (const std::size_t resolution : {12U, 13U, 17U, 20U, 31U, 40U, 64U}) {
      SCOPED_TRACE(k.name + " at " + std::to_string(resolution));
      const Cell_complex c = make_implicit_cells(f, cubes(k.half, resolution));
      EXPECT_TRUE(closed(c));
      EXPECT_EQ(c.euler_characteristic(), k.euler_characteristic);
      EXPECT_GT(volume(c), 0);
      expect_distinct_points(c);
      expect_on_surface(f, c);
    }
  }
}

TEST(Implicit_cells, enclose_the_volume_of_a_ball) {
  // Chords of length h lie below an arc of radius 1 by at most h²/8, over the area 4π.
  const double h = std::sqrt(3.0) * 2.6 / 64;
  const double v = volume(make_implicit_cells(Formula("x^2+y^2+z^2-1"), cubes(1.3, 64)));
  EXPECT_NEAR(v, 4 * std::numbers::pi / 3, 4 * std::numbers::pi * h * h / 8);
}

TEST(Implicit_cells, face_the_side_where_f_is_positive) {
  for (const Known& k : known) {
    const Formula f(k.formula);
    const Cell_complex c = make_implicit_cells(f, cubes(k.half, 40));
    Derivatives d;
    for (std::size_t i = 0; i < c.number_of_cells(); ++i) {
      f.derivatives(c.points[c.source(c.half_edges[c.cell_begin[i]])], 1, d);
      EXPECT_GT(dot(normal_of_cell(c, i), d.gradient), 0) << k.name << ", cell " << i;
    }
    EXPECT_LT(volume(make_implicit_cells(Moved_function(f, {}, -1), cubes(k.half, 20))), 0);
  }
}

TEST(Implicit_cells, do_not_depend_on_the_handedness_of_the_lattice) {
  for (const Known& k : known) {
    const Formula f(k.formula);
    const Lattice right = cubes(k.half, 24);
    Lattice left = right;
    left.origin = right.node(double(right.size[0] - 1), 0, 0);
    left.step[0] = {-right.step[0][0], 0, 0};
    const Cell_complex a = make_implicit_cells(f, right), b = make_implicit_cells(f, left);
    EXPECT_EQ(b.euler_characteristic(), k.euler_characteristic);
    EXPECT_GT(volume(b), 0);
    EXPECT_NEAR(volume(a), volume(b), 1e-9 * volume(a)); // the same polygons, with points equal to rounding
    EXPECT_EQ(a.points.size(), b.points.size());
  }
}

TEST(Implicit_cells, are_a_manifold_for_any_signs) {
  for (unsigned seed = 1; seed <= 4; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const std::size_t n = 8; // 343 cubes each: all 256 combinations of signs, up to symmetry
    const Random_signs f(seed, n);
    const Lattice lattice{{0, 0, 0}, {Vector{1, 0, 0}, Vector{0, 1, 0}, Vector{0, 0, 1}}, {n, n, n}};
    const Cell_complex c = make_implicit_cells(f, lattice);
    expect_distinct_points(c);
    expect_on_surface(f, c, 1e-13);
    EXPECT_FALSE(closed(c));
    // The border lies on the sides of the lattice.
    for (std::size_t e = 0; e < c.edges.size(); ++e)
      if (c.edge_cells[e][0] < 0 || c.edge_cells[e][1] < 0) {
        bool on_side = false;
        for (std::size_t a = 0; a < 3; ++a)
          for (const double side : {0.0, double(n - 1)})
            on_side = on_side || (std::abs(c.points[c.edges[e][0]][a] - side) < 0.1 &&
                                  std::abs(c.points[c.edges[e][1]][a] - side) < 0.1);
        EXPECT_TRUE(on_side);
      }
  }
}

TEST(Implicit_cells, are_a_manifold_for_waves_of_the_length_of_cubes) {
  for (unsigned seed = 1; seed <= 2; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Motion m = random_motion(seed);
    const auto& R = m.R;
    const auto f = make_function([R](auto x, auto y, auto z) {
      using std::cos;
      auto sum = cos(3.1 * x) + cos(2.9 * y) + cos(3.3 * z);
      for (const Vector& r : R)
        sum = sum + cos(5.0 * (r[0] * x + r[1] * y + r[2] * z) + r[0]);
      return sum;
    });
    const Cell_complex c = make_implicit_cells(f, make_lattice({0, 0, 0}, {8, 8, 8}, 9));
    expect_distinct_points(c);
    expect_on_surface(f, c, 1e-13);
  }
}

TEST(Implicit_cells, survive_zeros_at_nodes) {
  // Whole coordinates: x² + y² + z² = 25 holds at 30 nodes; the others vanish at many nodes or on whole planes of them.
  const Lattice whole{{-7, -7, -7}, {Vector{1, 0, 0}, Vector{0, 1, 0}, Vector{0, 0, 1}}, {15, 15, 15}};
  for (const std::string formula :
       {"x^2+y^2+z^2-25", "25-x^2-y^2-z^2", "x^2+y^2+z^2-9", "x+y+z", "x", "x*y-z", "x^2+y^2-z^2-1"}) {
    SCOPED_TRACE(formula);
    const Formula f(formula);
    const Cell_complex c = make_implicit_cells(f, whole);
    expect_distinct_points(c);
    expect_on_surface(f, c);
    if (formula.find("25") != std::string::npos || formula.find('9') != std::string::npos) {
      EXPECT_TRUE(closed(c));
      EXPECT_EQ(c.euler_characteristic(), 2);
    }
  }
}

TEST(Implicit_cells, survive_surfaces_that_cross_themselves_at_nodes) {
  // Not manifolds: sign(0) is +, so the cells are those of a surface that passes beside the crossings.
  const Lattice whole{{-3, -3, -3}, {Vector{1, 0, 0}, Vector{0, 1, 0}, Vector{0, 0, 1}}, {7, 7, 7}};
  for (const std::string formula : {"x*y*z", "x*y", "x^2+y^2-z^2", "x*y*(z-1)"}) {
    SCOPED_TRACE(formula);
    EXPECT_GT(make_implicit_cells(Formula(formula), whole).number_of_cells(), 0U);
  }
}

TEST(Implicit_cells, have_a_border_where_the_surface_leaves_the_box) {
  // The upper half of a sphere is a disk, a cylinder without ends a ring.
  const Cell_complex half =
      make_implicit_cells(Formula("x^2+y^2+z^2-1"), make_lattice({-1.2, -1.2, 0.013}, {1.2, 1.2, 1.2}, 24));
  EXPECT_FALSE(closed(half));
  EXPECT_EQ(half.euler_characteristic(), 1);
  const Cell_complex ring =
      make_implicit_cells(Formula("x^2+y^2-1"), make_lattice({-1.2, -1.2, -1}, {1.2, 1.2, 1}, 24));
  EXPECT_EQ(ring.euler_characteristic(), 0);
}

TEST(Implicit_cells, have_a_border_where_f_is_not_defined) {
  // sqrt(z) exists for z ≥ 0 only: x² + y² + z = 1 from its apex down to the plane, a disk.
  const Cell_complex c =
      make_implicit_cells(Formula("x^2+y^2+sqrt(z)^2-1"), make_lattice({-1.2, -1.2, -1}, {1.2, 1.2, 1.2}, 24));
  EXPECT_FALSE(closed(c));
  EXPECT_EQ(c.euler_characteristic(), 1);
  for (const Point& p : c.points)
    EXPECT_GE(p[2], 0);
}

TEST(Implicit_cells, do_not_depend_on_threads) {
  const Formula f(known[2].formula);
  Extraction_options one, two;
  one.threads = 1;
  two.threads = 2;
  const Cell_complex a = make_implicit_cells(f, cubes(3, 40), one), b = make_implicit_cells(f, cubes(3, 40), two);
  EXPECT_EQ(a.points, b.points);
  EXPECT_EQ(a.edges, b.edges);
  EXPECT_EQ(a.edge_cells, b.edge_cells);
  EXPECT_EQ(a.cell_begin, b.cell_begin);
  EXPECT_EQ(a.half_edges, b.half_edges);
}

TEST(Implicit_cells, tell_when_there_is_no_surface) {
  EXPECT_THROW(make_implicit_cells(Formula("x^2+y^2+z^2+1"), cubes(1, 8)), Extraction_error);
  EXPECT_THROW(make_implicit_cells(Formula("x^2+y^2+z^2-9"), cubes(1, 8)), Extraction_error);
  EXPECT_THROW(make_implicit_cells(Formula("sqrt(x-5)"), cubes(1, 8)), Extraction_error);
}

TEST(Implicit_cells, refuse_a_lattice_without_cubes) {
  Lattice flat = cubes(1, 8);
  flat.size[1] = 1;
  EXPECT_THROW(make_implicit_cells(Formula("x"), flat), std::invalid_argument);
}

TEST(Implicit_cells, can_be_cancelled) {
  Extraction_options options;
  options.progress = [](double done) { return done < 0.5; };
  EXPECT_THROW(make_implicit_cells(Formula("x"), cubes(1, 40), options), Cancelled);
}
