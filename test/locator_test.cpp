// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The cell that holds a point, told by the lines alone and by the surface that was cut along them.
#include "../src/cells/polygon_triangles.h"

#include <CGAL/Extremal_mesh_3/Formula.h>
#include <CGAL/Extremal_mesh_3/Line_locator.h>
#include <CGAL/Extremal_mesh_3/Patch_locator.h>
#include <CGAL/Extremal_mesh_3/simplify.h>

#include "changed_mesh.h"
#include "hand_made.h"
#include "random_surfaces.h"

#include <limits>

using namespace CGAL::Extremal_mesh_3;

namespace {

/// A point of a polygon: of one of the triangles that cover it.
struct Sample_point {
  Point point;
  Vector normal;
  std::uint32_t cell;
};

std::vector<Sample_point> samples_of(const Cell_patches& patches, unsigned seed) {
  random_surfaces::Random random(seed);
  std::vector<Sample_point> samples;
  for (std::size_t i = 0; i < patches.cell.size(); ++i) {
    std::vector<const Point*> corners;
    Vector normal{};
    for (std::size_t k = patches.begin[i]; k < patches.begin[i + 1]; ++k) {
      corners.push_back(&patches.points[patches.corners[k]]);
      normal = surfaces::along(normal, 1, patches.normals[patches.corners[k]]);
    }
    const Polygon_triangles cover = triangles_of_polygon(corners);
    std::array<Point, 3> triangle;
    const std::size_t n = cover.ears.empty() ? corners.size() : cover.ears.size();
    const auto which = std::min(n - 1, std::size_t(random.uniform(0, double(n))));
    if (cover.ears.empty())
      triangle = {cover.middle, *corners[which], *corners[(which + 1) % n]};
    else
      for (std::size_t k = 0; k < 3; ++k)
        triangle[k] = *corners[cover.ears[which][k]];
    Sample_point sample{{}, normal, patches.cell[i]};
    const double a = random.uniform(0.2, 1), b = random.uniform(0.2, 1), c = random.uniform(0.2, 1), sum = a + b + c;
    for (const auto& [w, corner] : {std::pair{a, 0}, std::pair{b, 1}, std::pair{c, 2}})
      sample.point = surfaces::along(sample.point, w / sum, triangle[std::size_t(corner)]);
    samples.push_back(sample);
  }
  return samples;
}

/// what becomes of the samples when their cells are looked for.
struct Found {
  std::size_t samples = 0, right = 0, wrong = 0;
};

Found find_by_lines(const Extremal_mesh& mesh, const std::vector<Sample_point>& samples) {
  const Line_locator locator(mesh);
  Found found;
  for (const Sample_point& sample : samples) {
    const auto cell = locator.cell_at(sample.point), with_normal = locator.cell_at(sample.point, sample.normal);
    EXPECT_EQ(cell, with_normal);
    ++found.samples;
    found.right += cell == sample.cell;
    found.wrong += cell && cell != sample.cell;
  }
  return found;
}

Found find_by_patches(const Cell_patches& patches) {
  const Patch_locator locator(patches);
  Found found;
  for (const Sample_point& sample : samples_of(patches, 2)) {
    const auto place = locator.nearest(sample.point);
    ++found.samples;
    (place && place->cell == sample.cell ? found.right : found.wrong) += 1;
  }
  return found;
}

Extraction with_patches(const Function_3& f, const Lattice& lattice) {
  Extraction_options options;
  options.patches = true;
  return extract_extremal_mesh(f, lattice, options);
}

} // namespace

