// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs the program as users do, and looks at its exit code, what it prints and which files it leaves.
#include <CGAL/Extremal_mesh_3/check.h>
#include <CGAL/Extremal_mesh_3/io.h>

#include "hand_made.h"
#include "temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <fstream>
#include <limits>
#include <string>
#include <sys/wait.h>
#include <unistd.h>

using namespace CGAL::Extremal_mesh_3;

namespace {

const std::string ellipsoid = "extract --formula 'x^2/9+y^2/4+z^2-1' --box -4 -3 -2 4 3 2 --resolution 24 ";

struct Outcome {
  int code = -1;
  std::string out, err;
};

class Tool : public ::testing::Test {
protected:
  /// runs the program in the test's folder with arguments for a shell.
  Outcome run(const std::string& arguments) const {
    const Temporary_folder streams;
    const std::string command = "cd " + folder.path() + " && " + EXTREMAL_MESH_3_PROGRAM + " " + arguments + " > " +
                                streams.file("out") + " 2> " + streams.file("err");
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_text(streams.file("out")),
            read_text(streams.file("err"))};
  }

  /// the one sentence with which a command is refused, leaving no file.
  std::string refusal(const std::string& arguments, int code) const {
    const std::size_t files = folder.number_of_files();
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, code) << arguments << "\n" << outcome.err;
    EXPECT_EQ(outcome.out, "") << arguments;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_TRUE(outcome.err.starts_with("extremal_mesh: ")) << outcome.err;
    EXPECT_EQ(folder.number_of_files(), files) << arguments;
    return outcome.err;
  }

  static bool contains(const std::string& text, const std::string& part) { return text.find(part) != text.npos; }

  Temporary_folder folder;
};

/// an image of 8³ voxels with a ball in its middle.
void write_nrrd(const std::string& file) {
  std::string voxels;
  for (int k = 0; k < 8; ++k)
    for (int j = 0; j < 8; ++j)
      for (int i = 0; i < 8; ++i)
        voxels += std::hypot(i - 3.5, j - 3.5, k - 3.5) < 2.5 ? 'd' : '\n';
  write_text(file, "NRRD0004\ntype: unsigned char\ndimension: 3\nsizes: 8 8 8\nencoding: raw\n\n" + voxels);
}

} // namespace

TEST_F(Tool, views_a_graph) {
  ASSERT_EQ(run(ellipsoid + "-o e.graphml --cells e.ply -o at_once.png --size 160x120 --camera 0 1 0").code, 0);
  const Outcome outcome = run("view e.graphml --surface e.ply -o e.html -o e.png --size 160x120 --camera 0 1 0");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "e.html\ne.png\n");
  EXPECT_EQ(read_text(folder.file("e.png")), read_text(folder.file("at_once.png")));
  EXPECT_TRUE(read_text(folder.file("e.html")).starts_with("<!DOCTYPE html>"));
  EXPECT_TRUE(contains(refusal("view e.graphml", 2), "-o view.html"));
  EXPECT_TRUE(contains(refusal("view e.graphml -o e.graphml", 2), "an .html or a .png"));
  EXPECT_TRUE(contains(refusal("view e.graphml -o x.html --up 0 0 1 --view 0 0 2", 2), "two different directions"));
  EXPECT_TRUE(contains(refusal("view none.graphml -o x.html", 1), "none.graphml"));
  EXPECT_TRUE(contains(refusal("view e.graphml --surface e.graphml -o x.html", 1), "e.graphml"));
}

