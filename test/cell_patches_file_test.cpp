// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The surface cut along the lines in files: PLY that is read back, and the colours of cells.
#include <CGAL/Extremal_mesh_3/Formula.h>
#include <CGAL/Extremal_mesh_3/io.h>
#include <CGAL/Extremal_mesh_3/read_mesh.h>

#include "hand_made.h"
#include "surfaces.h"
#include "temporary_folder.h"

#include <cstring>
#include <map>
#include <set>

using namespace CGAL::Extremal_mesh_3;

namespace {

const Extraction& extraction() {
  static const Extraction result = [] {
    Extraction_options options;
    options.patches = true;
    return extract_extremal_mesh(Formula("x^2+1.3*y^2+1.7*z^2+0.2*x^3+0.15*y^3-0.4*x*y*z+0.2*x^2*z+0.1*x*y^2-1"),
                                 make_lattice({-1.4, -1.4, -1.4}, {1.4, 1.4, 1.4}, 16), options);
  }();
  return result;
}

void expect_equal(const Cell_patches& a, const Cell_patches& b) {
  EXPECT_EQ(a.points, b.points);
  EXPECT_EQ(a.normals, b.normals);
  EXPECT_EQ(a.begin, b.begin);
  EXPECT_EQ(a.corners, b.corners);
  EXPECT_EQ(a.cell, b.cell);
}

/// An OFF file's colours, by what comes after the corners of each face.
std::vector<std::vector<int>> colours_in(const std::string& file) {
  std::istringstream in(read_text(file));
  std::string line;
  std::size_t points = 0, faces = 0;
  in >> line >> points >> faces;
  std::getline(in, line);
  for (std::size_t i = 0; i < points; ++i)
    std::getline(in, line);
  std::vector<std::vector<int>> colours(faces);
  for (std::vector<int>& colour : colours) {
    std::getline(in, line);
    std::istringstream words(line);
    std::size_t n = 0, corner = 0;
    words >> n;
    for (std::size_t i = 0; i < n; ++i)
      words >> corner;
    for (int part = 0; words >> part;)
      colour.push_back(part);
  }
  return colours;
}

class Cell_patches_file : public ::testing::Test {
protected:
  Temporary_folder folder;
  std::string file = folder.file("cells.ply");

  /// the message with which a file is refused.
  std::string refusal(const std::string& content) {
    write_text(file, content);
    try {
      read_cell_patches(file);
    } catch (const Io_error& error) {
      EXPECT_TRUE(std::string(error.what()).starts_with("cannot read '" + file + "': ")) << error.what();
      return error.what();
    }
    ADD_FAILURE() << "was read:\n" << content;
    return {};
  }
  static bool contains(const std::string& text, const std::string& part) { return text.find(part) != text.npos; }
};

const std::string text_header = "ply\nformat ascii 1.0\nelement vertex 3\n"
                                "property float x\nproperty float y\nproperty float z\n"
                                "property float nx\nproperty float ny\nproperty float nz\nproperty uchar quality\n"
                                "element face 1\nproperty list uchar uint vertex_indices\nproperty int cell\n"
                                "end_header\n";
const std::string text_points = "0 0 0 0 0 1 9\n1 0 0 0 0 1 9\n0 1 0 0 0 1 9\n";

} // namespace

TEST_F(Cell_patches_file, is_read_back_bit_for_bit) {
  for (const Cell_colouring colouring : {Cell_colouring::sign, Cell_colouring::cell}) {
    write_ply(file, extraction().patches, extraction().mesh, colouring);
    expect_equal(read_cell_patches(file), extraction().patches);
  }
  write_ply(file, Cell_patches(), extraction().mesh);
  expect_equal(read_cell_patches(file), Cell_patches());
}

TEST_F(Cell_patches_file, may_have_polygons_of_more_corners_than_a_byte_counts) {
  Cell_patches patches;
  for (std::uint32_t i = 0; i < 300; ++i) {
    const double angle = 2 * std::numbers::pi * i / 300;
    patches.points.push_back({std::cos(angle), std::sin(angle), 0});
    patches.normals.push_back({0, 0, 1});
    patches.corners.push_back(i);
  }
  patches.begin.push_back(300);
  patches.cell.push_back(2);
  write_ply(file, patches, hand_made::ellipsoid());
  expect_equal(read_cell_patches(file), patches);
}

TEST_F(Cell_patches_file, is_a_mesh_for_others) {
  write_ply(file, extraction().patches, extraction().mesh);
  const Mesh mesh = read_mesh(file);
  EXPECT_FALSE(mesh.repairs.any());
  EXPECT_EQ(mesh.cells.points, extraction().patches.points);
  EXPECT_EQ(mesh.cells.number_of_cells(), extraction().patches.cell.size());
}

TEST_F(Cell_patches_file, tells_the_frame) {
  write_ply(file, hand_made::octants(), hand_made::ellipsoid());
  EXPECT_FALSE(contains(read_text(file).substr(0, 400), "frame"));
  Extremal_mesh mesh = hand_made::ellipsoid();
  mesh.set_provenance("", "", "LPS");
  write_ply(file, hand_made::octants(), mesh);
  EXPECT_TRUE(contains(read_text(file), "\ncomment frame LPS\n"));
  mesh.set_provenance("", "", "a\nb"); // ends no line of the header
  write_ply(file, hand_made::octants(), mesh);
  EXPECT_TRUE(contains(read_text(file), "\ncomment frame a b\n"));
  expect_equal(read_cell_patches(file), hand_made::octants());
}

