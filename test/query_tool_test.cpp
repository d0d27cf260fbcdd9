// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// `extremal_mesh query` as users run it: what it prints is one JSON object, read here with a parser.
#include <CGAL/Extremal_mesh_3/io.h>
#include <CGAL/Extremal_mesh_3/lines.h>

#include "hand_made.h"
#include "temporary_folder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <set>
#include <sys/wait.h>

using namespace CGAL::Extremal_mesh_3;

namespace {

using Json = nlohmann::json;

class Query_tool : public ::testing::Test {
protected:
  struct Outcome {
    int code = -1;
    std::string out, err;
  };

  void SetUp() override {
    write_graphml(folder.file("mesh.graphml"), mesh);
    write_graphml(folder.file("loops.graphml"), hand_made::two_loops());
    write_graphml(folder.file("empty.graphml"), Extremal_mesh({}, {}, std::vector<Extremal_mesh_cell>(1), {}));
  }

  /// runs `query` in the test's folder with arguments for a shell.
  Outcome run(const std::string& arguments) const {
    const Temporary_folder streams;
    const std::string command = "cd " + folder.path() + " && " + EXTREMAL_MESH_3_PROGRAM + " query " + arguments +
                                " > " + streams.file("out") + " 2> " + streams.file("err");
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_text(streams.file("out")),
            read_text(streams.file("err"))};
  }

  /// the object that is printed.
  Json answer(const std::string& arguments) const {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, 0) << arguments << "\n" << outcome.err;
    EXPECT_EQ(outcome.err, "");
    const Json json = Json::parse(outcome.out, nullptr, false);
    EXPECT_TRUE(json.is_object()) << arguments << "\n" << outcome.out;
    return json;
  }

  /// the one sentence with which a question is refused.
  std::string refusal(const std::string& arguments, int code) const {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, code) << arguments << "\n" << outcome.out << outcome.err;
    EXPECT_EQ(outcome.out, "") << arguments;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_TRUE(outcome.err.starts_with("extremal_mesh: ")) << outcome.err;
    return outcome.err;
  }

  static bool contains(const std::string& text, const std::string& part) { return text.find(part) != text.npos; }

  const Extremal_mesh mesh = hand_made::ellipsoid();
  const Temporary_folder folder;
};

} // namespace

TEST_F(Query_tool, finds_the_cell_at_a_point) {
  const Json json = answer("mesh.graphml --cell-at 0.6 -.5 -0.62");
  EXPECT_EQ(json["cell"]["id"], 6); // the octant of y < 0, z < 0
  EXPECT_EQ(json["found_by"], "lines");
  EXPECT_EQ(json["point"], Json({0.6, -0.5, -0.62}));
  EXPECT_EQ(json["cell"]["boundary"][0].size(), 4U);
  EXPECT_EQ(answer("mesh.graphml --cell-at 0.6 -.5 -0.62 --normal 0.6 -.5 -0.62")["cell"]["id"], 6);
  EXPECT_EQ(answer("empty.graphml --cell-at 1 2 3")["cell"]["id"], 0);
  EXPECT_TRUE(answer("empty.graphml --cell-at 1 2 3")["nearest"].is_null());
}

TEST_F(Query_tool, finds_the_cell_on_the_cut_surface) {
  write_ply(folder.file("cells.ply"), hand_made::octants(), mesh);
  const Json json = answer("mesh.graphml --cell-at 0.6 -.5 -0.62 --surface cells.ply");
  EXPECT_EQ(json["cell"]["id"], 6);
  EXPECT_EQ(json["found_by"], "surface");
  EXPECT_LT(json["nearest"]["distance"], 0.01);
  EXPECT_TRUE(contains(refusal("loops.graphml --cell-at 0.6 -.5 -0.62 --surface cells.ply", 1), "cells.ply: polygon "));
  EXPECT_TRUE(contains(refusal("mesh.graphml --cell-at 1 0 0 --surface nothing.ply", 1), "nothing.ply"));
}

