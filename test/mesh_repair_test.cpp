// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is done to meshes that are no oriented manifolds.
#include <CGAL/Extremal_mesh_3/read_mesh.h>

#include "mesh_files.h"
#include "temporary_folder.h"

#include <gtest/gtest.h>

#include <limits>

using namespace CGAL::Extremal_mesh_3;
using meshes::Polygons;

namespace {

struct Topology {
  std::size_t vertices, faces;
  std::int64_t euler_characteristic;
  std::size_t components, border_edges, border_loops;

  bool operator==(const Topology&) const = default;
};

std::ostream& operator<<(std::ostream& out, const Topology& t) {
  return out << "V " << t.vertices << ", F " << t.faces << ", χ " << t.euler_characteristic << ", components "
             << t.components << ", border edges " << t.border_edges << ", loops " << t.border_loops;
}

/// counts the sets in which vertices are joined by some edges.
template <typename Joins> std::size_t number_of_sets(const Cell_complex& c, const Joins& joins) {
  std::vector<std::uint32_t> name(c.points.size());
  std::iota(name.begin(), name.end(), 0U);
  std::vector<bool> counts(c.points.size());
  const auto root = [&](std::uint32_t v) {
    while (name[v] != v)
      v = name[v] = name[name[v]];
    return v;
  };
  for (std::size_t e = 0; e < c.edges.size(); ++e)
    if (joins(e)) {
      name[root(c.edges[e][0])] = root(c.edges[e][1]);
      counts[c.edges[e][0]] = counts[c.edges[e][1]] = true;
    }
  std::size_t sets = 0;
  for (std::uint32_t v = 0; v < name.size(); ++v)
    sets += counts[v] && root(v) == v;
  return sets;
}

Topology topology(const Cell_complex& c) {
  const auto is_border = [&](std::size_t e) { return c.edge_cells[e][1] == Cell_complex::no_cell; };
  std::size_t border_edges = 0;
  for (std::size_t e = 0; e < c.edges.size(); ++e)
    border_edges += is_border(e);
  return {c.points.size(),
          c.number_of_cells(),
          c.euler_characteristic(),
          number_of_sets(c, [](std::size_t) { return true; }),
          border_edges,
          number_of_sets(c, is_border)};
}

class Mesh_repair : public ::testing::Test {
protected:
  Mesh repair(const Polygons& mesh, const Mesh_reading_options& options = {}) const {
    write_text(folder.file("mesh.off"), mesh_files::off(mesh));
    return read_mesh(folder.file("mesh.off"), options);
  }
  Temporary_folder folder;
};

/// a cube [0, s]³ + origin, its normals outwards.
void add_cube(Polygons& mesh, const Point& origin, double s) {
  const auto n = std::uint32_t(mesh.points.size());
  for (int i = 0; i < 8; ++i)
    mesh.points.push_back({origin[0] + s * (i & 1), origin[1] + s * (i >> 1 & 1), origin[2] + s * (i >> 2)});
  const std::vector<std::vector<std::uint32_t>> sides{{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                                      {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (auto side : sides) {
    for (std::uint32_t& corner : side)
      corner += n;
    mesh.polygons.push_back(side);
  }
}

double six_volumes(const Cell_complex& cells) {
  double sum = 0;
  const Polygons mesh = mesh_files::polygons_of(cells);
  for (const auto& p : mesh.polygons)
    for (std::size_t i = 2; i < p.size(); ++i) {
      const Point &a = mesh.points[p[0]], &b = mesh.points[p[i - 1]], &c = mesh.points[p[i]];
      sum +=
          a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
    }
  return sum;
}

} // namespace

TEST_F(Mesh_repair, leaves_a_sound_mesh_as_it_is) {
  Polygons cube;
  add_cube(cube, {0, 0, 0}, 1);
  const Mesh mesh = repair(cube);
  EXPECT_FALSE(mesh.repairs.any());
  EXPECT_EQ(to_string(mesh.repairs), "");
  EXPECT_EQ(mesh_files::polygons_of(mesh.cells).polygons, cube.polygons);
}

TEST_F(Mesh_repair, tells_all_in_one_line) {
  Mesh_repairs r;
  r.isolated_vertices = 3;
  r.welded_vertices = 576;
  r.turned_faces = 1;
  EXPECT_EQ(to_string(r), "repaired: 3 isolated vertices dropped, 576 vertices welded, 1 face turned");
}

TEST_F(Mesh_repair, drops_isolated_vertices) {
  Polygons mesh;
  mesh.points = {{5, 5, 5}, {6, 6, 6}};
  add_cube(mesh, {0, 0, 0}, 1);
  const Mesh result = repair(mesh);
  EXPECT_EQ(result.repairs.isolated_vertices, 2U);
  EXPECT_EQ(topology(result.cells), (Topology{8, 6, 2, 1, 0, 0}));
}

TEST_F(Mesh_repair, welds_vertices_at_the_same_place) {
  Polygons cube, apart; // six squares with vertices of their own
  add_cube(cube, {0, 0, 0}, 1);
  for (const auto& polygon : cube.polygons) {
    apart.polygons.emplace_back();
    for (const std::uint32_t corner : polygon) {
      apart.polygons.back().push_back(std::uint32_t(apart.points.size()));
      apart.points.push_back(cube.points[corner]);
    }
  }
  apart.points[0][0] = -0.0;
  Mesh result = repair(apart);
  EXPECT_EQ(result.repairs.welded_vertices, 16U);
  EXPECT_EQ(topology(result.cells), (Topology{8, 6, 2, 1, 0, 0}));

  std::map<Point, int> met;
  for (Point& p : apart.points)
    p[1] += 1e-6 * met[p]++; // 0, 1 or 2 times
  EXPECT_EQ(topology(repair(apart).cells).components, 6U);
  const Mesh_reading_options by_way_of_others{.weld_tolerance = 1.5e-6}, large{.weld_tolerance = 1e-2};
  EXPECT_EQ(topology(repair(apart, by_way_of_others).cells), (Topology{8, 6, 2, 1, 0, 0}));
  EXPECT_EQ(topology(repair(apart, large).cells), (Topology{8, 6, 2, 1, 0, 0}));
}

TEST_F(Mesh_repair, tolerances_that_would_collapse_the_mesh_are_refused) {
  Polygons cube; // of diagonal √3
  add_cube(cube, {0, 0, 0}, 1);
  for (const double tolerance : {-1e-9, 0.018, 1.0, std::nan(""), std::numeric_limits<double>::infinity()})
    EXPECT_THROW(repair(cube, {.weld_tolerance = tolerance}), std::invalid_argument) << tolerance;
  EXPECT_FALSE(repair(cube, {.weld_tolerance = 0.017}).repairs.any());
  EXPECT_FALSE(repair(cube, {.weld_tolerance = 1e-300}).repairs.any());
}

TEST_F(Mesh_repair, drops_faces_with_fewer_than_three_different_vertices) {
  Polygons mesh;
  add_cube(mesh, {0, 0, 0}, 1);
  mesh.polygons.insert(mesh.polygons.begin(), {{}, {3}, {0, 1}, {4, 4, 5}, {1, 2, 1, 2}, {1, 3, 7, 3}});
  const Mesh result = repair(mesh);
  EXPECT_EQ(result.repairs.degenerate_faces, 6U);
  EXPECT_EQ(topology(result.cells), (Topology{8, 6, 2, 1, 0, 0}));
  EXPECT_THROW(repair({mesh.points, {{0, 1}, {2, 2, 2}}}), Io_error);
}

TEST_F(Mesh_repair, divides_faces_that_touch_themselves) {
  // A repeated corner, a spike, and a figure of eight whose loops are 0 1 3 and 0 5 4.
  const Polygons cube = [] {
    Polygons m;
    add_cube(m, {0, 0, 0}, 1);
    return m;
  }();
  EXPECT_EQ(mesh_files::polygons_of(repair({cube.points, {{0, 0, 1, 3, 3, 2}}}).cells).polygons[0].size(), 4U);
  EXPECT_EQ(mesh_files::polygons_of(repair({cube.points, {{0, 1, 5, 1, 3, 2}}}).cells).polygons[0].size(), 4U);
  const Mesh eight = repair({cube.points, {{0, 1, 3, 0, 5, 4}}});
  EXPECT_EQ(topology(eight.cells), (Topology{6, 2, 2, 2, 6, 2})); // vertex 0 is split
  EXPECT_EQ(eight.repairs.degenerate_faces, 1U);
  EXPECT_EQ(eight.repairs.non_manifold_vertices, 1U);
}

TEST_F(Mesh_repair, drops_duplicate_faces) {
  Polygons mesh;
  add_cube(mesh, {0, 0, 0}, 1);
  mesh.polygons.push_back({3, 1, 0, 2});
  mesh.polygons.push_back({4, 6, 7, 5});
  const Mesh result = repair(mesh);
  EXPECT_EQ(result.repairs.duplicate_faces, 2U);
  EXPECT_EQ(topology(result.cells), (Topology{8, 6, 2, 1, 0, 0}));
}

TEST_F(Mesh_repair, separates_what_touches_at_an_edge_or_a_vertex) {
  Polygons at_edge, at_vertex;
  add_cube(at_edge, {0, 0, 0}, 1);
  at_vertex = at_edge;
  add_cube(at_edge, {1, 1, 0}, 1);
  add_cube(at_vertex, {1, 1, 1}, 1);
  const Mesh edge = repair(at_edge), vertex = repair(at_vertex);
  EXPECT_EQ(topology(edge.cells), (Topology{16, 12, 4, 2, 0, 0}));
  EXPECT_EQ(edge.repairs.non_manifold_edges, 1U);
  EXPECT_EQ(edge.repairs.non_manifold_vertices, 2U);
  EXPECT_EQ(topology(vertex.cells), (Topology{16, 12, 4, 2, 0, 0}));
  EXPECT_EQ(vertex.repairs.non_manifold_edges, 0U);
  EXPECT_EQ(vertex.repairs.non_manifold_vertices, 1U);
}

TEST_F(Mesh_repair, cuts_three_sheets_that_meet_at_an_edge) {
  const Polygons book{{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {-1, 1, 0}, {-1, -1, 0}}, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}};
  EXPECT_EQ(topology(repair(book).cells), (Topology{9, 3, 3, 3, 9, 3}));
}

TEST_F(Mesh_repair, cuts_a_one_sided_surface_open) {
  Polygons band; // of seven quadrilaterals, with half a turn
  constexpr std::uint32_t n = 7;
  for (std::uint32_t i = 0; i < n; ++i) {
    const double a = 6.283185307179586 * i / n;
    for (const double s : {-0.3, 0.3})
      band.points.push_back(
          {(2 + s * std::cos(a / 2)) * std::cos(a), (2 + s * std::cos(a / 2)) * std::sin(a), s * std::sin(a / 2)});
    const std::uint32_t k = 2 * i;
    if (i + 1 < n)
      band.polygons.push_back({k, k + 2, k + 3, k + 1});
    else
      band.polygons.push_back({k, 1, 0, k + 1});
  }
  EXPECT_EQ(topology(repair(band).cells), (Topology{16, 7, 1, 1, 16, 1})); // χ 0 → 1
}

TEST_F(Mesh_repair, turns_faces_like_their_neighbours_and_closed_surfaces_outwards) {
  Polygons mesh;
  add_cube(mesh, {0, 0, 0}, 1);
  std::reverse(mesh.polygons[0].begin(), mesh.polygons[0].end());
  Mesh result = repair(mesh);
  EXPECT_EQ(result.repairs.turned_faces, 1U);
  EXPECT_EQ(six_volumes(result.cells), 6);

  for (auto& polygon : mesh.polygons)
    std::reverse(polygon.begin(), polygon.end());
  add_cube(mesh, {5, 5, 5}, 2);
  result = repair(mesh);
  EXPECT_EQ(result.repairs.turned_faces, 5U);
  EXPECT_EQ(six_volumes(result.cells), 6 * (1 + 8));
}

TEST_F(Mesh_repair, turns_few_faces_of_a_surface_with_border) {
  Polygons mesh;
  add_cube(mesh, {0, 0, 0}, 1);
  mesh.polygons.pop_back();
  std::reverse(mesh.polygons[0].begin(), mesh.polygons[0].end()); // the others are turned to it, and back
  EXPECT_EQ(repair(mesh).repairs.turned_faces, 1U);
}

TEST_F(Mesh_repair, takes_faces_without_area_into_their_neighbours) {
  // A square of four triangles around its middle; beside one of them a triangle without area fills the gap to a
  // neighbour with one vertex more.
  const Polygons mesh{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 0}, {0.5, -1, 0}, {0.3, 0, 0}},
                      {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {1, 0, 6}, {6, 0, 5}, {1, 6, 5}}};
  const Mesh result = repair(mesh);
  EXPECT_EQ(result.repairs.flat_faces, 1U);
  EXPECT_EQ(topology(result.cells), (Topology{7, 6, 1, 1, 5, 1}));
  EXPECT_EQ(mesh_files::polygons_of(result.cells).polygons[0], (std::vector<std::uint32_t>{0, 6, 1, 4}));
}

