// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A cell for each face of a surface.
#include <CGAL/Extremal_mesh_3/segment.h>

#include <CGAL/Extremal_mesh_3/Formula.h>
#include <CGAL/Extremal_mesh_3/fit_vertex_shapes.h>
#include <CGAL/Extremal_mesh_3/read_mesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

using namespace CGAL::Extremal_mesh_3;

namespace {

const Formula& ellipsoid() {
  static const Formula formula("x^2/9 + y^2/4 + z^2 - 1");
  return formula;
}

Cell_complex ellipsoid_cells(std::size_t resolution) {
  return make_implicit_cells(ellipsoid(), make_lattice({-4.1, -3.2, -2.3}, {4, 3, 2}, resolution));
}

const Extraction& extraction() {
  static const Extraction result = [] {
    Extraction_options options;
    options.patches = true;
    return extract_extremal_mesh(ellipsoid(), ellipsoid_cells(40), options);
  }();
  return result;
}

std::size_t number_of_faces(const Segmentation& result) {
  std::size_t sum = 0;
  for (const Cell_share& share : result.cells)
    sum += share.faces;
  return sum;
}

/// the signs of the coordinates of the middle of a face: its octant.
int octant_of(const Cell_patches& faces, std::size_t i) {
  Point sum{};
  for (std::size_t j = faces.begin[i]; j < faces.begin[i + 1]; ++j)
    for (std::size_t a = 0; a < 3; ++a)
      sum[a] += faces.points[faces.corners[j]][a];
  return (sum[0] > 0 ? 1 : 0) + (sum[1] > 0 ? 2 : 0) + (sum[2] > 0 ? 4 : 0);
}

/// whether all corners of a face are on one side of all planes of coordinates.
bool is_in_one_octant(const Cell_patches& faces, std::size_t i) {
  for (std::size_t a = 0; a < 3; ++a) {
    bool below = false, above = false;
    for (std::size_t j = faces.begin[i]; j < faces.begin[i + 1]; ++j) {
      below = below || faces.points[faces.corners[j]][a] < 0;
      above = above || faces.points[faces.corners[j]][a] > 0;
    }
    if (below && above)
      return false;
  }
  return true;
}

std::string refusal(const auto& function) {
  try {
    function();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

} // namespace

TEST(Segment, takes_over_the_cells_of_the_surface_that_is_cut_along_the_lines) {
  const auto& [mesh, report, patches] = extraction();
  const Segmentation result = segment(mesh, patches);
  EXPECT_EQ(result.faces.cell, patches.cell);
  EXPECT_EQ(number_of_faces(result), patches.cell.size());
  EXPECT_EQ(result.cut_faces, 0U);
  for (std::size_t c = 0; c < mesh.number_of_cells(); ++c) {
    EXPECT_EQ(result.cells[c].pieces, 1U) << c;
    EXPECT_NEAR(result.cells[c].area, mesh.cell(c).area, 1e-12 * mesh.surface().area) << c;
  }
}

// The lines of an ellipsoid are where it meets the planes of coordinates: cells are octants.
TEST(Segment, finds_the_octants_of_an_ellipsoid_on_meshes_that_are_not_cut_along_the_lines) {
  const auto& [mesh, report, patches] = extraction();
  for (const std::size_t resolution : {13, 31, 57}) {
    const Cell_complex surface = ellipsoid_cells(resolution);
    Segmentation_options options;
    options.tolerance = 0.2; // coarse polygons are deep below the surface
    const Segmentation result = segment(surface, mesh, patches, options);
    ASSERT_EQ(result.faces.cell.size(), surface.number_of_cells());
    EXPECT_EQ(number_of_faces(result), surface.number_of_cells());
    std::set<std::pair<int, std::uint32_t>> found;
    std::size_t divided = 0;
    for (std::size_t i = 0; i < surface.number_of_cells(); ++i) {
      if (is_in_one_octant(result.faces, i))
        found.insert({octant_of(result.faces, i), result.faces.cell[i]});
      else
        ++divided;
    }
    EXPECT_EQ(found.size(), 8U) << resolution; // so each octant is in one cell, and all of them are others
    EXPECT_GT(result.cut_faces, 0U);
    EXPECT_LE(result.cut_faces, divided);
    double sum = 0;
    for (const Cell_share& share : result.cells) {
      EXPECT_EQ(share.pieces, 1U);
      EXPECT_NEAR(share.area, result.area / 8, result.cut_area);
      sum += share.area;
    }
    EXPECT_NEAR(sum, result.area, 1e-12 * result.area);
    // the sagitta of a cube's diagonal where the curvature is 1/r = 3 at most, for both surfaces
    const double step = 8.1 / double(resolution) + 8.1 / 40;
    EXPECT_LT(result.largest_distance, 3 * step * step * 3 / 8);
  }
}

TEST(Segment, does_not_depend_on_the_number_of_threads) {
  const auto& [mesh, report, patches] = extraction();
  const Cell_complex surface = ellipsoid_cells(57);
  Segmentation_options options;
  options.threads = 1;
  const Segmentation one = segment(surface, mesh, patches, options);
  options.threads = 3;
  const Segmentation three = segment(surface, mesh, patches, options);
  EXPECT_EQ(one.faces.cell, three.faces.cell);
  EXPECT_EQ(one.largest_distance, three.largest_distance);
}

TEST(Segment, labels_a_real_mesh_as_its_cut_faces_are) {
  const Mesh femur = read_mesh(EXTREMAL_MESH_3_DATA_DIR "/femur.off");
  Fit_options fit;
  fit.radius = 0.1;
  Extraction_options options;
  options.patches = true;
  const Extraction extraction = extract_extremal_mesh(femur.cells, fit_vertex_shapes(femur.cells, fit).shapes, options);
  const Segmentation whole = segment(femur.cells, extraction.mesh, extraction.patches),
                     cut = segment(extraction.mesh, extraction.patches);
  EXPECT_EQ(number_of_faces(whole), femur.cells.number_of_cells());
  // Of the faces through which a line runs at most half is in another cell.
  double sum = 0;
  for (std::size_t c = 0; c < whole.cells.size(); ++c)
    sum += std::abs(whole.cells[c].area - cut.cells[c].area);
  EXPECT_LT(sum / 2, whole.cut_area + whole.away_area);
}

TEST(Segment, refuses_a_surface_that_is_elsewhere) {
  const auto& [mesh, report, patches] = extraction();
  Cell_complex surface = ellipsoid_cells(20);
  for (Point& p : surface.points)
    p[0] += 1;
  EXPECT_TRUE(refusal([&] { segment(surface, mesh, patches); }).find("of the surface are farther") !=
              std::string::npos);
}

TEST(Segment, refuses_cells_that_are_not_those_of_the_mesh) {
  const auto& [mesh, report, patches] = extraction();
  Cell_patches others = patches;
  std::swap(*std::find(others.cell.begin(), others.cell.end(), 0U),
            *std::find(others.cell.begin(), others.cell.end(), 1U));
  for (Point& p : others.points)
    p[2] *= 1.01;
  EXPECT_TRUE(
      refusal([&] { segment(mesh, others); }).starts_with("the surface is not that of the extremal mesh: cell "));
  others = patches;
  others.cell[7] = 8;
  EXPECT_NE(refusal([&] { segment(mesh, others); }), "");
  EXPECT_NE(refusal([&] { segment(ellipsoid_cells(20), mesh, {}); }), "");
}

TEST(Segment, can_be_cancelled) {
  const auto& [mesh, report, patches] = extraction();
  Segmentation_options options;
  options.progress = [](double) { return false; };
  EXPECT_THROW(segment(ellipsoid_cells(20), mesh, patches, options), Cancelled);
}
