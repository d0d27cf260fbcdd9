// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Simplification keeps every identity at every level, follows the surface when that is moved, and brings back the mesh
// of an ellipsoid from under noise.
#include <CGAL/Extremal_mesh_3/Image_function.h>
#include <CGAL/Extremal_mesh_3/fit_vertex_shapes.h>
#include <CGAL/Extremal_mesh_3/io.h>
#include <CGAL/Extremal_mesh_3/read_mesh.h>
#include <CGAL/Extremal_mesh_3/simplify.h>
#include <CGAL/Extremal_mesh_3/summary.h>

#include "graph_comparison.h"
#include "meshes.h"
#include "random_surfaces.h"
#include "same_mesh.h"
#include "strands.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <ostream>
#include <set>

using namespace CGAL::Extremal_mesh_3;

namespace {

/// what must hold of a level, with everything that depends on it alone.
void expect_good_level(const Extremal_mesh& given, const Simplification& simplification, std::size_t level) {
  SCOPED_TRACE("level " + std::to_string(level));
  const Extremal_mesh mesh = simplification.mesh_at(level);
  surfaces::expect_all_checks_hold(mesh);
  if (level == 0)
    return;
  const Simplification_step& step = simplification.steps()[level - 1];
  EXPECT_EQ(mesh.number_of_vertices(), step.vertices);
  EXPECT_EQ(mesh.number_of_edges(), step.edges);
  EXPECT_EQ(mesh.number_of_cells(), step.cells);
  const double before = level > 1 ? simplification.steps()[level - 2].persistence : 0;
  EXPECT_GE(step.persistence, before);
  const std::vector<std::uint32_t> cell = simplification.cells_at(level);
  ASSERT_EQ(cell.size(), given.number_of_cells());
  std::vector<double> area(mesh.number_of_cells(), 0);
  for (std::size_t c = 0; c < cell.size(); ++c)
    area.at(cell[c]) += given.cell(c).area;
  for (std::size_t c = 0; c < area.size(); ++c)
    EXPECT_DOUBLE_EQ(area[c], mesh.cell(c).area);
}

void expect_good_levels(const Extremal_mesh& given, std::size_t every = 1) {
  const Simplification simplification(given);
  for (std::size_t level = 0; level < simplification.number_of_levels(); level += every)
    expect_good_level(given, simplification, level);
  expect_good_level(given, simplification, simplification.number_of_levels() - 1);
  same_mesh::expect_same(simplification.mesh_at(0), given);
}

/// Persistence is an integral along lines, which is as exact as they are fine.
Extremal_mesh extract(const Function_3& f, const surfaces::Box& box, std::size_t resolution) {
  Extraction_options options;
  options.line_tolerance = 2e-5 * box.size();
  return extract_extremal_mesh(f, make_lattice(box.low, box.high, resolution), options).mesh;
}

std::size_t number_of_four_sided_cells(const Extremal_mesh& mesh) {
  return std::size_t(std::count_if(mesh.cells().begin(), mesh.cells().end(), [](const Extremal_mesh_cell& c) {
    return c.euler_characteristic == 1 && c.boundary.size() == 1 && c.boundary[0].size() == 4;
  }));
}

const surfaces::Counts ellipsoid_counts{6, 4, 0, 16, 8, 0, 2};
const double b = std::sqrt(0.5), c = 0.5; ///< of the ellipsoid x² + 2y² + 4z² = 1

/// the level before the greatest rise of the persistence is the ellipsoid's mesh.
/// \param ratio  of the persistence above the gap to that below
void expect_ellipsoid_at_gap(const Extremal_mesh& noisy, double ratio, double distance) {
  const Simplification simplification(noisy);
  const std::size_t level = simplification.level_at_gap();
  ASSERT_GT(level, 0U);
  ASSERT_LT(level, simplification.steps().size());
  const double below = simplification.steps()[level - 1].persistence, above = simplification.steps()[level].persistence;
  EXPECT_GT(above / below, ratio) << above << " over " << below;
  const Extremal_mesh mesh = simplification.mesh_at(level);
  EXPECT_EQ(surfaces::counts_of(mesh), ellipsoid_counts);
  EXPECT_EQ(number_of_four_sided_cells(mesh), 8U);
  const double x = std::sqrt(2.0 / 3), z = c * std::sqrt(1.0 / 3);
  const auto off = graph_comparison::largest_distance(graph_comparison::positions(mesh, Vertex_kind::umbilic),
                                                      {{x, 0, z}, {-x, 0, z}, {x, 0, -z}, {-x, 0, -z}});
  ASSERT_TRUE(off);
  EXPECT_LT(*off, distance);
}

} // namespace

