// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Surfaces on which E_g = 0 everywhere, and such as come near to that.
#include <CGAL/Extremal_mesh_3/Formula.h>

#include "graph_comparison.h"
#include "surfaces.h"

using namespace CGAL::Extremal_mesh_3;

namespace {

using surfaces::Motion;
using surfaces::Moved_function;

struct Degenerate {
  std::string name, formula;
  bool umbilics; ///< all points are umbilics
};

// Curvature is constant along circles of a surface of revolution; so are both curvatures along the lines of curvature
// of Dupin's cyclides, of which the torus is one.
const std::vector<Degenerate> degenerate = {
    {"sphere", "x^2+y^2+z^2-1", true},
    {"plane", "0.3*x+0.5*y-0.7*z-0.1", true},
    {"torus", "(x^2+y^2+z^2+0.51)^2-4*(0.64*(x^2+y^2))", false},
    {"cylinder", "x^2+y^2-0.5", false},
    {"cone", "x^2+y^2-(z-3)^2/9", false},
    {"ellipsoid_of_revolution", "x^2+y^2+2*z^2-1", false},
    {"barrel", "x^2+y^2-0.6+0.3*z^2-0.1*z^4", false},
};

std::string message(const Function_3& f) {
  try {
    // Sides of different lengths and an offset: nothing is where the symmetry would have it.
    extract_extremal_mesh(f, make_lattice({-1.31, -1.33, -1.29}, {1.37, 1.39, 1.35}, 25));
  } catch (const Degenerate_surface_error& error) {
    return error.what();
  }
  return "accepted";
}

class Degenerate_surfaces : public testing::TestWithParam<Degenerate> {};

} // namespace

TEST_P(Degenerate_surfaces, are_named_as_such) {
  const Formula f(GetParam().formula);
  for (unsigned seed = 0; seed <= 3; ++seed)
    for (const double sign : {1.0, -1.0}) {
      SCOPED_TRACE("seed " + std::to_string(seed));
      const Motion motion = seed == 0 ? Motion() : surfaces::random_motion(seed, 0.02);
      const std::string told = message(Moved_function(f, motion, sign));
      EXPECT_EQ(told.rfind("E_g is 0 over 100 % of the surface", 0), 0U) << told;
      EXPECT_NE(told.find(GetParam().umbilics ? "umbilics" : "constant along its own lines"), std::string::npos)
          << told;
    }
}

TEST_P(Degenerate_surfaces, are_found_at_any_scale) {
  const Formula f(GetParam().formula);
  for (const double scale : {1e-6, 1e6}) {
    Motion motion;
    motion.scale = scale;
    const Moved_function moved(f, motion);
    const double l = 1.31 * scale, h = 1.37 * scale;
    EXPECT_THROW(extract_extremal_mesh(moved, make_lattice({-l, -l, -l}, {h, h, h}, 25)), Degenerate_surface_error)
        << scale;
  }
}

INSTANTIATE_TEST_SUITE_P(Surfaces, Degenerate_surfaces, testing::ValuesIn(degenerate),
                         [](const auto& info) { return info.param.name; });

TEST(Nearly_degenerate, triaxial_ellipsoids_keep_their_mesh) {
  // Axes that differ by 1 % are already generic; MATHEMATICS 4 gives the counts.
  for (const std::string formula : {"x^2+1.01*y^2+1.02*z^2-1", "x^2+1.001*y^2+2*z^2-1", "x^2+2*y^2+2.001*z^2-1"}) {
    SCOPED_TRACE(formula);
    const Formula f(formula);
    const Motion motion = surfaces::random_motion(3, 0.1);
    const Moved_function moved(f, motion);
    const Extremal_mesh mesh = extract_extremal_mesh(moved, make_lattice({-1.3, -1.3, -1.3}, {1.3, 1.3, 1.3}, 32)).mesh;
    surfaces::expect_all_checks_hold(mesh);
    EXPECT_EQ(surfaces::counts_of(mesh), (surfaces::Counts{6, 4, 0, 16, 8, 0, 2}));
  }
}