TEST_F(Cell_patches_file, is_read_as_others_write_it) {
  write_text(file, text_header + text_points + "3 0 1 2 5\n");
  const Cell_patches patches = read_cell_patches(file);
  EXPECT_EQ(patches.points, (std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  EXPECT_EQ(patches.normals, std::vector<Vector>(3, Vector{0, 0, 1}));
  EXPECT_EQ(patches.corners, (std::vector<std::uint32_t>{0, 1, 2}));
  EXPECT_EQ(patches.begin, (std::vector<std::size_t>{0, 3}));
  EXPECT_EQ(patches.cell, std::vector<std::uint32_t>{5});
}

TEST_F(Cell_patches_file, that_is_wrong_is_refused_with_the_place) {
  EXPECT_TRUE(contains(refusal(text_header + text_points + "3 0 1 3 5\n"), "line 18: expected the index of a vertex"));
  EXPECT_TRUE(contains(refusal(text_header + text_points + "3 0 1 2 -5\n"), "line 18: expected the number of a cell"));
  EXPECT_TRUE(contains(refusal(text_header + text_points + "3 0 1 2 0.5\n"), "expected the number of a cell"));
  EXPECT_TRUE(contains(refusal(text_header + text_points + "1 0 5\n"), "expected a polygon of at least two corners"));
  EXPECT_TRUE(contains(refusal(text_header + text_points + "3 0 1 2"), "line 18: expected the number of a cell"));
  EXPECT_TRUE(contains(refusal(text_header + "0 0 nan 0 0 1 9\n"), "line 15: expected a"));
  EXPECT_TRUE(contains(refusal(""), "it is empty"));
  EXPECT_TRUE(contains(refusal("OFF\n"), "line 1: expected the word ply"));
  const auto without = [&](const std::string& line) {
    std::string text = text_header + text_points + "3 0 1 2 5\n";
    return text.erase(text.find(line), line.size());
  };
  EXPECT_TRUE(contains(refusal(without("property int cell\n")), "expected a property cell of the element face"));
  EXPECT_TRUE(contains(refusal(without("property float ny\n")), "expected a property ny of the element vertex"));
  EXPECT_TRUE(contains(refusal("ply\nformat ascii 1.0\nend_header\n"), "expected an element vertex"));
  EXPECT_THROW(read_cell_patches(folder.file("nothing.ply")), Io_error);
  EXPECT_THROW(read_cell_patches(folder.path()), Io_error);
}

TEST_F(Cell_patches_file, that_is_truncated_is_refused_wherever_it_ends) {
  write_ply(file, hand_made::octants(2), hand_made::ellipsoid());
  const std::string all = read_text(file);
  for (std::size_t n = 0; n < all.size(); ++n)
    refusal(all.substr(0, n));
}

TEST_F(Cell_patches_file, takes_no_memory_for_what_a_header_promises) {
  std::string text = text_header + text_points + "3 0 1 2 5\n";
  text.replace(text.find("face 1"), 6, "face 99999999999999");
  refusal(text);
  text = text_header + text_points + "250 0 1 2 5\n";
  refusal(text);
}

TEST_F(Cell_patches_file, is_not_written_for_another_mesh) {
  EXPECT_THROW(write_ply(file, extraction().patches, hand_made::ellipsoid()), std::invalid_argument);
  EXPECT_THROW(write_off(file, extraction().patches, hand_made::ellipsoid()), std::invalid_argument);
  EXPECT_EQ(folder.number_of_files(), 0U);
}

TEST_F(Cell_patches_file, tells_cells_apart_by_colours_of_their_own) {
  const Extremal_mesh& mesh = extraction().mesh;
  write_off(file, extraction().patches, mesh, Cell_colouring::cell);
  const auto colours = colours_in(file);
  ASSERT_EQ(colours.size(), extraction().patches.cell.size());
  std::map<std::uint32_t, std::vector<int>> colour_of;
  for (std::size_t i = 0; i < colours.size(); ++i) {
    ASSERT_EQ(colours[i].size(), 3U);
    EXPECT_EQ(colour_of.try_emplace(extraction().patches.cell[i], colours[i]).first->second, colours[i]);
  }
  ASSERT_EQ(colour_of.size(), mesh.number_of_cells());
  // Around each vertex all are different; a vertex has at most six cells.
  for (std::size_t v = 0; v < mesh.number_of_vertices(); ++v) {
    std::set<std::uint32_t> cells;
    for (const Half_edge h : mesh.vertex(v).star)
      cells.insert(mesh.left_cell(h));
    std::set<std::vector<int>> met;
    for (const std::uint32_t c : cells)
      met.insert(colour_of.at(c));
    EXPECT_EQ(met.size(), cells.size()) << "at vertex " << v;
  }
  EXPECT_GT(std::set<std::vector<int>>(colours.begin(), colours.end()).size(), 8U);
  write_off(file, extraction().patches, mesh);
  const auto by_sign = colours_in(file);
  EXPECT_EQ(std::set<std::vector<int>>(by_sign.begin(), by_sign.end()).size(), 2U);
}

TEST_F(Cell_patches_file, writes_the_same_colours_in_off_and_ply) {
  write_off(file, hand_made::octants(1), hand_made::ellipsoid(), Cell_colouring::cell);
  const auto in_off = colours_in(file);
  write_ply(file, hand_made::octants(1), hand_made::ellipsoid(), Cell_colouring::cell);
  const std::string content = read_text(file);
  // 8 triangles at the end: a byte, three corners, the colour, the cell.
  constexpr std::size_t size = 1 + 3 * 4 + 3 + 4;
  for (std::size_t i = 0; i < 8; ++i) {
    const std::string face = content.substr(content.size() - (8 - i) * size, size);
    EXPECT_EQ(face[0], 3);
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_EQ(int(static_cast<unsigned char>(face[13 + k])), in_off[i][k]) << i;
    EXPECT_EQ(std::size_t(face[16]), i);
  }
}
