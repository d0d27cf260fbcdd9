// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// `extremal_mesh register`, `compare`, `landmarks`, `match` and `scale-space` as users run them.
#include <CGAL/Extremal_mesh_3/Formula.h>
#include <CGAL/Extremal_mesh_3/io.h>
#include <CGAL/Extremal_mesh_3/landmarks.h>

#include "surfaces.h"
#include "temporary_folder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>

#include <sys/wait.h>

using namespace CGAL::Extremal_mesh_3;

namespace {

using Json = nlohmann::json;

class Registration_tool : public ::testing::Test {
protected:
  struct Outcome {
    int code = -1;
    std::string out, err;
  };

  static void SetUpTestSuite() {
    folder = new Temporary_folder;
    // the second one is the first turned by 90 degrees about z, and moved
    write("a", "x^2/9 + y^2/4 + z^2 + 0.02*sin(4*x)*cos(5*y + 1) + 0.05*x*y*z = 1", {-3.4, -2.4, -1.3},
          {3.4, 2.4, 1.3});
    write("b", "(y-2)^2/9 + (1-x)^2/4 + (z-3)^2 + 0.02*sin(4*(y-2))*cos(5*(1-x) + 1) + 0.05*(y-2)*(1-x)*(z-3) = 1",
          {-1.4, -1.4, 1.7}, {3.4, 5.4, 4.3});
    write("other", "x^2/9 + y^2/3 + z^2 + 0.02*sin(5*y)*cos(4*x + 2) + 0.1*x*y = 1", {-3.6, -2.4, -1.3},
          {3.6, 2.4, 1.3});
  }
  static void TearDownTestSuite() { delete folder; }

  static void write(const std::string& name, const std::string& formula, const Point& low, const Point& high) {
    write_graphml(folder->file(name + ".graphml"),
                  extract_extremal_mesh(Formula(formula), make_lattice(low, high, 60)).mesh);
  }

  static Outcome run(const std::string& arguments) {
    const Temporary_folder streams;
    const std::string command = "cd " + folder->path() + " && " + EXTREMAL_MESH_3_PROGRAM + " " + arguments + " > " +
                                streams.file("out") + " 2> " + streams.file("err");
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_text(streams.file("out")),
            read_text(streams.file("err"))};
  }

  static void expect_refused(const std::string& arguments, int code, const std::string& part) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, code) << arguments;
    EXPECT_NE(outcome.err.find(part), std::string::npos) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  }

  static Temporary_folder* folder;
};
Temporary_folder* Registration_tool::folder = nullptr;

} // namespace

TEST_F(Registration_tool, writes_the_motion_and_prints_the_table) {
  const Outcome outcome = run("register a.graphml b.graphml -o motion.json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("max_largest"), std::string::npos);
  const Json json = Json::parse(read_text(folder->file("motion.json")));
  EXPECT_EQ(json["found"], true);
  const std::array<std::array<double, 4>, 4> truth{{{0, -1, 0, 1}, {1, 0, 0, 2}, {0, 0, 1, 3}, {0, 0, 0, 1}}};
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j)
      EXPECT_NEAR(json["matrix"][i][j].get<double>(), truth[i][j], 1e-4) << i << j;
  EXPECT_GT(json["matched"]["extremal_point"], 50);
  EXPECT_LT(json["rms"], 1e-3);
  EXPECT_LT(json["uncertainty"]["rotation_degrees"], 0.1);
  EXPECT_EQ(json["pairs"].size(),
            json["matched"]["extremal_point"].get<std::size_t>() + json["matched"]["umbilic"].get<std::size_t>());

  const Outcome compared = run("compare a.graphml b.graphml --transform motion.json -o table.csv -o table.json --json");
  ASSERT_EQ(compared.code, 0) << compared.err;
  const Json table = Json::parse(compared.out);
  EXPECT_EQ(table, Json::parse(read_text(folder->file("table.json"))));
  EXPECT_EQ(table["rows"].size(), 9U);
  EXPECT_GT(table["rows"][0]["matched_percent"], 99);
  EXPECT_GT(table["cells_percent"], 90);
  EXPECT_NE(read_text(folder->file("table.csv")).find("umbilic_3_ridge"), std::string::npos);
}

TEST_F(Registration_tool, fails_without_a_matrix_where_there_is_no_motion) {
  expect_refused("register a.graphml other.graphml -o none.json", 1, "no motion takes 'a.graphml' to 'other.graphml'");
  const Json json = Json::parse(read_text(folder->file("none.json")));
  EXPECT_EQ(json["found"], false);
  EXPECT_TRUE(json["matrix"].is_null());
  EXPECT_NE(json["reason"], "");
  expect_refused("compare a.graphml other.graphml --transform none.json", 1, "no motion was found");
}

