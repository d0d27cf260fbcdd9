// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Extremal_mesh_3/Cell_complex.h>
#include <CGAL/Extremal_mesh_3/errors.h>
#include <CGAL/Extremal_mesh_3/keep_components.h>

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

using namespace CGAL::Extremal_mesh_3;

namespace {

using Polygons = std::vector<std::vector<std::uint32_t>>;

Cell_complex make(std::size_t points, const Polygons& polygons) {
  std::vector<Point> p;
  for (std::size_t i = 0; i < points; ++i)
    p.push_back({double(i), double(i * i), 0});
  std::vector<std::size_t> begin{0};
  std::vector<std::uint32_t> corners;
  for (const auto& polygon : polygons) {
    corners.insert(corners.end(), polygon.begin(), polygon.end());
    begin.push_back(corners.size());
  }
  return make_cell_complex(p, begin, corners);
}

std::string message(std::size_t points, const Polygons& polygons) {
  try {
    make(points, polygons);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

/// what every complex must satisfy, whatever its polygons.
void expect_consistent(const Cell_complex& c, const Polygons& polygons) {
  ASSERT_EQ(c.number_of_cells(), polygons.size());
  ASSERT_EQ(c.edge_cells.size(), c.edges.size());
  std::vector<int> used(2 * c.edges.size(), 0);
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    const std::size_t n = polygons[i].size();
    ASSERT_EQ(c.cell_begin[i + 1] - c.cell_begin[i], n);
    for (std::size_t k = 0; k < n; ++k) {
      const std::uint32_t h = c.half_edges[c.cell_begin[i] + k];
      EXPECT_EQ(c.source(h), polygons[i][k]);
      EXPECT_EQ(c.target(h), polygons[i][(k + 1) % n]);
      EXPECT_EQ(c.edge_cells[h / 2][h % 2], std::int32_t(i));
      ++used[h];
    }
  }
  for (std::uint32_t h = 0; h < used.size(); ++h)
    EXPECT_EQ(used[h], c.edge_cells[h / 2][h % 2] == Cell_complex::no_cell ? 0 : 1);
}

const Polygons cube = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};

} // namespace

TEST(Cell_complex, of_a_cube_is_closed_and_oriented) {
  const Cell_complex c = make(8, cube);
  expect_consistent(c, cube);
  EXPECT_EQ(c.edges.size(), 12U);
  EXPECT_EQ(c.euler_characteristic(), 2);
  for (const auto& cells : c.edge_cells) {
    EXPECT_NE(cells[0], Cell_complex::no_cell);
    EXPECT_NE(cells[1], Cell_complex::no_cell);
  }
}

TEST(Cell_complex, numbers_edges_in_the_order_of_their_first_use) {
  const Cell_complex c = make(4, {{0, 1, 2}, {2, 1, 3}});
  EXPECT_EQ(c.edges, (std::vector<std::array<std::uint32_t, 2>>{{0, 1}, {1, 2}, {2, 0}, {1, 3}, {3, 2}}));
  EXPECT_EQ(c.half_edges, (std::vector<std::uint32_t>{0, 2, 4, 3, 6, 8}));
}

TEST(Cell_complex, may_have_borders) {
  const Polygons fan = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4, 5}};
  const Cell_complex open = make(6, fan);
  expect_consistent(open, fan);
  EXPECT_EQ(open.euler_characteristic(), 1);
  // A band of three quadrilaterals has two borders.
  const Polygons band = {{0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}};
  const Cell_complex ring = make(6, band);
  expect_consistent(ring, band);
  EXPECT_EQ(ring.euler_characteristic(), 0);
  std::size_t border = 0;
  for (const auto& cells : ring.edge_cells)
    border += cells[1] == Cell_complex::no_cell;
  EXPECT_EQ(border, 6U);
}

TEST(Cell_complex, may_have_several_components_and_cells_of_any_size) {
  const Polygons apart = {{0, 1, 2}, {3, 4, 5, 6, 7, 8, 9}};
  expect_consistent(make(10, apart), apart);
  EXPECT_EQ(make(10, apart).euler_characteristic(), 2);
}

TEST(Cell_complex, two_cells_may_share_all_their_sides) {
  const Polygons pillow = {{0, 1, 2}, {2, 1, 0}};
  expect_consistent(make(3, pillow), pillow);
  EXPECT_EQ(make(3, pillow).euler_characteristic(), 2);
}

