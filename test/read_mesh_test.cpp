// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Mesh files of every format, whole, damaged and hostile.
#include <CGAL/Extremal_mesh_3/read_mesh.h>

#include "mesh_files.h"
#include "temporary_folder.h"

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Simple_cartesian.h>
#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <gtest/gtest.h>

using namespace CGAL::Extremal_mesh_3;
using meshes::Polygons;

namespace {

struct Traits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
};
using Open_mesh = OpenMesh::PolyMesh_ArrayKernelT<Traits>;

class Read_mesh : public ::testing::Test {
protected:
  Mesh read(const std::string& name, const std::string& content) const {
    write_text(folder.file(name), content);
    return read_mesh(folder.file(name));
  }

  /// reads what holds this very mesh.
  void expect(const std::string& name, const std::string& content, Polygons mesh) const {
    const Mesh result = read(name, content);
    Polygons found = mesh_files::polygons_of(result.cells);
    for (Polygons* polygons : {&mesh, &found}) // OM does not tell where faces begin
      for (auto& p : polygons->polygons)
        std::rotate(p.begin(), std::min_element(p.begin(), p.end()), p.end());
    EXPECT_EQ(found.points, mesh.points) << name;
    EXPECT_EQ(found.polygons, mesh.polygons) << name;
    EXPECT_FALSE(result.repairs.any()) << to_string(result.repairs);
  }

  /// the message of the `Io_error`, without the beginning that all have.
  std::string refusal(const std::string& name, const std::string& content) const {
    try {
      read(name, content);
    } catch (const Io_error& error) {
      const std::string message = error.what(), begin = "cannot read '" + folder.file(name) + "': ";
      EXPECT_TRUE(message.starts_with(begin)) << message;
      EXPECT_EQ(message.find('\n'), message.npos) << message;
      return message.substr(std::min(begin.size(), message.size()));
    }
    ADD_FAILURE() << name << " was read";
    return "";
  }

  /// cuts a file everywhere: it must be refused, or read as the rest of it stands.
  void cut(const std::string& name, const std::string& content) const {
    for (std::size_t n = 0; n < content.size(); ++n)
      try {
        EXPECT_GE(read(name, content.substr(0, n)).cells.number_of_cells(), 1U);
      } catch (const Io_error&) {
      }
  }

  /// changes a byte here and there.
  void damage(const std::string& name, const std::string& content) const {
    std::mt19937 random(7);
    for (int i = 0; i < 500; ++i) {
      std::string damaged = content;
      for (int k = 0; k < 3; ++k)
        damaged[random() % damaged.size()] = char(random());
      try {
        EXPECT_GE(read(name, damaged).cells.number_of_cells(), 1U);
      } catch (const Io_error&) {
      }
    }
  }

  std::string om() const {
    Open_mesh mesh;
    std::vector<Open_mesh::VertexHandle> vertices;
    for (const Point& p : prism.points)
      vertices.push_back(mesh.add_vertex({p[0], p[1], p[2]}));
    for (const auto& polygon : prism.polygons) {
      std::vector<Open_mesh::VertexHandle> face;
      for (const std::uint32_t corner : polygon)
        face.push_back(vertices[corner]);
      mesh.add_face(face);
    }
    // What is to be left out.
    mesh.request_vertex_normals();
    mesh.request_face_normals();
    mesh.request_face_status();
    mesh.update_normals();
    OpenMesh::VPropHandleT<double> quality;
    mesh.add_property(quality, "quality");
    mesh.property(quality).set_persistent(true);
    using OpenMesh::IO::Options;
    omlog().disable(); // it tells how many bytes it has written
    EXPECT_TRUE(OpenMesh::IO::write_mesh(mesh, folder.file("mesh.om"),
                                         Options(Options::VertexNormal | Options::FaceNormal | Options::Status)));
    return read_text(folder.file("mesh.om"));
  }

  const Polygons prism = mesh_files::prism();
  const Polygons tetrahedron = mesh_files::tetrahedron();
  Temporary_folder folder;
};

std::string replaced(std::string text, const std::string& part, const std::string& by) {
  const std::size_t at = text.find(part);
  EXPECT_NE(at, text.npos) << part;
  return text.replace(at, part.size(), by);
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != text.npos;
}

} // namespace

TEST_F(Read_mesh, reads_every_format_exactly) {
  expect("a.off", mesh_files::off(prism), prism);
  expect("a.obj", mesh_files::obj(prism), prism);
  expect("a.ply", mesh_files::ply_text(prism), prism);
  expect("a.ply", mesh_files::ply_binary(prism, std::endian::little), prism);
  expect("a.ply", mesh_files::ply_binary(prism, std::endian::big), prism);
  expect("a.om", om(), prism);
}

