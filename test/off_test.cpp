// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Extremal_mesh_3/io.h>

#include "hand_made.h"
#include "temporary_folder.h"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <sstream>

using namespace CGAL::Extremal_mesh_3;

namespace {

/// A strict reader: exactly the announced numbers of lines, nothing else.
struct Off {
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> polygons;
  std::vector<std::vector<int>> colours;

  explicit Off(const std::string& file) {
    std::istringstream stream(read_text(file));
    std::string line;
    std::getline(stream, line);
    EXPECT_EQ(line, "OFF");
    std::size_t number_of_points = 0, number_of_polygons = 0, zero = 1;
    stream >> number_of_points >> number_of_polygons >> zero;
    std::getline(stream, line);
    EXPECT_EQ(zero, 0U);
    for (std::size_t i = 0; i < number_of_points && std::getline(stream, line); ++i) {
      std::istringstream words(line);
      Point& p = points.emplace_back();
      EXPECT_TRUE(words >> p[0] >> p[1] >> p[2]) << line;
    }
    while (std::getline(stream, line)) {
      std::istringstream words(line);
      std::size_t n = 0;
      words >> n;
      EXPECT_GE(n, 3U);
      polygons.emplace_back(n);
      for (std::size_t& corner : polygons.back()) {
        EXPECT_TRUE(words >> corner) << line;
        EXPECT_LT(corner, number_of_points);
      }
      colours.emplace_back();
      for (int c = 0; words >> c;)
        colours.back().push_back(c);
    }
    EXPECT_EQ(points.size(), number_of_points);
    EXPECT_EQ(polygons.size(), number_of_polygons);
  }

  std::set<std::vector<int>> set_of_colours() const { return {colours.begin(), colours.end()}; }

  /// V − E + F of the used points; every edge must be used once in each direction.
  long euler_characteristic_of_closed_surface() const {
    std::map<std::pair<std::size_t, std::size_t>, int> edges;
    std::set<std::size_t> used;
    for (const auto& polygon : polygons)
      for (std::size_t i = 0; i < polygon.size(); ++i) {
        ++edges[{polygon[i], polygon[(i + 1) % polygon.size()]}];
        used.insert(polygon[i]);
      }
    for (const auto& [edge, count] : edges) {
      EXPECT_EQ(count, 1);
      EXPECT_TRUE(edges.contains({edge.second, edge.first}));
    }
    return long(used.size()) - long(edges.size() / 2) + long(polygons.size());
  }

  /// positive if the polygons look outwards.
  double volume() const {
    double sum = 0;
    for (const auto& polygon : polygons)
      for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
        sum += hand_made::dot(points[polygon[0]], hand_made::cross(points[polygon[i]], points[polygon[i + 1]])) / 6;
    return sum;
  }
};

template <typename Write> Off written(const Write& write) {
  const Temporary_folder folder;
  write(folder.file("out.off"));
  return Off(folder.file("out.off"));
}

} // namespace

TEST(Off, cells_of_an_ellipsoid_are_a_closed_surface_in_two_tints) {
  const Off off = written([](const std::string& file) { write_off(file, hand_made::ellipsoid()); });
  EXPECT_EQ(off.polygons.size(), 8U);
  EXPECT_EQ(off.points.size(), 10U + 16 * 11);
  EXPECT_EQ(off.euler_characteristic_of_closed_surface(), 2);
  EXPECT_GT(off.volume(), 0);
  EXPECT_EQ(off.set_of_colours().size(), 2U);
  for (const auto& colour : off.colours)
    EXPECT_EQ(colour.size(), 3U);
}

TEST(Off, cells_with_multiple_edges_are_told_apart) {
  const Off off = written([](const std::string& file) { write_off(file, hand_made::meridians()); });
  EXPECT_EQ(off.polygons.size(), 4U);
  EXPECT_EQ(off.euler_characteristic_of_closed_surface(), 2);
}

TEST(Off, an_annulus_is_left_out) {
  const Off off = written([](const std::string& file) { write_off(file, hand_made::two_loops()); });
  EXPECT_EQ(off.polygons.size(), 2U);
  EXPECT_EQ(off.polygons[0].size(), 24U);
}

