// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cells by CGAL's mesher are as good as those of the lattice.
#include <CGAL/Extremal_mesh_3/Formula.h>
#include <CGAL/Extremal_mesh_3/Functor_function.h>
#include <CGAL/Extremal_mesh_3/errors.h>
#include <CGAL/Extremal_mesh_3/make_cgal_cells.h>

#include "graph_comparison.h"
#include "surfaces.h"

#include <memory>
#include <thread>

using namespace CGAL::Extremal_mesh_3;

namespace {

std::size_t border_edges(const Cell_complex& c) {
  return std::size_t(std::count_if(c.edge_cells.begin(), c.edge_cells.end(), [](const auto& e) {
    return e[0] == Cell_complex::no_cell || e[1] == Cell_complex::no_cell;
  }));
}

/// the corners of triangle i.
std::array<Point, 3> corners(const Cell_complex& c, std::size_t i) {
  std::array<Point, 3> p;
  for (std::size_t k = 0; k < 3; ++k)
    p[k] = c.points[c.source(c.half_edges[3 * i + k])];
  return p;
}

Vector gradient(const Function_3& f, const Point& p) {
  Derivatives d;
  f.derivatives(p, 1, d);
  return d.gradient;
}

void expect_triangles_on(const Function_3& f, const Cell_complex& c) {
  ASSERT_EQ(c.half_edges.size(), 3 * c.number_of_cells());
  double size = 0;
  for (const Point& p : c.points)
    size = std::max(size, surfaces::length(p));
  for (const Point& p : c.points) {
    // Rounding of the coordinates, and of the terms of f, some of which are larger than the coordinates.
    EXPECT_LT(std::abs(f.value(p)), 1e-14 * std::max(size, 1.0) * std::max(surfaces::length(gradient(f, p)), 1.0));
  }
  for (std::size_t i = 0; i < c.number_of_cells(); ++i) {
    const auto [p, q, r] = corners(c, i);
    const Vector normal = surfaces::cross(surfaces::along(q, -1, p), surfaces::along(r, -1, p));
    EXPECT_GT(surfaces::dot(normal, gradient(f, p)), 0);
  }
}

void expect_same(const Cell_complex& a, const Cell_complex& b) {
  EXPECT_EQ(a.points, b.points);
  EXPECT_EQ(a.edges, b.edges);
  EXPECT_EQ(a.half_edges, b.half_edges);
}

template <class Error>
std::string message(const Function_3& f, const Lattice& lattice, const Cgal_mesh_options& o = {}) {
  try {
    make_cgal_cells(f, lattice, o);
  } catch (const Error& error) {
    return error.what();
  }
  return "accepted";
}

const Formula ellipsoid("x^2/9+y^2/4+z^2-1");
const Lattice around_ellipsoid = make_lattice({-3.2, -2.3, -1.2}, {3.3, 2.1, 1.3}, 24);

/// two ellipsoids 0.5 apart, of very different size.
const Formula two("((x+1)^2/9+y^2/4+z^2-1)*((x-2.8)^2+(y-0.1)^2/0.5+z^2/0.7-0.09)");
const Lattice around_two = make_lattice({-4.3, -2.3, -1.3}, {3.4, 2.2, 1.2}, 40);

struct Surface {
  std::string name, formula;
  double half_size; ///< of a cube that holds the surface
  std::size_t resolution;
  int euler_characteristic;
  friend std::ostream& operator<<(std::ostream& out, const Surface& s) { return out << s.name; }
};

// Those of generic_surfaces_test.
const std::vector<Surface> all_surfaces = {
    {"ellipsoid", "x^2/9+y^2/4+z^2-1", 3.4, 24, 2},
    {"egg", "x^2+2*y^2+4*z^2-1+0.15*x^3+0.1*y^3-0.2*x*y*z+0.1*x^2*z", 1.4, 24, 2},
    {"potato", "x^2+1.3*y^2+1.7*z^2+0.2*x^3+0.15*y^3-0.4*x*y*z+0.2*x^2*z+0.1*x*y^2-1", 1.4, 24, 2},
    {"cube", "x^2+1.05*y^2+0.96*z^2+x^4+y^4+z^4+0.05*x*y*z+0.03*x^3-0.02*y^3+0.025*y^2*z+0.02*x*y-1", 1.1, 24, 2},
    {"torus", "(x^2+y^2+z^2+0.84)^2-4*(x^2+y^2)+0.1*x^2+0.15*x*y*z+0.06*x^3+0.08*y*z^2+0.05*x*z+0.04*y^3", 1.8, 32, 0},
    {"tanglecube", "x^4+y^4+z^4-5.03*x^2-4.98*y^2-5*z^2+11.8+0.06*x*y*z+0.04*x^3-0.03*y^3+0.05*x*z^2+0.04*x*y", 3.2, 40,
     -8}};

class Cgal_cells : public testing::TestWithParam<Surface> {};

} // namespace

