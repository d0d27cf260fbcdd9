// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Images that are too large for memory are read piece by piece into a file that is mapped.
#include "temporary_folder.h"

#include <CGAL/Extremal_mesh_3/Image.h>
#include <CGAL/Extremal_mesh_3/Image_function.h>
#include <CGAL/Extremal_mesh_3/extract_extremal_mesh.h>
#include <CGAL/Extremal_mesh_3/io.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace CGAL::Extremal_mesh_3 {
namespace {

constexpr const char* folder = EXTREMAL_MESH_3_SCRATCH_DIR;

Image read_into_file(const std::string& file) {
  return read_image(file, {.memory_limit = 1000, .scratch_folder = folder});
}

void expect_same(const Image& a, const Image& b, const std::string& what) {
  EXPECT_EQ(a.lattice.size, b.lattice.size) << what;
  ASSERT_EQ(a.voxels.size(), b.voxels.size()) << what;
  EXPECT_EQ(std::memcmp(a.voxels.data(), b.voxels.data(), a.voxels.size() * sizeof(float)), 0) << what;
}

std::string error_of(const std::string& file, const Image_reading_options& options) {
  try {
    read_image(file, options);
  } catch (const Io_error& error) {
    return error.what();
  }
  return "";
}

/// A build folder may be in memory: then there is no place for the file.
class Voxels_in_a_file : public testing::Test {
protected:
  void SetUp() override {
    if (error_of(EXTREMAL_MESH_3_DATA_DIR "/headsq.nii.gz", {.memory_limit = 1000, .scratch_folder = folder})
            .find("kept in memory") != std::string::npos)
      GTEST_SKIP() << folder << " is in memory";
  }
};
using The_program = Voxels_in_a_file;

/// an NRRD file of 6 × 5 × 4 numbers from −60 on, or from 0 if they have no sign.
template <class Number> std::string nrrd(const char* type, bool big_endian) {
  std::string text = "NRRD0004\ndimension: 3\nsizes: 6 5 4\nencoding: raw\ntype: ";
  text += type;
  text += big_endian ? "\nendian: big\n\n" : "\nendian: little\n\n";
  for (int i = 0; i < 120; ++i) {
    const auto number = static_cast<Number>(std::is_signed_v<Number> ? i - 60 : i);
    std::array<char, sizeof number> bytes;
    std::memcpy(bytes.data(), &number, sizeof number);
    if (big_endian == (std::endian::native == std::endian::little))
      std::reverse(bytes.begin(), bytes.end());
    for (const char byte : bytes)
      text.push_back(byte);
  }
  return text;
}

TEST_F(Voxels_in_a_file, are_those_that_are_read_into_memory) {
  for (const std::string file :
       {EXTREMAL_MESH_3_DATA_DIR "/headsq.nii.gz", EXTREMAL_MESH_3_DATA_DIR "/skull_2.9.nrrd"}) {
    const Image in_memory = read_image(file), in_file = read_into_file(file);
    EXPECT_FALSE(in_memory.voxels.get_allocator().is_in_file());
    EXPECT_TRUE(in_file.voxels.get_allocator().is_in_file());
    expect_same(in_memory, in_file, file);
  }
}

TEST_F(Voxels_in_a_file, are_of_any_type_in_either_byte_order) {
  const Temporary_folder temporary;
  const auto check = [&](const std::string& content, const std::string& what) {
    const std::string file = temporary.file("a.nrrd");
    std::ofstream(file, std::ios::binary) << content;
    const Image image = read_image(file, {.memory_limit = 100, .scratch_folder = folder});
    EXPECT_TRUE(image.voxels.get_allocator().is_in_file()) << what;
    EXPECT_EQ(image.voxels[7] - image.voxels[0], 7) << what;
    expect_same(image, read_image(file), what);
  };
  for (const bool big : {false, true}) {
    check(nrrd<signed char>("signed char", big), "signed char");
    check(nrrd<unsigned char>("uchar", big), "uchar");
    check(nrrd<short>("short", big), "short");
    check(nrrd<unsigned short>("ushort", big), "ushort");
    check(nrrd<int>("int", big), "int");
    check(nrrd<unsigned>("uint", big), "uint");
    check(nrrd<float>("float", big), "float");
    check(nrrd<double>("double", big), "double");
  }
}

TEST_F(Voxels_in_a_file, give_the_same_mesh) {
  const std::string file = EXTREMAL_MESH_3_DATA_DIR "/skull_2.9.nrrd";
  const auto graphml = [](const Image& image, double sigma) {
    Image_function_options options;
    options.iso = 2.9;
    options.sigma = sigma;
    const Image_function f(image, options);
    const Temporary_folder temporary;
    const std::string graph = temporary.file("a.graphml");
    write_graphml(graph, extract_extremal_mesh(f, f.lattice(), Extraction_options()).mesh);
    return read_text(graph);
  };
  const Image in_memory = read_image(file), in_file = read_into_file(file);
  EXPECT_EQ(graphml(in_memory, 12), graphml(in_file, 12));
}

TEST_F(Voxels_in_a_file, leave_nothing_in_the_folder) {
  const Temporary_folder temporary;
  const std::string file = EXTREMAL_MESH_3_DATA_DIR "/headsq.nii.gz";
  Image_reading_options options{.memory_limit = 1000, .scratch_folder = temporary.path()};
  if (error_of(file, options).find("kept in memory") != std::string::npos)
    GTEST_SKIP() << "the folder for temporary files is in memory";
  Image image = read_image(file, options);
  EXPECT_EQ(temporary.number_of_files(), 0U);
  const Image copy = image;
  EXPECT_TRUE(copy.voxels.get_allocator().is_in_file());
  EXPECT_EQ(copy.voxels, image.voxels);
  EXPECT_EQ(temporary.number_of_files(), 0U);
}

TEST_F(Voxels_in_a_file, need_a_folder_that_can_hold_it) {
  const std::string file = EXTREMAL_MESH_3_DATA_DIR "/headsq.nii.gz";
  const std::string error = error_of(file, {.memory_limit = 1000, .scratch_folder = "/nowhere"});
  EXPECT_NE(error.find("temporary file of 1 MB"), std::string::npos) << error;
  EXPECT_NE(error.find("'/nowhere': No such file or directory"), std::string::npos) << error;
  EXPECT_NE(error.find("TMPDIR"), std::string::npos) << error;
}

TEST_F(Voxels_in_a_file, are_not_read_from_text) {
  const Temporary_folder temporary;
  std::ofstream out(temporary.file("a.nrrd"));
  out << "NRRD0004\ntype: int\ndimension: 3\nsizes: 10 10 10\nencoding: ascii\n\n";
  for (int i = 0; i < 1000; ++i)
    out << i << '\n';
  out.close();
  const std::string error = error_of(temporary.file("a.nrrd"), {.memory_limit = 1000, .scratch_folder = folder});
  EXPECT_NE(error.find("more than"), std::string::npos) << error;
}

/// an ellipsoid, the voxels being floats.
void write_ellipsoid(const std::string& file, int n) {
  std::ofstream out(file, std::ios::binary);
  out << "NRRD0004\ntype: float\ndimension: 3\nsizes: " << n << ' ' << n << ' ' << n
      << "\nspacings: 1 1 1\nencoding: raw\nendian: " << (std::endian::native == std::endian::little ? "little" : "big")
      << "\n\n";
  const auto square = [&](int i, double axis) { return std::pow((i - 0.5 * n + 0.5) / axis, 2); };
  std::vector<float> row(std::size_t(n), 0);
  for (int k = 0; k < n; ++k)
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i < n; ++i)
        row[std::size_t(i)] = float(100 * std::min(3.0, square(i, 30) + square(j, 22) + square(k, 18)));
      out.write(reinterpret_cast<const char*>(row.data()), std::streamsize(row.size() * sizeof(float)));
    }
}