TEST(Simplification, leaves_the_exact_ellipsoid_as_it_is_below_the_gap) {
  const Extremal_mesh mesh =
      extract(make_function([](auto x, auto y, auto z) { return x * x + 2 * y * y + 4 * z * z - 1; }),
              {{-1.1, -0.8, -0.6}, {1.1, 0.8, 0.6}}, 32);
  const Simplification simplification(mesh);
  EXPECT_EQ(simplification.level_at_gap(), 0U);
  // Two cancellations leave the 4 lemons and the 2 extremal points that Poincaré and Hopf ask for.
  ASSERT_EQ(simplification.steps().size(), 2U);
  // The least costs as much as k1 or k2 changes along an edge between extremal points.
  double least = 1e9;
  for (std::size_t e = 0; e < mesh.number_of_edges(); ++e) {
    const Extremal_mesh_edge& edge = mesh.edge(e);
    const Extremal_mesh_vertex &s = mesh.vertex(edge.source), &t = mesh.vertex(edge.target);
    if (s.kind == Vertex_kind::extremal_point && t.kind == Vertex_kind::extremal_point)
      least = std::min(least, edge.family == 1 ? std::abs(s.k2 - t.k2) : std::abs(s.k1 - t.k1));
  }
  EXPECT_NEAR(simplification.steps()[0].persistence, std::sqrt(mesh.surface().area) * least, 0.01 * least);
  expect_good_levels(mesh);
}

struct Noise {
  double sigma; ///< of the vertices along the radius, in mean lengths of an edge
  int rings;    ///< of the jets
  unsigned seed;

  friend std::ostream& operator<<(std::ostream& out, const Noise& n) {
    return out << n.sigma << " edges, " << n.rings << " rings, seed " << n.seed;
  }
};

class Ellipsoid_with_vertex_noise : public testing::TestWithParam<Noise> {};

TEST_P(Ellipsoid_with_vertex_noise, has_its_mesh_back_at_the_gap) {
  const Noise noise = GetParam();
  const meshes::Polygons exact = meshes::on_ellipsoid(meshes::icosphere(5), 1, b, c); // 10242 vertices
  const double edge = meshes::mean_edge_length(exact);
  const Cell_complex cells = meshes::with_radial_noise(exact, noise.sigma * edge, noise.seed).cells();
  Fit_options options;
  options.rings = noise.rings;
  const Extremal_mesh noisy = extract_extremal_mesh(cells, fit_vertex_shapes(cells, options).shapes).mesh;
  EXPECT_GT(noisy.number_of_vertices(), 300U);
  expect_ellipsoid_at_gap(noisy, 1.5, 4 * edge);
}

INSTANTIATE_TEST_SUITE_P(Seeds, Ellipsoid_with_vertex_noise,
                         testing::Values(Noise{0.001, 3, 1}, Noise{0.001, 3, 2}, Noise{0.001, 3, 3}, Noise{0.001, 3, 4},
                                         Noise{0.01, 6, 1}, Noise{0.01, 6, 2}, Noise{0.01, 6, 3}, Noise{0.01, 6, 4}));

class Ellipsoid_in_a_noisy_image : public testing::TestWithParam<unsigned> {};