TEST_F(Read_mesh, stl_is_joined_at_equal_vertices) {
  Polygons in_order = tetrahedron; // vertices in the order in which STL has them first
  in_order.points = {tetrahedron.points[0], tetrahedron.points[2], tetrahedron.points[1], tetrahedron.points[3]};
  in_order.polygons = {{0, 1, 2}, {0, 2, 3}, {2, 1, 3}, {1, 0, 3}};
  expect("a.stl", mesh_files::stl_text(tetrahedron), in_order);
  expect("a.stl", mesh_files::stl_binary(tetrahedron), in_order);
}

TEST_F(Read_mesh, extensions_may_be_in_capitals) {
  expect("A.OFF", mesh_files::off(prism), prism);
  EXPECT_TRUE(is_mesh_file("folder.d/a.Stl"));
  EXPECT_FALSE(is_mesh_file("a.nrrd"));
  EXPECT_FALSE(is_mesh_file("off"));
  EXPECT_TRUE(contains(refusal("a.vtp", "?"), ".off .obj .ply .stl .om"));
}

TEST_F(Read_mesh, off_with_attributes_and_comments) {
  const std::string rest = "3 0 1 2 255 0 0\n3 0 2 3 # red\n\n3 0 3 1 1.0 0.5 0.25 1\n3 1 3 2\n";
  const Polygons expected{tetrahedron.points, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}};
  Polygons inwards = expected;
  for (auto& polygon : inwards.polygons)
    std::reverse(polygon.begin(), polygon.end());
  const auto read_points = [&](const std::string& content) {
    const Mesh mesh = read("a.off", content);
    EXPECT_EQ(mesh.cells.points, tetrahedron.points) << content;
    EXPECT_EQ(mesh.cells.number_of_cells(), 4U);
  };
  read_points(
      "# a comment\nCOFF # another\n4 4 6\n0 0 0 9 9 9 255\n1.5 0 0 1 2 3 4\n0 1.25 0 0.1 0.2 0.3 1\n0 0 2 0 0 0 0\n" +
      rest);
  read_points("NOFF\n4 4\n0 0 0 0 0 1\n1.5 0 0 0 0 1\n0 1.25 0 0 0 1\n0 0 2 0 0 1\n" + rest);
  read_points("STCNOFF 4 4 0\n0 0 0 0 0 1 2 3 4 5 6\r\n1.5 0 0\r\n0 1.25 0\r\n0 0 2\r\n" + rest);
  read_points("4 4 0\n0 0 0\n1.5 0 0\n0 1.25 0\n0 0 +2e0\n" + rest);
}

TEST_F(Read_mesh, obj_with_all_that_others_write) {
  const std::string content =
      "g\r\nv 0 0 0 1.0\r\nv\t1.5 0 0\nvn 0 0 1\nvt 0 1\n\nv 0 1.25 0 0.5 0.5 0.5\nl 1 2 3\np 1\n"
      "f 1/1/1\t3//1 2/2 # tabs and a comment\ns off\nusemtl x\nv 0 0 2\nf -4 -3 -1\n"
      "f 2 \\\n 3 4\nf 3/1 1/1 \\\r\n4/1\n";
  expect("a.obj", content, {tetrahedron.points, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}});
}

TEST_F(Read_mesh, ply_with_elements_and_types_of_all_kinds) {
  const std::string header =
      "ply\r\nformat ascii 1.0\r\nobj_info nothing\r\nelement face 4\r\nproperty float32 quality\r\n"
      "property list uint16 uint8 vertex_index\r\nproperty list int float texcoord\r\n"
      "element edge 2\r\nproperty int a\r\nelement vertex 4\r\nproperty int8 z\r\n"
      "property float nx\r\nproperty float64 x\r\nproperty float32 y\r\nend_header\r\n";
  const std::string faces = "0.5 3 0 2 1 6 0 0 0 0 0 0\nnan 3 0 1 3 0\n1 3 1 2 3 1 0.5\n1 3 2 0 3 0\n7\n8\n";
  expect("a.ply", header + faces + "0 1 0 0\n0 1 1.5 0\n0 1 0 1.25\n2 1 0 0\n", tetrahedron);
}

TEST_F(Read_mesh, stl_of_several_solids_in_capitals) {
  std::string twice = mesh_files::stl_text(tetrahedron);
  Polygons moved = tetrahedron;
  for (Point& p : moved.points)
    p[0] += 10;
  twice += mesh_files::stl_text(moved);
  std::transform(twice.begin(), twice.end(), twice.begin(), [](unsigned char c) { return char(std::toupper(c)); });
  const Mesh mesh = read("a.stl", twice);
  EXPECT_EQ(mesh.cells.points.size(), 8U);
  EXPECT_EQ(mesh.cells.euler_characteristic(), 4);
}