TEST_F(Tool, extracts_the_mesh_of_an_ellipsoid) { // MATHEMATICS 4: V, E, F = 10, 16, 8
  const Outcome outcome = run(ellipsoid + "-o out.graphml -o cells.off -o picture.png --size 200x150 --lines lines.off "
                                          "--cells patches.off --surface surface.off --report report.json");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  for (const std::string line : {"vertices        10  6 extremal_point, 4 umbilic\n", "4 lemon, 4 one-ridge\n",
                                 "edges           16  ", "cells            8  8 with 4 edges\n",
                                 "closed surface, 1 component, Euler characteristic 2, area ", "all hold\n"})
    EXPECT_TRUE(contains(outcome.out, line)) << outcome.out;
  EXPECT_EQ(folder.number_of_files(), 7U);
  const Extremal_mesh mesh = read_graphml(folder.file("out.graphml"));
  EXPECT_EQ(mesh.number_of_vertices(), 10U);
  EXPECT_TRUE(all_hold(CGAL::Extremal_mesh_3::check(mesh)));
  EXPECT_EQ(mesh.surface().source, "x^2/9+y^2/4+z^2-1");
  EXPECT_TRUE(contains(mesh.surface().parameters, "\"resolution\":24"));
  const std::string report = read_text(folder.file("report.json"));
  for (const std::string part :
       {"\"extremal_point\": 6", "\"lemon\": 4", "\"one_ridge\": 4", "\"edges\": 16", "\"max_largest\": 4",
        "\"cells\": 8", "\"4\": 8", "\"components\": 1", "\"euler_characteristic\": 2", "\"umbilic_index_sum\": 2.0",
        "\"euler\": true", "\"ok\": true", "\"uncertain_cells\": 0"})
    EXPECT_TRUE(contains(report, part)) << part;
  EXPECT_TRUE(read_text(folder.file("picture.png")).starts_with("\x89PNG"));
  for (const std::string file : {"cells.off", "lines.off", "patches.off", "surface.off"})
    EXPECT_TRUE(read_text(folder.file(file)).starts_with("OFF\n")) << file;
}

TEST_F(Tool, extracts_the_mesh_of_an_ellipsoid_by_cgals_mesher) {
  const Outcome outcome = run(ellipsoid + "--mesher cgal -o out.graphml");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(contains(outcome.out, "8 with 4 edges")) << outcome.out;
  EXPECT_TRUE(contains(read_graphml(folder.file("out.graphml")).surface().parameters, "\"mesher\":\"cgal\""));
  EXPECT_TRUE(contains(refusal(ellipsoid + "--mesher marching", 2), "--mesher grid or cgal"));
}

// Of the ellipsoid x² + 2y² + 4z² = 1: 6 vertices of the axes and 4 umbilics, joined by 16 lines.
TEST_F(Tool, extracts_the_mesh_of_a_polygon_mesh) {
  const std::string file = EXTREMAL_MESH_3_DATA_DIR "/ellipsoid_exact_poly.off";
  const Outcome outcome =
      run("extract " + file + " -o out.graphml -o out.png --surface surface.off --report report.json");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  for (const std::string line :
       {"fitted        3108  surface points with radius 0.", "vertices        10  6 extremal_point, 4 umbilic\n",
        "edges           16  ", "cells            8  8 with 4 edges\n", "all hold\n"})
    EXPECT_TRUE(contains(outcome.out, line)) << outcome.out;
  EXPECT_FALSE(contains(outcome.out, "repaired"));
  EXPECT_TRUE(contains(read_graphml(folder.file("out.graphml")).surface().parameters, "\"radii_used\":["));
  const std::string report = read_text(folder.file("report.json"));
  for (const std::string part :
       {"\"repairs\": {", "\"turned_faces\": 0", "\"fit\": {", "\"fitted\": 3108", "\"not_fitted\": 0"})
    EXPECT_TRUE(contains(report, part)) << part;
  EXPECT_TRUE(read_text(folder.file("surface.off")).starts_with("OFF\n3108 1556 "));
}

TEST_F(Tool, tells_what_was_repaired_and_takes_the_options_of_meshes) {
  const std::string command = "extract " EXTREMAL_MESH_3_DATA_DIR "/ellipe0.003.off --report report.json ";
  Outcome outcome = run(command + "--radius 0.4 --weld 1e-5 -o out.graphml");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(
      outcome.out.starts_with("repaired: 3108 faces turned\nfitted        1556  surface points with radius 0.4 "))
      << outcome.out;
  EXPECT_TRUE(contains(read_text(folder.file("report.json")), "\"turned_faces\": 3108"));
  const std::string parameters = read_graphml(folder.file("out.graphml")).surface().parameters;
  EXPECT_TRUE(contains(parameters, "\"weld\":1e-05,\"radius\":0.4,")) << parameters;
  outcome = run(command + "--rings 4 --quiet -o out.graphml");
  EXPECT_EQ(outcome.out + outcome.err, "");
  EXPECT_TRUE(contains(read_graphml(folder.file("out.graphml")).surface().parameters, "\"rings\":4"));
}