TEST(Cell_complex, of_nothing_is_empty) {
  const Cell_complex c = make(0, {});
  EXPECT_EQ(c.number_of_cells(), 0U);
  EXPECT_EQ(c.euler_characteristic(), 0);
}

TEST(Cell_complex, names_the_polygon_that_is_none) {
  EXPECT_EQ(message(3, {{0, 1, 2}, {0, 1}}), "polygon 1 has fewer than 3 sides");
  EXPECT_EQ(message(3, {{0, 1, 2}, {}}), "polygon 1 has fewer than 3 sides");
  EXPECT_EQ(message(4, {{0, 1, 2, 1}}), "polygon 0 meets point 1 twice");
  EXPECT_EQ(message(3, {{0, 1, 3}}), "polygon 0 names point 3, but there are 3 points");
}

TEST(Cell_complex, names_the_points_of_a_bad_edge) {
  EXPECT_EQ(message(5, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}),
            "the edge between points 0 and 1 has 3 polygons, more than 2");
  EXPECT_EQ(message(4, {{0, 1, 2}, {0, 1, 3}}),
            "the two polygons at the edge between points 0 and 1 are oriented differently");
}

TEST(Cell_complex, names_the_point_where_two_fans_meet) {
  EXPECT_EQ(message(5, {{0, 1, 2}, {0, 3, 4}}), "the cells around point 0 do not form a single fan");
  // Two closed fans: tetrahedra that share a corner.
  EXPECT_EQ(message(7, {{1, 2, 3}, {0, 2, 1}, {0, 3, 2}, {0, 1, 3}, {4, 5, 6}, {0, 5, 4}, {0, 6, 5}, {0, 4, 6}}),
            "the cells around point 0 do not form a single fan");
  // A closed and an open one.
  EXPECT_EQ(message(6, {{1, 2, 3}, {0, 2, 1}, {0, 3, 2}, {0, 1, 3}, {0, 4, 5}}),
            "the cells around point 0 do not form a single fan");
}

TEST(Cell_complex, names_the_point_of_no_polygon) {
  EXPECT_EQ(message(4, {{0, 1, 2}}), "point 3 belongs to no polygon");
}

TEST(Cell_complex, refuses_lists_that_do_not_fit) {
  const std::vector<Point> points(3);
  EXPECT_THROW(make_cell_complex(points, {0, 2}, {0, 1, 2}), std::invalid_argument);
  EXPECT_THROW(make_cell_complex(points, {1, 3}, {0, 1, 2}), std::invalid_argument);
  EXPECT_THROW(make_cell_complex(points, {}, {}), std::invalid_argument);
  EXPECT_THROW(make_cell_complex(points, {0, 3, 1, 3}, {0, 1, 2}), std::invalid_argument);
}

namespace {

/// A triangle of area ½, one of area 2, and two that share an edge, of area 1 together.
Cell_complex three_components() {
  return make_cell_complex(
      {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 0, 0}, {7, 0, 0}, {5, 2, 0}, {0, 5, 0}, {1, 5, 0}, {1, 6, 0}, {0, 6, 0}},
      {0, 3, 6, 9, 12}, {6, 7, 8, 0, 1, 2, 6, 8, 9, 3, 4, 5});
}

} // namespace

TEST(Keep_components, keeps_the_largest) {
  const Cell_complex c = keep_components(three_components(), {.largest = true});
  EXPECT_EQ(c.points, (std::vector<Point>{{5, 0, 0}, {7, 0, 0}, {5, 2, 0}}));
  EXPECT_EQ(c.number_of_cells(), 1U);
}

TEST(Keep_components, keeps_those_of_an_area) {
  const Cell_complex c = keep_components(three_components(), {.min_area = 0.75});
  EXPECT_EQ(c.number_of_cells(), 3U);
  EXPECT_EQ(c.points.size(), 7U);
  EXPECT_EQ(keep_components(three_components(), {.min_area = 0.25}).number_of_cells(), 4U);
  EXPECT_EQ(keep_components(three_components(), {}).points.size(), 10U);
}

TEST(Keep_components, refuses_to_leave_nothing) {
  EXPECT_THROW(keep_components(three_components(), {.min_area = 3}), Extraction_error);
  EXPECT_THROW(keep_components(three_components(), {.min_area = -1}), std::invalid_argument);
}