TEST_F(Read_mesh, errors_tell_the_place_and_what_was_expected) {
  const std::string off = mesh_files::off(prism);
  EXPECT_EQ(refusal("a.off", "PLY"), "line 1: expected the word OFF, found 'PLY'");
  EXPECT_EQ(refusal("a.off", "4OFF"), "line 1: expected OFF with vertices x y z, found '4'");
  EXPECT_EQ(refusal("a.off", replaced(off, " 1.5", " 1,5")), "line 4: expected a finite coordinate, found '1,5'");
  EXPECT_EQ(refusal("a.off", replaced(off, " 1.5", " nan")), "line 4: expected a finite coordinate, found 'nan'");
  EXPECT_EQ(refusal("a.off", replaced(off, " 1.5", " 1e999")), "line 4: expected a finite coordinate, found '1e999'");
  EXPECT_EQ(refusal("a.off", replaced(off, "3 0 2 1", "3 0 2 6")),
            "line 9: expected the index of a vertex from 0 to 5, found '6'");
  EXPECT_EQ(refusal("a.off", replaced(off, "3 0 2 1", "3 0 2 -1")),
            "line 9: expected the index of a vertex from 0 to 5, found '-1'");
  EXPECT_EQ(refusal("a.off", off.substr(0, off.size() - 3)),
            "line 13: expected a face's number of vertices, found 4, which is more than the rest of the file can hold");

  const std::string obj = mesh_files::obj(prism);
  EXPECT_EQ(refusal("a.obj", replaced(obj, "f 1 3 2", "f 1 3 0")),
            "line 10: expected the number of a vertex, with 6 before it, found '0'");
  EXPECT_EQ(refusal("a.obj", replaced(obj, "f 1 3 2", "f 1 3 -7")),
            "line 10: expected the number of a vertex, with 6 before it, found '-7'");
  EXPECT_EQ(refusal("a.obj", replaced(obj, "f 1 3 2", "f 1 3 7")),
            "line 10: expected the number of one of 6 vertices, found '7'");
  EXPECT_EQ(refusal("a.obj", replaced(obj, "f 1 3 2", "f 1 3 99999999999999999999")),
            "line 10: expected the number of a vertex, with 6 before it, found '99999999999999999999'");
  EXPECT_EQ(refusal("a.obj", "\x01\n"), "line 1: expected a keyword such as v or f, found '?'");
  EXPECT_EQ(refusal("a.obj", "v 0 0 0\n"), "expected at least one face, found none");

  const std::string ply = mesh_files::ply_text(prism), binary = mesh_files::ply_binary(prism, std::endian::big);
  EXPECT_EQ(refusal("a.ply", replaced(ply, "ascii", "ASCII")),
            "line 2: expected ascii, binary_little_endian or binary_big_endian, found 'ASCII'");
  EXPECT_EQ(refusal("a.ply", replaced(ply, "double z", "double w")),
            "its header: expected properties x, y and z of the element vertex");
  EXPECT_EQ(refusal("a.ply", replaced(ply, "vertex_indices", "corners")),
            "its header: expected a list vertex_indices of the element face");
  EXPECT_EQ(refusal("a.ply", replaced(ply, "list uchar int", "list uchar word")),
            "line 10: expected the type of a property, such as float or int, found 'word'");
  EXPECT_EQ(refusal("a.ply", replaced(ply, "3 0 2 1", "3 0 2 1.5")),
            "line 18: expected the index of a vertex from 0 to 5, found '1.5'");
  EXPECT_EQ(refusal("a.ply", replaced(ply, "3 0 2 1", "-3 0 2 1")),
            "line 18: expected the length of a list, found '-3'");
  EXPECT_TRUE(contains(refusal("a.ply", binary.substr(0, binary.size() - 4)), "found the end after"));

  EXPECT_EQ(refusal("a.stl", "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0\nvertex"),
            "line 5: expected a finite coordinate, found 'vertex'");
  EXPECT_EQ(refusal("a.stl", replaced(mesh_files::stl_binary(tetrahedron), mesh_files::bytes(1.5F),
                                      mesh_files::bytes(std::nanf("")))),
            "byte 120: expected a finite coordinate, found nan");
  EXPECT_EQ(refusal("a.om", "OFF"), "byte 0: expected the letters OM");
}