TEST_P(Ellipsoid_in_a_noisy_image, has_its_mesh_back_at_the_gap) {
  const std::size_t n = 64;
  const double step = 2.4 / double(n - 1);
  Image image{{{-1.2, -1.2, -1.2}, {{{step, 0, 0}, {0, step, 0}, {0, 0, step}}}, {n, n, n}}, {}};
  random_surfaces::Random random(GetParam());
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t i = 0; i < n; ++i) {
        const Point p = image.lattice.node(double(i), double(j), double(k));
        const double f = 1 - p[0] * p[0] - 2 * p[1] * p[1] - 4 * p[2] * p[2];
        image.voxels.push_back(float(f + random.uniform(-0.03, 0.03)));
      }
  Image_function_options options;
  options.sigma = 2 * step;
  const Image_function f(std::move(image), options);
  const Extremal_mesh noisy = extract_extremal_mesh(f, f.lattice()).mesh;
  EXPECT_GT(noisy.number_of_vertices(), 100U);
  expect_ellipsoid_at_gap(noisy, 1.5, 4 * step);
}

INSTANTIATE_TEST_SUITE_P(Seeds, Ellipsoid_in_a_noisy_image, testing::Range(1U, 4U));

class Random_surface_levels : public testing::TestWithParam<unsigned> {};

