// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "temporary_folder.h"

#include <CGAL/Extremal_mesh_3/Image.h>

#include "../src/io/base64.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <fstream>
#include <gtest/gtest.h>
#include <string>
#include <zlib.h>

namespace CGAL::Extremal_mesh_3 {
namespace {

constexpr std::size_t n = 6 * 5 * 4;

template <class Number> std::string bytes_of(const std::vector<Number>& numbers, bool big_endian) {
  std::string all;
  for (Number number : numbers) {
    std::string bytes(sizeof number, '\0');
    std::memcpy(bytes.data(), &number, sizeof number);
    if (big_endian == (std::endian::native == std::endian::little))
      std::reverse(bytes.begin(), bytes.end());
    all += bytes;
  }
  return all;
}

template <class Number> std::vector<Number> voxels() {
  std::vector<Number> all;
  for (std::size_t i = 0; i < n; ++i)
    all.push_back(Number(3 * i % 100));
  return all;
}

std::string zlibbed(const std::string& bytes) {
  uLongf length = ::compressBound(uLong(bytes.size()));
  std::string out(length, '\0');
  ::compress(reinterpret_cast<Bytef*>(out.data()), &length, reinterpret_cast<const Bytef*>(bytes.data()),
             uLong(bytes.size()));
  out.resize(length);
  return out;
}

/// the numbers in front of an array in blocks of 100 bytes, and the blocks.
struct Blocks {
  std::string sizes, data;
};
Blocks blocks_of(const std::string& bytes) {
  constexpr std::size_t length = 100;
  std::vector<std::uint32_t> sizes{std::uint32_t((bytes.size() + length - 1) / length), length,
                                   std::uint32_t(bytes.size() % length)};
  Blocks blocks;
  for (std::size_t at = 0; at < bytes.size(); at += length) {
    const std::string block = zlibbed(bytes.substr(at, length));
    sizes.push_back(std::uint32_t(block.size()));
    blocks.data += block;
  }
  blocks.sizes = bytes_of(sizes, false);
  return blocks;
}

class Read_vti : public ::testing::Test {
protected:
  std::string write(const std::string& content) const {
    std::ofstream(folder.file("a.vti"), std::ios::binary) << content;
    return folder.file("a.vti");
  }
  std::string error_of(const std::string& content) const {
    const std::string file = write(content);
    try {
      read_image(file);
    } catch (const Io_error& error) {
      return error.what();
    }
    return "";
  }
  void expect_the_volume(const std::string& content, const char* what) const {
    const Image image = read_image(write(content));
    EXPECT_EQ(image.lattice.size, (std::array<std::size_t, 3>{6, 5, 4})) << what;
    ASSERT_EQ(image.voxels.size(), n) << what;
    for (std::size_t i = 0; i < n; ++i)
      ASSERT_EQ(image.voxels[i], float(3 * i % 100)) << what << ", voxel " << i;
  }
  Temporary_folder folder;
};

std::string file_of(const std::string& attributes, const std::string& array, const std::string& appended = "",
                    const std::string& geometry = R"(Origin="1 2 3" Spacing="0.5 1 2")") {
  std::string text = R"(<?xml version="1.0"?><VTKFile type="ImageData" version="1.0" )";
  text += attributes;
  text += R"(><ImageData WholeExtent="0 5 0 4 0 3" )";
  text += geometry;
  text +=
      R"(><Piece Extent="0 5 0 4 0 3"><PointData Scalars="s"><DataArray Name="v" type="Float32" NumberOfComponents="3" )"
      R"(format="ascii">1 2 3</DataArray><DataArray Name="s" )";
  text += array;
  text += "</DataArray></PointData></Piece></ImageData>";
  text += appended;
  text += "</VTKFile>";
  return text;
}

constexpr const char* little = R"(byte_order="LittleEndian" header_type="UInt32")";

TEST_F(Read_vti, reads_text) {
  std::string text;
  for (const int value : voxels<int>()) {
    text += std::to_string(value);
    text += '\n';
  }
  expect_the_volume(file_of(little, R"(type="Int16" format="ascii">)" + text), "text");
}

TEST_F(Read_vti, reads_base64_of_any_type_in_either_byte_order) {
  const auto check = [&](const char* type, const auto& numbers) {
    for (const bool big : {false, true})
      for (const bool wide : {false, true}) {
        const std::string bytes = bytes_of(numbers, big);
        const std::string size = wide ? bytes_of(std::vector<std::uint64_t>{bytes.size()}, big)
                                      : bytes_of(std::vector<std::uint32_t>{std::uint32_t(bytes.size())}, big);
        std::string attributes = big ? R"(byte_order="BigEndian" )" : R"(byte_order="LittleEndian" )";
        attributes += wide ? R"(header_type="UInt64")" : R"(header_type="UInt32")";
        std::string start = R"(type=")";
        start += type;
        start += R"(" format="binary">)";
        // VTK has had both: one text for all, and one for the length.
        expect_the_volume(file_of(attributes, start + base64(size + bytes)), type);
        expect_the_volume(file_of(attributes, start + base64(size) + base64(bytes)), type);
      }
  };
  check("Int8", voxels<std::int8_t>());
  check("UInt8", voxels<std::uint8_t>());
  check("Int16", voxels<std::int16_t>());
  check("UInt16", voxels<std::uint16_t>());
  check("Int32", voxels<std::int32_t>());
  check("UInt32", voxels<std::uint32_t>());
  check("Int64", voxels<std::int64_t>());
  check("UInt64", voxels<std::uint64_t>());
  check("Float32", voxels<float>());
  check("Float64", voxels<double>());
}

