// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A good mesh, one thing broken: the checks that it breaks are violated and no others, and they name the place.
#include <CGAL/Extremal_mesh_3/Formula.h>

#include "surfaces.h"

#include <functional>
#include <limits>
#include <set>

using namespace CGAL::Extremal_mesh_3;

namespace {

using Names = std::set<std::string>;

struct Parts {
  std::vector<Extremal_mesh_vertex> vertices;
  std::vector<Extremal_mesh_edge> edges;
  std::vector<Extremal_mesh_cell> cells;
  Surface_info surface;

  explicit Parts(const Extremal_mesh& mesh) : cells(mesh.cells()), surface(mesh.surface()) {
    for (std::size_t v = 0; v < mesh.number_of_vertices(); ++v)
      vertices.push_back(mesh.vertex(v));
    for (std::size_t e = 0; e < mesh.number_of_edges(); ++e)
      edges.push_back(mesh.edge(e));
  }
  Extremal_mesh mesh() const { return {vertices, edges, cells, surface}; }
  std::size_t first(Vertex_kind kind) const {
    std::size_t v = 0;
    while (vertices[v].kind != kind)
      ++v;
    return v;
  }
};

const Extremal_mesh& closed_mesh() {
  static const Extremal_mesh mesh =
      extract_extremal_mesh(Formula("x^2+1.3*y^2+1.7*z^2+0.2*x^3+0.15*y^3-0.4*x*y*z+0.2*x^2*z+0.1*x*y^2-1"),
                            make_lattice({-1.4, -1.4, -1.4}, {1.4, 1.4, 1.4}, 20))
          .mesh;
  return mesh;
}

const Extremal_mesh& bordered_mesh() {
  static const Extremal_mesh mesh =
      extract_extremal_mesh(Formula("x^2+1.3*y^2+1.7*z^2+0.2*x^3+0.15*y^3-0.4*x*y*z+0.2*x^2*z+0.1*x*y^2-1"),
                            make_lattice({-1.4, -1.4, -0.1}, {1.4, 1.4, 1.4}, 20))
          .mesh;
  return mesh;
}

struct Outcome {
  Names violated;
  std::string details;
  bool names(const std::string& text) const { return details.find(text) != std::string::npos; }
};

Outcome outcome(const Extremal_mesh& mesh) {
  Outcome o;
  for (const Check& c : check(mesh))
    if (c.applies && !c.holds) {
      o.violated.insert(c.name);
      o.details += c.detail + '\n';
    }
  return o;
}

Outcome after(const Extremal_mesh& mesh, const std::function<void(Parts&)>& breaking) {
  Parts parts(mesh);
  breaking(parts);
  const Extremal_mesh broken = parts.mesh();
  const Outcome o = outcome(broken);
  EXPECT_EQ(all_hold(check(broken)), o.violated.empty());
  return o;
}

/// "vertex 3" for the first vertex of a kind, "extremal_point 3" and so on.
std::string name_of(const Extremal_mesh& mesh, Vertex_kind kind, const std::string& word) {
  return word + ' ' + std::to_string(Parts(mesh).first(kind));
}

} // namespace

TEST(Check, holds_on_good_meshes) {
  EXPECT_EQ(outcome(closed_mesh()).violated, Names());
  EXPECT_EQ(outcome(bordered_mesh()).violated, Names());
  EXPECT_EQ(outcome(Extremal_mesh()).violated, Names());
}

TEST(Check, says_what_does_not_apply_to_surfaces_with_border) {
  ASSERT_FALSE(bordered_mesh().surface().closed);
  Names left_out;
  for (const Check& c : check(bordered_mesh()))
    if (!c.applies) {
      left_out.insert(c.name);
      EXPECT_EQ(c.detail, "the surface has a border");
    }
  EXPECT_EQ(left_out, (Names{"faces", "umbilic_index", "field_index", "even_extremal_points"}));
  for (const Check& c : check(closed_mesh()))
    EXPECT_TRUE(c.applies) << c.name;
}

TEST(Check, finds_a_branch_that_is_missing_from_a_star) {
  const Outcome o =
      after(closed_mesh(), [](Parts& p) { p.vertices[p.first(Vertex_kind::extremal_point)].star.pop_back(); });
  EXPECT_EQ(o.violated, (Names{"stars", "walks", "degrees", "families", "winding", "faces"}));
  EXPECT_TRUE(o.names("stands in 0 stars")) << o.details;
  EXPECT_TRUE(o.names(name_of(closed_mesh(), Vertex_kind::extremal_point, "extremal_point") + " of degree 3"))
      << o.details;
}