TEST(Line_locator, finds_the_cells_of_points_on_surfaces) {
  std::vector<std::pair<Extremal_mesh, Cell_patches>> surfaces_with_patches = {
      {hand_made::ellipsoid(), hand_made::octants()}};
  const auto add = [&](const Function_3& f, const Lattice& lattice) {
    Extraction extraction = with_patches(f, lattice);
    surfaces_with_patches.emplace_back(extraction.mesh, std::move(extraction.patches));
  };
  add(Formula("x^2/9+y^2/4+z^2=1"), make_lattice({-4, -3, -2}, {4, 3, 2}, 48));
  for (const unsigned seed : {1U, 2U, 4U, 5U, 8U}) {
    const auto f = random_surfaces::ellipsoid(seed);
    const surfaces::Box box = random_surfaces::box_of(f);
    add(f, make_lattice(box.low, box.high, 24));
  }
  add(random_surfaces::torus(2), make_lattice({-1.7, -1.7, -0.7}, {1.7, 1.7, 0.7}, 40));
  add(random_surfaces::torus(2), make_lattice({-1.7, -1.7, -0.7}, {0.3, 1.7, 0.7}, 40)); // with a border
  for (const auto& [mesh, patches] : surfaces_with_patches) {
    const Found by_lines = find_by_lines(mesh, samples_of(patches, 1)), by_patches = find_by_patches(patches);
    EXPECT_GT(by_lines.samples, 1000U);
    EXPECT_EQ(by_lines.right, by_lines.samples);
    EXPECT_EQ(by_patches.right, by_patches.samples);
  }
}

// Where cells are narrower than the polygons' distance from the surface, points of these can lie beyond the next line: so it is
// points of the surface that are looked for. Two lines that run beside each other may pass through one polygon.
TEST(Line_locator, is_hardly_ever_wrong_where_cells_are_narrow) {
  const auto f = random_surfaces::double_torus(1);
  const Extraction extraction = with_patches(f, make_lattice({-1.3, -0.9, -0.6}, {1.3, 0.9, 0.6}, 128));
  std::vector<Sample_point> samples = samples_of(extraction.patches, 1);
  for (Sample_point& sample : samples)
    for (int i = 0; i < 5; ++i) {
      Derivatives d;
      f.derivatives(sample.point, 1, d);
      const double slope = surfaces::dot(d.gradient, d.gradient);
      sample.point = surfaces::along(sample.point, -d.value / slope, d.gradient);
    }
  const Found found = find_by_lines(extraction.mesh, samples);
  EXPECT_GT(found.samples, 30000U);
  EXPECT_LE(found.wrong, found.samples / 5000);
  EXPECT_EQ(found.right + found.wrong, found.samples);
}

// There lines run along the same points, beside each other. Where these do not tell, nothing is told.
TEST(Line_locator, tells_nothing_wrong_after_simplification) {
  for (const unsigned seed : {1U, 5U, 7U}) {
    const auto f = random_surfaces::ellipsoid(seed);
    const surfaces::Box box = random_surfaces::box_of(f);
    const Extraction extraction = with_patches(f, make_lattice(box.low, box.high, 24));
    const Simplification simplification(extraction.mesh);
    for (std::size_t level = 1; level < simplification.number_of_levels(); ++level) {
      const Found found = find_by_lines(simplification.mesh_at(level),
                                        samples_of(simplification.patches_at(level, extraction.patches), 1));
      EXPECT_EQ(found.wrong, 0U) << "seed " << seed << ", level " << level;
      EXPECT_GE(found.right, found.samples * 9 / 10) << "seed " << seed << ", level " << level;
    }
  }
}

TEST(Line_locator, finds_what_a_search_over_all_lines_finds) {
  const Extremal_mesh mesh = hand_made::ellipsoid();
  const Line_locator locator(mesh);
  random_surfaces::Random random(3);
  for (int i = 0; i < 200; ++i) {
    const Point p = {random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(-2, 2)};
    double to_vertex = std::numeric_limits<double>::infinity(), to_line = to_vertex;
    for (std::size_t v = 0; v < mesh.number_of_vertices(); ++v)
      to_vertex = std::min(to_vertex, surfaces::distance(p, mesh.vertex(v).point));
    for (std::size_t e = 0; e < mesh.number_of_edges(); ++e) {
      const auto& line = mesh.edge(e).polyline;
      for (std::size_t s = 0; s + 1 < line.size(); ++s)
        for (int k = 0; k <= 100; ++k)
          to_line = std::min(
              to_line,
              surfaces::distance(p, surfaces::along(line[s], k / 100.0, surfaces::along(line[s + 1], -1, line[s]))));
    }
    const auto vertex = locator.nearest_vertex(p);
    ASSERT_TRUE(vertex);
    EXPECT_EQ(vertex->distance, to_vertex);
    EXPECT_EQ(surfaces::distance(p, mesh.vertex(vertex->vertex).point), to_vertex);
    const auto q = locator.nearest_line(p);
    ASSERT_TRUE(q);
    EXPECT_LE(q->distance, to_line);
    EXPECT_NEAR(q->distance, to_line, 1e-3); // segments have a length of 0.13, samples on them 1 % of that
    EXPECT_EQ(q->distance, surfaces::distance(p, q->point));
    const auto& line = mesh.edge(q->edge).polyline;
    const Point on_line =
        surfaces::along(line[q->segment], q->t, surfaces::along(line[q->segment + 1], -1, line[q->segment]));
    EXPECT_LT(surfaces::distance(on_line, q->point), 1e-15);
  }
}