TEST_F(Read_vti, reads_compressed_and_appended_arrays) {
  const std::string bytes = bytes_of(voxels<std::int16_t>(), false);
  const std::string size = bytes_of(std::vector<std::uint32_t>{std::uint32_t(bytes.size())}, false);
  const Blocks blocks = blocks_of(bytes);
  std::string compressed = little;
  compressed += R"( compressor="vtkZLibDataCompressor")";
  expect_the_volume(
      file_of(compressed, R"(type="Int16" format="binary">)" + base64(blocks.sizes) + base64(blocks.data)),
      "compressed");
  const std::string at_3 = R"(type="Int16" format="appended" offset="3">)";
  const std::string raw = R"(<AppendedData encoding="raw"> _...)", text = R"(<AppendedData encoding="base64"> _AAAA)";
  expect_the_volume(file_of(little, at_3, raw + size + bytes + "</AppendedData>"), "raw");
  expect_the_volume(file_of(compressed, at_3, raw + blocks.sizes + blocks.data + "</AppendedData>"), "raw, compressed");
  const std::string at_4 = R"(type="Int16" format="appended" offset="4">)";
  expect_the_volume(file_of(little, at_4, text + base64(size + bytes) + "</AppendedData>"), "appended base64");
}

TEST_F(Read_vti, has_the_lattice_of_the_file) {
  const std::string bytes = bytes_of(voxels<std::uint8_t>(), false);
  const std::string array =
      R"(type="UInt8" format="binary">)" + base64(bytes_of(std::vector<std::uint32_t>{n}, false) + bytes);
  const Image image = read_image(write(file_of(little, array)));
  EXPECT_EQ(image.lattice.origin, (Point{1, 2, 3}));
  EXPECT_EQ(image.lattice.step, (std::array<Vector, 3>{Vector{0.5, 0, 0}, Vector{0, 1, 0}, Vector{0, 0, 2}}));
  const Image turned = read_image(
      write(file_of(little, array, "", R"(Origin="1 2 3" Spacing="0.5 1 2" Direction="0 -1 0 1 0 0 0 0 1")")));
  EXPECT_EQ(turned.lattice.step, (std::array<Vector, 3>{Vector{0, 0.5, 0}, Vector{-1, 0, 0}, Vector{0, 0, 2}}));
}

TEST_F(Read_vti, refuses_what_is_not_an_image) {
  const std::string bytes = bytes_of(voxels<std::uint8_t>(), false);
  const std::string start = R"(type="UInt8" format="binary">)";
  const auto sized = [&](std::uint32_t size) {
    return base64(bytes_of(std::vector<std::uint32_t>{size}, false) + bytes);
  };
  const auto expect = [&](const std::string& content, const std::string& part) {
    const std::string error = error_of(content);
    EXPECT_NE(error.find(part), std::string::npos) << error;
  };
  const std::string good = file_of(little, start + sized(n));
  EXPECT_EQ(error_of(good), "");
  expect("nothing", "XML");
  expect(R"(<VTKFile type="PolyData"></VTKFile>)", "not an image in VTK's XML format");
  expect(file_of(little, start + sized(n + 1)), "121 bytes; expected 120");
  expect(file_of(little, start + sized(n).substr(0, 60)), "truncated");
  expect(file_of(little, R"(type="Complex" format="binary">)" + sized(n)), "'Complex'");
  expect(file_of(little, R"(type="Float32" format="ascii">1 2 3)"), "3 voxels as text; expected 120");
  expect(file_of(R"(compressor="vtkLZ4DataCompressor")", start + sized(n)), "vtkLZ4DataCompressor");
  expect(file_of(R"(compressor="vtkZLibDataCompressor")", start + sized(n)), "damaged");
  expect(file_of(little, R"(type="UInt8" format="appended" offset="0">)"), "no appended data");
  expect(file_of(little, start + sized(n), "", R"(Spacing="1 0 1")"), "spacing along axis 2");
  expect(file_of(little, start + sized(n), "", R"(Spacing="1 x 1")"), "Spacing is '1 x 1'");
  expect(file_of(little, start + sized(n), "", R"(Direction="1 0 0 1 0 0 0 0 1")"), "singular");
  std::string pieces = good;
  pieces.replace(pieces.find("Piece Extent=\"0 5"), 17, "Piece Extent=\"0 2");
  expect(pieces, "several pieces");
  for (std::size_t length = 0; length < good.size() - 60; length += 7)
    EXPECT_NE(error_of(good.substr(0, length)), "") << length;
}

#ifdef EXTREMAL_MESH_3_SHARED_DATA_DIR

TEST(Shared_vti, is_the_same_image) {
  const std::string start = EXTREMAL_MESH_3_SHARED_DATA_DIR "/volumes/headsq_formats/headsq";
  const Image image = read_image(start + ".vti"), expected = read_image(start + "_raw.nrrd");
  EXPECT_EQ(image.lattice.size, expected.lattice.size);
  EXPECT_EQ(image.lattice.step, expected.lattice.step);
  EXPECT_EQ(image.voxels, expected.voxels);
}

#endif

} // namespace
} // namespace CGAL::Extremal_mesh_3
