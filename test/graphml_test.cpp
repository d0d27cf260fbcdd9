// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Extremal_mesh_3/io.h>

#include "hand_made.h"
#include "same_mesh.h"
#include "temporary_folder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace CGAL::Extremal_mesh_3;
using same_mesh::expect_same;

namespace {

Extremal_mesh round_trip(const Extremal_mesh& mesh) {
  const Temporary_folder folder;
  write_graphml(folder.file("mesh.graphml"), mesh);
  return read_graphml(folder.file("mesh.graphml"));
}

/// an ellipsoid's mesh with numbers that are hard to print.
Extremal_mesh hard_numbers() {
  const Extremal_mesh mesh = hand_made::ellipsoid();
  std::vector<Extremal_mesh_vertex> vertices;
  for (std::size_t v = 0; v < mesh.number_of_vertices(); ++v)
    vertices.push_back(mesh.vertex(v));
  std::vector<Extremal_mesh_edge> edges;
  for (std::size_t e = 0; e < mesh.number_of_edges(); ++e)
    edges.push_back(mesh.edge(e));
  std::vector<Extremal_mesh_cell> cells = mesh.cells();
  using Limits = std::numeric_limits<double>;
  vertices[0].k1 = Limits::max();
  vertices[0].k2 = Limits::lowest();
  vertices[0].t1 = {Limits::denorm_min(), Limits::min(), -0.0};
  vertices[1].t1 = {0.1 + 0.2, 1e23, 9007199254740993.0};
  vertices[6].umbilic_index = -0.5;
  vertices[6].extrema = {Line_type::min_second, Line_type::max_second};
  edges[0].type_changes = {{1, Type_change_kind::turning_point},
                           {3, Type_change_kind::equal_curvatures},
                           {3, Type_change_kind::parabolic_point},
                           {5, Type_change_kind::former_vertex}};
  edges[0].k1[3] = std::nextafter(1.0, 2.0);
  cells[0].area = -0.0;
  cells[1].area = 3;
  cells[2].weight = 1e300;
  return Extremal_mesh(vertices, edges, cells, mesh.surface());
}

/// the message with which a file is refused, its name and line taken off.
std::string refusal(const std::string& text) {
  const Temporary_folder folder;
  const std::string file = folder.file("hostile.graphml");
  write_text(file, text);
  try {
    read_graphml(file);
  } catch (const Io_error& error) {
    std::string message = error.what();
    EXPECT_NE(message.find("hostile.graphml"), message.npos) << message;
    EXPECT_EQ(message.find('\n'), message.npos) << message;
    if (message.starts_with(file + ":"))
      message.erase(0, message.find(": ") + 2);
    return message;
  }
  return "accepted";
}

/// the file of a hemisphere's mesh with one text put for another.
std::string spoilt(const std::string& from, const std::string& to) {
  const Temporary_folder folder;
  write_graphml(folder.file("mesh.graphml"), hand_made::hemisphere());
  std::string text = read_text(folder.file("mesh.graphml"));
  const std::size_t at = text.find(from);
  EXPECT_NE(at, text.npos) << from;
  return text.replace(at, from.size(), to);
}

} // namespace

TEST(GraphML, round_trip_is_exact) {
  expect_same(round_trip(hand_made::ellipsoid()), hand_made::ellipsoid());
  expect_same(round_trip(hard_numbers()), hard_numbers());
}

TEST(GraphML, round_trip_keeps_self_loops_anchors_and_annuli) {
  expect_same(round_trip(hand_made::two_loops()), hand_made::two_loops());
}

TEST(GraphML, round_trip_keeps_multiple_edges) {
  expect_same(round_trip(hand_made::meridians()), hand_made::meridians());
}

TEST(GraphML, round_trip_keeps_borders) {
  expect_same(round_trip(hand_made::hemisphere()), hand_made::hemisphere());
}

TEST(GraphML, round_trip_keeps_an_empty_mesh) {
  expect_same(round_trip(Extremal_mesh()), Extremal_mesh());
}