TEST(Line_locator, gives_a_cell_beside_for_points_on_lines_and_vertices) {
  const Extremal_mesh mesh = hand_made::ellipsoid();
  const Line_locator locator(mesh);
  for (std::uint32_t v = 0; v < mesh.number_of_vertices(); ++v) {
    EXPECT_EQ(locator.nearest_vertex(mesh.vertex(v).point)->vertex, v);
    EXPECT_TRUE(locator.cell_at(mesh.vertex(v).point));
  }
  for (std::size_t e = 0; e < mesh.number_of_edges(); ++e) {
    const Extremal_mesh_edge& edge = mesh.edge(e);
    const auto cell = locator.cell_at(edge.polyline[5]);
    EXPECT_TRUE(cell == edge.left_cell || cell == edge.right_cell);
  }
}

// Two spheres of radius 1 that nearly touch: the lines of the other one are nearer than its own.
TEST(Line_locator, passes_over_other_sheets_if_the_normal_is_known) {
  const Extremal_mesh one = hand_made::ellipsoid();
  const Extremal_mesh two = changed(hand_made::meridians(), [&](Mesh_parts& p) {
    // The octants of one sphere, and beside it at x = 2.001 the other, with its lines around x = 1.
    const auto cells = std::uint32_t(p.cells.size());
    for (Extremal_mesh_edge& e : p.edges)
      for (Point& q : e.polyline)
        q = {2.001 - q[2], q[1], q[0]}; // the north pole beside the first sphere, turned so as to keep the orientation
    for (Extremal_mesh_edge& e : p.edges)
      for (Vector& n : e.normals)
        n = {-n[2], n[1], n[0]};
    for (Extremal_mesh_vertex& v : p.vertices) {
      v.point = {2.001 - v.point[2], v.point[1], v.point[0]};
      v.normal = {-v.normal[2], v.normal[1], v.normal[0]};
    }
    const auto n_vertices = std::uint32_t(p.vertices.size()), n_edges = std::uint32_t(p.edges.size());
    for (std::size_t v = 0; v < one.number_of_vertices(); ++v) {
      p.vertices.push_back(one.vertex(v));
      for (Half_edge& h : p.vertices.back().star)
        h += 2 * n_edges;
    }
    for (std::size_t e = 0; e < one.number_of_edges(); ++e) {
      p.edges.push_back(one.edge(e));
      p.edges.back().id += n_edges;
      p.edges.back().source += n_vertices;
      p.edges.back().target += n_vertices;
      p.edges.back().left_cell += cells;
      p.edges.back().right_cell += cells;
    }
    p.cells.insert(p.cells.end(), one.cells().begin(), one.cells().end());
    for (std::size_t c = cells; c < p.cells.size(); ++c)
      for (auto& walk : p.cells[c].boundary)
        for (Half_edge& h : walk)
          h += 2 * n_edges;
  });
  const Line_locator locator(two);
  // On the second sphere, in the middle between two of its meridians but near to the first one's extremal point at x = 1.
  const Vector direction = surfaces::unit({-1, 0.02, 0.02});
  const Point p = surfaces::along({2.001, 0, 0}, 1, direction);
  const auto without = locator.cell_at(p), with = locator.cell_at(p, direction);
  ASSERT_TRUE(without && with);
  EXPECT_LT(*with, 4U);    // a cell of the second sphere
  EXPECT_GE(*without, 4U); // what the nearest line says
}