TEST_F(Tool, gives_the_same_bytes_every_time) {
  EXPECT_EQ(run(ellipsoid + "-o a.graphml --threads 1").code, 0);
  EXPECT_EQ(run(ellipsoid + "-o b.graphml").code, 0);
  EXPECT_EQ(read_text(folder.file("a.graphml")), read_text(folder.file("b.graphml")));
}

TEST_F(Tool, says_nothing_when_asked_to_be_quiet) {
  const Outcome outcome = run(ellipsoid + "-o out.graphml --quiet");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.out + outcome.err, "");
}

TEST_F(Tool, formulas_and_numbers_may_begin_with_a_minus) {
  const Outcome outcome =
      run("extract --formula '-1+x^2/.09+y^2/.04+z^2/.01' --box -.4 -.4 -.4 .4 .4 .4 --resolution 24");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(contains(outcome.out, "8 with 4 edges"));
}

TEST_F(Tool, info_and_check_read_graphs) {
  write_graphml(folder.file("mesh.graphml"), hand_made::ellipsoid());
  Outcome outcome = run("info mesh.graphml");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(contains(outcome.out, "10  6 extremal_point, 4 umbilic\n")) << outcome.out;
  outcome = run("info mesh.graphml --json");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_TRUE(outcome.out.starts_with("{\n")) << outcome.out;
  EXPECT_TRUE(contains(outcome.out, "\"extremal_point\": 6"));
  outcome = run("check mesh.graphml");
  EXPECT_TRUE(contains(outcome.out, "euler                  holds          2 = 2")) << outcome.out;
}

TEST_F(Tool, check_fails_if_an_identity_is_violated) {
  write_graphml(folder.file("mesh.graphml"), hand_made::ellipsoid());
  std::string text = read_text(folder.file("mesh.graphml"));
  const std::string right = "<data key=\"euler_characteristic\">2<";
  const std::size_t at = text.find(right);
  ASSERT_NE(at, text.npos);
  text.replace(at, right.size(), "<data key=\"euler_characteristic\">4<");
  write_text(folder.file("wrong.graphml"), text);
  Outcome outcome = run("check wrong.graphml");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_TRUE(contains(outcome.out, "euler                  violated       2 ≠ 4")) << outcome.out;
  outcome = run("check wrong.graphml --json");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_TRUE(contains(outcome.out, "\"euler\": false"));
  EXPECT_TRUE(contains(outcome.out, "\"ok\": false"));
  EXPECT_EQ(run("info wrong.graphml").code, 0);
}

TEST_F(Tool, writes_cells_as_off_and_ply_in_the_colours_asked_for) {
  EXPECT_EQ(run(ellipsoid + "-o a.graphml --cells a.ply --quiet").code, 0);
  EXPECT_EQ(run(ellipsoid + "--cells a.off --quiet").code, 0);
  EXPECT_EQ(run(ellipsoid + "-o a.png --size 160x120 --quiet").code, 0);
  EXPECT_EQ(run(ellipsoid + "-o b.graphml -o b.png --size 160x120 --cells b.ply --colour cell --quiet").code, 0);
  EXPECT_EQ(run(ellipsoid + "--cells b.off --colour cell --quiet").code, 0);
  const Cell_patches patches = read_cell_patches(folder.file("a.ply"));
  EXPECT_EQ(*std::max_element(patches.cell.begin(), patches.cell.end()), 7U);
  EXPECT_EQ(patches.points, read_cell_patches(folder.file("b.ply")).points);
  EXPECT_EQ(read_text(folder.file("a.graphml")), read_text(folder.file("b.graphml")));
  for (const std::string extension : {"ply", "off", "png"})
    EXPECT_NE(read_text(folder.file("a." + extension)), read_text(folder.file("b." + extension))) << extension;
  EXPECT_TRUE(contains(refusal(ellipsoid + "--cells a.obj", 2), "give an .off or a .ply"));
  EXPECT_TRUE(contains(refusal(ellipsoid + "--cells c.ply --colour red", 2), "--colour sign or cell"));
}