TEST(Off, cells_at_the_border_keep_both_ends_of_their_lines) {
  const Off off = written([](const std::string& file) { write_off(file, hand_made::hemisphere()); });
  EXPECT_EQ(off.polygons.size(), 2U);
  EXPECT_EQ(off.polygons[0].size(), 13U);
}

TEST(Off, tubes_are_closed_and_look_outwards) {
  const Extremal_mesh mesh = hand_made::ellipsoid();
  const Off off = written([&](const std::string& file) { write_lines_off(file, mesh); });
  EXPECT_EQ(off.euler_characteristic_of_closed_surface(), 2 * 16);
  EXPECT_GT(off.volume(), 0);
  EXPECT_EQ(off.set_of_colours().size(), 4U);
}

TEST(Off, tubes_have_the_radius_asked_for) {
  const double radius = 0.01;
  const Off off = written([&](const std::string& file) { write_lines_off(file, hand_made::two_loops(), radius); });
  EXPECT_EQ(off.euler_characteristic_of_closed_surface(), 2 * 2);
  EXPECT_EQ(off.set_of_colours().size(), 2U); // one segment is of another type
  double length = 0;
  for (const std::uint32_t e : {0U, 1U})
    length += hand_made::two_loops().edge(e).length;
  // a regular hexagon has the area 3√3/2 r²; that rings lie on bisecting planes makes the tubes at most a little
  // thinner
  EXPECT_NEAR(off.volume(), length * radius * radius * 1.5 * std::sqrt(3), 0.02 * off.volume());
}

TEST(Off, tubes_survive_repeated_points_and_sharp_turns) {
  std::vector<Extremal_mesh_vertex> vertices(2);
  std::vector<Extremal_mesh_edge> edges(2);
  edges[0].polyline = {{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0, 0, 0}, {0, 0, 1}, {0, 0, 1}};
  edges[1].polyline = {{1, 1, 1}, {1, 1, 1}}; // nothing to show
  for (std::uint32_t e = 0; e < 2; ++e) {
    edges[e].id = e;
    edges[e].target = 1;
    edges[e].normals.resize(edges[e].polyline.size());
    edges[e].extremality.resize(edges[e].polyline.size());
    edges[e].k1.resize(edges[e].polyline.size());
    edges[e].k2.resize(edges[e].polyline.size());
    edges[e].segment_types.resize(edges[e].polyline.size() - 1);
  }
  const Extremal_mesh mesh(vertices, edges, std::vector<Extremal_mesh_cell>(1), {});
  const Off off = written([&](const std::string& file) { write_lines_off(file, mesh); });
  EXPECT_EQ(off.polygons.size(), 3U * 6 + 2);
  for (const Point& p : off.points)
    for (const double x : p)
      EXPECT_TRUE(std::isfinite(x));
}

TEST(Off, patches_are_coloured_by_the_sign_of_their_cells) {
  const Extremal_mesh mesh = hand_made::ellipsoid();
  const Cell_patches patches = hand_made::octants(4);
  const Off off = written([&](const std::string& file) { write_off(file, patches, mesh); });
  ASSERT_EQ(off.polygons.size(), patches.cell.size());
  EXPECT_GT(off.volume(), 0);
  for (std::size_t i = 0; i < off.polygons.size(); ++i)
    EXPECT_EQ(off.colours[i] == off.colours[0], mesh.cell(patches.cell[i]).sign == mesh.cell(0).sign);
}

TEST(Off, cell_complexes_have_no_colours) {
  Cell_complex square;
  square.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0.125}};
  square.edges = {{0, 1}, {1, 2}, {3, 2}, {3, 0}};
  square.half_edges = {0, 2, 5, 6};
  square.cell_begin = {0, 4};
  const Temporary_folder folder;
  write_off(folder.file("out.off"), square);
  EXPECT_EQ(read_text(folder.file("out.off")), "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0.125\n4 0 1 2 3\n");
}

TEST(Off, nothing_is_left_where_nothing_can_be_written) {
  const Temporary_folder folder;
  EXPECT_THROW(write_off(folder.file("none/out.off"), hand_made::ellipsoid()), Io_error);
  EXPECT_THROW(write_lines_off(folder.file("none/out.off"), hand_made::ellipsoid()), Io_error);
  EXPECT_THROW(write_lines_off(folder.file("out.off"), hand_made::ellipsoid(), -1), std::invalid_argument);
  EXPECT_EQ(folder.number_of_files(), 0U);
}