TEST_P(Cgal_cells, have_the_extremal_mesh_of_cells_on_a_lattice) {
  const Formula f(GetParam().formula);
  const double h = GetParam().half_size;
  const Lattice lattice = make_lattice({-h, -h, -h}, {h, h, h}, GetParam().resolution);
  const Cell_complex cells = make_cgal_cells(f, lattice);
  EXPECT_EQ(cells.euler_characteristic(), GetParam().euler_characteristic);
  EXPECT_EQ(border_edges(cells), 0U);
  expect_triangles_on(f, cells);

  const Extremal_mesh mesh = extract_extremal_mesh(f, cells).mesh, expected = extract_extremal_mesh(f, lattice).mesh;
  surfaces::expect_all_checks_hold(mesh);
  EXPECT_TRUE(graph_comparison::isomorphic(expected, mesh)) << surfaces::counts_of(expected) << '\n'
                                                            << surfaces::counts_of(mesh);
  for (const auto kind : {Vertex_kind::extremal_point, Vertex_kind::umbilic}) {
    const auto off = graph_comparison::largest_distance(graph_comparison::positions(expected, kind),
                                                        graph_comparison::positions(mesh, kind));
    ASSERT_TRUE(off);
    EXPECT_LT(*off, 1e-9 * 2 * h); // as for lattices in other positions, see generic_surfaces_test
  }
}

INSTANTIATE_TEST_SUITE_P(Algebraic, Cgal_cells, testing::ValuesIn(all_surfaces),
                         [](const auto& info) { return info.param.name; });

TEST(Cgal_cells, are_the_same_in_every_call) {
  const Cell_complex first = make_cgal_cells(ellipsoid, around_ellipsoid);
  // Other surfaces, and memory in another state, in between.
  make_cgal_cells(two, around_two);
  std::vector<std::unique_ptr<char[]>> memory;
  for (std::size_t i = 1; i < 2000; ++i)
    memory.push_back(std::make_unique<char[]>(37 * (i * 7919 % 1000)));
  for (std::size_t i = 0; i < memory.size(); i += 3)
    memory[i].reset();
  Cgal_mesh_options options;
  options.threads = 1;
  expect_same(first, make_cgal_cells(ellipsoid, around_ellipsoid, options));
  Cell_complex other;
  std::thread([&] { other = make_cgal_cells(ellipsoid, around_ellipsoid); }).join();
  expect_same(first, other);
}

TEST(Cgal_cells, keep_to_the_bounds) {
  Cgal_mesh_options options;
  options.angle = 25;
  options.radius = 0.4;
  options.distance = 0.01;
  const auto measure = [](const Cell_complex& c) {
    double sine = 1, radius = 0;
    for (std::size_t i = 0; i < c.number_of_cells(); ++i) {
      const auto p = corners(c, i);
      const double a = surfaces::distance(p[1], p[2]), b = surfaces::distance(p[2], p[0]),
                   d = surfaces::distance(p[0], p[1]);
      const double twice_area =
          surfaces::length(surfaces::cross(surfaces::along(p[1], -1, p[0]), surfaces::along(p[2], -1, p[0])));
      sine = std::min({sine, twice_area / (a * b), twice_area / (b * d), twice_area / (d * a)});
      radius = std::max(radius, a * b * d / (2 * twice_area));
    }
    return std::pair(sine, radius);
  };
  const Cell_complex coarse = make_cgal_cells(ellipsoid, around_ellipsoid, options);
  const auto [sine, radius] = measure(coarse);
  EXPECT_GT(sine, std::sin(25 * std::acos(-1.0) / 180) - 1e-9);
  // The bound is for the ball around a point of the surface, which is larger than the triangle's circle.
  EXPECT_LT(radius, 0.4);

  // A tenth of the distance: a tenth of the area per triangle, as the distance grows with the square of the radius.
  options.distance = 0.001;
  const std::size_t cells = make_cgal_cells(ellipsoid, around_ellipsoid, options).number_of_cells();
  EXPECT_GT(cells, 5 * coarse.number_of_cells());
  EXPECT_LT(cells, 20 * coarse.number_of_cells());
  options = {};
  options.radius = 0.1;
  EXPECT_LT(measure(make_cgal_cells(ellipsoid, around_ellipsoid, options)).second, 0.1);
}

TEST(Cgal_cells, are_found_on_every_component) {
  for (const double radius : {0.0, 0.5}) {
    Cgal_mesh_options options;
    options.radius = radius;
    const Cell_complex cells = make_cgal_cells(two, around_two, options);
    EXPECT_EQ(cells.euler_characteristic(), 4);
    EXPECT_EQ(border_edges(cells), 0U);
    expect_triangles_on(two, cells);
  }
}