TEST_F(Tool, simplifies_to_what_is_asked_for) {
  // waves on an ellipsoid: some vertices more than its ten
  const std::string wavy = "extract --formula 'x^2/9+y^2/4+z^2-1+0.01*sin(3*x)*cos(4*y+1)+0.005*sin(7*z+2*x)' --box "
                           "-4 -3 -2 4 3 2 --resolution 32 --quiet -o wavy.graphml --cells wavy.ply";
  ASSERT_EQ(run(wavy).code, 0);
  const Extremal_mesh given = read_graphml(folder.file("wavy.graphml"));
  const auto simple = [&](const std::string& options) {
    const Outcome outcome = run("simplify wavy.graphml -o simple.graphml " + options);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_TRUE(contains(outcome.out, "before     " + std::to_string(given.number_of_vertices()) + " vertices, "));
    EXPECT_TRUE(contains(outcome.out, "all hold\n")) << outcome.out;
    const Extremal_mesh mesh = read_graphml(folder.file("simple.graphml"));
    EXPECT_TRUE(contains(outcome.out, "after      " + std::to_string(mesh.number_of_vertices()) + " vertices, "));
    EXPECT_TRUE(all_hold(CGAL::Extremal_mesh_3::check(mesh)));
    return mesh;
  };
  const std::size_t vertices = given.number_of_vertices(), cells = given.number_of_cells();
  ASSERT_GT(cells, 20U);
  EXPECT_EQ(simple("--level 0").number_of_vertices(), vertices);
  EXPECT_LT(simple("--level 1").number_of_vertices(), vertices);
  EXPECT_EQ(simple("--threshold 0").number_of_cells(), cells);
  const Extremal_mesh few = simple("--threshold 1e9");
  EXPECT_LE(simple("--cells 20").number_of_cells(), 20U);
  EXPECT_LE(simple("--vertices 20").number_of_vertices(), 20U);
  EXPECT_EQ(simple("--vertices 0").number_of_vertices(), few.number_of_vertices());
  EXPECT_LT(simple("--gap").number_of_vertices(), vertices);
  EXPECT_TRUE(contains(simple("--level 2").surface().parameters, "\"simplification\":{\"level\":2,"));
  // What cannot be reached is told.
  EXPECT_TRUE(contains(run("simplify wavy.graphml --cells 1 -o simple.graphml").out, "1 cells cannot be reached"));
  // Who keeps every crest line can simplify less.
  EXPECT_GT(simple("--threshold 1e9 --keep-crest 0").number_of_vertices(), few.number_of_vertices());
}

TEST_F(Tool, simplify_writes_surfaces_diagrams_and_tables) {
  ASSERT_EQ(run("extract --formula 'x^2/9+y^2/4+z^2-1+0.01*sin(3*x)*cos(4*y+1)+0.005*sin(7*z+2*x)' --box -4 -3 -2 4 3 "
                "2 --resolution 32 --quiet -o wavy.graphml --cells wavy.ply")
                .code,
            0);
  Outcome outcome = run("simplify wavy.graphml --vertices 20 --surface wavy.ply -o a.graphml -o a.png -o a.off --size "
                        "160x120 --patches a.ply --lines lines.off --persistence a.svg --hierarchy a.csv");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(folder.number_of_files(), 9U);
  const Extremal_mesh mesh = read_graphml(folder.file("a.graphml"));
  const Cell_patches given = read_cell_patches(folder.file("wavy.ply")),
                     patches = read_cell_patches(folder.file("a.ply"));
  EXPECT_EQ(patches.points, given.points);
  EXPECT_EQ(patches.corners, given.corners);
  std::vector<bool> met(mesh.number_of_cells(), false);
  for (const std::uint32_t c : patches.cell)
    met.at(c) = true;
  EXPECT_EQ(std::count(met.begin(), met.end(), false), 0);
  EXPECT_TRUE(read_text(folder.file("a.svg")).starts_with("<svg "));
  const std::string steps = read_text(folder.file("a.csv"));
  EXPECT_TRUE(steps.starts_with("level,operation,persistence,x,y,z,vertices,edges,cells,vanished\n1,")) << steps;
  // A diagram or a table alone needs no criterion.
  outcome = run("simplify wavy.graphml --persistence b.csv --hierarchy b_steps.csv --quiet");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(read_text(folder.file("b_steps.csv")), steps);
  const std::string diagram = read_text(folder.file("b.csv"));
  EXPECT_EQ(std::count(diagram.begin(), diagram.end(), '\n'), std::count(steps.begin(), steps.end(), '\n'));

  // The patches of another mesh.
  ASSERT_EQ(run(ellipsoid + "-o plain.graphml --quiet").code, 0);
  EXPECT_TRUE(contains(refusal("simplify plain.graphml --level 0 --surface wavy.ply -o b.png", 1),
                       "'wavy.ply' is not of the mesh in 'plain.graphml'"));
}