TEST_F(Mesh_repair, leaves_a_face_without_area_where_it_cannot_be_taken_out) {
  const Polygons at_border{{{0, 0, 0}, {2, 0, 0}, {1, 0, 0}, {1, 1, 0}}, {{1, 0, 2}, {2, 0, 3}, {1, 2, 3}}};
  const Mesh result = repair(at_border);
  EXPECT_EQ(result.repairs.flat_faces, 0U);
  EXPECT_EQ(topology(result.cells), (Topology{4, 3, 1, 1, 3, 1}));
}

TEST_F(Mesh_repair, makes_a_manifold_of_anything) {
  std::mt19937 random(11);
  std::size_t read = 0;
  for (int trial = 0; trial < 400; ++trial) {
    Polygons mesh;
    for (int i = 0; i < 9; ++i) // with points at the same place and faces without area
      mesh.points.push_back({double(random() % 3), double(random() % 3), double(random() % 3)});
    for (unsigned f = 0, n = 1 + unsigned(random() % 25); f < n; ++f) {
      mesh.polygons.emplace_back(2 + random() % 5);
      for (std::uint32_t& corner : mesh.polygons.back())
        corner = std::uint32_t(random() % 9);
    }
    try {
      const Mesh result = repair(mesh); // make_cell_complex() has checked it
      EXPECT_GE(result.cells.number_of_cells(), 1U);
      ++read;
    } catch (const Io_error& error) {
      EXPECT_NE(std::string(error.what()).find("three different vertices"), std::string::npos) << error.what();
    }
  }
  EXPECT_GT(read, 300U);
}