TEST_F(Read_mesh, headers_that_lie_take_no_memory) {
  const std::string huge = "1000000000000000000", larger = "99999999999999999999999";
  const std::string off = mesh_files::off(prism), ply = mesh_files::ply_text(prism);
  for (const std::string& n : {huge, larger}) {
    refusal("a.off", replaced(off, "6 5 0", n + " 5 0"));
    refusal("a.off", replaced(off, "6 5 0", "6 " + n + " 0"));
    refusal("a.off", replaced(off, "3 0 2 1", n + " 0 2 1"));
    refusal("a.ply", replaced(ply, "vertex 6", "vertex " + n));
    refusal("a.ply", replaced(ply, "face 5", "face " + n));
    refusal("a.ply", replaced(ply, "3 0 2 1", n + " 0 2 1"));
    for (const auto order : {std::endian::little, std::endian::big}) {
      refusal("a.ply", replaced(mesh_files::ply_binary(prism, order), "vertex 6", "vertex " + n));
      refusal("a.ply", replaced(mesh_files::ply_binary(prism, order), "face 5", "face " + n));
    }
  }
  refusal("a.off", replaced(off, "6 5 0", "-6 5 0"));
  refusal("a.ply", replaced(ply, "vertex 6", "vertex -6"));
  // Elements without properties take no bytes, however many there are.
  const Mesh mesh = read("a.ply", replaced(ply, "element face", "element nothing " + huge + "\nelement face"));
  EXPECT_EQ(mesh.cells.number_of_cells(), 5U);

  const std::string stl = mesh_files::stl_binary(tetrahedron), all_bits = "\xff\xff\xff\xff";
  refusal("a.stl", std::string(stl).replace(80, 4, all_bits));
  for (const std::size_t count : {4U, 12U}) // of vertices, of edges
    refusal("a.om", om().replace(count, 4, all_bits));
}

TEST_F(Read_mesh, files_that_hold_no_mesh) {
  for (const std::string extension : {".off", ".obj", ".ply", ".stl", ".om"}) {
    EXPECT_EQ(refusal("empty" + extension, ""), "it is empty");
    std::mt19937 random(3);
    std::string garbage;
    for (int i = 0; i < 10000; ++i)
      garbage += char(random());
    refusal("garbage" + extension, garbage);
    refusal("text" + extension, "This is not a mesh.\n");
    refusal("zeros" + extension, std::string(1000, '\0'));
  }
  refusal("none.off", "OFF\n0 0 0\n");
  refusal("none.stl", "solid nothing\nendsolid nothing\n");
  std::filesystem::create_directory(folder.file("folder.off"));
  for (const std::string name : {"missing.off", "folder.off"})
    EXPECT_THROW(read_mesh(folder.file(name)), Io_error);
  EXPECT_THROW(read_mesh("/dev/zero"), Io_error);
  EXPECT_THROW(read_mesh(""), Io_error);
}

TEST_F(Read_mesh, numbers_too_large_to_be_squared_are_refused) {
  Polygons mesh = prism;
  mesh.points[3][0] = -1e200;
  EXPECT_EQ(refusal("a.off", mesh_files::off(mesh)), "expected coordinates of at most 1e+100, found one of 1e+200");
}

TEST_F(Read_mesh, files_cut_anywhere_are_refused_or_read) {
  cut("a.off", mesh_files::off(prism));
  cut("a.obj", mesh_files::obj(prism));
  cut("a.ply", mesh_files::ply_text(prism));
  cut("a.ply", mesh_files::ply_binary(prism, std::endian::little));
  cut("a.ply", mesh_files::ply_binary(prism, std::endian::big));
  cut("a.stl", mesh_files::stl_text(tetrahedron));
  cut("a.stl", mesh_files::stl_binary(tetrahedron));
  cut("a.om", om());
}

TEST_F(Read_mesh, damaged_files_are_refused_or_read) {
  damage("a.off", mesh_files::off(prism));
  damage("a.obj", mesh_files::obj(prism));
  damage("a.ply", mesh_files::ply_text(prism));
  damage("a.ply", mesh_files::ply_binary(prism, std::endian::little));
  damage("a.stl", mesh_files::stl_text(tetrahedron));
  damage("a.stl", mesh_files::stl_binary(tetrahedron));
  damage("a.om", om());
}

#ifdef EXTREMAL_MESH_3_SHARED_DATA_DIR
TEST(Read_shared_mesh, finds_what_the_readers_of_CGAL_find) {
  std::size_t compared = 0;
  for (const auto& entry : std::filesystem::directory_iterator(EXTREMAL_MESH_3_SHARED_DATA_DIR "/meshes")) {
    const std::string file = entry.path().string();
    std::vector<CGAL::Simple_cartesian<double>::Point_3> points;
    std::vector<std::vector<std::uint32_t>> polygons;
    ASSERT_TRUE(CGAL::IO::read_polygon_soup(file, points, polygons)) << file;
    const Mesh mesh = read_mesh(file);
    if (mesh.repairs.any())
      continue;
    ++compared;
    const Polygons found = mesh_files::polygons_of(mesh.cells);
    EXPECT_EQ(found.polygons, polygons) << file;
    ASSERT_EQ(found.points.size(), points.size()) << file;
    for (std::size_t i = 0; i < points.size(); ++i)
      ASSERT_EQ(found.points[i], (Point{points[i].x(), points[i].y(), points[i].z()})) << file;
  }
  EXPECT_GE(compared, 10U);
}
#endif