TEST_P(Random_surface_levels, pass_every_check) {
  const unsigned seed = GetParam();
  {
    SCOPED_TRACE("ellipsoid");
    const auto f = random_surfaces::ellipsoid(seed);
    expect_good_levels(extract(f, random_surfaces::box_of(f), 32));
  }
  {
    SCOPED_TRACE("torus");
    expect_good_levels(extract(random_surfaces::torus(seed), {{-1.8, -1.7, -0.7}, {1.8, 1.7, 0.7}}, 48));
  }
  {
    SCOPED_TRACE("genus 2");
    const Extremal_mesh mesh =
        extract(random_surfaces::double_torus(seed), {{-1.35, -0.85, -0.5}, {1.35, 0.85, 0.5}}, 64);
    EXPECT_EQ(mesh.surface().euler_characteristic, -2);
    expect_good_levels(mesh);
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, Random_surface_levels, testing::Range(1U, 7U));

class Random_surface_lines : public testing::TestWithParam<unsigned> {};

TEST_P(Random_surface_lines, run_along_given_ones_and_do_not_cross) {
  const Extremal_mesh mesh =
      extract(random_surfaces::double_torus(GetParam()), {{-1.35, -0.85, -0.5}, {1.35, 0.85, 0.5}}, 48);
  const Simplification simplification(mesh);
  for (std::size_t level = 0; level < simplification.number_of_levels(); ++level)
    EXPECT_EQ(strands::crossings(mesh, simplification.mesh_at(level)), 0) << "level " << level;
}

INSTANTIATE_TEST_SUITE_P(Seeds, Random_surface_lines, testing::Range(1U, 4U));

TEST(Simplification, moves_with_the_surface) {
  const auto f = random_surfaces::ellipsoid(3);
  const surfaces::Box box = random_surfaces::box_of(f);
  const Simplification reference(extract(f, box, 32));
  ASSERT_GT(reference.steps().size(), 5U);
  for (unsigned seed = 1; seed <= 4; ++seed) {
    SCOPED_TRACE("motion " + std::to_string(seed));
    surfaces::Motion motion = surfaces::random_motion(seed, 3);
    motion.scale = seed == 4 ? 250 : 1; // nor does persistence depend on the scale
    const surfaces::Moved_function g(f, motion);
    const surfaces::Box around = surfaces::moved(box, motion);
    const Simplification moved(extract(g, around, 48));
    ASSERT_EQ(moved.steps().size(), reference.steps().size());
    for (std::size_t i = 0; i < moved.steps().size(); ++i) {
      const Simplification_step &a = reference.steps()[i], &b = moved.steps()[i];
      EXPECT_EQ(a.operation, b.operation) << i;
      EXPECT_NEAR(a.persistence, b.persistence, 0.02 * a.persistence) << i; // integrals along other polylines
      EXPECT_TRUE(graph_comparison::isomorphic(reference.mesh_at(i + 1), moved.mesh_at(i + 1))) << i;
    }
  }
}

TEST(Simplification, of_a_moved_mesh_is_the_moved_one) {
  meshes::Polygons mesh = meshes::on_ellipsoid(meshes::icosphere(4), 1, b, c);
  mesh = meshes::with_radial_noise(mesh, 0.003 * meshes::mean_edge_length(mesh), 1);
  Fit_options fit;
  fit.rings = 3;
  const auto simplification = [&](const Cell_complex& cells) {
    return Simplification(extract_extremal_mesh(cells, fit_vertex_shapes(cells, fit).shapes).mesh);
  };
  const Simplification reference = simplification(mesh.cells());
  ASSERT_GT(reference.steps().size(), 50U);
  for (unsigned seed = 1; seed <= 3; ++seed) {
    SCOPED_TRACE("motion " + std::to_string(seed));
    const surfaces::Motion motion = surfaces::random_motion(seed, 3);
    const Simplification moved = simplification(meshes::moved(mesh, motion).cells());
    ASSERT_EQ(moved.steps().size(), reference.steps().size());
    for (std::size_t i = 0; i < moved.steps().size(); ++i) {
      const Simplification_step &x = reference.steps()[i], &y = moved.steps()[i];
      EXPECT_EQ(x.operation, y.operation) << i;
      // Where extremal points lie within rounding of each other, persistence, of the order of 1 for shape, is rounding, too.
      EXPECT_NEAR(x.persistence, y.persistence, 1e-6 * x.persistence + 1e-15) << i;
    }
    for (const std::size_t level : {reference.level_at_gap() / 2, reference.level_at_gap()}) {
      const Extremal_mesh expected = reference.mesh_at(level), found = moved.mesh_at(level);
      EXPECT_TRUE(graph_comparison::isomorphic(expected, found)) << level;
      for (const Vertex_kind kind : {Vertex_kind::extremal_point, Vertex_kind::umbilic}) {
        std::vector<Point> points = graph_comparison::positions(expected, kind);
        for (Point& p : points)
          p = motion(p);
        const auto off = graph_comparison::largest_distance(graph_comparison::positions(found, kind), points);
        ASSERT_TRUE(off);
        EXPECT_LT(*off, 1e-6);
      }
    }
  }
}

TEST(Simplification, keeps_strong_crest_lines_where_they_are) {
  const Mesh femur = read_mesh(EXTREMAL_MESH_3_DATA_DIR "/femur.off");
  Fit_options fit;
  fit.radius = 0.06;
  const Extremal_mesh mesh = extract_extremal_mesh(femur.cells, fit_vertex_shapes(femur.cells, fit).shapes).mesh;
  Simplification_options options;
  options.keep_crest = 2;
  const Simplification simplification(mesh, options);
  const Extremal_mesh simple = simplification.mesh_at(simplification.steps().size());
  ASSERT_LT(simple.number_of_edges(), mesh.number_of_edges() / 2);
  using Segment = std::pair<Point, Point>;
  std::set<Segment> segments;
  for (std::size_t e = 0; e < simple.number_of_edges(); ++e) {
    const auto& line = simple.edge(e).polyline;
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
      segments.insert(std::minmax(line[i], line[i + 1]));
  }
  std::size_t kept = 0, gone = 0;
  for (std::size_t e = 0; e < mesh.number_of_edges(); ++e) {
    const Extremal_mesh_edge& edge = mesh.edge(e);
    bool all = true;
    for (std::size_t i = 0; i + 1 < edge.polyline.size(); ++i)
      all = all && segments.contains(std::minmax(edge.polyline[i], edge.polyline[i + 1]));
    gone += !all;
    if (edge.type != Line_type::max_largest || edge.strength < options.keep_crest)
      continue;
    ++kept;
    EXPECT_TRUE(all) << "edge " << e << " of strength " << edge.strength;
  }
  EXPECT_GT(kept, 0U);
  EXPECT_GT(gone, mesh.number_of_edges() / 4);
}

TEST(Simplification, of_a_skull_passes_every_check_at_every_level) {
  Image_function_options image_options;
  image_options.iso = 2.9;
  const Image_function f(read_image(EXTREMAL_MESH_3_DATA_DIR "/skull_2.9.nrrd"), image_options);
  Extraction_options options;
  options.max_level = 8;
  options.max_line_level = 2;
  const Extremal_mesh mesh = extract_extremal_mesh(f, f.lattice(), options).mesh;
  EXPECT_GT(mesh.number_of_vertices(), 2000U);
  expect_good_levels(mesh);
}

TEST(Simplification, of_a_bordered_surface_passes_every_check) {
  const Mesh mannequin = read_mesh(EXTREMAL_MESH_3_DATA_DIR "/mannequin-devil.off");
  Fit_options fit;
  fit.radius = 0.5;
  const Extremal_mesh mesh =
      extract_extremal_mesh(mannequin.cells, fit_vertex_shapes(mannequin.cells, fit).shapes).mesh;
  EXPECT_FALSE(mesh.surface().closed);
  expect_good_levels(mesh, 5); // of some thousand levels
}

TEST(Simplification, finds_levels_by_persistence_cells_and_vertices) {
  const auto f = random_surfaces::ellipsoid(3);
  const Simplification simplification(extract(f, random_surfaces::box_of(f), 32));
  const auto& steps = simplification.steps();
  for (std::size_t level = 1; level <= steps.size(); ++level) {
    const std::size_t found = simplification.level_of_persistence(steps[level - 1].persistence);
    EXPECT_GE(found, level);
    EXPECT_TRUE(found == steps.size() || steps[found].persistence > steps[level - 1].persistence);
    EXPECT_LE(steps[simplification.level_of_cells(steps[level - 1].cells) - 1].cells, steps[level - 1].cells);
    EXPECT_LE(steps[simplification.level_of_vertices(steps[level - 1].vertices) - 1].vertices,
              steps[level - 1].vertices);
  }
  EXPECT_EQ(simplification.level_of_persistence(-1), 0U);
  EXPECT_EQ(simplification.level_of_cells(1000000), 0U);
  EXPECT_EQ(simplification.level_of_vertices(0), steps.size());
  EXPECT_THROW(simplification.mesh_at(steps.size() + 1), std::out_of_range);
}

TEST(Simplification, tells_when_each_vertex_vanishes) {
  const auto f = random_surfaces::ellipsoid(5);
  const Extremal_mesh mesh = extract(f, random_surfaces::box_of(f), 32);
  const Simplification simplification(mesh);
  const std::vector<double> persistence = simplification.vertex_persistence();
  ASSERT_EQ(persistence.size(), mesh.number_of_vertices());
  for (std::size_t level = 0; level <= simplification.steps().size(); ++level) {
    const double threshold = level == 0 ? -1 : simplification.steps()[level - 1].persistence;
    const Extremal_mesh simple = simplification.mesh_at(simplification.level_of_persistence(threshold));
    std::set<Point> left;
    for (std::size_t v = 0; v < simple.number_of_vertices(); ++v)
      if (simple.vertex(v).kind != Vertex_kind::anchor)
        left.insert(simple.vertex(v).point);
    std::set<Point> expected;
    for (std::size_t v = 0; v < mesh.number_of_vertices(); ++v)
      if (mesh.vertex(v).kind != Vertex_kind::anchor && persistence[v] > threshold)
        expected.insert(mesh.vertex(v).point);
    EXPECT_EQ(left, expected) << "level " << level;
  }
}

TEST(Simplification, is_recorded_in_the_file) {
  const auto f = random_surfaces::ellipsoid(3);
  Extremal_mesh mesh = extract(f, random_surfaces::box_of(f), 32);
  mesh.set_provenance("a formula", R"({"resolution":32})", "");
  const Simplification simplification(mesh);
  const std::string file = testing::TempDir() + "simplified.graphml";
  write_graphml(file, simplification.mesh_at(2));
  const Extremal_mesh read = read_graphml(file);
  same_mesh::expect_same(read, simplification.mesh_at(2));
  EXPECT_EQ(read.surface().source, "a formula");
  auto parameters = nlohmann::json::parse(read.surface().parameters);
  EXPECT_EQ(parameters["resolution"], 32);
  EXPECT_EQ(parameters["simplification"]["level"], 2);
  EXPECT_EQ(parameters["simplification"]["persistence"], simplification.steps()[1].persistence);
  // Simplified again, from the file, it goes on where it was.
  const Simplification again(read);
  ASSERT_EQ(again.steps().size(), simplification.steps().size() - 2);
  parameters = nlohmann::json::parse(again.mesh_at(1).surface().parameters);
  EXPECT_EQ(parameters["simplification"]["level"], 1);
  EXPECT_EQ(parameters["simplification"]["before"]["level"], 2);
}

TEST(Simplification, of_an_empty_mesh_does_nothing) {
  const Simplification simplification{Extremal_mesh()};
  EXPECT_TRUE(simplification.steps().empty());
  EXPECT_EQ(simplification.level_at_gap(), 0U);
  EXPECT_EQ(simplification.mesh_at(0).number_of_vertices(), 0U);
}

TEST(Simplification, refuses_a_mesh_that_contradicts_itself) {
  const auto f = random_surfaces::ellipsoid(3);
  const Extremal_mesh mesh = extract(f, random_surfaces::box_of(f), 24);
  const auto refusal = [&](const auto& spoil) {
    std::vector<Extremal_mesh_vertex> vertices;
    std::vector<Extremal_mesh_edge> edges;
    for (std::size_t v = 0; v < mesh.number_of_vertices(); ++v)
      vertices.push_back(mesh.vertex(v));
    for (std::size_t e = 0; e < mesh.number_of_edges(); ++e)
      edges.push_back(mesh.edge(e));
    std::vector<Extremal_mesh_cell> cells = mesh.cells();
    spoil(vertices, edges, cells);
    try {
      const Simplification simplification{Extremal_mesh(vertices, edges, cells, mesh.surface())};
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  const std::string said = "the mesh fails the check ";
  EXPECT_TRUE(refusal([](auto&, auto&, auto&) {}).empty());
  EXPECT_TRUE(refusal([](auto& v, auto&, auto&) { v[0].star[0] = v[1].star[0]; }).starts_with(said));
  EXPECT_TRUE(refusal([](auto& v, auto&, auto&) { v[0].star.pop_back(); }).starts_with(said));
  EXPECT_TRUE(refusal([](auto& v, auto&, auto&) { std::swap(v[0].star[0], v[0].star[1]); }).starts_with(said));
  EXPECT_TRUE(refusal([](auto& v, auto&, auto&) { v[0].kind = Vertex_kind::boundary; }).starts_with(said));
  EXPECT_TRUE(refusal([](auto&, auto& e, auto&) { e[0].left_cell = e[0].right_cell; }).starts_with(said));
  EXPECT_TRUE(refusal([](auto&, auto& e, auto&) { e[0].extremality[0] = std::nan(""); }).starts_with(said));
  EXPECT_TRUE(refusal([](auto&, auto&, auto& c) { c[0].boundary.pop_back(); }).starts_with(said));
  // Wrong indices concern one vertex only, which is left alone.
  EXPECT_TRUE(refusal([](auto& v, auto&, auto&) { v[0].field_index = 7; }).empty());
}