TEST(GraphML, round_trip_keeps_odd_characters) {
  Extremal_mesh mesh = hand_made::hemisphere();
  for (const std::string source : {"<a href=\"x\">&amp;</a>", "]]>", " two  spaces ", "\ttab\nlines\r\n",
                                   "größe 面 🙂", "x^2 < 1 && y > 'z'"}) {
    mesh.set_provenance(source, source, source);
    expect_same(round_trip(mesh), mesh);
  }
}

TEST(GraphML, replaces_what_xml_cannot_hold) {
  Extremal_mesh mesh = hand_made::hemisphere();
  mesh.set_provenance("a\x01"
                      "b\xFF"
                      "c\xED\xA0\x80"
                      "d\xC3",
                      "", "");
  EXPECT_EQ(round_trip(mesh).surface().source, "a\uFFFDb\uFFFDc\uFFFD\uFFFD\uFFFDd\uFFFD");
}

TEST(GraphML, does_not_write_numbers_that_are_not_finite) {
  const Temporary_folder folder;
  Extremal_mesh_vertex vertex;
  vertex.k1 = std::nan("");
  const Extremal_mesh mesh({vertex}, {}, {}, {});
  try {
    write_graphml(folder.file("mesh.graphml"), mesh);
    FAIL();
  } catch (const Io_error& error) {
    EXPECT_EQ(error.what(),
              "cannot write '" + folder.file("mesh.graphml") + "': vertex 0: k_max: nan is not a finite number");
  }
  EXPECT_EQ(folder.number_of_files(), 0U);
}

TEST(GraphML, refuses_what_is_not_graphml) {
  EXPECT_NE(refusal("").find("is empty"), std::string::npos);
  EXPECT_EQ(refusal("OFF\n3 1 0\n"), "this is not XML; it should begin with '<'");
  EXPECT_EQ(refusal("<svg/>"), "this is not GraphML; its first element is <svg>");
  EXPECT_EQ(refusal("<graphml/>"), "there is no graph");
  EXPECT_EQ(refusal("<graphml><graph edgedefault='undirected'><node id='a'/></graph></graphml>"),
            "this graph was not written by Extremal_mesh_3; make one with 'extremal_mesh extract'");
  EXPECT_EQ(refusal(spoilt("Extremal_mesh_3 2<", "Extremal_mesh_3 1<")),
            "the graph: format: it is 'Extremal_mesh_3 1'; this program reads 'Extremal_mesh_3 2'");
  EXPECT_EQ(refusal(std::string(1000, '\0')), "this is not XML; it should begin with '<'");
}

TEST(GraphML, refuses_broken_xml) {
  EXPECT_EQ(refusal("<graphml>"), "the file ends inside <graphml>; it is truncated");
  EXPECT_EQ(refusal("<graphml></graph>"), "</graph> closes an element that is not open");
  EXPECT_EQ(refusal("<graphml/><graphml/>"), "<graphml> comes after the end of the document");
  EXPECT_EQ(refusal("<graphml a>"), "attribute 'a' has no value");
  EXPECT_EQ(refusal("<graphml a=1>"), "the value of attribute 'a' is not in quotes");
  EXPECT_EQ(refusal("<graphml a='1>"), "the value of attribute 'a' does not end");
  EXPECT_EQ(refusal("<graphml a='&#xD800;'>"), "'&#xD800;' is not a known entity");
  EXPECT_EQ(refusal("<graphml a='&'>"), "expected ';' after '&'");
  EXPECT_EQ(refusal("<graphml><!-- >"), "this comment does not end");
  EXPECT_EQ(refusal("<!DOCTYPE x [<!ENTITY a 'b'>]><graphml/>"),
            "document types with declarations of their own are not supported");
  EXPECT_EQ(refusal("<"), "expected a name");
}

TEST(GraphML, every_truncation_is_refused) {
  const std::string text = spoilt("<", "<");
  const std::size_t last = text.rfind('>');
  for (std::size_t length = 0; length < last; length += 7)
    ASSERT_NE(refusal(text.substr(0, length)), "accepted") << length;
}