TEST_F(Tool, simplify_refuses_what_makes_no_sense) {
  write_graphml(folder.file("mesh.graphml"), hand_made::ellipsoid());
  const std::string command = "simplify mesh.graphml ";
  refusal("simplify", 2);
  EXPECT_TRUE(contains(refusal(command, 2), "nothing to write"));
  EXPECT_TRUE(contains(refusal(command + "--cells 3", 2), "nothing to write"));
  EXPECT_TRUE(contains(refusal(command + "-o a.graphml", 2), "not said how far"));
  EXPECT_TRUE(contains(refusal(command + "-o a.graphml --cells 3 --gap", 2), "2 ways"));
  refusal(command + "-o a.graphml --threshold 1 --level 3", 2);
  refusal(command + "-o a.graphml --threshold -1", 2);
  refusal(command + "-o a.graphml --threshold nan", 2);
  refusal(command + "-o a.graphml --threshold much", 2);
  refusal(command + "-o a.graphml --cells -1", 2);
  refusal(command + "-o a.graphml --vertices 1.5", 2);
  EXPECT_TRUE(contains(refusal(command + "-o a.graphml --level 100000", 2), "there is no level 100000"));
  refusal(command + "-o a.graphml --gap --keep-crest -1", 2);
  refusal(command + "-o a.graphml --gap --threads -1", 2);
  refusal(command + "-o a.stl --gap", 2);
  refusal(command + "--persistence a.pdf", 2);
  refusal(command + "--persistence a.csv --hierarchy a.csv", 2);
  EXPECT_TRUE(contains(refusal(command + "--gap --patches a.ply", 2), "--surface"));
  refusal(command + "--gap -o a.png --surface nothing.ply", 1);
  refusal("simplify nothing.graphml --gap -o a.graphml", 1);
  refusal(command + "--persistence none/a.svg", 1);
}

TEST_F(Tool, help_shows_an_example_of_each_command) {
  for (const std::string command : {"extract", "info", "check", "simplify"}) {
    const Outcome outcome = run(command + " --help");
    EXPECT_EQ(outcome.code, 0);
    EXPECT_TRUE(contains(outcome.out, "Example:\n  extremal_mesh " + command)) << outcome.out;
  }
  EXPECT_EQ(run("--help").code, 0);
  EXPECT_TRUE(run("--version").out.starts_with("extremal_mesh "));
}

TEST_F(Tool, wrong_command_lines_exit_with_2) {
  refusal("", 2);
  refusal("nonsense", 2);
  refusal("info", 2);
  refusal("extract --nonsense", 2);
  refusal("extract -o out.graphml", 2);
  refusal("extract --formula x", 2);
  refusal("extract --formula", 2);
  refusal("extract a.nrrd --formula x --box 0 0 0 1 1 1", 2);
  refusal("extract --formula x --box 0 0 0 1 1 1 --iso 3", 2);
  refusal("extract a.nrrd -o out.graphml", 2);
  refusal("extract a.nrrd --iso 3 --resolution 8", 2);
  refusal("extract a.nrrd --iso 3 --mesher cgal", 2);
  refusal("extract a.nrrd --iso 3 --radius 1", 2);
  refusal("extract a.off --certify", 2);
  refusal(ellipsoid + "--rings 3", 2);
  refusal(ellipsoid + "--weld 3", 2);
  refusal(ellipsoid + "--threads -1", 2);
  refusal(ellipsoid + "--max-level -1", 2);
  refusal(ellipsoid + "--max-level 1000", 2);
  EXPECT_TRUE(contains(refusal(ellipsoid + "--line-tolerance -0.1", 2), "the line tolerance is -0.1"));
  refusal(ellipsoid + "--line-tolerance nan", 2);
  refusal(ellipsoid + "--min-area -1", 2);
  refusal(ellipsoid + "--min-area 1 --largest", 2);
  EXPECT_TRUE(contains(refusal(ellipsoid + "--min-area 1000", 1), "no component"));
  refusal(ellipsoid + "--line-tolerance inf", 2);
  refusal(ellipsoid + "--line-tolerance small", 2);
}