TEST(Cgal_cells, look_outwards_on_shells_within_each_other) {
  // Positive between two spheres' surfaces of radius 1 and 2: the inner one looks to where f is positive, outwards, the
  // outer one inwards.
  const Formula f("(x^2+y^2+z^2-1)*(4-x^2-y^2-z^2)");
  const Cell_complex cells = make_cgal_cells(f, make_lattice({-2.1, -2.1, -2.1}, {2.1, 2.1, 2.1}, 24));
  EXPECT_EQ(cells.euler_characteristic(), 4);
  expect_triangles_on(f, cells);
  for (std::size_t i = 0; i < cells.number_of_cells(); ++i) {
    const auto [p, q, r] = corners(cells, i);
    const double volume = surfaces::dot(p, surfaces::cross(q, r));
    EXPECT_GT(surfaces::length(p) < 1.5 ? volume : -volume, 0);
  }
}

TEST(Cgal_cells, end_at_the_box) {
  // A slab of a hyperboloid: an annulus, as its lattice's box says.
  const Formula f("x^2+1.3*y^2-z^2-1+0.1*x*y*z");
  const Lattice lattice = make_lattice({-2, -2, -1}, {2, 2, 1}, 32);
  const Cell_complex cells = make_cgal_cells(f, lattice);
  EXPECT_EQ(cells.euler_characteristic(), 0);
  EXPECT_GT(border_edges(cells), 0U);
  expect_triangles_on(f, cells);
  for (const Point& p : cells.points)
    EXPECT_LE(std::abs(p[2]), 1);
  // The triangles reach the border of the box up to about their size.
  for (std::size_t e = 0; e < cells.edges.size(); ++e)
    if (cells.edge_cells[e][0] < 0 || cells.edge_cells[e][1] < 0) {
      EXPECT_GT(std::abs(cells.points[cells.edges[e][0]][2]), 1 - 2 * 0.125);
    }
  surfaces::expect_all_checks_hold(extract_extremal_mesh(f, cells).mesh);
}

TEST(Cgal_cells, are_made_in_lattices_of_any_direction) {
  const surfaces::Motion motion = surfaces::random_motion(3, 10);
  const surfaces::Moved_function moved(ellipsoid, motion);
  Lattice lattice = around_ellipsoid;
  lattice.origin = motion(lattice.origin);
  for (Vector& step : lattice.step)
    step = motion.turned(step);
  const Cell_complex cells = make_cgal_cells(moved, lattice);
  EXPECT_EQ(cells.euler_characteristic(), 2);
  EXPECT_EQ(border_edges(cells), 0U);
}

TEST(Cgal_cells, are_refused_without_a_surface) {
  EXPECT_NE(message<Extraction_error>(Formula("x^2+y^2+z^2+1"), around_ellipsoid).find("no zero surface"),
            std::string::npos);
}

TEST(Cgal_cells, are_refused_if_components_are_joined) {
  // Two sheets 0.1 apart, triangles of size 1.
  const Formula sheets("(x^2/9+y^2/9+(z-0.35)^2/0.09-1)*(x^2/9+y^2/9+(z+0.35)^2/0.09-1)");
  Cgal_mesh_options options;
  options.radius = 3;
  options.distance = 3;
  const std::string error =
      message<Extraction_error>(sheets, make_lattice({-3.1, -3.1, -0.8}, {3.1, 3.1, 0.8}, 100), options);
  EXPECT_NE(error.find("too large"), std::string::npos) << error;
}

TEST(Cgal_cells, are_given_up_if_there_are_too_many) {
  Cgal_mesh_options options;
  options.max_points = 500;
  EXPECT_NE(message<Extraction_error>(ellipsoid, around_ellipsoid, options).find("does not come to an end"),
            std::string::npos);
}

TEST(Cgal_cells, can_be_cancelled) {
  Cgal_mesh_options options;
  options.radius = 0.05;
  double last = 0;
  int calls = 0;
  options.progress = [&](double share) {
    EXPECT_GE(share, last);
    EXPECT_LT(share, 1);
    last = share;
    return ++calls < 3;
  };
  EXPECT_THROW(make_cgal_cells(ellipsoid, around_ellipsoid, options), Cancelled);
  EXPECT_EQ(calls, 3);
}

TEST(Cgal_cells, need_options_within_their_ranges) {
  const auto error = [](double Cgal_mesh_options::*member, double value) {
    Cgal_mesh_options options;
    options.*member = value;
    return message<std::invalid_argument>(ellipsoid, around_ellipsoid, options);
  };
  EXPECT_EQ(error(&Cgal_mesh_options::angle, 60), "angle is 60, not in [0, 60) degrees");
  EXPECT_EQ(error(&Cgal_mesh_options::radius, -1), "radius is -1, not 0 or a length");
  EXPECT_EQ(error(&Cgal_mesh_options::distance, std::nan("")), "distance is nan, not 0 or a length");
}