TEST(Check, finds_a_branch_that_belongs_to_another_vertex) {
  const Outcome o = after(closed_mesh(), [](Parts& p) {
    std::swap(p.vertices[p.first(Vertex_kind::extremal_point)].star[0],
              p.vertices[p.first(Vertex_kind::umbilic)].star[0]);
  });
  EXPECT_TRUE(o.violated.count("stars"));
  EXPECT_TRUE(o.violated.count("walks"));
  EXPECT_TRUE(o.names("in the star of " + name_of(closed_mesh(), Vertex_kind::umbilic, "vertex"))) << o.details;
}

TEST(Check, finds_a_type_that_changes_where_nothing_changes_it) {
  const auto changing = [](Parts& p) {
    for (Extremal_mesh_edge& edge : p.edges)
      if (edge.type_changes.empty() && edge.segment_types.size() > 2) {
        edge.segment_types.back() =
            edge.type == Line_type::max_largest ? Line_type::min_largest : Line_type::max_largest;
        break;
      }
  };
  const Outcome o = after(closed_mesh(), changing);
  EXPECT_EQ(o.violated, Names{"type_changes"});
  EXPECT_TRUE(o.names("changes from")) << o.details;
  // A file of an older version tells no change at all.
  EXPECT_EQ(after(closed_mesh(),
                  [&](Parts& p) {
                    changing(p);
                    for (Extremal_mesh_edge& edge : p.edges)
                      edge.type_changes.clear();
                  })
                .violated,
            Names());
}

TEST(Check, finds_a_star_in_the_wrong_order) {
  const Outcome o = after(closed_mesh(), [](Parts& p) {
    auto& star = p.vertices[p.first(Vertex_kind::extremal_point)].star;
    std::swap(star[0], star[2]); // families still alternate
  });
  EXPECT_EQ(o.violated, (Names{"walks"}));
  EXPECT_TRUE(o.names("at " + name_of(closed_mesh(), Vertex_kind::extremal_point, "vertex"))) << o.details;
}

TEST(Check, finds_a_walk_that_does_not_turn_as_it_should) {
  const Outcome o =
      after(closed_mesh(), [](Parts& p) { std::swap(p.cells[3].boundary[0][0], p.cells[3].boundary[0][1]); });
  EXPECT_EQ(o.violated, (Names{"walks"}));
  EXPECT_TRUE(o.names("around cell 3")) << o.details;
}

TEST(Check, finds_a_half_edge_that_bounds_no_cell) {
  Half_edge gone = 0;
  const Outcome o = after(closed_mesh(), [&](Parts& p) {
    gone = p.cells[2].boundary[0].back();
    p.cells[2].boundary[0].pop_back();
  });
  EXPECT_EQ(o.violated, (Names{"walks"}));
  EXPECT_TRUE(o.names("half-edge " + std::to_string(gone) + " stands in 0 boundary walks")) << o.details;
}

TEST(Check, finds_an_edge_with_the_wrong_cell_on_its_left) {
  const Outcome o = after(closed_mesh(), [](Parts& p) {
    std::uint32_t other = 0; // of the same sign
    while (other == p.edges[5].left_cell || p.cells[other].sign != p.cells[p.edges[5].left_cell].sign)
      ++other;
    p.edges[5].left_cell = other;
  });
  EXPECT_EQ(o.violated, (Names{"walks"}));
  EXPECT_TRUE(o.names("half-edge 10 bounds cell")) << o.details;
}

TEST(Check, finds_a_polyline_that_does_not_end_at_its_vertex) {
  const Outcome o = after(closed_mesh(), [](Parts& p) { p.edges[4].polyline.back()[1] += 1e-9; });
  EXPECT_EQ(o.violated, (Names{"geometry"}));
  EXPECT_TRUE(o.names("the polyline of edge 4 does not end at its vertices")) << o.details;
}