TEST(GraphML, refuses_wrong_values) {
  EXPECT_EQ(refusal(spoilt(">boundary<", ">bondary<")),
            "node 'n0': kind: 'bondary' is not one of extremal_point, umbilic, "
            "non_generic, boundary, anchor");
  EXPECT_EQ(refusal(spoilt("<data key=\"x\">1<", "<data key=\"x\">nan<")),
            "node 'n0': x: 'nan' is not a finite number");
  EXPECT_EQ(refusal(spoilt("<data key=\"x\">1<", "<data key=\"x\">1e999<")), "node 'n0': x: '1e999' is not a number");
  EXPECT_EQ(refusal(spoilt("<data key=\"x\">1<", "<data key=\"x\">1 2<")), "node 'n0': x: '' is not a number");
  EXPECT_EQ(refusal(spoilt("<data key=\"x\">1</data>", "")), "node 'n0' has no 'x'");
  EXPECT_EQ(refusal(spoilt("<data key=\"x\">1<", "<data key=\"xx\">1<")),
            "node 'n0' has data of key 'xx', which is not declared");
  EXPECT_EQ(refusal(spoilt("<data key=\"x\">1<", "<data key=\"x\"><b/><")),
            "node 'n0': there is an element in 'x'; expected a value");
  EXPECT_EQ(refusal(spoilt("<data key=\"polyline\">1 ", "<data key=\"polyline\">1 2 ")),
            "edge 'e0': polyline: 40 coordinates are not a multiple of 3");
  EXPECT_EQ(refusal(spoilt("<data key=\"family\">2<", "<data key=\"family\">two<")),
            "edge 'e0': family: 'two' is not an integer");
  EXPECT_EQ(refusal(spoilt("<data key=\"closed\">false<", "<data key=\"closed\">no<")),
            "the graph: closed: 'no' is not true or false");
  EXPECT_NE(refusal(spoilt("<data key=\"family\">2<", "<data key=\"family\">7<")).find("its family is 7"),
            std::string::npos);
}

TEST(GraphML, reads_files_that_do_not_tell_where_types_change) {
  const Temporary_folder folder;
  const std::string file = folder.file("old.graphml");
  write_text(file,
             spoilt("  <key id=\"type_changes\" for=\"edge\" attr.name=\"type_changes\" attr.type=\"string\"/>\n", ""));
  expect_same(read_graphml(file), hand_made::hemisphere());
}

TEST(GraphML, refuses_type_changes_of_no_kind_or_place) {
  const auto with = [](const std::string& changes) {
    return refusal(spoilt("<data key=\"segment_types\">",
                          "<data key=\"type_changes\">" + changes + "</data><data key=\"segment_types\">"));
  };
  EXPECT_EQ(with("1 turning_point 2 parabolic_point"), "accepted");
  EXPECT_EQ(with("1"), "edge 'e0': type_changes: '' is not one of turning_point, equal_curvatures, parabolic_point, "
                       "former_vertex");
  EXPECT_EQ(with("-1 turning_point"), "edge 'e0': type_changes: '-1' is not the number of a point");
  EXPECT_NE(with("99 turning_point").find("its type changes at point 99"), std::string::npos);
}

TEST(GraphML, refuses_references_to_nothing) {
  EXPECT_EQ(refusal(spoilt("target=\"n1\"", "target=\"n7\"")), "edge 'e0' ends at node 'n7', which does not exist");
  EXPECT_EQ(refusal(spoilt("id=\"n1\"", "id=\"n0\"")), "there is a second node 'n0'");
  EXPECT_EQ(refusal(spoilt("id=\"e0\"", "id=\"0\"")), "'0' is not the id of an edge; expected e0, e1, …");
  EXPECT_NE(refusal(spoilt("id=\"e0\"", "id=\"e4294967295\"")).find("its id is 4294967295"), std::string::npos);
  EXPECT_EQ(refusal(spoilt("id=\"e0\"", "id=\"e4294967296\"")),
            "'e4294967296' is not the id of an edge; expected e0, e1, …");
  EXPECT_NE(refusal(spoilt("\"star\">0<", "\"star\">9<")).find("its star names half-edge 9"), std::string::npos);
}

