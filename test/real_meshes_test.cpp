// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Meshes as they are in the wild: scans, models, CAD, with borders and defects. Each gives an extremal mesh whose identities
// hold, or a clear statement why there is none.
#include <CGAL/Extremal_mesh_3/errors.h>
#include <CGAL/Extremal_mesh_3/fit_vertex_shapes.h>
#include <CGAL/Extremal_mesh_3/read_mesh.h>

#include "graph_comparison.h"
#include "surfaces.h"

#include <filesystem>

using namespace CGAL::Extremal_mesh_3;

namespace {

/// What becomes of a mesh.
enum class Outcome { mesh, spherical, of_revolution, too_few_vertices };

struct Real_mesh {
  std::string file;
  Outcome outcome;
  int euler_characteristic; ///< of the surface, before anything is cut out

  friend std::ostream& operator<<(std::ostream& out, const Real_mesh& m) { return out << m.file; }
};

std::string folder() {
#ifdef EXTREMAL_MESH_3_SHARED_DATA_DIR
  return EXTREMAL_MESH_3_SHARED_DATA_DIR "/meshes/";
#else
  return "";
#endif
}

class Real_meshes : public testing::TestWithParam<Real_mesh> {
protected:
  void SetUp() override {
    if (folder().empty() || !std::filesystem::exists(folder() + GetParam().file))
      GTEST_SKIP() << "the shared data are not here";
  }
};

Extraction extract(const Cell_complex& cells) {
  Extraction_options options; // as the program has them for meshes
  options.max_level = 8;
  options.max_line_level = 2;
  return extract_extremal_mesh(cells, fit_vertex_shapes(cells).shapes, options);
}

std::string statement(const Cell_complex& cells) {
  try {
    extract(cells);
  } catch (const Extraction_error& error) {
    return error.what();
  }
  return "";
}

} // namespace

TEST_P(Real_meshes, give_a_sound_mesh_or_a_clear_statement) {
  const Cell_complex cells = read_mesh(folder() + GetParam().file).cells;
  EXPECT_EQ(cells.euler_characteristic(), GetParam().euler_characteristic);
  switch (GetParam().outcome) {
  case Outcome::mesh: {
    const Extraction extraction = extract(cells);
    surfaces::expect_all_checks_hold(extraction.mesh);
    EXPECT_GT(extraction.mesh.number_of_edges(), 0U);
    break;
  }
  case Outcome::spherical:
    EXPECT_NE(statement(cells).find("all its points are umbilics"), std::string::npos) << statement(cells);
    break;
  case Outcome::of_revolution:
    EXPECT_NE(statement(cells).find("constant along its own lines"), std::string::npos) << statement(cells);
    break;
  case Outcome::too_few_vertices:
    EXPECT_NE(statement(cells).find("no jet of degree 4 could be fitted"), std::string::npos) << statement(cells);
    break;
  }
}

// Euler characteristics: what an independent count of vertices, edges and faces gives after welding; see the sources'
// README for what each mesh is.
INSTANTIATE_TEST_SUITE_P(
    Files, Real_meshes,
    testing::Values(
        Real_mesh{"ellipsoid_exact_tri.off", Outcome::mesh, 2}, Real_mesh{"ellipsoid_exact_quad.off", Outcome::mesh, 2},
        Real_mesh{"ellipsoid.off", Outcome::mesh, 2}, Real_mesh{"sphere966.off", Outcome::spherical, 2},
        Real_mesh{"hemisphere.off", Outcome::spherical, 1}, Real_mesh{"torus.STL", Outcome::of_revolution, 0},
        Real_mesh{"cylinder.obj", Outcome::of_revolution, 2}, Real_mesh{"poly2x2_y2-0.062500.off", Outcome::mesh, 1},
        Real_mesh{"mannequin-devil.off", Outcome::mesh, 1}, Real_mesh{"suzanne.obj", Outcome::mesh, 2},
        Real_mesh{"fandisk.off", Outcome::mesh, 2}, Real_mesh{"fandisk_quads.off", Outcome::mesh, 2},
        Real_mesh{"joint.off", Outcome::too_few_vertices, -2}, Real_mesh{"featuretype.STL", Outcome::mesh, -16},
        Real_mesh{"femur.off", Outcome::mesh, -2}, Real_mesh{"femur_dual_poly.off", Outcome::mesh, -2},
        Real_mesh{"shark.ply", Outcome::mesh, 2}, Real_mesh{"horse_quad.obj", Outcome::mesh, 2},
        Real_mesh{"bone.ply", Outcome::mesh, 2}, Real_mesh{"bunny_adaptive.off", Outcome::mesh, 2},
        Real_mesh{"SCP1.ply", Outcome::mesh, -32}, Real_mesh{"cube_poly.off", Outcome::too_few_vertices, 2},
        Real_mesh{"corner_poly.off", Outcome::too_few_vertices, 2}, Real_mesh{"cross_quad.off", Outcome::mesh, 2},
        Real_mesh{"chamfer-cube.off", Outcome::too_few_vertices, 2},
        Real_mesh{"torus_quad.off", Outcome::too_few_vertices, 0}),
    [](const auto& info) {
      std::string name = std::filesystem::path(info.param.file).stem().string();
      for (char& c : name)
        c = std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
      return name;
    });

TEST(Paraboloid, has_its_vertex_and_its_umbilics) {
  const std::string file = folder() + "poly2x2_y2-0.062500.off";
  if (folder().empty() || !std::filesystem::exists(file))
    GTEST_SKIP() << "the shared data are not here";
  // z = 2x² + y² over [−1, 1]². On the line y = 0 the curvatures are 4/(1 + 16x²)^{3/2} and 2/(1 + 16x²)^{1/2}, equal at
  // x = ±1/4; the vertex is the only extremal point.
  const Extremal_mesh mesh = extract(read_mesh(file).cells).mesh;
  const double edge = 1.0 / 16;
  const auto points = graph_comparison::positions(mesh, Vertex_kind::extremal_point);
  const auto umbilics = graph_comparison::positions(mesh, Vertex_kind::umbilic);
  EXPECT_LT(graph_comparison::largest_distance(points, {{0, 0, 0}}).value_or(1), edge);
  EXPECT_LT(graph_comparison::largest_distance(umbilics, {{0.25, 0, 0.125}, {-0.25, 0, 0.125}}).value_or(1), edge);
}