TEST(Check, finds_numbers_that_are_not_finite) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Outcome o = after(closed_mesh(), [&](Parts& p) { p.vertices[7].k1 = nan; });
  EXPECT_EQ(o.violated, (Names{"geometry"}));
  EXPECT_TRUE(o.names("vertex 7")) << o.details;
  o = after(closed_mesh(), [&](Parts& p) { p.edges[6].polyline[1][2] = nan; });
  EXPECT_EQ(o.violated, (Names{"geometry"}));
  EXPECT_TRUE(o.names("edge 6")) << o.details;
  o = after(closed_mesh(), [&](Parts& p) { p.edges[6].length = std::numeric_limits<double>::infinity(); });
  EXPECT_EQ(o.violated, (Names{"geometry"}));
  // Curvatures along the lines and directions at the vertices are numbers, too.
  EXPECT_EQ(after(closed_mesh(), [&](Parts& p) { p.edges[6].k1[1] = nan; }).violated, (Names{"geometry"}));
  EXPECT_EQ(after(closed_mesh(), [&](Parts& p) { p.vertices[7].t1[0] = nan; }).violated, (Names{"geometry"}));
  EXPECT_EQ(after(closed_mesh(), [&](Parts& p) { p.cells[1].weight = nan; }).violated, (Names{"geometry"}));
  EXPECT_EQ(after(closed_mesh(), [&](Parts& p) { p.cells[1].area = nan; }).violated.count("cells"), 1U);
  EXPECT_EQ(after(closed_mesh(), [&](Parts& p) { p.cells[1].area = -0.1; }).violated.count("cells"), 1U);
}

TEST(Check, finds_bad_normals_and_curvatures) {
  Outcome o = after(closed_mesh(), [](Parts& p) { p.vertices[2].normal[0] += 0.1; });
  EXPECT_EQ(o.violated, (Names{"geometry"}));
  EXPECT_TRUE(o.names("the normal of vertex 2")) << o.details;
  o = after(closed_mesh(), [](Parts& p) { p.vertices[2].k1 = p.vertices[2].k2 - 1; });
  EXPECT_EQ(o.violated, (Names{"geometry"}));
  EXPECT_TRUE(o.names("vertex 2 has k1 < k2")) << o.details;
}

TEST(Check, finds_degrees_that_do_not_fit_the_kind) {
  const Outcome o = after(closed_mesh(), [](Parts& p) { p.vertices[p.first(Vertex_kind::umbilic)].ridges = 3; });
  EXPECT_EQ(o.violated, (Names{"degrees"}));
  EXPECT_TRUE(o.names(name_of(closed_mesh(), Vertex_kind::umbilic, "umbilic") + " of degree 2")) << o.details;
}

TEST(Check, finds_an_edge_of_the_wrong_family) {
  const Outcome o = after(closed_mesh(), [](Parts& p) { p.edges[0].family = 3 - p.edges[0].family; });
  EXPECT_EQ(o.violated, (Names{"families", "winding"}));
  EXPECT_TRUE(o.names("2 violations")) << o.details; // at its two ends
  EXPECT_TRUE(o.names(' ' + std::to_string(closed_mesh().edge(0).source) + " at")) << o.details;
}

TEST(Check, finds_umbilics_of_the_wrong_class) {
  Outcome o = after(closed_mesh(),
                    [](Parts& p) { p.vertices[p.first(Vertex_kind::umbilic)].umbilic_type = Umbilic_type::star; });
  EXPECT_EQ(o.violated, (Names{"umbilics"}));
  EXPECT_TRUE(o.names(name_of(closed_mesh(), Vertex_kind::umbilic, "umbilic") + " is a star of index 0.5"))
      << o.details;
  o = after(closed_mesh(), [](Parts& p) {
    auto& v = p.vertices[p.first(Vertex_kind::umbilic)];
    v.umbilic_type = Umbilic_type::star;
    v.umbilic_index = -0.5;
  });
  EXPECT_EQ(o.violated, (Names{"winding", "umbilic_index"}));
  EXPECT_TRUE(o.names("1 ≠ 2")) << o.details;
}

TEST(Check, finds_two_cells_of_one_sign_side_by_side) {
  const Outcome o = after(closed_mesh(), [](Parts& p) { p.cells[5].sign = -p.cells[5].sign; });
  EXPECT_EQ(o.violated, (Names{"alternation", "winding"}));
  EXPECT_TRUE(o.names("5")) << o.details;
}

TEST(Check, finds_cells_that_do_not_add_up) {
  Outcome o = after(closed_mesh(), [](Parts& p) { p.cells[5].area *= 1.001; });
  EXPECT_EQ(o.violated, (Names{"cells"}));
  o = after(closed_mesh(), [](Parts& p) { p.cells[5].euler_characteristic = 0; });
  EXPECT_EQ(o.violated, (Names{"cells", "euler"}));
  EXPECT_TRUE(o.names("cell 5")) << o.details;
}

TEST(Check, finds_the_wrong_euler_characteristic) {
  const Outcome o = after(closed_mesh(), [](Parts& p) { p.surface.euler_characteristic = 0; });
  EXPECT_EQ(o.violated, (Names{"euler", "faces", "umbilic_index", "field_index"}));
}

