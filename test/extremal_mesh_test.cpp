// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Extremal_mesh_3/Extremal_mesh.h>

#include "hand_made.h"
#include "same_mesh.h"

#include <gtest/gtest.h>

#include <memory>

using namespace CGAL::Extremal_mesh_3;

namespace {

struct Parts {
  std::vector<Extremal_mesh_vertex> vertices;
  std::vector<Extremal_mesh_edge> edges;
  std::vector<Extremal_mesh_cell> cells;
};

Parts parts_of(const Extremal_mesh& mesh) {
  Parts parts;
  for (std::size_t v = 0; v < mesh.number_of_vertices(); ++v)
    parts.vertices.push_back(mesh.vertex(v));
  for (std::size_t e = 0; e < mesh.number_of_edges(); ++e)
    parts.edges.push_back(mesh.edge(e));
  parts.cells = mesh.cells();
  return parts;
}

/// the message of the exception for an ellipsoid's mesh that `spoil` has changed.
std::string message(const std::function<void(Parts&)>& spoil) {
  Parts parts = parts_of(hand_made::ellipsoid());
  spoil(parts);
  try {
    const Extremal_mesh mesh(parts.vertices, parts.edges, parts.cells, {});
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

} // namespace

TEST(Extremal_mesh, of_an_ellipsoid_has_10_vertices_16_edges_8_cells) { // MATHEMATICS 4
  const Extremal_mesh mesh = hand_made::ellipsoid();
  EXPECT_EQ(mesh.number_of_vertices(), 10U);
  EXPECT_EQ(mesh.number_of_edges(), 16U);
  EXPECT_EQ(mesh.number_of_cells(), 8U);
  for (std::size_t c = 0; c < 8; ++c) {
    ASSERT_EQ(mesh.cell(c).boundary.size(), 1U);
    EXPECT_EQ(mesh.cell(c).boundary[0].size(), 4U);
  }
}

TEST(Extremal_mesh, iterates_edges_in_the_order_of_their_ids) {
  const Extremal_mesh mesh = hand_made::ellipsoid();
  std::uint32_t id = 0;
  for (auto [e, end] = boost::edges(mesh.graph()); e != end; ++e, ++id) {
    EXPECT_EQ(mesh.graph()[*e].id, id);
    EXPECT_EQ(boost::source(*e, mesh.graph()), mesh.edge(id).source);
    EXPECT_EQ(mesh.edge_descriptor_of(id), *e);
  }
  EXPECT_EQ(id, 16U);
}

TEST(Extremal_mesh, half_edges_go_both_ways) {
  const Extremal_mesh mesh = hand_made::ellipsoid();
  for (Half_edge h = 0; h < 32; ++h) {
    EXPECT_EQ(mesh.source(h), mesh.target(h ^ 1U));
    EXPECT_NE(mesh.left_cell(h), mesh.left_cell(h ^ 1U));
  }
  for (std::uint32_t c = 0; c < 8; ++c)
    for (const Half_edge h : mesh.cell(c).boundary[0])
      EXPECT_EQ(mesh.left_cell(h), c);
}

TEST(Extremal_mesh, keeps_self_loops_and_multiple_edges) {
  const Extremal_mesh loops = hand_made::two_loops();
  EXPECT_EQ(boost::num_edges(loops.graph()), 2U);
  EXPECT_EQ(boost::out_degree(0, loops.graph()), 2U);
  EXPECT_EQ(loops.cell(1).boundary.size(), 2U);
  const Extremal_mesh meridians = hand_made::meridians();
  EXPECT_EQ(boost::num_edges(meridians.graph()), 4U);
  EXPECT_EQ(boost::out_degree(1, meridians.graph()), 4U);
}

TEST(Extremal_mesh, copies_and_moved_meshes_outlive_the_original) {
  auto original = std::make_unique<Extremal_mesh>(hand_made::ellipsoid());
  const Extremal_mesh copy = *original;
  Extremal_mesh assigned;
  assigned = *original;
  const Extremal_mesh moved = std::move(*original);
  original.reset();
  same_mesh::expect_same(copy, hand_made::ellipsoid());
  same_mesh::expect_same(assigned, hand_made::ellipsoid());
  same_mesh::expect_same(moved, hand_made::ellipsoid());
}

TEST(Extremal_mesh, is_empty_by_default) {
  const Extremal_mesh mesh;
  EXPECT_EQ(mesh.number_of_vertices(), 0U);
  EXPECT_EQ(mesh.number_of_edges(), 0U);
  EXPECT_EQ(boost::num_vertices(dual_graph(mesh)), 0U);
}

TEST(Extremal_mesh, dual_graph_joins_cells_of_opposite_signs) {
  const Extremal_mesh mesh = hand_made::ellipsoid();
  const Dual_graph dual = dual_graph(mesh);
  ASSERT_EQ(boost::num_vertices(dual), 8U);
  ASSERT_EQ(boost::num_edges(dual), 16U);
  for (auto [e, end] = boost::edges(dual); e != end; ++e) {
    const auto a = boost::source(*e, dual), b = boost::target(*e, dual);
    EXPECT_EQ(mesh.cell(a).sign, -mesh.cell(b).sign);
    EXPECT_EQ(mesh.edge(dual[*e].edge).left_cell, a);
  }
}

TEST(Extremal_mesh, names_the_element_that_refers_to_nothing) {
  EXPECT_EQ(message([](Parts&) {}), "accepted");
  EXPECT_EQ(message([](Parts& p) { p.edges[3].target = 10; }),
            "edge 3: it ends at vertex 10, but there are only 10 vertices");
  EXPECT_EQ(message([](Parts& p) { p.edges[3].id = 4; }), "edge 3: its id is 4; ids must be 0, 1, 2, …");
  EXPECT_EQ(message([](Parts& p) { p.edges[15].left_cell = 8; }),
            "edge 15: it borders cell 8, but there are only 8 cells");
  EXPECT_EQ(message([](Parts& p) { p.edges[0].family = 3; }), "edge 0: its family is 3; it must be 1 or 2");
  EXPECT_EQ(message([](Parts& p) { p.edges[0].polyline.resize(1); }),
            "edge 0: its polyline has 1 points; it needs at least 2");
  EXPECT_EQ(message([](Parts& p) { p.edges[0].k2.pop_back(); }),
            "edge 0: it has 13 points, 13 values of k1 and 12 of k2");
  EXPECT_EQ(message([](Parts& p) { p.edges[0].segment_types.pop_back(); }),
            "edge 0: it has 12 segments and 11 segment types");
  EXPECT_EQ(message([](Parts& p) {
              p.edges[0].type_changes = {{12, Type_change_kind::turning_point}};
            }),
            "edge 0: its type changes at point 12, which is not between the ends of 13 points");
  EXPECT_EQ(message([](Parts& p) {
              p.edges[0].type_changes = {{3, Type_change_kind::turning_point}, {2, Type_change_kind::parabolic_point}};
            }),
            "edge 0: its type changes at point 2 after point 3");
  EXPECT_EQ(message([](Parts& p) { p.vertices[9].star[0] = 32; }),
            "vertex 9: its star names half-edge 32, but there are only 32");
  EXPECT_EQ(message([](Parts& p) { p.cells[7].boundary[0][0] = 99; }),
            "cell 7: its boundary names half-edge 99, but there are only 32");
  EXPECT_EQ(message([](Parts& p) { p.cells[7].sign = 0; }), "cell 7: its sign is 0; it must be 1 or -1");
}

TEST(Extremal_mesh, provenance_can_be_recorded) {
  Extremal_mesh mesh = hand_made::hemisphere();
  mesh.set_provenance("a.nrrd", "{}", "LPS");
  EXPECT_EQ(mesh.surface().source, "a.nrrd");
  EXPECT_EQ(mesh.surface().parameters, "{}");
  EXPECT_EQ(mesh.surface().frame, "LPS");
  EXPECT_FALSE(mesh.surface().closed);
}