TEST_F(The_program, works_with_half_the_memory_that_the_volume_takes) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "a sanitizer takes more memory";
#endif
  const Temporary_folder temporary;
  write_ellipsoid(temporary.file("a.nrrd"), 256);
  const auto graph = [&](const std::string& arguments, const std::string& name) {
    const std::string command = std::string("cd ") + temporary.path() + " && TMPDIR=" + folder + " " +
                                EXTREMAL_MESH_3_PROGRAM + " extract a.nrrd --iso 100 --sigma 1.5 --quiet " + arguments +
                                " -o " + name;
    EXPECT_EQ(std::system(command.c_str()), 0) << command;
    return read_text(temporary.file(name));
  };
  const std::string in_memory = graph("", "a.graphml");
  EXPECT_NE(in_memory.find("extremal_point"), std::string::npos);
  EXPECT_EQ(in_memory, graph("--memory-limit 32M", "b.graphml"));
}

#ifdef EXTREMAL_MESH_3_SHARED_DATA_DIR

TEST_F(Voxels_in_a_file, are_the_same_in_every_encoding) {
  const std::string start = EXTREMAL_MESH_3_SHARED_DATA_DIR "/volumes/headsq_formats/headsq";
  for (const char* name : {"_raw.nrrd", "_bigendian.nrrd", "_float.nrrd", "_detached.nhdr", ".mha", ".mhd", "_z.mhd",
                           ".nii", ".nii.gz", ".vtk", "_uint8.nrrd"}) {
    const Image in_file = read_into_file(start + name);
    EXPECT_TRUE(in_file.voxels.get_allocator().is_in_file()) << name;
    expect_same(read_image(start + name), in_file, name);
  }
}

#endif

} // namespace
} // namespace CGAL::Extremal_mesh_3
