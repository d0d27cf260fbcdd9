// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Shapes at vertices from jets fitted to the vertices around, against the exact ones.
#include <CGAL/Extremal_mesh_3/Formula.h>
#include <CGAL/Extremal_mesh_3/Functor_function.h>
#include <CGAL/Extremal_mesh_3/errors.h>
#include <CGAL/Extremal_mesh_3/fit_vertex_shapes.h>

#include "meshes.h"

#include <cstring>
#include <limits>

using namespace CGAL::Extremal_mesh_3;

namespace {

using Complex = std::complex<double>;
using meshes::Polygons;

const Formula ellipsoid("x^2+2*y^2+4*z^2-1");
Polygons ellipsoid_mesh(int levels) {
  return meshes::on_ellipsoid(meshes::icosphere(levels), 1, std::sqrt(0.5), 0.5);
}

/// (n + 1)² vertices over [−1, 1]², at random places near those of a grid, so that the fits have no symmetry.
template <class Height> Polygons graph(int n, const Height& height, double unevenness = 0.2) {
  Polygons m;
  std::mt19937 random(7);
  const auto offset = [&](int i) {
    const double uniform = double(random()) / 4294967295.0 - 0.5;
    return i == 0 || i == n ? 0 : unevenness * uniform;
  };
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) {
      const double x = -1 + 2 * (i + offset(i)) / n, y = -1 + 2 * (j + offset(j)) / n;
      m.points.push_back({x, y, height(x, y)});
    }
  const auto vertex = [&](int i, int j) { return std::uint32_t(j * (n + 1) + i); };
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      m.polygons.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
      m.polygons.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
    }
  return m;
}

Fit fit(const Polygons& m, double radius = 0, int threads = 0) {
  Fit_options options;
  options.radius = radius;
  options.threads = threads;
  return fit_vertex_shapes(m.cells(), options);
}

/// e^{iα}, α the angle from the basis of `a` to that of `b`: A1 of b is multiplied by it to come to the basis of a.
Complex turn(const Local_shape& a, const Local_shape& b) {
  const Complex w(surfaces::dot(b.u, a.u), surfaces::dot(b.u, a.v()));
  return w / std::abs(w);
}

/// How far a shape is from another: of L and of C, root mean square over the directions.
struct Difference {
  double L, C;
};

Difference difference(const Local_shape& a, const Local_shape& b) {
  const Complex w = turn(a, b);
  return {std::sqrt(std::pow(a.H - b.H, 2) + std::norm(a.Q - b.Q * w * w) / 2),
          std::sqrt((std::norm(a.A1 - b.A1 * w) + std::norm(a.A3 - b.A3 * w * w * w)) / 2)};
}

/// root mean squares of the differences over all vertices.
Difference rms(const std::vector<Local_shape>& a, const std::vector<Local_shape>& b) {
  Difference sum{0, 0};
  for (std::size_t v = 0; v < a.size(); ++v) {
    const Difference d = difference(a[v], b[v]);
    sum.L += d.L * d.L;
    sum.C += d.C * d.C;
  }
  return {std::sqrt(sum.L / double(a.size())), std::sqrt(sum.C / double(a.size()))};
}

/// root mean squares of the shapes themselves.
Difference size(const std::vector<Local_shape>& shapes) {
  Difference sum{0, 0};
  for (const Local_shape& s : shapes) {
    sum.L += s.H * s.H + std::norm(s.Q) / 2;
    sum.C += (std::norm(s.A1) + std::norm(s.A3)) / 2;
  }
  return {std::sqrt(sum.L / double(shapes.size())), std::sqrt(sum.C / double(shapes.size()))};
}

bool is_zero(const Local_shape& s) {
  return s.H == 0 && s.Q == Complex() && s.A1 == Complex() && s.A3 == Complex();
}

} // namespace

