// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The files are written here, byte by byte: a volume of 5 x 6 x 7 voxels with steps along the axes of lengths 2, 3 and
// 4 in each of the formats, then the same with something wrong.

#include <CGAL/Extremal_mesh_3/Image.h>

#include "temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <functional>
#include <limits>
#include <zlib.h>

namespace CGAL::Extremal_mesh_3 {
namespace {

constexpr std::size_t n = 5 * 6 * 7;

template <typename T> std::string bytes(T value, bool big_endian = false) {
  std::string text(sizeof(T), '\0');
  std::memcpy(text.data(), &value, sizeof(T));
  if (big_endian == (std::endian::native == std::endian::little))
    std::reverse(text.begin(), text.end());
  return text;
}

// The voxels 0, 3, 6, … as numbers of any type.
template <typename T> std::string voxels(bool big_endian = false) {
  std::string all;
  for (std::size_t i = 0; i < n; ++i)
    all += bytes(static_cast<T>(3 * i % 100), big_endian);
  return all;
}

std::string text_voxels() {
  std::string all;
  for (std::size_t i = 0; i < n; ++i)
    all += std::to_string(3 * i % 100) + (i % 10 == 9 ? "\n" : " ");
  return all;
}

Voxels expected_voxels() {
  Voxels all;
  for (std::size_t i = 0; i < n; ++i)
    all.push_back(static_cast<float>(3 * i % 100));
  return all;
}

std::string deflated(const std::string& data, int window_bits) {
  z_stream stream{};
  deflateInit2(&stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, window_bits, 8, Z_DEFAULT_STRATEGY);
  std::string out(deflateBound(&stream, data.size()) + 64, '\0');
  std::string in = data;
  stream.next_in = reinterpret_cast<Bytef*>(in.data());
  stream.avail_in = static_cast<uInt>(in.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  deflate(&stream, Z_FINISH);
  out.resize(stream.total_out);
  deflateEnd(&stream);
  return out;
}

std::string gzipped(const std::string& data) {
  return deflated(data, 16 + MAX_WBITS);
}
std::string zlibbed(const std::string& data) {
  return deflated(data, MAX_WBITS);
}

std::string nrrd_header(const std::string& more) {
  return "NRRD0004\n# a comment: with a colon\ndimension: 3\nsizes: 5 6 7\n" + more + "\n\n";
}
const std::string nrrd_geometry =
    "space: left-posterior-superior\nspace directions: (2,0,0) (0,3,0) (0,0,4)\nspace origin: (-1,2,3)\n";

std::string nrrd(const std::string& fields, const std::string& data) {
  return nrrd_header(nrrd_geometry + fields) + data;
}
std::string good_nrrd() {
  return nrrd("type: short\nendian: little\nencoding: raw", voxels<short>());
}

std::string meta_header(const std::string& more) {
  return "ObjectType = Image\nNDims = 3\nBinaryData = True\nTransformMatrix = 1 0 0 0 1 0 0 0 1\nOffset = -1 2 3\n"
         "ElementSpacing = 2 3 4\nDimSize = 5 6 7\nElementType = MET_SHORT\n" +
         more;
}
std::string compressed_meta(const std::string& zlib) {
  return meta_header("CompressedData = True\nCompressedDataSize = " + std::to_string(zlib.size()) +
                     "\nElementDataFile = LOCAL\n") +
         zlib;
}
std::string good_meta() {
  return meta_header("ElementDataFile = LOCAL\n") + voxels<short>();
}

// A NIfTI header; its world is RAS, so that x and y change sign.
struct Nifti {
  bool big_endian = false;
  std::array<short, 8> dim{3, 5, 6, 7, 1, 1, 1, 1};
  short type = 4, bits = 16;
  std::array<float, 8> pixdim{1, 2, 3, 4, 0, 0, 0, 0};
  float slope = 0, intercept = 0;
  short qform = 0, sform = 1;
  std::array<float, 12> rows{-2, 0, 0, 1, 0, -3, 0, -2, 0, 0, 4, 3};

  std::string header() const {
    std::string text(352, '\0');
    const auto put = [&](std::size_t offset, auto value) {
      const std::string number = bytes(value, big_endian);
      std::copy(number.begin(), number.end(), text.begin() + static_cast<std::ptrdiff_t>(offset));
    };
    put(0, 348);
    for (std::size_t i = 0; i < 8; ++i) {
      put(40 + 2 * i, dim[i]);
      put(76 + 4 * i, pixdim[i]);
    }
    put(70, type);
    put(72, bits);
    put(108, 352.0F);
    put(112, slope);
    put(116, intercept);
    put(252, qform);
    put(254, sform);
    for (std::size_t i = 0; i < 12; ++i)
      put(280 + 4 * i, rows[i]);
    std::memcpy(text.data() + 344, "n+1", 4);
    return text;
  }
};
std::string good_nifti() {
  return Nifti().header() + voxels<short>();
}

std::string vtk(const std::string& format, const std::string& data) {
  return "# vtk DataFile Version 3.0\na title\n" + format +
         "\nDATASET STRUCTURED_POINTS\nDIMENSIONS 5 6 7\nSPACING 2 3 4\nORIGIN -1 2 3\nPOINT_DATA 210\n"
         "SCALARS values short 1\nLOOKUP_TABLE default\n" +
         data;
}
std::string good_vtk() {
  return vtk("BINARY", voxels<short>(true));
}

std::string replaced(const std::string& text, const std::string& what, const std::string& by) {
  const auto place = text.find(what);
  EXPECT_NE(place, std::string::npos) << what;
  return text.substr(0, place) + by + text.substr(place + what.size());
}

class Read_image : public testing::Test {
protected:
  std::string write(const std::string& name, const std::string& content) {
    write_text(folder_.file(name), content);
    return folder_.file(name);
  }

  void expect_the_volume(const std::string& name, const std::string& content) {
    const Image image = read_image(write(name, content));
    EXPECT_EQ(image.lattice.size, (std::array<std::size_t, 3>{5, 6, 7})) << name;
    EXPECT_EQ(image.lattice.origin, (Point{-1, 2, 3})) << name;
    EXPECT_EQ(image.lattice.step, (std::array<Vector, 3>{Vector{2, 0, 0}, Vector{0, 3, 0}, Vector{0, 0, 4}})) << name;
    EXPECT_EQ(image.voxels, expected_voxels()) << name;
  }

  // The message is one sentence of ours, names the file and says `what`; nothing goes to the console.
  void expect_error(const std::string& file, const std::string& what) {
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    std::string message = "no error";
    try {
      read_image(file);
    } catch (const Io_error& error) {
      message = error.what();
    }
    EXPECT_EQ(testing::internal::GetCapturedStdout() + testing::internal::GetCapturedStderr(), "") << file;
    EXPECT_TRUE(message.find("'" + file + "'") != std::string::npos && message.find(what) != std::string::npos &&
                message.find('\n') == std::string::npos && message.find("itk") == std::string::npos)
        << file << ": " << message << "\nexpected: " << what;
  }

  void expect_error(const std::string& name, const std::string& content, const std::string& what) {
    expect_error(write(name, content), what);
  }

  Temporary_folder folder_;
};

} // namespace

TEST_F(Read_image, reads_nrrd_in_all_its_encodings) {
  expect_the_volume("raw.nrrd", good_nrrd());
  expect_the_volume("big_endian.nrrd", nrrd("type: int16\nendian: big\nencoding: raw", voxels<short>(true)));
  expect_the_volume("gzip.nrrd", nrrd("type: short\nendian: little\nencoding: gzip", gzipped(voxels<short>())));
  expect_the_volume("ascii.nrrd", nrrd("type: short\nencoding: ascii", text_voxels()));
  write("voxels.raw", voxels<short>());
  expect_the_volume("detached.nhdr", nrrd("type: short\nendian: little\nencoding: raw\ndata file: voxels.raw", ""));
  write("voxels.raw.gz", gzipped(voxels<short>()));
  expect_the_volume("detached_gzip.nhdr",
                    nrrd("type: short\nendian: little\nencoding: gzip\ndata file: voxels.raw.gz", ""));
}

TEST_F(Read_image, reads_metaimage_in_all_its_encodings) {
  expect_the_volume("local.mha", good_meta());
  expect_the_volume("big_endian.mha",
                    meta_header("BinaryDataByteOrderMSB = True\nElementDataFile = LOCAL\n") + voxels<short>(true));
  const std::string zlib = zlibbed(voxels<short>());
  const std::string size = "CompressedDataSize = " + std::to_string(zlib.size()) + "\n";
  expect_the_volume("compressed.mha", compressed_meta(zlib));
  write("voxels.raw", voxels<short>());
  expect_the_volume("detached.mhd", meta_header("ElementDataFile = voxels.raw\n"));
  write("voxels.zraw", zlib);
  expect_the_volume("compressed.mhd",
                    meta_header("CompressedData = True\n" + size + "ElementDataFile = voxels.zraw\n"));
  expect_the_volume("without_size.mhd", meta_header("CompressedData = True\nElementDataFile = voxels.zraw\n"));
  write("skipped.raw", "twelve bytes" + voxels<short>());
  expect_the_volume("skipped.mhd", meta_header("HeaderSize = 12\nElementDataFile = skipped.raw\n"));
  expect_the_volume("from_end.mhd", meta_header("HeaderSize = -1\nElementDataFile = skipped.raw\n"));
}

TEST_F(Read_image, reads_nifti_and_converts_ras_to_lps) {
  expect_the_volume("plain.nii", good_nifti());
  expect_the_volume("gzip.nii.gz", gzipped(good_nifti()));
  Nifti nifti;
  nifti.big_endian = true;
  expect_the_volume("big_endian.nii", nifti.header() + voxels<short>(true));
  nifti = {};
  nifti.dim = {4, 5, 6, 7, 1, 1, 1, 1};
  expect_the_volume("one_time.nii", nifti.header() + voxels<short>());
  nifti = {};
  nifti.slope = 0.5;
  nifti.intercept = 10;
  const Image image = read_image(write("scaled.nii", nifti.header() + voxels<short>()));
  EXPECT_EQ(image.voxels[7], 0.5F * 21 + 10);
}

TEST_F(Read_image, reads_vtk) {
  expect_the_volume("binary.vtk", good_vtk());
  expect_the_volume("text.vtk", vtk("ASCII", text_voxels()));
}

TEST_F(Read_image, takes_extensions_in_capitals) {
  expect_the_volume("A.NRRD", good_nrrd());
  expect_the_volume("B.MHA", good_meta());
  expect_the_volume("C.Vtk", good_vtk());
}

TEST_F(Read_image, reads_every_type_of_number) {
  const auto type = [](const std::string& name) { return "type: " + name + "\nendian: little\nencoding: raw"; };
  expect_the_volume("a.nrrd", nrrd(type("int8"), voxels<std::int8_t>()));
  expect_the_volume("b.nrrd", nrrd(type("uint8"), voxels<std::uint8_t>()));
  expect_the_volume("c.nrrd", nrrd(type("uint16"), voxels<std::uint16_t>()));
  expect_the_volume("d.nrrd", nrrd(type("int32"), voxels<std::int32_t>()));
  expect_the_volume("e.nrrd", nrrd(type("uint32"), voxels<std::uint32_t>()));
  expect_the_volume("f.nrrd", nrrd(type("int64"), voxels<std::int64_t>()));
  expect_the_volume("g.nrrd", nrrd(type("uint64"), voxels<std::uint64_t>()));
  expect_the_volume("h.nrrd", nrrd(type("float"), voxels<float>()));
  expect_the_volume("i.nrrd", nrrd(type("double"), voxels<double>()));
}

TEST_F(Read_image, keeps_left_handed_and_oblique_directions) {
  const std::string fields = "type: short\nendian: little\nencoding: raw\n";
  const Image flipped = read_image(write(
      "flipped.nrrd", nrrd_header(fields + "space: LPS\nspace directions: (0,2,0) (3,0,0) (0,0,4)") + voxels<short>()));
  EXPECT_EQ(flipped.lattice.step, (std::array<Vector, 3>{Vector{0, 2, 0}, Vector{3, 0, 0}, Vector{0, 0, 4}}));
  const Image ras = read_image(write(
      "ras.nrrd", nrrd_header(fields + "space: RAS\nspace directions: (2,0,0) (0,3,0) (0,0,4)\nspace origin: (1,2,3)") +
                      voxels<short>()));
  EXPECT_EQ(ras.lattice.step, (std::array<Vector, 3>{Vector{-2, 0, 0}, Vector{0, -3, 0}, Vector{0, 0, 4}}));
  EXPECT_EQ(ras.lattice.origin, (Point{-1, -2, 3}));

  Nifti nifti; // columns 2·(0.6, 0.8, 0), 3·(−0.8, 0.6, 0) and 4·(0, 0, 1)
  nifti.rows = {1.2F, -2.4F, 0, 1, 1.6F, 1.8F, 0, 2, 0, 0, 4, 3};
  const Image oblique = read_image(write("oblique.nii", nifti.header() + voxels<short>()));
  const std::array<Vector, 3> step{Vector{-1.2, -1.6, 0}, Vector{2.4, -1.8, 0}, Vector{0, 0, 4}};
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_NEAR(oblique.lattice.step[a][i], step[a][i], 1e-6); // the file holds floats
  EXPECT_EQ(oblique.lattice.origin, (Point{-1, -2, 3}));
}

TEST_F(Read_image, takes_the_decimal_that_a_float_in_nifti_stands_for) {
  Nifti nifti;
  nifti.pixdim = {1, 3.2F, 3.2F, 1.5F, 0, 0, 0, 0};
  nifti.rows = {-3.2F, 0, 0, -0.7F, 0, -3.2F, 0, 0, 0, 0, 1.5F, 0};
  const Image image = read_image(write("a.nii", nifti.header() + voxels<short>()));
  EXPECT_EQ(image.lattice.step[0], (Vector{3.2, 0, 0}));
  EXPECT_EQ(image.lattice.origin, (Point{0.7, 0, 0}));
}

TEST_F(Read_image, reports_every_truncated_file) {
  const std::vector<std::pair<std::string, std::string>> files{
      {"a.nrrd", good_nrrd()},
      {"b.nrrd", nrrd("type: short\nendian: little\nencoding: gzip", gzipped(voxels<short>()))},
      {"c.nrrd", nrrd("type: short\nencoding: ascii", text_voxels())},
      {"d.mha", good_meta()},
      {"e.mha", compressed_meta(zlibbed(voxels<short>()))},
      {"g.nii", good_nifti()},
      {"h.nii.gz", gzipped(good_nifti())},
      {"i.vtk", good_vtk()},
      {"j.vtk", vtk("ASCII", text_voxels())}};
  for (const auto& [name, content] : files)
    for (std::size_t cut :
         {std::size_t{3}, std::size_t{40}, std::size_t{100}, content.size() - 150, content.size() - 20})
      if (cut < content.size()) {
        SCOPED_TRACE(cut);
        expect_error(name, content.substr(0, content.size() - cut), "");
      }
  expect_error("a.nrrd", good_nrrd().substr(0, good_nrrd().size() - 1),
               "truncated: expected 420 bytes of voxels, found 419");
}

TEST_F(Read_image, reports_complete_compressed_data_of_too_few_voxels) {
  const std::string few = voxels<short>().substr(2);
  expect_error("a.nrrd", nrrd("type: short\nendian: little\nencoding: gzip", gzipped(few)),
               "expected 420 bytes of voxels, found 418");
  expect_error("b.mha", compressed_meta(zlibbed(few)), "expected 420 bytes of voxels, found 418");
  expect_error("c.nii.gz", gzipped(Nifti().header() + few), "expected 420 bytes of voxels, found 418");
}

TEST_F(Read_image, reports_a_compressed_size_that_is_not_the_data_s) {
  const std::string good = compressed_meta(zlibbed(voxels<short>()));
  const std::string size = "CompressedDataSize = " + std::to_string(zlibbed(voxels<short>()).size());
  expect_error("a.mha", replaced(good, size, "CompressedDataSize = 60"), "truncated");
  expect_error("b.mha", replaced(good, size + "\n", ""), "no CompressedDataSize");
}

TEST_F(Read_image, reports_damaged_compressed_data) {
  std::string content = gzipped(good_nifti());
  content[content.size() / 2] = static_cast<char>(~content[content.size() / 2]);
  expect_error("a.nii.gz", content, "");
  content = gzipped(voxels<short>());
  content[content.size() - 6] = static_cast<char>(~content[content.size() - 6]); // in the checksum
  expect_error("b.nrrd", nrrd("type: short\nendian: little\nencoding: gzip", content), "damaged");
}

TEST_F(Read_image, takes_no_memory_for_a_size_that_the_file_cannot_have) {
  expect_error("a.nrrd", replaced(good_nrrd(), "5 6 7", "50000 60000 70000"), "truncated");
  expect_error("b.nrrd", replaced(good_nrrd(), "5 6 7", "4000000000 4000000000 4000000000"), "");
  expect_error("c.nrrd",
               replaced(nrrd("type: short\nendian: little\nencoding: gzip", gzipped(voxels<short>())), "5 6 7",
                        "50000 60000 70000"),
               "truncated");
  expect_error("d.mha", replaced(good_meta(), "5 6 7", "50000 60000 70000"), "truncated");
  expect_error("e.mha", replaced(good_meta(), "5 6 7", "4000000000 4000000000 4000000000"), "");
  expect_error("f.mha", replaced(good_meta(), "5 6 7", "-5 6 7"), "DimSize");
  expect_error("g.vtk", replaced(good_vtk(), "5 6 7", "50000 60000 70000"), "truncated");
  Nifti nifti;
  nifti.dim = {3, 32000, 32000, 32000, 1, 1, 1, 1};
  expect_error("h.nii", nifti.header() + voxels<short>(), "truncated");
  expect_error("i.nii.gz", gzipped(nifti.header() + voxels<short>()), "truncated");
  nifti.dim = {3, 5, -6, 7, 1, 1, 1, 1};
  expect_error("j.nii", nifti.header() + voxels<short>(), "size along axis 2 is -6");
}

TEST_F(Read_image, reports_spacings_that_are_no_lengths) {
  const std::string fields = "type: short\nendian: little\nencoding: raw\n";
  for (const char* spacing : {"0 1 1", "-1 1 1", "nan 1 1", "inf 1 1", "1e400 1 1"}) {
    expect_error("a.nrrd", nrrd_header(fields + "spacings: " + spacing) + voxels<short>(), "spacing");
    expect_error("b.mha", replaced(good_meta(), "2 3 4", spacing), "Spacing");
    expect_error("c.vtk", replaced(good_vtk(), "2 3 4", spacing), "SPACING");
  }
  for (float spacing : {0.0F, -1.0F, std::numeric_limits<float>::quiet_NaN()}) {
    Nifti nifti;
    nifti.pixdim[2] = spacing;
    expect_error("d.nii", nifti.header() + voxels<short>(), "spacing along axis 2");
  }
}

TEST_F(Read_image, reports_singular_directions) {
  expect_error("a.nrrd", replaced(good_nrrd(), "(0,3,0)", "(5,0,0)"), "singular");
  expect_error("b.mha", replaced(good_meta(), "1 0 0 0 1 0 0 0 1", "1 0 0 1 0 0 0 0 1"), "singular");
  Nifti nifti;
  nifti.rows = {1, 1, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0};
  expect_error("c.nii", nifti.header() + voxels<short>(), "singular");
  nifti.rows[3] = std::numeric_limits<float>::quiet_NaN();
  expect_error("d.nii", nifti.header() + voxels<short>(), "orientation has the number nan");
  nifti.rows[3] = 1e38F;
  expect_error("d.nii", nifti.header() + voxels<short>(), "orientation has the number 1e+38");
  nifti.rows[3] = std::numeric_limits<float>::denorm_min();
  expect_error("e.nii", nifti.header() + voxels<short>(), "orientation has the number 1e-45");
}

TEST_F(Read_image, reports_what_is_not_a_3d_scalar_image) {
  const std::string fields = "type: short\nendian: little\nencoding: raw\n";
  expect_error("a.nrrd", "NRRD0004\ndimension: 2\nsizes: 5 42\n" + fields + "\n" + voxels<short>(),
               "not 3D: its size is 5 x 42");
  expect_error("b.nrrd", "NRRD0004\ndimension: 4\nsizes: 5 6 1 7\n" + fields + "\n" + voxels<short>(), "not 3D");
  expect_error("c.nrrd",
               "NRRD0004\ndimension: 4\nsizes: 3 5 2 7\nkinds: vector domain domain domain\n" + fields + "\n" +
                   voxels<short>(),
               "3 values per voxel");
  expect_error("d.nrrd", replaced(good_nrrd(), "5 6 7", "105 2 1"), "size along axis 2 is 2");
  expect_error("e.mha", replaced(good_meta(), "MET_SHORT", "MET_SHORT\nElementNumberOfChannels = 3"), "");
  expect_error("f.mha", replaced(good_meta(), "NDims = 3", "NDims = 2"), "2 dimensions");
  expect_error("g.vtk", replaced(good_vtk(), "SCALARS values short 1", "VECTORS values short"), "several values");
  expect_error("h.vtk", replaced(good_vtk(), "STRUCTURED_POINTS", "POLYDATA"), "not an image");
  Nifti nifti;
  nifti.type = 128;
  nifti.bits = 24;
  expect_error("i.nii", nifti.header() + voxels<short>() + voxels<short>(), "several values");
  nifti = {};
  nifti.dim = {2, 5, 42, 1, 1, 1, 1, 1};
  expect_error("j.nii", nifti.header() + voxels<short>(), "2 dimensions");
}

TEST_F(Read_image, reports_voxels_that_are_not_finite) {
  std::string data = voxels<float>();
  data.replace(7 * sizeof(float), sizeof(float), bytes(std::numeric_limits<float>::quiet_NaN()));
  expect_error("a.nrrd", nrrd("type: float\nendian: little\nencoding: raw", data), "voxel 7 is nan");
  expect_error("b.mha", replaced(meta_header("ElementDataFile = LOCAL\n"), "MET_SHORT", "MET_FLOAT") + data,
               "voxel 7 is nan");
  Nifti nifti;
  nifti.type = 16;
  nifti.bits = 32;
  expect_error("c.nii", nifti.header() + data, "voxel 7 is nan");
  data.replace(7 * sizeof(float), sizeof(float), bytes(std::numeric_limits<float>::infinity()));
  expect_error("d.nrrd", nrrd("type: float\nendian: little\nencoding: raw", data), "voxel 7 is inf");
  expect_error("e.nii.gz", gzipped(nifti.header() + data), "voxel 7 is inf");
}

TEST_F(Read_image, reports_what_is_no_image_file) {
  expect_error(folder_.file("missing.nrrd"), "does not exist");
  expect_error(folder_.path(), "is a folder");
  expect_error("a.png", "something", "extensions that are read: .nrrd .nhdr .mha .mhd .nii .nii.gz .vtk");
  expect_error("b.gz", "something", "extensions that are read");
  for (const char* name : {"c.nrrd", "d.mha", "e.mhd", "f.nii", "g.nii.gz", "h.vtk", "i.nhdr"}) {
    expect_error(name, "", "is empty");
    expect_error(name, "something else altogether\n", "");
    expect_error(name, std::string(100000, '\xff'), "");
    expect_error(name, std::string(100000, '\0'), "");
  }
  expect_error("j.nhdr", nrrd("type: short\nendian: little\nencoding: raw\ndata file: missing.raw", ""),
               "missing.raw' does not exist");
  expect_error("k.mhd", meta_header("ElementDataFile = missing.raw\n"), "missing.raw' does not exist");
  expect_error("l.nii", gzipped(good_nifti()), "end in .nii.gz");
}

TEST_F(Read_image, says_what_it_does_not_support) {
  expect_error("a.nrrd", nrrd("type: short\nendian: little\nencoding: bzip2", voxels<short>()),
               "'bzip2' is not supported");
  expect_error("b.nhdr", nrrd("type: short\nendian: little\nencoding: raw\ndata file: LIST\na.raw", ""),
               "several files");
  expect_error("c.mhd", meta_header("ElementDataFile = slice%03d.raw 1 7 1\n"), "several files");
  expect_error("d.mha", replaced(good_meta(), "BinaryData = True", "BinaryData = False"), "as text");
  expect_error("d.mha", replaced(good_meta(), "BinaryData = True\n", ""), "as text");
  std::string nifti_2 = bytes(540) + good_nifti();
  expect_error("e.nii", nifti_2, "NIfTI-2");
}

TEST(Shipped_images, can_be_read) {
  const Image head = read_image(EXTREMAL_MESH_3_DATA_DIR "/headsq.nii.gz");
  EXPECT_EQ(head.lattice.size, (std::array<std::size_t, 3>{64, 64, 93}));
  EXPECT_EQ(head.lattice.step, (std::array<Vector, 3>{Vector{3.2, 0, 0}, Vector{0, 3.2, 0}, Vector{0, 0, 1.5}}));
  const Image skull = read_image(EXTREMAL_MESH_3_DATA_DIR "/skull_2.9.nrrd");
  EXPECT_EQ(skull.lattice.size, (std::array<std::size_t, 3>{64, 64, 64}));
}

#ifdef EXTREMAL_MESH_3_SHARED_DATA_DIR

TEST(Shared_images, are_the_same_in_every_encoding) {
  const std::string folder = EXTREMAL_MESH_3_SHARED_DATA_DIR "/volumes/headsq_formats/headsq";
  const Image expected = read_image(folder + "_raw.nrrd");
  for (const char* name : {"_bigendian.nrrd", "_float.nrrd", "_detached.nhdr", ".mha", ".mhd", "_z.mhd", ".nii",
                           ".nii.gz", ".vtk", "_uint8.nrrd"}) {
    Image image = read_image(folder + name);
    EXPECT_EQ(image.lattice.origin, expected.lattice.origin) << name;
    EXPECT_EQ(image.lattice.step, expected.lattice.step) << name;
    EXPECT_EQ(image.lattice.size, expected.lattice.size) << name;
    ASSERT_EQ(image.voxels.size(), expected.voxels.size()) << name;
    const bool is_sixteenth = std::string(name) == "_uint8.nrrd"; // value / 16, rounded
    for (std::size_t i = 0; i < image.voxels.size(); ++i)
      ASSERT_NEAR(image.voxels[i] * (is_sixteenth ? 16 : 1), expected.voxels[i], is_sixteenth ? 16 : 0)
          << name << ", voxel " << i;
  }
}

TEST(Shared_images, may_be_left_handed) {
  const Image image = read_image(EXTREMAL_MESH_3_SHARED_DATA_DIR "/volumes/cranium_ct.nrrd");
  EXPECT_LT(image.lattice.step[0][0] * image.lattice.step[1][1] * image.lattice.step[2][2], 0);
}

#endif

} // namespace CGAL::Extremal_mesh_3