TEST_F(Mesh_repair, is_the_same_every_time) {
  Polygons mesh = meshes::with_radial_noise(meshes::icosphere(3), 0.2, 5);
  for (std::size_t i = 0; i < mesh.polygons.size(); i += 3)
    std::reverse(mesh.polygons[i].begin(), mesh.polygons[i].end());
  const Mesh a = repair(mesh, {.weld_tolerance = 0.01}), b = repair(mesh, {.weld_tolerance = 0.01});
  EXPECT_EQ(a.cells.points, b.cells.points);
  EXPECT_EQ(a.cells.half_edges, b.cells.half_edges);
}

#ifdef EXTREMAL_MESH_3_SHARED_DATA_DIR
namespace {

struct Shared_mesh {
  const char* file;
  Topology topology;
  const char* repairs;
};

} // namespace

class Repair_of_shared_mesh : public ::testing::TestWithParam<Shared_mesh> {};

TEST_P(Repair_of_shared_mesh, has_the_right_topology) {
  const Mesh mesh = read_mesh(std::string(EXTREMAL_MESH_3_SHARED_DATA_DIR "/meshes/") + GetParam().file);
  EXPECT_EQ(topology(mesh.cells), GetParam().topology);
  EXPECT_EQ(to_string(mesh.repairs), GetParam().repairs);
}