TEST_F(Tool, wrong_formulas_exit_with_2_and_tell_where) {
  EXPECT_TRUE(contains(refusal("extract --formula 'x^2+' --box 0 0 0 1 1 1 -o out.graphml", 2), "formula"));
  refusal("extract --formula '' --box 0 0 0 1 1 1 -o out.graphml", 2);
  refusal("extract --formula 'x+w' --box 0 0 0 1 1 1 -o out.graphml", 2);
  refusal("extract --formula 'x\n+' --box 0 0 0 1 1 1 -o out.graphml", 2);
}

TEST_F(Tool, wrong_boxes_exit_with_2) {
  const std::string formula = "extract --formula 'x^2+y^2/2+z^2/3-1' -o out.graphml ";
  EXPECT_TRUE(
      contains(refusal(formula + "--box 2 2 2 -2 -2 -2", 2), "the box is empty: x0 = 2 is not less than x1 = -2"));
  EXPECT_TRUE(contains(refusal(formula + "--box -2 -2 1 2 2 1", 2), "z0 = 1"));
  refusal(formula + "--box -2 -2 -2 2 2", 2);
  refusal(formula + "--box -2 -2 -2 2 2 nan", 2);
  refusal(formula + "--box -2 -2 -2 2 2 inf", 2);
  refusal(formula + "--box -2 -2 -2 2 2 two", 2);
}

TEST_F(Tool, wrong_resolutions_exit_with_2_before_memory_is_taken) {
  const std::string command = "extract --formula 'x^2+y^2/2+z^2/3-1' --box -2 -2 -2 2 2 2 -o out.graphml --resolution ";
  for (const std::string resolution : {"0", "-5", "1000000000", "99999999999999999999", "12.5", "many"})
    refusal(command + resolution, 2);
}

TEST_F(Tool, wrong_outputs_are_told_before_the_work) {
  EXPECT_TRUE(contains(refusal(ellipsoid + "-o out.xyz", 2), "extension"));
  refusal(ellipsoid + "-o out", 2);
  refusal(ellipsoid + "-o a.off -o a.off", 2);
  refusal(ellipsoid + "-o a.png --size 3x", 2);
  refusal(ellipsoid + "-o a.png --size x", 2);
  refusal(ellipsoid + "-o a.png --size 99999x100", 2);
  EXPECT_TRUE(contains(refusal(ellipsoid + "-o none/out.graphml", 1), "the folder 'none' does not exist"));
  refusal(ellipsoid + "-o out.graphml --report none/report.json", 1);
  refusal(ellipsoid + "--report /dev/stdout", 1);
  refusal(ellipsoid + "--report /dev/fd/1", 1);
  refusal(ellipsoid + "--report .", 1);
}

TEST_F(Tool, surfaces_without_a_mesh_exit_with_1) {
  const std::string box = "--box -2 -2 -2 2 2 2 --resolution 16 -o out.graphml";
  refusal("extract --formula 'x^2+y^2+z^2+1' " + box, 1);   // nowhere
  refusal("extract --formula 'x^2+y^2+z^2-100' " + box, 1); // not in the box
  refusal("extract --formula '1' " + box, 1);
  refusal("extract --formula 'x^2+y^2+z^2-1' " + box, 1);     // a sphere
  refusal("extract --formula 'x+y/2+z/3' " + box, 1);         // a plane
  refusal("extract --formula 'x^2+y^2-1' " + box, 1);         // a cylinder
  refusal("extract --formula 'x^2/3+y^2/3+z^2-1' " + box, 1); // a surface of revolution
}