TEST_F(Registration_tool, refuses_what_makes_no_sense) {
  expect_refused("register a.graphml", 2, "required");
  expect_refused("register a.graphml missing.graphml", 1, "missing.graphml");
  expect_refused("register a.graphml b.graphml --tolerance -1", 2, "--tolerance");
  expect_refused("register a.graphml b.graphml -o no/such/folder.json", 1, "no/such/folder.json");
  expect_refused("compare a.graphml b.graphml -o table.xls", 2, "table.xls");
  expect_refused("compare a.graphml b.graphml --transform missing.json", 1, "missing.json");
  expect_refused("compare a.graphml b.graphml --transform a.graphml", 1, "matrix");
  expect_refused("landmarks a.graphml", 2, "nothing to write");
  expect_refused("landmarks a.graphml -o points.txt", 2, "points.txt");
  expect_refused("match a.graphml missing.csv", 1, "missing.csv");
  expect_refused("match a.graphml a.graphml", 1, "a number is expected");
  expect_refused("scale-space image.nrrd --iso 1 --sigma 2 -o x.csv", 2, "several scales");
  expect_refused("scale-space image.nrrd --iso 1 --sigma 2 3", 2, "nothing to write");
  expect_refused("scale-space mesh.off --iso 1 --sigma 2 3 -o x.csv", 2, "is a mesh");
}

TEST_F(Registration_tool, writes_landmarks_that_are_read_again) {
  const Outcome outcome = run("landmarks a.graphml --most 12 -o points.mrk.json -o points.csv");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const Extremal_mesh mesh = read_graphml(folder->file("a.graphml"));
  const std::vector<Landmark> strongest = strongest_landmarks(mesh);
  for (const char* file : {"points.mrk.json", "points.csv"}) {
    const std::vector<Given_landmark> read = read_landmarks(folder->file(file));
    ASSERT_EQ(read.size(), 12U) << file;
    for (std::size_t i = 0; i < read.size(); ++i) {
      EXPECT_EQ(read[i].label, "EP" + std::to_string(i + 1));
      EXPECT_EQ(read[i].point, mesh.vertex(strongest[i].vertex).point);
    }
  }
  const Outcome matched = run("match a.graphml points.csv points.mrk.json --json -o matched.csv");
  ASSERT_EQ(matched.code, 0) << matched.err;
  const Json json = Json::parse(matched.out);
  EXPECT_EQ(json["landmarks"], 24);
  EXPECT_EQ(json["extremal_point"]["greatest"], 0);
  EXPECT_EQ(json["line"]["greatest"], 0);
  EXPECT_GT(json["extremal_point"]["mean_by_chance"], 0.01);
}

TEST_F(Registration_tool, reads_markups_in_ras_as_lps) {
  write_text_file(folder->file("ras.mrk.json"),
                  R"({"markups":[{"coordinateSystem":"RAS","controlPoints":[{"label":"tip","position":[1,2,3]}]}]})");
  const auto read = read_landmarks(folder->file("ras.mrk.json"));
  ASSERT_EQ(read.size(), 1U);
  EXPECT_EQ(read[0].label, "tip");
  EXPECT_EQ(read[0].point, (Point{-1, -2, 3}));
}

TEST_F(Registration_tool, follows_an_image_from_scale_to_scale) {
  const Outcome outcome =
      run(std::string("scale-space ") + EXTREMAL_MESH_3_DATA_DIR +
          "/skull_2.9.nrrd --iso 2.9 --sigma 12 16 -o scales.csv --events events.csv --plot scales.svg");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(read_text(folder->file("scales.csv")).find("\n1,16,"), std::string::npos);
  EXPECT_NE(read_text(folder->file("events.csv")).find("cancel"), std::string::npos);
  EXPECT_NE(read_text(folder->file("scales.svg")).find("umbilics"), std::string::npos);
}

TEST_F(Registration_tool, simplifies_by_the_life_times_of_a_scale_space) {
  std::filesystem::create_directory(folder->file("scales"));
  const Outcome scales = run(std::string("scale-space ") + EXTREMAL_MESH_3_DATA_DIR +
                             "/skull_2.9.nrrd --iso 2.9 --sigma 12 16 --graphs scales --quiet");
  ASSERT_EQ(scales.code, 0) << scales.err;
  const Extremal_mesh mesh = read_graphml(folder->file("scales/sigma_12.graphml"));
  std::size_t brief = 0;
  for (std::size_t v = 0; v < mesh.number_of_vertices(); ++v) {
    ASSERT_TRUE(mesh.vertex(v).life_time.has_value());
    brief += *mesh.vertex(v).life_time == 0;
  }
  EXPECT_GT(brief, 0U);
  const Outcome simple = run("simplify scales/sigma_12.graphml --measure life-time --threshold 0 -o simple.graphml");
  ASSERT_EQ(simple.code, 0) << simple.err;
  EXPECT_NE(simple.out.find("of life time 0"), std::string::npos) << simple.out;
  EXPECT_LT(read_graphml(folder->file("simple.graphml")).number_of_vertices(), mesh.number_of_vertices());
  EXPECT_NE(read_text(folder->file("simple.graphml")).find("\"measure\":\"life_time\""), std::string::npos);
  // by another name, and of a mesh without life times, it is refused
  EXPECT_EQ(run("simplify simple.graphml --measure age --gap -o x.graphml").code, 2);
  EXPECT_NE(run("simplify a.graphml --measure life-time --gap -o x.graphml").code, 0);
}