TEST(Line_locator, copes_with_meshes_that_have_no_line) {
  const std::vector<Extremal_mesh_cell> one(1), two(2);
  EXPECT_EQ(Line_locator(Extremal_mesh({}, {}, one, {})).cell_at({1, 2, 3}), std::optional<std::uint32_t>(0));
  const Line_locator locator(Extremal_mesh({}, {}, two, {}));
  EXPECT_FALSE(locator.cell_at({1, 2, 3}));
  EXPECT_FALSE(locator.nearest_line({1, 2, 3}));
  EXPECT_FALSE(locator.nearest_vertex({1, 2, 3}));
  EXPECT_FALSE(Line_locator(Extremal_mesh()).cell_at({1, 2, 3}));
  EXPECT_FALSE(Patch_locator(Cell_patches()).nearest({1, 2, 3}));
}

TEST(Locators, refuse_numbers_that_are_not_finite) {
  const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
  const Line_locator lines(hand_made::ellipsoid());
  const Patch_locator patches(hand_made::octants(4));
  for (const Point& p : {Point{nan, 0, 0}, Point{0, infinity, 0}, Point{0, 0, -infinity}}) {
    EXPECT_THROW(lines.cell_at(p), std::invalid_argument);
    EXPECT_THROW(lines.cell_at({1, 0, 0}, p), std::invalid_argument);
    EXPECT_THROW(lines.nearest_line(p), std::invalid_argument);
    EXPECT_THROW(lines.nearest_vertex(p), std::invalid_argument);
    EXPECT_THROW(patches.nearest(p), std::invalid_argument);
  }
  EXPECT_NO_THROW(lines.cell_at({1e300, -1e300, 1e300})); // whose distance is not finite
  EXPECT_THROW(Line_locator(changed(hand_made::ellipsoid(), [&](Mesh_parts& p) { p.edges[3].polyline[2][1] = nan; })),
               std::invalid_argument);
  EXPECT_THROW(Line_locator(changed(hand_made::ellipsoid(), [&](Mesh_parts& p) { p.vertices[3].point[2] = nan; })),
               std::invalid_argument);
}

TEST(Patch_locator, refuses_arrays_that_do_not_fit_together) {
  const auto refuses = [](const std::function<void(Cell_patches&)>& spoil) {
    Cell_patches patches = hand_made::octants(4);
    spoil(patches);
    EXPECT_THROW(Patch_locator{patches}, std::invalid_argument);
  };
  refuses([](Cell_patches& p) { p.cell.pop_back(); });
  refuses([](Cell_patches& p) { p.begin.clear(); });
  refuses([](Cell_patches& p) { p.begin[0] = 1; });
  refuses([](Cell_patches& p) { p.begin[3] = p.begin[4]; });
  refuses([](Cell_patches& p) { p.begin[3] = 1000000; });
  refuses([](Cell_patches& p) { p.corners[7] = std::uint32_t(p.points.size()); });
  refuses([](Cell_patches& p) { p.points[7][2] = std::nan(""); });
}

TEST(Patch_locator, finds_the_nearest_point_of_triangles) {
  Cell_patches patches; // one triangle
  patches.points = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}};
  patches.corners = {0, 1, 2};
  patches.begin = {0, 3};
  patches.cell = {5};
  const Patch_locator locator(patches);
  const auto expect_nearest = [&](const Point& p, const Point& q) {
    const auto found = locator.nearest(p);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->cell, 5U);
    EXPECT_LT(surfaces::distance(found->point, q), 1e-15);
    EXPECT_NEAR(found->distance, surfaces::distance(p, q), 1e-15);
  };
  expect_nearest({0.5, 0.5, 3}, {0.5, 0.5, 0});
  expect_nearest({-1, -1, 1}, {0, 0, 0});
  expect_nearest({3, -1, 1}, {2, 0, 0});
  expect_nearest({-1, 3, 1}, {0, 2, 0});
  expect_nearest({1, -1, 0}, {1, 0, 0});
  expect_nearest({-1, 1, 0}, {0, 1, 0});
  expect_nearest({2, 2, 0}, {1, 1, 0});
}