TEST_F(Tool, bad_images_exit_with_1) {
  const std::string options = " --iso 50 -o out.graphml";
  EXPECT_TRUE(contains(refusal("extract nothing.nrrd" + options, 1), "nothing.nrrd"));
  write_text(folder.file("empty.nrrd"), "");
  refusal("extract empty.nrrd" + options, 1);
  write_text(folder.file("text.nii"), "This is not an image.\n");
  refusal("extract text.nii" + options, 1);
  write_text(folder.file("image.xyz"), "?");
  refusal("extract image.xyz" + options, 1);
  refusal("extract ." + options, 1);
  write_nrrd(folder.file("ball.nrrd"));
  const std::string all = read_text(folder.file("ball.nrrd"));
  write_text(folder.file("truncated.nrrd"), all.substr(0, all.size() / 2));
  refusal("extract truncated.nrrd" + options, 1);
  refusal("extract ball.nrrd --iso 300 -o out.graphml", 1); // outside of the range of values
  refusal("extract ball.nrrd --iso nan -o out.graphml", 2);
  refusal("extract ball.nrrd --iso 50 --sigma -1 -o out.graphml", 2);
  refusal("extract ball.nrrd --iso 50 --sigma 0.01 -o out.graphml", 2);
}

TEST_F(Tool, bad_meshes_exit_with_1_and_wrong_options_for_them_with_2) {
  EXPECT_TRUE(contains(refusal("extract nothing.off -o out.graphml", 1), "nothing.off"));
  write_text(folder.file("a.off"), "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n");
  EXPECT_TRUE(
      contains(refusal("extract a.off -o out.graphml", 1), "line 6: expected the index of a vertex from 0 to 2"));
  write_text(folder.file("a.off"), "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  refusal("extract a.off -o out.graphml", 1); // too little to fit anything
  for (const std::string options :
       {"--iso 3", "--sigma 1", "--resolution 8", "--box 0 0 0 1 1 1", "--mesher cgal", "--radius 1 --rings 2",
        "--radius 0", "--radius -1", "--radius nan", "--radius inf", "--rings 0", "--rings -1", "--rings 99999",
        "--rings 1.5", "--line-tolerance 1", "--weld -1", "--weld 1"})
    refusal("extract a.off -o out.graphml " + options, 2);
}

TEST_F(Tool, bad_graphs_exit_with_1) {
  for (const std::string command : {"info ", "check "}) {
    EXPECT_TRUE(contains(refusal(command + "nothing.graphml", 1), "nothing.graphml"));
    write_text(folder.file("empty.graphml"), "");
    EXPECT_TRUE(contains(refusal(command + "empty.graphml", 1), "is empty"));
    write_text(folder.file("other.graphml"), "<graphml><graph/></graphml>");
    EXPECT_TRUE(contains(refusal(command + "other.graphml", 1), "extremal_mesh extract"));
    refusal(command + ".", 1);
  }
}

/// tells whether a process has a handler for SIGINT, which it installs some time after it started.
bool handles_interrupts(::pid_t process) {
  std::ifstream status("/proc/" + std::to_string(process) + "/status");
  for (std::string name; status >> name; status.ignore(std::numeric_limits<std::streamsize>::max(), '\n'))
    if (unsigned long long caught = 0; name == "SigCgt:" && status >> std::hex >> caught)
      return (caught >> (SIGINT - 1) & 1U) != 0;
  return false;
}

TEST_F(Tool, an_interrupt_leaves_no_file) {
  const ::pid_t child = ::fork();
  if (child == 0) {
    if (::chdir(folder.path().c_str()) != 0 || !std::freopen("/dev/null", "w", stderr))
      ::_exit(99);
    ::execl(EXTREMAL_MESH_3_PROGRAM, EXTREMAL_MESH_3_PROGRAM, "extract", "--formula",
            "x^2/9+y^2/4+z^2+sin(5*x)*sin(4*y)/9-1", "--box", "-4", "-3", "-2", "4", "3", "2", "--resolution", "1500",
            "-o", "out.graphml", static_cast<char*>(nullptr));
    ::_exit(99);
  }
  for (int i = 0; i < 600 && !handles_interrupts(child); ++i)
    ::usleep(100'000);
  ::usleep(300'000);
  ASSERT_EQ(::kill(child, SIGINT), 0);
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 130);
  EXPECT_EQ(folder.number_of_files(), 0U);
}