// SCP1, suzanne and bone: counted by a program of its own that joins the corners of faces along edges with two faces.
INSTANTIATE_TEST_SUITE_P(
    All, Repair_of_shared_mesh,
    ::testing::Values(Shared_mesh{"featuretype.STL", {1722, 3476, -16, 1, 0, 0}, "repaired: 288 vertices welded"},
                      Shared_mesh{"torus.STL", {4350, 8700, 0, 1, 0, 0}, ""},
                      Shared_mesh{
                          "suzanne.obj", {507, 500, 2, 3, 42, 4}, "repaired: 2 vertices welded, 2 vertices split"},
                      Shared_mesh{"horse_quad.obj", {2400, 2398, 2, 1, 0, 0}, ""},
                      Shared_mesh{"cylinder.obj", {220, 202, 2, 1, 0, 0}, ""},
                      Shared_mesh{"SCP1.ply",
                                  {15599, 31084, -32, 51, 178, 50},
                                  "repaired: 75 non-manifold edges cut, 152 vertices split, 87 faces turned"},
                      Shared_mesh{"bone.ply", {1513, 3022, 2, 1, 0, 0}, "repaired: 359 isolated vertices dropped"},
                      Shared_mesh{"shark.ply", {2560, 2562, 2, 1, 0, 0}, "repaired: 2562 faces turned"},
                      Shared_mesh{"femur_dual_poly.off", {7798, 3897, -2, 1, 0, 0}, ""},
                      Shared_mesh{"ellipe0.003.off", {1556, 3108, 2, 1, 0, 0}, "repaired: 3108 faces turned"},
                      Shared_mesh{"hemisphere.off", {1861, 3600, 1, 1, 120, 1}, ""},
                      Shared_mesh{"mannequin-devil.off", {12977, 25888, 1, 1, 64, 1}, ""},
                      Shared_mesh{"joint.off", {221, 446, -2, 1, 0, 0}, ""}),
    [](const auto& test) {
      std::string name = test.param.file;
      std::replace_if(
          name.begin(), name.end(), [](char c) { return c == '.' || c == '-'; }, '_');
      return name;
    });
#endif