TEST(Fitted_jet, of_the_graph_of_a_quartic_is_exact) {
  // With normals along z heights are those of the graph, in other coordinates a polynomial of degree 4 too.
  const auto f = make_function([](auto x, auto y, auto z) {
    return z - (0.3 * x - 0.2 * y + 0.7 * (x * x) - 0.4 * (x * y) - 0.5 * (y * y) + 0.6 * (x * x * x) -
                0.3 * (x * y * y) + 0.2 * (y * y * y) + 0.25 * (x * x * x * x) - 0.35 * (x * x * x * y) +
                0.15 * (x * x * y * y) - 0.1 * (y * y * y * y));
  });
  const Polygons mesh = graph(20, [&](double x, double y) { return -f.value({x, y, 0}); });
  Fit_options options;
  options.normals.assign(mesh.points.size(), {0, 0, 1});
  const Vertex_shapes exact = meshes::exact_shapes(f, mesh.points);
  for (const int rings : {0, 2, 3}) {
    SCOPED_TRACE(rings);
    options.rings = rings;
    const Fit fit = fit_vertex_shapes(mesh.cells(), options);
    EXPECT_EQ(fit.report.not_fitted, 0U);
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
      // Rounding of heights, 1e-16, is amplified by at most the square of the condition, which at corners is up to
      // 1e3 with rings; the n-th derivative has it over R^n, R ≥ 0.2.
      const Difference d = difference(fit.shapes.shapes[v], exact.shapes[v]);
      EXPECT_LT(d.L, 2e-10) << v;
      EXPECT_LT(d.C, 5e-9) << v;
      const Complex w = turn(fit.shapes.shapes[v], exact.shapes[v]);
      const Fourth_order_form &a = fit.shapes.fourth[v], &b = exact.fourth[v];
      EXPECT_LT(std::abs(a.D0 - b.D0) + std::abs(a.D2 - b.D2 * w * w) + std::abs(a.D4 - b.D4 * w * w * w * w), 1e-7)
          << v;
    }
  }
}

TEST(Fitted_jet, converges_with_the_radius) {
  // Half the radius, four times as many vertices. The first terms that jets leave out are of degree 5: they change
  // second derivatives by R^3 or, where neighbourhoods are symmetric, R^4, third derivatives by R². A quarter is
  // allowed for terms of higher degree and neighbourhoods that have to grow.
  Difference last{0, 0};
  for (int levels = 4; levels <= 6; ++levels) {
    const Polygons mesh = ellipsoid_mesh(levels);
    const Difference d = rms(fit(mesh, 0.2 * std::pow(0.5, levels - 4)).shapes.shapes,
                             meshes::exact_shapes(ellipsoid, mesh.points).shapes);
    if (levels > 4) {
      EXPECT_LT(d.L, 1.25 * last.L / 8);
      EXPECT_LT(d.C, 1.25 * last.C / 4);
    }
    last = d;
  }
}

TEST(Fitted_jet, does_not_depend_on_the_numbering_and_moves_with_the_mesh) {
  const Polygons mesh = meshes::with_radial_noise(ellipsoid_mesh(4), 1e-4, 1);
  const Fit reference = fit(mesh);
  const Difference all = size(reference.shapes.shapes);
  for (unsigned seed = 1; seed <= 3; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const surfaces::Motion motion = surfaces::random_motion(seed);
    const Polygons other = meshes::moved(meshes::shuffled(mesh, seed), motion);
    const Fit moved = fit(other);
    EXPECT_EQ(moved.report.multiple, reference.report.multiple);
    EXPECT_NEAR(moved.report.radius_median, reference.report.radius_median, 1e-12);
    // The vertices of both, by where they are.
    std::map<std::array<long, 3>, std::size_t> at;
    const auto key = [](const Point& p) {
      return std::array{std::lround(p[0] * 1e6), std::lround(p[1] * 1e6), std::lround(p[2] * 1e6)};
    };
    for (std::size_t v = 0; v < mesh.points.size(); ++v)
      at[key(mesh.points[v])] = v;
    std::size_t found = 0;
    for (std::size_t w = 0; w < other.points.size(); ++w) {
      const auto it = at.find(key(motion.back(other.points[w])));
      if (it == at.end())
        continue; // on the border between two keys
      ++found;
      Local_shape expected = reference.shapes.shapes[it->second];
      expected.n = motion.turned(expected.n);
      expected.u = motion.turned(expected.u);
      const Difference d = difference(moved.shapes.shapes[w], expected);
      // rounding of coordinates, 1e-16, amplified by condition / R² and / R³; R = 0.15
      EXPECT_LT(d.L, 1e-11 * all.L);
      EXPECT_LT(d.C, 1e-9 * all.C);
      EXPECT_LT(surfaces::distance(moved.shapes.shapes[w].n, expected.n), 1e-12);
    }
    EXPECT_GT(found, mesh.points.size() * 9 / 10);
  }
}

