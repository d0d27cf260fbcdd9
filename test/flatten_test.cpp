// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cells in the plane.
#include "extracted_femur.h"

#include <CGAL/Extremal_mesh_3/flatten.h>

#include <CGAL/Extremal_mesh_3/Formula.h>
#include <CGAL/Extremal_mesh_3/cell_queries.h>

#include "temporary_folder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <sstream>

using namespace CGAL::Extremal_mesh_3;

namespace {

const Extraction& ellipsoid() {
  static const Extraction result = [] {
    Extraction_options options;
    options.patches = true;
    return extract_extremal_mesh(Formula("x^2/9 + y^2/4 + z^2 - 1"), make_lattice({-4.1, -3.2, -2.3}, {4, 3, 2}, 40),
                                 options);
  }();
  return result;
}

double area_in_plane(const std::array<std::array<double, 2>, 3>& t) {
  return 0.5 * ((t[1][0] - t[0][0]) * (t[2][1] - t[0][1]) - (t[1][1] - t[0][1]) * (t[2][0] - t[0][0]));
}

/// the areas in the plane of each cell that is flat; no triangle of which may be clockwise.
std::map<std::size_t, double> areas_in_plane(const Flattening& result) {
  std::map<std::size_t, double> areas;
  for (std::size_t c = 0; c < result.cells.size(); ++c) {
    const Flat_cell& cell = result.cells[c];
    if (cell.outcome != Flattening_outcome::flat)
      continue;
    for (std::size_t t = cell.first_triangle; t < cell.first_triangle + cell.triangles; ++t) {
      EXPECT_EQ(result.faces.cell[t], c);
      const double area = area_in_plane(result.places[t]);
      EXPECT_GE(area, -1e-16); // rounded here; decided exactly below
      areas[c] += area;
    }
  }
  EXPECT_EQ(result.flipped, 0U);
  return areas;
}

/// of n corners, in the unit square.
double area_of_polygon(std::size_t n) {
  return n == 4 ? 1 : 0.125 * double(n) * std::sin(2 * 3.14159265358979323846 / double(n));
}

} // namespace

// Counter-clockwise triangles in a convex polygon that cover its area once are a one-to-one image.
TEST(Flatten, maps_the_octants_of_an_ellipsoid_to_the_unit_square_one_to_one) {
  const Flattening result = flatten(ellipsoid().mesh, ellipsoid().patches);
  ASSERT_EQ(result.cells.size(), 8U);
  const auto areas = areas_in_plane(result);
  EXPECT_EQ(areas.size(), 8U);
  for (const auto& [c, area] : areas)
    EXPECT_NEAR(area, 1, 1e-12) << c;
  for (std::uint32_t c = 0; c < 8; ++c) {
    const auto quad = quadrilateral(ellipsoid().mesh, c);
    ASSERT_TRUE(quad);
    ASSERT_EQ(result.cells[c].corners.size(), 4U);
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_EQ(result.cells[c].corners[i], ellipsoid().mesh.source(quad->sides[i].half_edge));
      // that vertex is in its corner of the square
      constexpr std::array<std::array<double, 2>, 4> square{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
      bool found = false;
      for (std::size_t t = result.cells[c].first_triangle;
           t < result.cells[c].first_triangle + result.cells[c].triangles; ++t)
        for (std::size_t k = 0; k < 3; ++k)
          if (result.faces.points[result.faces.corners[3 * t + k]] ==
              ellipsoid().mesh.vertex(result.cells[c].corners[i]).point) {
            EXPECT_EQ(result.places[t][k], square[i]);
            found = true;
          }
      EXPECT_TRUE(found);
    }
    EXPECT_LT(result.cells[c].area_distortion, 2);
    EXPECT_GT(result.cells[c].area_distortion, 1);
  }
}

TEST(Flatten, maps_cells_of_a_real_mesh_with_any_number_of_corners_and_tells_which_it_cannot) {
  const Extremal_mesh& mesh = femur().mesh;
  const Flattening result = flatten(mesh, femur().patches);
  const auto areas = areas_in_plane(result);
  for (const auto& [c, area] : areas) {
    const std::size_t n = result.cells[c].corners.size();
    if (n >= 3) {
      EXPECT_NEAR(area, area_of_polygon(n), 1e-12) << c;
    } else { // polygons in a circle
      EXPECT_LT(area, 0.7854) << c;
      EXPECT_GT(area, 0) << c;
    }
  }
  std::size_t disks = 0;
  for (std::size_t c = 0; c < mesh.number_of_cells(); ++c) {
    const bool is_disk = mesh.cell(c).euler_characteristic == 1 && mesh.cell(c).boundary.size() == 1;
    if (!is_disk) {
      EXPECT_NE(result.cells[c].outcome, Flattening_outcome::flat) << c;
    }
    disks += is_disk ? 1 : 0;
  }
  EXPECT_GE(areas.size(), disks * 9 / 10); // others touch themselves along the border of the surface
  double sum = 0;
  for (const Extremal_mesh_cell& cell : mesh.cells())
    sum += cell.area;
  double on_surface = 0;
  for (std::size_t t = 0; t < result.places.size(); ++t) {
    const auto p = [&](std::size_t k) { return result.faces.points[result.faces.corners[3 * t + k]]; };
    Vector a{}, b{};
    for (std::size_t i = 0; i < 3; ++i) {
      a[i] = p(1)[i] - p(0)[i];
      b[i] = p(2)[i] - p(0)[i];
    }
    on_surface += 0.5 * std::hypot(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]);
  }
  EXPECT_NEAR(on_surface, sum, 1e-9 * sum); // nothing of the surface is lost
}

TEST(Flatten, does_not_depend_on_the_number_of_threads) {
  EXPECT_EQ(flatten(femur().mesh, femur().patches, 1).places, flatten(femur().mesh, femur().patches, 3).places);
}

TEST(Flatten, writes_texture_coordinates_for_each_corner) {
  const Flattening result = flatten(ellipsoid().mesh, ellipsoid().patches);
  const Temporary_folder folder;
  write_flat_obj(folder.file("flat.obj"), result);
  std::istringstream in(read_text(folder.file("flat.obj")));
  std::vector<std::array<double, 2>> places;
  std::size_t faces = 0, groups = 0;
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string key;
    words >> key;
    groups += key == "g" ? 1 : 0;
    if (key == "vt") {
      auto& p = places.emplace_back();
      words >> p[0] >> p[1];
    }
    if (key != "f")
      continue;
    for (std::size_t i = 0; i < 3; ++i) {
      std::string corner;
      words >> corner;
      const std::size_t vt = std::stoul(corner.substr(corner.find('/') + 1));
      ASSERT_LE(vt, places.size());
      EXPECT_EQ(places[vt - 1], result.places[faces][i]); // to the last bit
    }
    ++faces;
  }
  EXPECT_EQ(faces, result.places.size());
  EXPECT_EQ(groups, 8U);
}

TEST(Flatten, refuses_a_surface_that_is_not_of_the_mesh) {
  EXPECT_THROW(flatten(ellipsoid().mesh, femur().patches), std::invalid_argument);
  Cell_patches moved = ellipsoid().patches; // of the same areas: its vertices are elsewhere
  for (Point& p : moved.points)
    p[0] += 1;
  for (const Flat_cell& cell : flatten(ellipsoid().mesh, moved).cells)
    EXPECT_EQ(cell.outcome, Flattening_outcome::unclear_border);
}