TEST(GraphML, refuses_broken_cells) {
  const std::string cells = "\"boundary\":[[";
  EXPECT_NE(refusal(spoilt(cells, "\"boundary\":[[-1,")).find("cell 0: '-1' is not the number of a half-edge"),
            std::string::npos);
  EXPECT_NE(refusal(spoilt(cells, "\"boundary\":[[77,")).find("its boundary names half-edge 77"), std::string::npos);
  EXPECT_NE(refusal(spoilt(cells, "\"boundary\":[")).find("the graph: cells: it is not the JSON of cells"),
            std::string::npos);
  EXPECT_NE(refusal(spoilt("\"id\":1", "\"id\":5")).find("cell 1 has id 5"), std::string::npos);
  EXPECT_NE(refusal(spoilt("\"sign\":1,", "")).find("key 'sign' not found"), std::string::npos);
  EXPECT_NE(refusal(spoilt("\"sign\":1,", "\"sign\":\"+\",")).find("cells"), std::string::npos);
  EXPECT_NE(refusal(spoilt("key=\"cells\">[", "key=\"cells\">[3,")).find("is not a JSON object"), std::string::npos);
  EXPECT_NE(refusal(spoilt("\"area\":0", "\"area\":1e999")).find("cells"), std::string::npos);
}

TEST(GraphML, missing_files_and_folders_are_told) {
  const Temporary_folder folder;
  for (const std::string& file : {folder.file("nothing.graphml"), folder.path()}) {
    try {
      read_graphml(file);
      FAIL();
    } catch (const Io_error& error) {
      EXPECT_EQ(std::string(error.what()).find("cannot read '" + file + "': "), 0U) << error.what();
    }
  }
}

TEST(GraphML, is_written_whole_or_not_at_all) {
  const Temporary_folder folder;
  const Extremal_mesh mesh = hand_made::ellipsoid();
  EXPECT_THROW(write_graphml(folder.file("none/mesh.graphml"), mesh), Io_error);
  EXPECT_THROW(write_graphml(folder.path(), mesh), Io_error);
  EXPECT_THROW(write_graphml("/dev/stdout", mesh), Io_error);
  EXPECT_THROW(write_graphml("", mesh), Io_error);
  EXPECT_EQ(folder.number_of_files(), 0U);
  write_text(folder.file("mesh.graphml"), "old");
  EXPECT_NO_THROW(check_writable(folder.file("mesh.graphml")));
  EXPECT_EQ(read_text(folder.file("mesh.graphml")), "old");
  write_graphml(folder.file("mesh.graphml"), mesh);
  EXPECT_EQ(folder.number_of_files(), 1U);
  expect_same(read_graphml(folder.file("mesh.graphml")), mesh);
}

TEST(GraphML, a_link_stays_a_link) {
  const Temporary_folder folder;
  write_text(folder.file("real"), "old");
  std::filesystem::create_symlink("real", folder.file("link"));
  write_graphml(folder.file("link"), hand_made::ellipsoid());
  EXPECT_TRUE(std::filesystem::is_symlink(folder.file("link")));
  EXPECT_NO_THROW(read_graphml(folder.file("real")));
}

#ifdef EXTREMAL_MESH_3_NETWORKX_PYTHON
// networkx_test.py checks the counts and a few attributes, adds attributes of its own, and writes the graph again.
TEST(GraphML, is_read_and_written_by_networkx) {
  const Extremal_mesh meshes[] = {hand_made::ellipsoid(), hand_made::two_loops(), hand_made::meridians(),
                                  hand_made::hemisphere(), hard_numbers()};
  for (const Extremal_mesh& mesh : meshes) {
    const Temporary_folder folder;
    write_graphml(folder.file("mesh.graphml"), mesh);
    const std::string command = std::string(EXTREMAL_MESH_3_NETWORKX_PYTHON) + " " + EXTREMAL_MESH_3_NETWORKX_SCRIPT +
                                " " + folder.file("mesh.graphml") + " " + std::to_string(mesh.number_of_vertices()) +
                                " " + std::to_string(mesh.number_of_edges()) + " " +
                                std::to_string(mesh.number_of_cells()) + " " + folder.file("again.graphml");
    ASSERT_EQ(std::system(command.c_str()), 0) << command;
    expect_same(read_graphml(folder.file("again.graphml")), mesh);
  }
}
#endif