TEST(Fitted_jet, of_reversed_cells_has_the_opposite_curvatures) {
  Polygons mesh = ellipsoid_mesh(4);
  const Fit reference = fit(mesh);
  for (auto& p : mesh.polygons)
    std::reverse(p.begin(), p.end());
  const Fit reversed = fit(mesh);
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    const Principal_quantities a = principal_quantities(reference.shapes.shapes[v]),
                               b = principal_quantities(reversed.shapes.shapes[v]);
    EXPECT_LT(a.k1, 0); // normals point outwards
    EXPECT_NEAR(a.k1, -b.k2, 1e-9);
    EXPECT_NEAR(a.k2, -b.k1, 1e-9);
    EXPECT_LT(surfaces::length(surfaces::along(reference.shapes.shapes[v].n, 1, reversed.shapes.shapes[v].n)), 1e-11);
    EXPECT_NEAR(a.gaussian_extremality(), b.gaussian_extremality(), 1e-6 * (1 + std::abs(a.gaussian_extremality())));
  }
}

TEST(Fitted_jet, does_not_depend_on_threads) {
  const Polygons mesh = meshes::with_radial_noise(ellipsoid_mesh(4), 1e-4, 1);
  const Fit one = fit(mesh, 0, 1);
  for (const int threads : {2, 3, 0}) {
    const Fit many = fit(mesh, 0, threads);
    EXPECT_EQ(one.report.noise, many.report.noise);
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
      const Local_shape &a = one.shapes.shapes[v], &b = many.shapes.shapes[v];
      EXPECT_TRUE(a.n == b.n && a.u == b.u && a.H == b.H && a.Q == b.Q && a.A1 == b.A1 && a.A3 == b.A3) << v;
      EXPECT_EQ(one.shapes.fourth[v].D4, many.shapes.fourth[v].D4);
      EXPECT_EQ(one.shapes.quality[v].C_error, many.shapes.quality[v].C_error);
    }
  }
}

TEST(Neighbourhood, of_one_side_of_a_thin_plate_has_nothing_of_the_other) {
  // z = 0.2 x² + 0.01 above, z = −0.3 y² below, R = 0.3: where the sheets would mix, heights would differ by several
  // times what the jets leave out.
  const auto above = [](double x, double) { return 0.2 * x * x + 0.01; };
  const auto below = [](double, double y) { return -0.3 * y * y; };
  const int n = 40;
  Polygons plate = graph(n, above);
  const Polygons lower = graph(n, below);
  const Fit single = fit(plate, 0.3), lower_single = fit(lower, 0.3);
  const std::uint32_t offset = std::uint32_t(plate.points.size());
  plate.points.insert(plate.points.end(), lower.points.begin(), lower.points.end());
  for (const auto& t : lower.polygons)
    plate.polygons.push_back({t[2] + offset, t[1] + offset, t[0] + offset});
  const auto rim = [&](std::uint32_t a, std::uint32_t b) { plate.polygons.push_back({b, a, a + offset, b + offset}); };
  const auto vertex = [&](int i, int j) { return std::uint32_t(j * (n + 1) + i); };
  for (int i = 0; i < n; ++i) {
    rim(vertex(i, 0), vertex(i + 1, 0));
    rim(vertex(n, i), vertex(n, i + 1));
    rim(vertex(i + 1, n), vertex(i, n));
    rim(vertex(0, i + 1), vertex(0, i));
  }
  const Fit both = fit(plate, 0.3);
  std::size_t compared = 0;
  for (std::uint32_t v = 0; v < offset; ++v) {
    const Point& p = plate.points[v];
    if (std::max(std::abs(p[0]), std::abs(p[1])) > 0.65)
      continue; // the rim is within the radius: it is part of the neighbourhood
    ++compared;
    EXPECT_EQ(both.shapes.quality[v].points, single.shapes.quality[v].points);
    EXPECT_LT(difference(both.shapes.shapes[v], single.shapes.shapes[v]).C, 1e-9) << v;
    EXPECT_NEAR(both.shapes.shapes[v + offset].H, -lower_single.shapes.shapes[v].H, 1e-10) << v;
  }
  EXPECT_GT(compared, 500U);
}

