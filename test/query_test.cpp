// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Questions about extremal meshes drawn by hand, of which the answers are seen, and about extracted ones, of which they are
// compared with a search over all there is.
#include <CGAL/Extremal_mesh_3/Formula.h>
#include <CGAL/Extremal_mesh_3/cell_queries.h>
#include <CGAL/Extremal_mesh_3/lines.h>
#include <CGAL/Extremal_mesh_3/paths.h>
#include <CGAL/Extremal_mesh_3/select.h>

#include "changed_mesh.h"
#include "hand_made.h"
#include "random_surfaces.h"

#include <limits>
#include <numeric>
#include <set>

using namespace CGAL::Extremal_mesh_3;

namespace {

/// extremal meshes with much in them: a perturbed ellipsoid with umbilics of one and three ridges, a torus, a surface that the box
/// cuts.
const std::vector<Extremal_mesh>& extracted() {
  static const std::vector<Extremal_mesh> meshes = [] {
    std::vector<Extremal_mesh> all;
    const auto add = [&](const auto& f, int resolution) {
      const surfaces::Box box = random_surfaces::box_of(f);
      all.push_back(extract_extremal_mesh(f, make_lattice(box.low, box.high, std::size_t(resolution))).mesh);
    };
    add(random_surfaces::ellipsoid(7), 24);
    add(random_surfaces::ellipsoid(8), 24);
    const auto torus = random_surfaces::torus(1);
    all.push_back(extract_extremal_mesh(torus, make_lattice({-1.7, -1.7, -0.7}, {1.7, 1.7, 0.7}, 40)).mesh);
    all.push_back(extract_extremal_mesh(torus, make_lattice({-1.7, -1.7, -0.7}, {0.3, 1.7, 0.7}, 40)).mesh);
    return all;
  }();
  return meshes;
}

std::vector<Extremal_mesh> hand_made_ones() {
  return {hand_made::ellipsoid(), hand_made::two_loops(), hand_made::meridians(), hand_made::hemisphere(),
          Extremal_mesh()};
}

std::vector<Extremal_mesh> all_meshes() {
  std::vector<Extremal_mesh> all = hand_made_ones();
  all.insert(all.end(), extracted().begin(), extracted().end());
  return all;
}

std::vector<std::uint32_t> edges_of(const Extremal_line& line) {
  std::vector<std::uint32_t> edges;
  for (const Half_edge h : line.half_edges)
    edges.push_back(h / 2);
  std::sort(edges.begin(), edges.end());
  return edges;
}

std::string message_of(const std::function<void()>& call) {
  try {
    call();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

} // namespace

TEST(Lines, of_an_ellipsoid_are_its_three_ellipses) {
  const Extremal_mesh mesh = hand_made::ellipsoid();
  const std::vector<Extremal_line> lines = all_lines(mesh);
  ASSERT_EQ(lines.size(), 3U);
  for (const Extremal_line& line : lines)
    EXPECT_TRUE(line.closed);
  EXPECT_EQ(edges_of(lines[0]), (std::vector<std::uint32_t>{0, 1, 2, 3}));                   // z = 0
  EXPECT_EQ(edges_of(lines[1]), (std::vector<std::uint32_t>{4, 5, 6, 7}));                   // x = 0
  EXPECT_EQ(edges_of(lines[2]), (std::vector<std::uint32_t>{8, 9, 10, 11, 12, 13, 14, 15})); // through the umbilics
  EXPECT_EQ(edges_of(line_through(mesh, 13)), edges_of(lines[2]));
  EXPECT_EQ(line_through(mesh, 13).half_edges.front(), 26U);
}

TEST(Lines, hold_every_edge_exactly_once) {
  for (const Extremal_mesh& mesh : all_meshes()) {
    std::vector<int> met(mesh.number_of_edges());
    for (const Extremal_line& line : all_lines(mesh)) {
      ASSERT_FALSE(line.half_edges.empty());
      for (std::size_t i = 0; i < line.half_edges.size(); ++i) {
        ++met[line.half_edges[i] / 2];
        if (i > 0) {
          EXPECT_EQ(mesh.source(line.half_edges[i]), mesh.target(line.half_edges[i - 1]));
        }
      }
      const auto next = next_on_line(mesh, line.half_edges.back());
      EXPECT_EQ(next, line.closed ? std::optional(line.half_edges.front()) : std::nullopt);
      if (!line.closed) {
        EXPECT_EQ(next_on_line(mesh, line.half_edges.front() ^ 1U), std::nullopt);
      }
      for (const Half_edge h : line.half_edges)
        EXPECT_EQ(edges_of(line_through(mesh, h / 2)), edges_of(line));
    }
    EXPECT_EQ(met, std::vector<int>(mesh.number_of_edges(), 1));
  }
}

// MATHEMATICS 2 and 3: lines keep their family through extremal points and change it at every umbilic.
TEST(Lines, keep_their_family_at_extremal_points_and_change_it_at_umbilics) {
  std::size_t extremal_points = 0, one_ridge = 0, three_ridge = 0;
  for (const Extremal_mesh& mesh : extracted())
    for (Half_edge h = 0; h < 2 * mesh.number_of_edges(); ++h) {
      const Extremal_mesh_vertex& vertex = mesh.vertex(mesh.target(h));
      const auto next = next_on_line(mesh, h);
      const bool goes_on = vertex.kind != Vertex_kind::boundary && vertex.kind != Vertex_kind::non_generic;
      ASSERT_EQ(next.has_value(), goes_on) << to_string(vertex.kind);
      if (!next)
        continue;
      EXPECT_EQ(mesh.source(*next), mesh.target(h));
      EXPECT_EQ(next_on_line(mesh, *next ^ 1U), std::optional(h ^ 1U));
      const bool same = mesh.edge(*next / 2).family == mesh.edge(h / 2).family;
      EXPECT_EQ(same, vertex.kind != Vertex_kind::umbilic);
      extremal_points += vertex.kind == Vertex_kind::extremal_point;
      one_ridge += vertex.ridges == 1;
      three_ridge += vertex.ridges == 3;
    }
  EXPECT_GT(extremal_points, 0U);
  EXPECT_GT(one_ridge, 0U);
  EXPECT_GT(three_ridge, 0U);
}

// The opposite branch of a vertex is the one that leaves in the opposite direction: lines are smooth.
TEST(Lines, go_on_straight) {
  const Extremal_mesh mesh = hand_made::ellipsoid();
  for (Half_edge h = 0; h < 2 * mesh.number_of_edges(); ++h) {
    const Half_edge next = next_on_line(mesh, h).value();
    const std::vector<Point> line = polyline(mesh, {h, next});
    ASSERT_EQ(line.size(), 25U);
    const Vector in = surfaces::along(line[12], -1, line[11]), out = surfaces::along(line[13], -1, line[12]);
    EXPECT_GT(surfaces::dot(in, out), 0.95 * surfaces::length(in) * surfaces::length(out));
  }
}

TEST(Lines, end_at_borders_and_at_vertices_that_are_not_generic) {
  const Extremal_line across = line_through(hand_made::hemisphere(), 0);
  EXPECT_EQ(across.half_edges, std::vector<Half_edge>{0});
  EXPECT_FALSE(across.closed);
  const Extremal_mesh cut =
      changed(hand_made::ellipsoid(), [](Mesh_parts& p) { p.vertices[2].kind = Vertex_kind::non_generic; });
  const Extremal_line equator = line_through(cut, 2); // 0 → 2 → 1 → 3 → 0 is cut at 2
  EXPECT_FALSE(equator.closed);
  EXPECT_EQ(equator.half_edges, (std::vector<Half_edge>{2, 4, 6, 0}));
}

TEST(Lines, close_at_anchors) {
  const Extremal_mesh mesh = hand_made::two_loops();
  const std::vector<Extremal_line> lines = all_lines(mesh);
  ASSERT_EQ(lines.size(), 2U);
  for (std::uint32_t i = 0; i < 2; ++i) {
    EXPECT_TRUE(lines[i].closed);
    EXPECT_EQ(lines[i].half_edges, std::vector<Half_edge>{2 * i});
    EXPECT_EQ(polyline(mesh, lines[i].half_edges), mesh.edge(i).polyline);
  }
}

// A star that names a half-edge twice, or not at all, is no reason to walk forever.
TEST(Lines, come_to_an_end_on_inconsistent_meshes) {
  const Extremal_mesh mesh = changed(hand_made::ellipsoid(), [](Mesh_parts& p) {
    p.vertices[0].star = {0, 0, 0, 0};
    p.vertices[2].star = {3, 3, 3, 3};
    p.vertices[4].star.clear();
  });
  std::size_t edges = 0;
  for (const Extremal_line& line : all_lines(mesh))
    edges += line.half_edges.size();
  EXPECT_EQ(edges, mesh.number_of_edges());
}

TEST(Crest_lines, come_strongest_first_and_hold_every_edge_of_their_type) {
  for (const Extremal_mesh& mesh : all_meshes()) {
    const std::vector<Extremal_line> all = strongest_crest_lines(mesh, std::numeric_limits<std::size_t>::max());
    std::vector<std::uint32_t> edges;
    double last = std::numeric_limits<double>::infinity();
    for (const Extremal_line& line : all) {
      double strength = 0;
      for (const Half_edge h : line.half_edges) {
        edges.push_back(h / 2);
        strength += mesh.edge(h / 2).strength;
      }
      EXPECT_LE(strength, last);
      last = strength;
      if (const auto next = next_on_line(mesh, line.half_edges.back()); next && !line.closed) {
        EXPECT_NE(mesh.edge(*next / 2).type, Line_type::max_largest);
      }
    }
    std::sort(edges.begin(), edges.end());
    EXPECT_EQ(edges, select_edges(mesh, {Line_type::max_largest, std::nullopt, {}}));
    const std::vector<Extremal_line> first = strongest_crest_lines(mesh, 2);
    ASSERT_EQ(first.size(), std::min<std::size_t>(2, all.size()));
    for (std::size_t i = 0; i < first.size(); ++i)
      EXPECT_EQ(first[i].half_edges, all[i].half_edges);
    EXPECT_TRUE(strongest_crest_lines(mesh, 0).empty());
  }
}

TEST(Shortest_path, is_as_long_as_a_search_over_all_pairs_says) {
  for (const Extremal_mesh& mesh : all_meshes()) {
    const std::size_t n = mesh.number_of_vertices();
    std::vector<std::vector<double>> length(n, std::vector<double>(n, std::numeric_limits<double>::infinity()));
    for (std::size_t v = 0; v < n; ++v)
      length[v][v] = 0;
    for (std::size_t e = 0; e < mesh.number_of_edges(); ++e) {
      const auto [a, b] = std::pair(mesh.edge(e).source, mesh.edge(e).target);
      length[a][b] = length[b][a] = std::min(length[a][b], mesh.edge(e).length);
    }
    for (std::size_t k = 0; k < n; ++k) // Floyd and Warshall
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j)
          length[i][j] = std::min(length[i][j], length[i][k] + length[k][j]);
    for (std::uint32_t a = 0; a < n; a += 3)
      for (std::uint32_t b = 0; b < n; ++b) {
        const auto path = shortest_path(mesh, a, b);
        ASSERT_EQ(path.has_value(), std::isfinite(length[a][b]));
        if (!path)
          continue;
        EXPECT_NEAR(path->length, length[a][b], 1e-12 * length[a][b]);
        double sum = 0;
        std::uint32_t at = a;
        for (const Half_edge h : path->half_edges) {
          ASSERT_EQ(mesh.source(h), at);
          at = mesh.target(h);
          sum += mesh.edge(h / 2).length;
        }
        EXPECT_EQ(at, b);
        EXPECT_NEAR(sum, path->length, 1e-12 * sum);
        if (a != b) {
          EXPECT_EQ(polyline(mesh, path->half_edges).back(), mesh.vertex(b).point);
        }
      }
  }
}

TEST(Shortest_path, takes_the_shorter_of_two_edges_between_the_same_vertices) {
  const Extremal_mesh mesh = changed(hand_made::meridians(), [](Mesh_parts& p) { p.edges[2].length = 1; });
  EXPECT_EQ(shortest_path(mesh, 0, 1)->half_edges, std::vector<Half_edge>{4});
  EXPECT_EQ(shortest_path(mesh, 1, 0)->half_edges, std::vector<Half_edge>{5});
}

TEST(Connected_components, are_those_of_the_graph) {
  EXPECT_EQ(connected_components(hand_made::ellipsoid()).number, 1U);
  const Connected_components two = connected_components(hand_made::two_loops());
  EXPECT_EQ(two.number, 2U);
  EXPECT_EQ(two.of_vertex, (std::vector<std::uint32_t>{0, 1}));
  EXPECT_EQ(connected_components(Extremal_mesh()).number, 0U);
}

TEST(Cells_around, lie_between_the_branches_and_alternate) { // MATHEMATICS 2
  for (const Extremal_mesh& mesh : all_meshes())
    for (std::uint32_t v = 0; v < mesh.number_of_vertices(); ++v) {
      const auto& star = mesh.vertex(v).star;
      const std::vector<std::uint32_t> cells = cells_around(mesh, v);
      const bool at_border = mesh.vertex(v).kind == Vertex_kind::boundary;
      ASSERT_EQ(cells.size(), star.size() + at_border);
      for (std::size_t i = 0; i < star.size(); ++i) {
        EXPECT_EQ(cells[i + at_border], mesh.left_cell(star[i]));
        const std::uint32_t clockwise = at_border ? cells[i] : cells[(i + star.size() - 1) % star.size()];
        EXPECT_EQ(clockwise, mesh.left_cell(star[i] ^ 1U));
        EXPECT_EQ(mesh.cell(clockwise).sign, -mesh.cell(cells[i + at_border]).sign);
      }
    }
}

TEST(Cell_sides, have_the_cell_on_their_left_and_a_neighbour_beyond) {
  for (const Extremal_mesh& mesh : all_meshes())
    for (std::uint32_t c = 0; c < mesh.number_of_cells(); ++c) {
      std::set<std::uint32_t> beyond;
      double perimeter = 0;
      for (const auto& walk : cell_sides(mesh, c))
        for (const Cell_side& side : walk) {
          EXPECT_EQ(mesh.left_cell(side.half_edge), c);
          EXPECT_EQ(mesh.left_cell(side.half_edge ^ 1U), side.neighbour);
          EXPECT_EQ(side.type, mesh.edge(side.half_edge / 2).type);
          EXPECT_EQ(side.family, mesh.edge(side.half_edge / 2).family);
          beyond.insert(side.neighbour);
          perimeter += mesh.edge(side.half_edge / 2).length;
        }
      std::vector<std::uint32_t> found;
      double common = 0;
      for (const Cell_neighbour& neighbour : neighbours(mesh, c)) {
        found.push_back(neighbour.cell);
        common += neighbour.length;
      }
      EXPECT_EQ(found, std::vector<std::uint32_t>(beyond.begin(), beyond.end()));
      EXPECT_NEAR(common, perimeter, 1e-12 * perimeter);
    }
  EXPECT_EQ(cell_sides(hand_made::two_loops(), 1).size(), 2U); // an annulus
}

TEST(Quadrilaterals, of_an_ellipsoid_have_one_side_of_each_type) { // MATHEMATICS 4
  const Formula ellipsoid("x^2/9+y^2/4+z^2=1");
  const Extremal_mesh mesh = extract_extremal_mesh(ellipsoid, make_lattice({-4, -3, -2}, {4, 3, 2}, 32)).mesh;
  const std::vector<Quadrilateral> quads = quadrilaterals(mesh);
  ASSERT_EQ(quads.size(), 8U);
  // From the largest to the smallest half-axis and back: neighbours at an umbilic are of different families, opposite sides are as well.
  std::size_t one_way = 0;
  for (const Quadrilateral& quad : quads) {
    const auto& s = quad.sides;
    EXPECT_EQ(s[0].type, Line_type::max_largest);
    EXPECT_EQ(s[2].type, Line_type::min_largest);
    EXPECT_TRUE((s[1].type == Line_type::max_second && s[3].type == Line_type::min_second) ||
                (s[1].type == Line_type::min_second && s[3].type == Line_type::max_second));
    one_way += s[1].type == Line_type::max_second;
    for (std::size_t i = 0; i < 4; ++i)
      EXPECT_EQ(mesh.target(s[i].half_edge), mesh.source(s[(i + 1) % 4].half_edge));
  }
  EXPECT_EQ(one_way, 4U); // the mirror images go the other way round
}

TEST(Quadrilaterals, do_not_depend_on_where_the_walk_begins) {
  const Extremal_mesh mesh = hand_made::ellipsoid();
  for (std::uint32_t c = 0; c < 8; ++c)
    for (int turn = 1; turn < 4; ++turn) {
      const Extremal_mesh turned = changed(mesh, [&](Mesh_parts& p) {
        auto& walk = p.cells[c].boundary[0];
        std::rotate(walk.begin(), walk.begin() + turn, walk.end());
      });
      const auto a = quadrilateral(mesh, c), b = quadrilateral(turned, c);
      ASSERT_TRUE(a && b);
      for (std::size_t i = 0; i < 4; ++i)
        EXPECT_EQ(a->sides[i].half_edge, b->sides[i].half_edge);
    }
}

TEST(Quadrilaterals, are_disks_away_from_borders) {
  EXPECT_TRUE(quadrilaterals(hand_made::two_loops()).empty());
  EXPECT_TRUE(quadrilaterals(hand_made::meridians()).empty());
  const Extremal_mesh mesh = hand_made::ellipsoid();
  EXPECT_FALSE(quadrilateral(changed(mesh, [](Mesh_parts& p) { p.cells[2].touches_border = true; }), 2));
  EXPECT_FALSE(quadrilateral(changed(mesh, [](Mesh_parts& p) { p.cells[2].euler_characteristic = 0; }), 2));
}

TEST(Selection, takes_vertices_by_kind) {
  const Extremal_mesh mesh = hand_made::ellipsoid();
  EXPECT_EQ(vertices_of_kind(mesh, Vertex_kind::umbilic), (std::vector<std::uint32_t>{6, 7, 8, 9}));
  EXPECT_EQ(vertices_of_kind(mesh, Vertex_kind::extremal_point).size(), 6U);
  EXPECT_TRUE(vertices_of_kind(mesh, Vertex_kind::boundary).empty());
}

TEST(Selection, takes_edges_that_agree_with_all_that_is_asked) {
  const Extremal_mesh mesh = extracted()[0];
  for (const Line_measure measure :
       {Line_measure::length, Line_measure::strength, Line_measure::sharpness, Line_measure::mean_curvature,
        Line_measure::extreme_curvature, Line_measure::stability}) {
    std::vector<double> values;
    for (std::uint32_t e = 0; e < mesh.number_of_edges(); ++e)
      values.push_back(value_of(edge_measures(mesh, e), measure));
    std::vector<double> sorted = values;
    std::sort(sorted.begin(), sorted.end());
    ASSERT_LT(sorted.front(), sorted.back());
    const double low = sorted[sorted.size() / 4], high = sorted[sorted.size() / 2];
    std::vector<std::uint32_t> expected;
    for (std::uint32_t e = 0; e < values.size(); ++e)
      if (values[e] >= low && values[e] <= high && mesh.edge(e).family == 1)
        expected.push_back(e);
    EXPECT_FALSE(expected.empty());
    EXPECT_EQ(select_edges(mesh, {std::nullopt, 1, {{measure, low, high}}}), expected) << to_string(measure);
  }
  EXPECT_EQ(select_edges(mesh, {}).size(), mesh.number_of_edges());
}

TEST(Queries, refuse_what_is_not_there) {
  const Extremal_mesh mesh = hand_made::ellipsoid(), empty;
  EXPECT_EQ(message_of([&] { line_through(mesh, 16); }), "there is no edge 16: the mesh has those from 0 to 15");
  EXPECT_EQ(message_of([&] { line_through(empty, 0); }), "there is no edge 0: the mesh has none");
  EXPECT_EQ(message_of([&] { next_on_line(mesh, 32); }), "there is no half-edge 32: the mesh has those from 0 to 31");
  EXPECT_EQ(message_of([&] { cell_sides(mesh, 8); }), "there is no cell 8: the mesh has those from 0 to 7");
  EXPECT_NE(message_of([&] { neighbours(mesh, 4294967295U); }), "accepted");
  EXPECT_NE(message_of([&] { quadrilateral(mesh, 8); }), "accepted");
  EXPECT_NE(message_of([&] { cells_around(mesh, 10); }), "accepted");
  EXPECT_NE(message_of([&] { shortest_path(mesh, 0, 10); }), "accepted");
  EXPECT_NE(message_of([&] { shortest_path(mesh, 10, 0); }), "accepted");
  EXPECT_EQ(message_of([&] {
              polyline(mesh, {0, 4});
            }),
            "half-edge 4 starts at vertex 1, but half-edge 0 before it ends at 2");
  EXPECT_EQ(message_of([&] { select_edges(mesh, {std::nullopt, 3, {}}); }), "the family is 3; it must be 1 or 2");
  EXPECT_EQ(message_of([&] {
              select_edges(mesh, {std::nullopt, std::nullopt, {{Line_measure::length, std::nan(""), 1}}});
            }),
            "a bound of the length is not a number");
  const Extremal_mesh wrong = changed(mesh, [](Mesh_parts& p) { p.edges[5].length = -1; });
  EXPECT_EQ(message_of([&] { shortest_path(wrong, 0, 1); }), "edge 5 has the length -1");
}
