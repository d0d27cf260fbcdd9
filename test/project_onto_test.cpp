// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Extremal_mesh_3/Formula.h>
#include <CGAL/Extremal_mesh_3/errors.h>
#include <CGAL/Extremal_mesh_3/project_onto.h>

#include "meshes.h"

using namespace CGAL::Extremal_mesh_3;

namespace {

const Formula ellipsoid("x^2/9 + y^2/4 + z^2 - 1");

meshes::Polygons mesh() {
  return meshes::on_ellipsoid(meshes::icosphere(3), 3, 2, 1);
}

/// the sum over the cells of area · gradient: positive if they look outwards.
double looks_outwards(const Cell_complex& c, std::size_t first_point, std::size_t last_point) {
  double sum = 0;
  for (std::size_t i = 0; i < c.number_of_cells(); ++i) {
    const std::uint32_t* h = &c.half_edges[c.cell_begin[i]];
    const Point &p = c.points[c.source(h[0])], &q = c.points[c.source(h[1])], &r = c.points[c.source(h[2])];
    if (c.source(h[0]) < first_point || c.source(h[0]) >= last_point)
      continue;
    Derivatives d;
    ellipsoid.derivatives(p, 1, d);
    sum += surfaces::dot(surfaces::cross(surfaces::along(q, -1, p), surfaces::along(r, -1, p)), d.gradient);
  }
  return sum;
}

} // namespace

TEST(Project_onto, places_points_on_the_surface_up_to_rounding) {
  const auto exact = mesh();
  const double edge = meshes::mean_edge_length(exact);
  const Cell_complex noisy = meshes::with_radial_noise(exact, 0.2 * edge, 1).cells();
  const Cell_complex cells = project_onto(ellipsoid, noisy);
  for (std::size_t i = 0; i < cells.points.size(); ++i) {
    Derivatives d;
    ellipsoid.derivatives(cells.points[i], 1, d);
    // Coordinates up to 3 have rounding errors of up to 4e-16, and f has some more operations.
    EXPECT_LT(std::abs(d.value) / surfaces::length(d.gradient), 2e-15);
    EXPECT_LT(surfaces::distance(cells.points[i], noisy.points[i]), 1.5 * edge);
  }
  EXPECT_EQ(cells.edges, noisy.edges);
  EXPECT_EQ(cells.edge_cells, noisy.edge_cells);
  EXPECT_EQ(cells.half_edges, noisy.half_edges);
}

TEST(Project_onto, leaves_points_on_the_surface_where_they_are) {
  const Cell_complex before = mesh().cells(), after = project_onto(ellipsoid, before);
  for (std::size_t i = 0; i < before.points.size(); ++i)
    EXPECT_LT(surfaces::distance(before.points[i], after.points[i]), 2e-15); // rounding, as above
}

TEST(Project_onto, turns_each_component_to_where_the_function_is_positive) {
  // Twice the same ellipsoid, the second one inside out.
  auto m = mesh();
  const std::size_t n = m.points.size(), faces = m.polygons.size();
  m.points.insert(m.points.end(), m.points.begin(), m.points.begin() + std::ptrdiff_t(n));
  for (std::size_t i = 0; i < faces; ++i) {
    std::vector<std::uint32_t> p = m.polygons[i];
    std::reverse(p.begin(), p.end());
    for (std::uint32_t& v : p)
      v += std::uint32_t(n);
    m.polygons.push_back(p);
  }
  const Cell_complex before = m.cells(), after = project_onto(ellipsoid, before);
  EXPECT_GT(looks_outwards(before, 0, n), 0);
  EXPECT_LT(looks_outwards(before, n, 2 * n), 0);
  EXPECT_GT(looks_outwards(after, 0, n), 0);
  EXPECT_GT(looks_outwards(after, n, 2 * n), 0);
  for (std::size_t c = 0; c < after.number_of_cells(); ++c)
    for (std::size_t i = after.cell_begin[c]; i < after.cell_begin[c + 1]; ++i) {
      const std::uint32_t h = after.half_edges[i],
                          next = after.half_edges[i + 1 < after.cell_begin[c + 1] ? i + 1 : after.cell_begin[c]];
      EXPECT_EQ(after.edge_cells[h / 2][h % 2], std::int32_t(c));
      EXPECT_EQ(after.target(h), after.source(next));
    }
}

TEST(Project_onto, does_not_depend_on_the_number_of_threads) {
  const Cell_complex cells = meshes::with_radial_noise(mesh(), 0.01, 2).cells();
  EXPECT_EQ(project_onto(ellipsoid, cells, 1).points, project_onto(ellipsoid, cells, 4).points);
}

TEST(Project_onto, refuses_points_far_from_the_surface) {
  auto m = mesh();
  for (Point& p : m.points)
    p = surfaces::along({0, 0, 0}, 2, p); // 1 to 3 away, with edges of length 1.2 at most
  try {
    project_onto(ellipsoid, m.cells());
    FAIL() << "accepted";
  } catch (const Extraction_error& error) {
    EXPECT_NE(std::string(error.what()).find("point 0 at (-"), std::string::npos) << error.what();
  }
}

TEST(Project_onto, refuses_points_at_which_there_is_no_gradient) {
  const Formula f("x*y"); // its gradient is 0 along the z axis
  meshes::Polygons m;
  m.points = {{0, 0, 0}, {1, 0.1, 0}, {0.1, 1, 0}};
  m.polygons = {{0, 1, 2}};
  EXPECT_THROW(project_onto(f, m.cells()), Extraction_error);
}