TEST(Partly_degenerate, surfaces_tell_the_degenerate_area) {
  // A sphere and an ellipsoid that do not touch: one of the two components is degenerate. Areas: 4π·0.25² = 0.785 of
  // the sphere; the other one is larger.
  const Formula f("min((x+0.8)^2+y^2+z^2-0.0625,(x-0.3)^2+2*y^2+3*z^2-0.4)");
  const Extraction extraction = extract_extremal_mesh(f, make_lattice({-1.3, -1, -1}, {1.3, 1, 1}, 60));
  EXPECT_NEAR(extraction.mesh.surface().degenerate_area, 0.785, 0.01); // less by the chords of its cells
  EXPECT_GT(extraction.report.degenerate_cells, 0U);
  EXPECT_EQ(extraction.mesh.surface().components, 2U);
}

class Symmetric_surfaces : public testing::TestWithParam<std::string> {};

TEST_P(Symmetric_surfaces, are_survived) {
  // Mirror planes make lines of one family cross and umbilics of any even degree [MATHEMATICS 4]: what is found then is
  // not always known, but the parts must fit together.
  const Formula f(GetParam());
  for (const std::size_t resolution : {20U, 21U}) {
    SCOPED_TRACE(resolution);
    const Extremal_mesh mesh =
        extract_extremal_mesh(f, make_lattice({-1.3, -1.3, -1.3}, {1.3, 1.3, 1.3}, resolution)).mesh;
    for (const Check& c : check(mesh)) {
      const bool structure = c.name == "stars" || c.name == "walks" || c.name == "geometry" || c.name == "euler" ||
                             c.name == "alternation" || c.name == "umbilic_index" || c.name == "field_index";
      if (structure) {
        EXPECT_TRUE(!c.applies || c.holds) << c.name << ": " << c.detail;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Formulas, Symmetric_surfaces,
                         testing::Values("x^4+y^4+z^4-1", "x^6+y^6+z^6-1", "x^4+y^4+2*z^2-1"));

TEST(Rounded_cube, has_umbilics_of_degree_6_at_its_corners_and_index_1_at_each_face) {
  // x⁴ + y⁴ + z⁴ = 1 is symmetric about its corners' and faces' axes. At a corner the three mirror planes leave a star
  // of index −½ with six branches; indices sum to 2 = 8·(−½) + 6·1, so each face's centre has index 1. (It is flat to
  // third order there: whether all its branches are found to meet in one vertex depends on rounding.)
  const Extremal_mesh mesh =
      extract_extremal_mesh(Formula("x^4+y^4+z^4-1"), make_lattice({-1.23, -1.21, -1.19}, {1.27, 1.25, 1.22}, 25)).mesh;
  int corners = 0;
  std::map<std::pair<std::size_t, bool>, double> face_index;
  for (std::size_t v = 0; v < mesh.number_of_vertices(); ++v) {
    const Extremal_mesh_vertex& x = mesh.vertex(v);
    const double corner = std::pow(1.0 / 3, 0.25);
    if (std::abs(std::abs(x.point[0]) - corner) < 1e-9 && std::abs(std::abs(x.point[1]) - corner) < 1e-9) {
      ++corners;
      EXPECT_EQ(x.umbilic_type, Umbilic_type::star);
      EXPECT_EQ(x.star.size(), 6U);
    }
    for (std::size_t a = 0; a < 3; ++a)
      if (std::abs(x.point[a]) > 1 - 1e-3)
        face_index[{a, x.point[a] > 0}] += x.umbilic_index;
  }
  EXPECT_EQ(corners, 8);
  EXPECT_EQ(face_index.size(), 6U);
  for (const auto& [face, index] : face_index)
    EXPECT_EQ(index, 1) << "face across axis " << face.first;
}