TEST_F(Query_tool, shows_cells_and_their_neighbours) {
  for (int c = 0; c < 8; ++c) {
    const Json cell = answer("mesh.graphml --cell " + std::to_string(c))["cell"];
    EXPECT_EQ(cell["sign"], mesh.cell(std::size_t(c)).sign);
    EXPECT_EQ(cell["sides"], 4);
    std::set<int> beyond;
    for (std::size_t i = 0; i < 4; ++i) {
      const Json &side = cell["boundary"][0][i], &next = cell["boundary"][0][(i + 1) % 4];
      EXPECT_EQ(side["to"], next["from"]);
      beyond.insert(side["neighbour"].get<int>());
    }
    std::set<int> neighbours;
    const Json answered = answer("mesh.graphml --neighbours " + std::to_string(c));
    for (const Json& neighbour : answered["neighbours"])
      neighbours.insert(neighbour["id"].get<int>());
    EXPECT_EQ(neighbours, beyond);
  }
  EXPECT_TRUE(answer("empty.graphml --cell 0")["cell"]["compactness"].is_null());
  EXPECT_TRUE(answer("empty.graphml --cell 0")["cell"]["boundary"].empty());
  EXPECT_TRUE(answer("empty.graphml --neighbours 0")["neighbours"].empty());
}

TEST_F(Query_tool, shows_what_is_around_a_vertex) {
  const Json json = answer("mesh.graphml --around 2");
  EXPECT_EQ(json["vertex"]["kind"], "extremal_point");
  EXPECT_EQ(json["vertex"]["extrema"], "max/min");
  EXPECT_EQ(json["branches"].size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    const Half_edge h = json["branches"][i]["half_edge"];
    EXPECT_EQ(h, mesh.vertex(2).star[i]);
    EXPECT_EQ(json["cells"][i], mesh.left_cell(h));
  }
}

TEST_F(Query_tool, follows_lines) {
  Json json = answer("mesh.graphml --line-through 9");
  EXPECT_EQ(json["closed"], true);
  EXPECT_EQ(json["half_edges"].size(), 8U);
  EXPECT_EQ(json["vertices"].front(), json["vertices"].back());
  EXPECT_EQ(json["polyline"].size(), 8U * 12 + 1);
  json = answer("mesh.graphml --strongest 3 --json");
  ASSERT_EQ(json["crest_lines"].size(), 1U); // the equator
  EXPECT_EQ(json["crest_lines"][0]["half_edges"], Json({0, 2, 4, 6}));
}

TEST_F(Query_tool, finds_paths) {
  Json json = answer("mesh.graphml --path 2 3");
  EXPECT_EQ(json["found"], true);
  EXPECT_EQ(json["half_edges"].size(), 2U);
  EXPECT_EQ(json["polyline"].size(), 25U);
  EXPECT_EQ(json["vertices"].front(), 2);
  EXPECT_EQ(json["vertices"].back(), 3);
  json = answer("mesh.graphml --path 4 4");
  EXPECT_EQ(json["length"], 0.0);
  EXPECT_EQ(json["vertices"], Json({4}));
  EXPECT_EQ(answer("loops.graphml --path 0 1")["found"], false);
}

TEST_F(Query_tool, finds_what_is_nearest) {
  const Json json = answer("mesh.graphml --nearest 0 0 2");
  EXPECT_EQ(json["vertex"]["id"], 4);
  EXPECT_EQ(json["vertex"]["distance"], 1.0);
  EXPECT_EQ(json["line"]["distance"], 1.0);
  EXPECT_TRUE(answer("empty.graphml --nearest 0 0 2")["vertex"].is_null());
}