TEST(Check, finds_the_wrong_index_of_the_vector_field) {
  const Outcome o =
      after(closed_mesh(), [](Parts& p) { p.vertices[p.first(Vertex_kind::extremal_point)].field_index *= -1; });
  EXPECT_EQ(o.violated, (Names{"winding", "field_index"}));
}

TEST(Check, finds_two_wrong_indices_that_cancel_in_the_sum) {
  std::array<std::size_t, 2> points{}; // of opposite index
  const Outcome o = after(closed_mesh(), [&](Parts& p) {
    points[0] = points[1] = p.first(Vertex_kind::extremal_point);
    while (p.vertices[points[1]].kind != Vertex_kind::extremal_point ||
           p.vertices[points[1]].field_index != -p.vertices[points[0]].field_index)
      ++points[1];
    std::swap(p.vertices[points[0]].field_index, p.vertices[points[1]].field_index);
  });
  EXPECT_EQ(o.violated, (Names{"winding"}));
  for (const std::size_t v : points)
    EXPECT_TRUE(o.names("around extremal_point " + std::to_string(v) + " of indices 0 and")) << o.details;
  EXPECT_TRUE(o.names("2 violations")) << o.details;
}

TEST(Check, finds_a_mesh_whose_lines_are_of_the_other_family) {
  // Every other statement is the same for both families: only Φ turns the other way round.
  const Outcome o = after(closed_mesh(), [](Parts& p) {
    for (Extremal_mesh_edge& e : p.edges)
      e.family = 3 - e.family;
  });
  EXPECT_EQ(o.violated, (Names{"winding"}));
}

TEST(Check, finds_a_mirrored_mesh_whose_cells_kept_their_signs) {
  EXPECT_EQ(after(bordered_mesh(),
                  [](Parts& p) {
                    for (Extremal_mesh_cell& c : p.cells)
                      c.sign = -c.sign;
                  })
                .violated,
            (Names{"winding"}));
}

TEST(Check, finds_an_odd_number_of_extremal_points) {
  const Outcome o = after(
      closed_mesh(), [](Parts& p) { p.vertices[p.first(Vertex_kind::extremal_point)].kind = Vertex_kind::anchor; });
  EXPECT_EQ(o.violated, (Names{"degrees", "even_extremal_points"}));
  EXPECT_TRUE(o.names("7 extremal points")) << o.details;
}

TEST(Check, finds_a_border_that_should_not_be_there_or_is_missing) {
  EXPECT_EQ(after(closed_mesh(), [](Parts& p) { p.cells[0].touches_border = true; }).violated, (Names{"border"}));
  EXPECT_TRUE(after(closed_mesh(), [](Parts& p) { p.cells[3].touches_border = true; }).names("cell 3 touches"));
  EXPECT_EQ(after(closed_mesh(), [](Parts& p) { p.surface.closed = false; }).violated, (Names{"border"}));
  EXPECT_TRUE(after(bordered_mesh(), [](Parts& p) { p.surface.closed = true; }).violated.count("border"));
}

TEST(Check, finds_a_line_of_the_wrong_family_at_the_border) {
  const Outcome o = after(bordered_mesh(), [](Parts& p) {
    int& family = p.edges[p.vertices[p.first(Vertex_kind::boundary)].star[0] / 2].family;
    family = 3 - family;
  });
  EXPECT_TRUE(o.violated.count("border_parity")) << o.details;
}

TEST(Check, finds_a_loop_of_the_border_with_an_odd_number_of_ends) {
  const Outcome o = after(bordered_mesh(),
                          [](Parts& p) { p.vertices[p.first(Vertex_kind::boundary)].kind = Vertex_kind::non_generic; });
  EXPECT_TRUE(o.violated.count("border")) << o.details;
  EXPECT_TRUE(o.names(" lines end on the loop of the border with vertex ")) << o.details;
}

TEST(Check, tells_at_most_five_places_and_counts_the_rest) {
  const Outcome o = after(closed_mesh(), [](Parts& p) {
    for (Extremal_mesh_cell& c : p.cells)
      c.sign = 1;
  });
  EXPECT_EQ(o.violated, (Names{"alternation", "winding"}));
  const std::size_t begin = o.details.find("20 violations: edge ");
  ASSERT_NE(begin, std::string::npos) << o.details;
  const std::string edges = o.details.substr(begin, o.details.find('\n', begin) - begin);
  EXPECT_EQ(std::count(edges.begin(), edges.end(), ';'), 4) << edges;
}