TEST(Neighbourhood, is_connected_within_its_ball) {
  // A strip that is folded like an S: its first and third layers look the same way, 0.06 apart, and belong to one
  // surface.
  const double gap = 0.03, length = 2;
  const int n = 100, m = 20;
  Polygons s;
  const auto point = [&](double t) { // along the S
    const double bend = std::acos(-1.0) * gap / 2, period = length + bend;
    const int layer = int(std::min(2.0, std::floor(t / period)));
    const double r = t - layer * period, side = layer % 2 == 0 ? 1 : -1;
    if (r <= length)
      return Point{side * (r - length / 2), 0, layer * gap};
    const double angle = (r - length) / (gap / 2);
    return Point{side * (length / 2 + gap / 2 * std::sin(angle)), 0, layer * gap + gap / 2 * (1 - std::cos(angle))};
  };
  const double total = 3 * length + 2 * std::acos(-1.0) * gap / 2;
  for (int i = 0; i <= 3 * n; ++i)
    for (int j = 0; j <= m; ++j) {
      Point p = point(total * i / (3 * n));
      p[1] = length * j / n;
      s.points.push_back(p);
    }
  for (std::uint32_t i = 0; i < 3 * n; ++i)
    for (std::uint32_t j = 0; j < m; ++j)
      s.polygons.push_back({i * (m + 1) + j, (i + 1) * (m + 1) + j, (i + 1) * (m + 1) + j + 1, i * (m + 1) + j + 1});
  const Fit f = fit(s, 0.15);
  std::size_t middle = 0;
  for (std::size_t v = 0; v < s.points.size(); ++v)
    if (std::abs(s.points[v][0]) < 0.8) {
      ++middle;
      EXPECT_LT(std::abs(f.shapes.shapes[v].H) + std::abs(f.shapes.shapes[v].Q), 1e-10); // all of it is flat
    }
  EXPECT_GT(middle, 3000U);
}

TEST(Neighbourhood, grows_at_borders) {
  const auto f = make_function(
      [](auto x, auto y, auto z) { return z - 0.5 * (x * x) + 0.25 * (y * y) - 0.1 * (x * x * x * x * x); });
  const int n = 40;
  const Polygons mesh = graph(n, [&](double x, double y) { return -f.value({x, y, 0}); });
  const Fit fitted = fit(mesh);
  const Vertex_shapes exact = meshes::exact_shapes(f, mesh.points);
  EXPECT_EQ(fitted.report.not_fitted, 0U);
  EXPECT_GT(fitted.report.grown, std::size_t(4 * n - 1)); // every vertex of the border
  EXPECT_LT(fitted.report.grown, std::size_t(3 * 4 * n)); // and no more than three rows
  double inside = 0, border = 0;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) {
      const std::size_t v = std::size_t(j * (n + 1) + i);
      const bool at_border = i == 0 || j == 0 || i == n || j == n;
      double& largest = at_border ? border : inside;
      largest = std::max(largest, difference(fitted.shapes.shapes[v], exact.shapes[v]).C);
      if (at_border) {
        EXPECT_GT(fitted.shapes.quality[v].radius, 1.2 * fitted.report.radius_median);
      }
    }
  // Third derivatives are off by those of the fifth power, 6 x², times (R/x)²: a hundredth inside, a few tenths at
  // the border, where neighbourhoods of nearly twice the radius lie on one side.
  EXPECT_LT(inside, 0.1);
  EXPECT_LT(border, 0.7);
}