TEST_F(Query_tool, selects_vertices_and_edges) {
  EXPECT_EQ(answer("mesh.graphml --vertices umbilic")["count"], 4);
  EXPECT_EQ(answer("mesh.graphml --vertices all")["vertices"].size(), 10U);
  EXPECT_EQ(answer("mesh.graphml --edges max_second")["count"], 4);
  EXPECT_EQ(answer("mesh.graphml --edges 2")["count"], 8);
  EXPECT_EQ(answer("mesh.graphml --edges all")["edges"].size(), 16U);
  // The arcs between an umbilic and an extremal point are shorter than quarters of great circles.
  EXPECT_EQ(answer("mesh.graphml --edges all --min-length 1.5")["count"], 8);
  EXPECT_EQ(answer("mesh.graphml --edges max_second --max-length 0.65 --min-strength 0.2")["count"], 4);
  EXPECT_EQ(answer("mesh.graphml --edges 1 --min-mean-curvature -0.1")["count"], 0);
}

TEST_F(Query_tool, tells_components_and_quadrilaterals) {
  EXPECT_EQ(answer("mesh.graphml --components")["count"], 1);
  const Json two = answer("loops.graphml --components");
  EXPECT_EQ(two["count"], 2);
  EXPECT_EQ(two["components"][1]["first_vertex"], 1);
  const Json json = answer("mesh.graphml --quads");
  EXPECT_EQ(json["quadrilaterals"], 8);
  int sum = 0;
  for (const auto& [types, number] : json["by_types"].items())
    sum += number.get<int>();
  EXPECT_EQ(sum, 8);
}

TEST_F(Query_tool, refuses_questions_that_make_no_sense) {
  EXPECT_TRUE(contains(refusal("mesh.graphml", 2), "no questions"));
  EXPECT_TRUE(contains(refusal("mesh.graphml --cell 1 --around 2", 2), "several questions"));
  refusal("", 2);
  for (const std::string question : {"--cell",
                                     "--cell one",
                                     "--cell 1.5",
                                     "--cell 99999999999999999999",
                                     "--cell-at 1 2",
                                     "--cell-at 1 2 nan",
                                     "--cell-at inf 0 0",
                                     "--nearest a b c",
                                     "--path 1",
                                     "--strongest 0",
                                     "--strongest -3",
                                     "--vertices circle",
                                     "--edges 3",
                                     "--edges crest",
                                     "--edges all --min-length long",
                                     "--edges all --min-length nan",
                                     "--cell 1 --surface cells.ply",
                                     "--cell 1 --normal 1 0 0",
                                     "--cell 1 --min-length 1",
                                     "--nonsense"})
    refusal("mesh.graphml " + question, 2);
}

TEST_F(Query_tool, names_elements_that_are_not_there) {
  EXPECT_EQ(refusal("mesh.graphml --cell 8", 2), "extremal_mesh: there is no cell 8: the mesh has those from 0 to 7\n");
  EXPECT_EQ(refusal("mesh.graphml --cell -1", 2), "extremal_mesh: there is no cell -1; numbers begin with 0\n");
  for (const std::string question : {"--neighbours 8", "--around 10", "--line-through 16", "--path 0 10", "--path 10 0",
                                     "--path -1 0", "--cell 4294967296"})
    EXPECT_TRUE(contains(refusal("mesh.graphml " + question, 2), "there is no ")) << question;
}

TEST_F(Query_tool, shows_an_example) {
  const Outcome outcome = run("--help");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_TRUE(contains(outcome.out, "Example:\n  extremal_mesh query ")) << outcome.out;
  for (const std::string option : {"--cell-at", "--line-through", "--min-extreme-curvature", "--max-stability"})
    EXPECT_TRUE(contains(outcome.out, option)) << option;
}

TEST_F(Query_tool, fails_on_files_that_are_no_graphs) {
  EXPECT_TRUE(contains(refusal("nothing.graphml --quads", 1), "nothing.graphml"));
  write_text(folder.file("other.graphml"), "<graphml><graph/></graphml>");
  refusal("other.graphml --quads", 1);
}
