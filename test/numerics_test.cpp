// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Results do not depend on the unit of length, on where the origin is, or on how a mesh is numbered.

#include "temporary_folder.h"

#include <CGAL/Extremal_mesh_3/Formula.h>
#include <CGAL/Extremal_mesh_3/Image_function.h>
#include <CGAL/Extremal_mesh_3/check.h>
#include <CGAL/Extremal_mesh_3/extract_extremal_mesh.h>
#include <CGAL/Extremal_mesh_3/fit_vertex_shapes.h>
#include <CGAL/Extremal_mesh_3/read_mesh.h>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <utility>

namespace {

using namespace CGAL::Extremal_mesh_3;

/// what must be equal, lengths measured by `unit`.
struct Counts {
  std::size_t vertices = 0, umbilics = 0, edges = 0, cells = 0;
  double length = 0, area = 0;
};

Counts counts_of(const Extremal_mesh& mesh, double unit) {
  Counts counts{mesh.number_of_vertices(), 0, mesh.number_of_edges(), mesh.number_of_cells()};
  for (std::uint32_t v = 0; v < counts.vertices; ++v)
    counts.umbilics += mesh.vertex(v).kind == Vertex_kind::umbilic ? 1U : 0U;
  for (std::uint32_t e = 0; e < counts.edges; ++e)
    counts.length += mesh.edge(e).length / unit;
  counts.area = mesh.surface().area / unit / unit;
  return counts;
}

void expect_same(const Counts& a, const Counts& b, double tolerance) {
  EXPECT_EQ(a.vertices, b.vertices);
  EXPECT_EQ(a.umbilics, b.umbilics);
  EXPECT_EQ(a.edges, b.edges);
  EXPECT_EQ(a.cells, b.cells);
  EXPECT_NEAR(a.length / b.length, 1, tolerance);
  EXPECT_NEAR(a.area / b.area, 1, tolerance);
}

/// a surface without symmetry.
Extremal_mesh bent_ellipsoid(double unit) {
  const Formula f(fmt::format("(x/{0})^2/9 + (y/{0})^2/4 + (z/{0})^2 - 1 + 0.1*(x/{0})*(y/{0})*(z/{0})", unit));
  return extract_extremal_mesh(
             f, make_lattice({-4.1 * unit, -3.2 * unit, -2.3 * unit}, {4 * unit, 3 * unit, 2 * unit}, 20))
      .mesh;
}

/// x² + y²/2 + z²/3 + xyz/10, in an image.
Extremal_mesh bent_image(double unit) {
  Image image;
  image.lattice = make_lattice({-3.2, -3.2, -3.2}, {3.2, 3.2, 3.2}, 32);
  for (std::size_t k = 0; k < image.lattice.size[2]; ++k)
    for (std::size_t j = 0; j < image.lattice.size[1]; ++j)
      for (std::size_t i = 0; i < image.lattice.size[0]; ++i) {
        const auto [x, y, z] = image.lattice.node(double(i), double(j), double(k));
        image.voxels.push_back(float(x * x + y * y / 2 + z * z / 3 + x * y * z / 10));
      }
  for (double& x : image.lattice.origin)
    x *= unit;
  for (Vector& step : image.lattice.step)
    for (double& x : step)
      x *= unit;
  Image_function_options options;
  options.iso = 1.5;
  options.sigma = 0.6 * unit;
  return extract_extremal_mesh(Image_function(image, options),
                               make_lattice({-2 * unit, -2 * unit, -2.3 * unit}, {2 * unit, 2 * unit, 2.3 * unit}, 12))
      .mesh;
}

void expect_same_bits(const Extremal_mesh& mesh, double unit, const Extremal_mesh& expected) {
  ASSERT_EQ(mesh.number_of_vertices(), expected.number_of_vertices());
  ASSERT_EQ(mesh.number_of_edges(), expected.number_of_edges());
  ASSERT_EQ(mesh.number_of_cells(), expected.number_of_cells());
  const auto in_units = [&](const Point& p) { return Point{p[0] / unit, p[1] / unit, p[2] / unit}; };
  for (std::uint32_t v = 0; v < mesh.number_of_vertices(); ++v) {
    EXPECT_EQ(in_units(mesh.vertex(v).point), expected.vertex(v).point) << "vertex " << v;
    EXPECT_EQ(mesh.vertex(v).k1 * unit, expected.vertex(v).k1) << "vertex " << v;
  }
  for (std::uint32_t e = 0; e < mesh.number_of_edges(); ++e)
    EXPECT_EQ(mesh.edge(e).length / unit, expected.edge(e).length) << "edge " << e;
  for (std::uint32_t c = 0; c < mesh.number_of_cells(); ++c)
    EXPECT_EQ(mesh.cell(c).area / unit / unit, expected.cell(c).area) << "cell " << c;
}

TEST(Numerics, a_unit_that_is_a_power_of_two_changes_no_bit) {
  const Extremal_mesh surface = bent_ellipsoid(1), image = bent_image(1);
  ASSERT_GT(surface.number_of_vertices(), 4U);
  ASSERT_GT(image.number_of_vertices(), 4U);
  for (const double unit : {0x1p-40, 0x1p-27, 0x1p-10, 0x1p27, 0x1p40}) {
    SCOPED_TRACE(unit);
    expect_same_bits(bent_ellipsoid(unit), unit, surface);
    expect_same_bits(bent_image(unit), unit, image);
  }
}

/// an ellipsoid whose semi-axes are 3, 2 and 1 units, about (offset, offset, offset).
Counts ellipsoid(double unit, double offset) {
  const Formula f(fmt::format("((x-({1}))/{0})^2/9 + ((y-({1}))/{0})^2/4 + ((z-({1}))/{0})^2 - 1", unit, offset));
  const auto at = [&](double x) { return offset + unit * x; };
  const Extraction extraction =
      extract_extremal_mesh(f, make_lattice({at(-4), at(-3), at(-2)}, {at(4), at(3), at(2)}, 12));
  EXPECT_TRUE(all_hold(check(extraction.mesh)));
  return counts_of(extraction.mesh, unit);
}

TEST(Numerics, the_unit_of_length_does_not_matter) {
  const Counts expected = ellipsoid(1, 0);
  EXPECT_EQ(expected.umbilics, 4U);
  for (const double unit : {0x1p-40, 0x1p40, 1e-12, 1e12, 1e30, 1e-30}) {
    SCOPED_TRACE(unit);
    // Each coordinate is rounded: nodes that were exactly on a plane of symmetry are beside it, and the polygons others.
    expect_same(ellipsoid(unit, 0), expected, 1e-2);
  }
}

TEST(Numerics, a_surface_far_from_the_origin_is_the_same) {
  // Coordinates of 1e6 have an error of 1e-10 of a unit.
  expect_same(ellipsoid(1, 1e6), ellipsoid(1, 0), 1e-6);
  expect_same(ellipsoid(1e-12, 1e-6), ellipsoid(1, 0), 1e-6);
}

/// x² + y²/2 + z²/3 as an image of 1 : ratio spacing along z. A Gaussian adds a constant to it.
Counts image_of_ellipsoid(double ratio) {
  Image image;
  image.lattice = make_lattice({-3.2, -3.2, -3.2}, {3.2, 3.2, 3.2}, 96);
  Lattice& lattice = image.lattice;
  lattice.size[2] = std::size_t(std::lround(double(lattice.size[2] - 1) / ratio)) + 1;
  lattice.step[2][2] = 6.4 / double(lattice.size[2] - 1);
  for (std::size_t k = 0; k < lattice.size[2]; ++k)
    for (std::size_t j = 0; j < lattice.size[1]; ++j)
      for (std::size_t i = 0; i < lattice.size[0]; ++i) {
        const Point p = lattice.node(double(i), double(j), double(k));
        image.voxels.push_back(float(p[0] * p[0] + p[1] * p[1] / 2 + p[2] * p[2] / 3));
      }
  Image_function_options options;
  options.iso = 1.5;
  options.sigma = 0.6;
  const Image_function f(image, options);
  const Extraction extraction = extract_extremal_mesh(f, make_lattice({-2, -2, -2.3}, {2, 2, 2.3}, 24));
  EXPECT_TRUE(all_hold(check(extraction.mesh)));
  return counts_of(extraction.mesh, 1);
}

TEST(Numerics, voxels_ten_times_as_long_as_wide_give_the_same) {
  const Counts cubes = image_of_ellipsoid(1), long_ones = image_of_ellipsoid(10);
  EXPECT_EQ(cubes.umbilics, 4U);
  expect_same(long_ones, cubes, 0.02);
}

struct Polygons_of_mesh {
  std::vector<Point> points;
  std::vector<std::vector<std::uint32_t>> polygons;
};

Polygons_of_mesh polygons_of(const Cell_complex& cells) {
  Polygons_of_mesh result{cells.points, {}};
  for (std::size_t c = 0; c < cells.number_of_cells(); ++c) {
    auto& polygon = result.polygons.emplace_back();
    for (std::size_t h = cells.cell_begin[c]; h < cells.cell_begin[c + 1]; ++h)
      polygon.push_back(cells.source(cells.half_edges[h]));
  }
  return result;
}

Extremal_mesh extracted(const Polygons_of_mesh& mesh) {
  const Temporary_folder folder;
  std::string off = fmt::format("OFF\n{} {} 0\n", mesh.points.size(), mesh.polygons.size());
  for (const Point& p : mesh.points)
    off += fmt::format("{} {} {}\n", p[0], p[1], p[2]);
  for (const auto& polygon : mesh.polygons)
    off += fmt::format("{} {}\n", polygon.size(), fmt::join(polygon, " "));
  write_text(folder.file("m.off"), off);
  const Mesh read = read_mesh(folder.file("m.off"));
  Extraction extraction = extract_extremal_mesh(read.cells, fit_vertex_shapes(read.cells).shapes);
  EXPECT_TRUE(all_hold(check(extraction.mesh)));
  return std::move(extraction.mesh);
}

Counts counts_of_mesh(const Polygons_of_mesh& mesh, double unit) {
  return counts_of(extracted(mesh), unit);
}

class Numerics_of_meshes : public testing::Test {
protected:
  const Polygons_of_mesh mesh =
      polygons_of(read_mesh(std::string(EXTREMAL_MESH_3_DATA_DIR) + "/ellipsoid_exact_poly.off").cells);
  const Counts expected = counts_of_mesh(mesh, 1);
};

TEST_F(Numerics_of_meshes, the_unit_of_length_does_not_matter) {
  for (const double unit : {0x1p-40, 1e-12, 1e12, 1e-17, 1e17}) {
    SCOPED_TRACE(unit);
    Polygons_of_mesh scaled = mesh;
    for (Point& p : scaled.points)
      p = {unit * p[0], unit * p[1], unit * p[2]};
    expect_same(counts_of_mesh(scaled, unit), expected, 1e-6);
  }
}

TEST_F(Numerics_of_meshes, a_unit_that_is_a_power_of_two_changes_no_bit) {
  const Extremal_mesh one = extracted(mesh);
  for (const double unit : {0x1p-40, 0x1p40}) {
    SCOPED_TRACE(unit);
    Polygons_of_mesh scaled = mesh;
    for (Point& p : scaled.points)
      p = {unit * p[0], unit * p[1], unit * p[2]};
    expect_same_bits(extracted(scaled), unit, one);
  }
}

TEST_F(Numerics_of_meshes, numbering_and_repeated_vertices_do_not_matter) {
  Polygons_of_mesh other = mesh;
  std::mt19937 random(7);
  std::vector<std::uint32_t> place(mesh.points.size());
  std::iota(place.begin(), place.end(), 0U);
  std::shuffle(place.begin(), place.end(), random);
  for (std::size_t i = 0; i < place.size(); ++i)
    other.points[place[i]] = mesh.points[i];
  other.points.insert(other.points.end(), other.points.begin(), other.points.end());
  for (auto& polygon : other.polygons) {
    for (std::uint32_t& corner : polygon)
      corner = place[corner] + (random() % 2 == 0 ? std::uint32_t(mesh.points.size()) : 0U);
    std::rotate(polygon.begin(), polygon.begin() + 1, polygon.end());
  }
  std::shuffle(other.polygons.begin(), other.polygons.end(), random);
  expect_same(counts_of_mesh(other, 1), expected, 1e-9);
}

TEST(Numerics, what_is_beyond_the_accuracy_of_numbers_is_refused) {
  for (const double unit : {1e-310, 1e-160, 1e-60, 1e60, 1e200}) {
    SCOPED_TRACE(unit);
    EXPECT_THROW(ellipsoid(unit, 0), std::exception); // no lattice, no surface, or one of that size
  }
}

TEST_F(Numerics_of_meshes, of_a_size_beyond_the_accuracy_of_numbers_are_refused) {
  for (const double unit : {1e-300, 1e-80, 1e-40, 1e40, 1e80}) {
    SCOPED_TRACE(unit);
    Polygons_of_mesh scaled = mesh;
    for (Point& p : scaled.points)
      p = {unit * p[0], unit * p[1], unit * p[2]};
    EXPECT_THROW(counts_of_mesh(scaled, unit), Extraction_error);
  }
}

TEST_F(Numerics_of_meshes, with_a_point_that_is_not_finite_are_refused) {
  const Cell_complex good = read_mesh(std::string(EXTREMAL_MESH_3_DATA_DIR) + "/ellipsoid_exact_poly.off").cells;
  const Vertex_shapes shapes = fit_vertex_shapes(good).shapes;
  const Formula f("x^2/9 + y^2/4 + z^2 - 1");
  for (const double x : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    for (const std::size_t v : {std::size_t(0), std::size_t(5), good.points.size() - 1}) {
      Cell_complex bad = good;
      bad.points[v][1] = x;
      EXPECT_THROW(extract_extremal_mesh(bad, shapes), std::invalid_argument);
      EXPECT_THROW(extract_extremal_mesh(f, bad), std::invalid_argument);
      EXPECT_THROW(fit_vertex_shapes(bad), std::invalid_argument);
    }
}

} // namespace