TEST(Vertices_without_a_jet, are_named) {
  Polygons tetrahedron;
  tetrahedron.points = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  tetrahedron.polygons = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
  Polygons cube;
  for (const double z : {-1, 1})
    cube.points.insert(cube.points.end(), {{-1, -1, z}, {1, -1, z}, {1, 1, z}, {-1, 1, z}});
  cube.polygons = {{3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  for (const Polygons& mesh : {tetrahedron, cube})
    for (const int rings : {0, 2}) {
      Fit_options options;
      options.rings = rings;
      const Fit f = fit_vertex_shapes(mesh.cells(), options);
      EXPECT_EQ(f.report.fitted, 0U);
      EXPECT_EQ(f.report.not_fitted, mesh.points.size());
      for (std::size_t v = 0; v < mesh.points.size(); ++v) {
        EXPECT_EQ(f.shapes.quality[v].state, Fit_state::too_few_points);
        EXPECT_LE(f.shapes.quality[v].points, mesh.points.size());
        EXPECT_TRUE(is_zero(f.shapes.shapes[v]));
      }
    }
}

TEST(Vertices_without_a_jet, lie_on_a_few_lines) {
  // On three lines y = −1, 0, 1, y³ is y. On four, all of degree 3 is determined, y⁴ is not.
  for (const int rows : {3, 4}) {
    Polygons strip;
    for (int i = 0; i < 40; ++i)
      for (int j = 0; j < rows; ++j)
        strip.points.push_back({0.8 * i, double(j), 0.01 * i * i + 0.1 * j * j});
    for (std::uint32_t i = 0; i + 1 < 40; ++i)
      for (std::uint32_t j = 0; j + 1 < std::uint32_t(rows); ++j) {
        const std::uint32_t a = i * std::uint32_t(rows) + j, b = a + std::uint32_t(rows);
        strip.polygons.push_back({a, b, b + 1, a + 1});
      }
    Fit_options options;
    options.normals.assign(strip.points.size(), {0, 0, 1});
    const Fit f = fit_vertex_shapes(strip.cells(), options);
    EXPECT_EQ(f.report.fitted, 0U);
    for (std::size_t v = 0; v < strip.points.size(); ++v) {
      EXPECT_EQ(f.shapes.quality[v].state, Fit_state::rank_deficient);
      EXPECT_TRUE(is_zero(f.shapes.shapes[v]));
    }
  }
}

TEST(Vertices_without_a_jet, are_those_of_cells_without_area) {
  Polygons line;
  for (int i = 0; i < 60; ++i)
    line.points.push_back({double(i), 0, 0});
  for (std::uint32_t i = 0; i + 2 < 60; ++i)
    line.polygons.push_back(i % 2 == 0 ? std::vector{i, i + 1, i + 2} : std::vector{i + 1, i, i + 2});
  for (const double radius : {0.0, 30.0}) {
    const Fit f = fit(line, radius);
    EXPECT_EQ(f.report.fitted, 0U);
    for (const Local_shape& s : f.shapes.shapes)
      EXPECT_TRUE(is_zero(s));
  }
}

TEST(Flat_mesh, has_no_curvature) {
  const surfaces::Motion motion = surfaces::random_motion(1);
  for (const bool moved : {false, true}) {
    const Polygons mesh = moved ? meshes::moved(graph(20, [](double, double) { return 0.0; }), motion)
                                : graph(20, [](double, double) { return 0.0; });
    const Fit f = fit(mesh);
    EXPECT_EQ(f.report.not_fitted, 0U);
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
      // 1e-16 times what fits make of it: up to 1e3 / R² and 1e3 / R³, R > 0.25
      EXPECT_LT(std::abs(f.shapes.shapes[v].H) + std::abs(f.shapes.shapes[v].Q), 1e-11);
      EXPECT_LT(std::abs(f.shapes.shapes[v].A1) + std::abs(f.shapes.shapes[v].A3), 1e-10);
      EXPECT_GT(f.shapes.quality[v].C_error, 0); // coordinates are rounded, even if these are not
    }
  }
}

TEST(Fit_quality, tells_the_errors_that_noise_makes) {
  // A plane, on which there are no others. Standard errors are meant to be too large by up to 7 % for L, 28 % for C,
  // and random by a few per cent themselves.
  const double sigma = 1e-3;
  std::mt19937 random(3);
  const auto uniform = [&] { return (double(random()) + 0.5) / 4294967296.0; };
  const Polygons mesh = graph(60, [&](double, double) {
    return sigma * std::sqrt(-2 * std::log(uniform())) * std::cos(6.283185307179586 * uniform());
  });
  for (const double radius : {0.15, 0.3}) {
    SCOPED_TRACE(radius);
    const Fit f = fit(mesh, radius);
    double L = 0, L_error = 0, C = 0, C_error = 0, noise = 0, count = 0;
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
      const Point& p = mesh.points[v];
      if (std::max(std::abs(p[0]), std::abs(p[1])) > 1 - radius)
        continue;
      const Fit_quality& q = f.shapes.quality[v];
      const Local_shape& s = f.shapes.shapes[v];
      L += s.H * s.H + std::norm(s.Q) / 2;
      C += (std::norm(s.A1) + std::norm(s.A3)) / 2;
      L_error += q.L_error * q.L_error;
      C_error += q.C_error * q.C_error;
      noise += q.residual * q.residual * q.points / (q.points - 15);
      ++count;
    }
    EXPECT_NEAR(std::sqrt(noise / count), sigma, 0.1 * sigma);
    EXPECT_GT(std::sqrt(L_error / L), 0.95);
    EXPECT_LT(std::sqrt(L_error / L), 1.2);
    EXPECT_GT(std::sqrt(C_error / C), 0.95);
    EXPECT_LT(std::sqrt(C_error / C), 1.4);
  }
}

TEST(Default_radius, is_the_larger_the_more_noise_there_is) {
  const Polygons exact = ellipsoid_mesh(5);
  const double edge = meshes::mean_edge_length(exact);
  const Vertex_shapes truth = meshes::exact_shapes(ellipsoid, exact.points);
  const double C = size(truth.shapes).C;
  double last = 0;
  for (const double sigma : {0.0, 0.001, 0.01}) {
    SCOPED_TRACE(sigma);
    const Fit f = fit(meshes::with_radial_noise(exact, sigma * edge, 1));
    EXPECT_GT(f.report.multiple, last);
    EXPECT_GT(f.report.radius_min, 2.7 * f.report.sampling / 2); // edges of this mesh differ by 2
    last = f.report.multiple;
    // The aim is noise of 2.5 % of C; what it tells is the noise and a part of the truncation.
    double noise = 0;
    for (const Fit_quality& q : f.shapes.quality)
      noise += q.C_error * q.C_error / double(exact.points.size());
    EXPECT_LT(std::sqrt(noise), 0.05 * C);
    EXPECT_NEAR(f.report.noise, sigma * edge, 0.2 * sigma * edge + 1e-6);
  }
  EXPECT_LE(last, 16.5);
}

TEST(Default_radius, stays_small_on_exact_meshes_however_coarse) {
  for (int levels = 2; levels <= 5; ++levels)
    EXPECT_EQ(fit(ellipsoid_mesh(levels)).report.multiple, 2.75) << levels;
}

TEST(Fit_options, are_checked) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();
  const Polygons mesh = ellipsoid_mesh(2);
  const Cell_complex cells = mesh.cells();
  const auto with = [](const auto& change) {
    Fit_options options;
    change(options);
    return options;
  };
  for (const double radius : {-1.0, nan, infinite})
    EXPECT_THROW(fit_vertex_shapes(cells, with([&](Fit_options& o) { o.radius = radius; })), std::invalid_argument);
  EXPECT_THROW(fit_vertex_shapes(cells, with([](Fit_options& o) { o.rings = -1; })), std::invalid_argument);
  EXPECT_THROW(fit_vertex_shapes(cells, with([](Fit_options& o) { o.threads = -1; })), std::invalid_argument);
  EXPECT_THROW(fit_vertex_shapes(cells, with([](Fit_options& o) {
                                   o.normals.resize(3, {0, 0, 1});
                                 })),
               std::invalid_argument);
  EXPECT_THROW(fit_vertex_shapes(cells, with([&](Fit_options& o) {
                                   o.normals.resize(mesh.points.size(), {0, 0, 2});
                                 })),
               std::invalid_argument);
  for (const double x : {nan, infinite}) {
    Cell_complex broken = cells;
    broken.points[17][1] = x;
    try {
      fit_vertex_shapes(broken);
      ADD_FAILURE();
    } catch (const std::invalid_argument& e) {
      EXPECT_NE(std::string(e.what()).find("point 17"), std::string::npos) << e.what();
    }
  }
}

TEST(Fit_progress, rises_to_1_and_can_cancel) {
  const Cell_complex cells = ellipsoid_mesh(4).cells();
  Fit_options options;
  options.radius = 0.15;
  double last = 0;
  options.progress = [&](double part) {
    EXPECT_GE(part, last);
    last = part;
    return true;
  };
  fit_vertex_shapes(cells, options);
  EXPECT_EQ(last, 1);
  options.progress = [](double) { return false; };
  EXPECT_THROW(fit_vertex_shapes(cells, options), Cancelled);
}
