// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// DICOM series, written here byte by byte: upright ones and those of a tilted gantry.
#include <CGAL/Extremal_mesh_3/Image.h>
#include <CGAL/Extremal_mesh_3/Image_function.h>
#include <CGAL/Extremal_mesh_3/check.h>
#include <CGAL/Extremal_mesh_3/extract_extremal_mesh.h>
#include <CGAL/Extremal_mesh_3/io.h>

#include "repetitions.h"
#include "temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <sys/wait.h>

using namespace CGAL::Extremal_mesh_3;

namespace {

/// A slice in explicit VR, little endian (DICOM PS3.5, 7.1).
class Dicom_writer {
public:
  void add(std::uint16_t group, std::uint16_t element, const std::string& type, std::string value) {
    if (value.size() % 2 != 0)
      value += type == "UI" ? '\0' : ' ';
    number(group, 2);
    number(element, 2);
    bytes += type;
    if (type == "OB" || type == "OW") {
      number(0, 2);
      number(value.size(), 4);
    } else {
      number(value.size(), 2);
    }
    bytes += value;
  }
  void add_short(std::uint16_t group, std::uint16_t element, unsigned value) {
    add(group, element, "US", {char(value & 255U), char(value >> 8U)});
  }
  void number(std::uint64_t n, int size) {
    for (int i = 0; i < size; ++i)
      bytes += char((n >> (8 * i)) & 255U);
  }
  std::string bytes;
};

std::string vector_text(const std::vector<double>& numbers) {
  std::string text;
  for (const double x : numbers) {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%.10g", x);
    if (!text.empty())
      text += '\\';
    text += buffer;
  }
  return text;
}

struct Series {
  std::string uid = "1.2.3.4";
  Lattice lattice;
  double slope = 1, intercept = 0;
};

void write_slice(const std::string& file, const Series& series, std::size_t k, const Point& origin,
                 const std::vector<std::int16_t>& voxels) {
  const std::string ct = "1.2.840.10008.5.1.4.1.1.2", instance = series.uid + "." + std::to_string(k + 1);
  Dicom_writer meta, data;
  meta.add(2, 1, "OB", {'\0', '\1'});
  meta.add(2, 2, "UI", ct);
  meta.add(2, 3, "UI", instance);
  meta.add(2, 0x10, "UI", "1.2.840.10008.1.2.1");
  meta.add(2, 0x12, "UI", "1.2.3");
  data.add(8, 0x16, "UI", ct);
  data.add(8, 0x18, "UI", instance);
  data.add(8, 0x60, "CS", "CT");
  data.add(0x20, 0xd, "UI", "1.2.3");
  data.add(0x20, 0xe, "UI", series.uid);
  data.add(0x20, 0x13, "IS", std::to_string(k + 1));
  data.add(0x20, 0x32, "DS", vector_text({origin[0], origin[1], origin[2]}));
  const auto& step = series.lattice.step;
  const auto length = [](const Vector& v) { return std::hypot(v[0], v[1], v[2]); };
  std::vector<double> directions;
  for (std::size_t a = 0; a < 2; ++a)
    for (const double x : step[a])
      directions.push_back(x / length(step[a]));
  data.add(0x20, 0x37, "DS", vector_text(directions));
  data.add_short(0x28, 2, 1);
  data.add(0x28, 4, "CS", "MONOCHROME2");
  data.add_short(0x28, 0x10, unsigned(series.lattice.size[1]));
  data.add_short(0x28, 0x11, unsigned(series.lattice.size[0]));
  data.add(0x28, 0x30, "DS", vector_text({length(step[1]), length(step[0])})); // between rows first
  data.add_short(0x28, 0x100, 16);
  data.add_short(0x28, 0x101, 16);
  data.add_short(0x28, 0x102, 15);
  data.add_short(0x28, 0x103, 1);
  data.add(0x28, 0x1052, "DS", vector_text({series.intercept}));
  data.add(0x28, 0x1053, "DS", vector_text({series.slope}));
  std::string pixels;
  for (const std::int16_t v : voxels) {
    pixels += char(std::uint16_t(v) & 255U);
    pixels += char(std::uint16_t(v) >> 8U);
  }
  data.add(0x7fe0, 0x10, "OW", pixels);
  Dicom_writer length_of_meta;
  length_of_meta.number(2, 2);
  length_of_meta.number(0, 2);
  length_of_meta.bytes += "UL";
  length_of_meta.number(4, 2);
  length_of_meta.number(meta.bytes.size(), 4);
  write_text(file, std::string(128, '\0') + "DICM" + length_of_meta.bytes + meta.bytes + data.bytes);
}

constexpr std::array<double, 3> axes{30, 20, 12};

/// of an ellipsoid about the origin; 1000 on the surface, and more inside.
std::vector<std::int16_t> slice_of_ellipsoid(const Series& series, std::size_t k) {
  std::vector<std::int16_t> voxels;
  for (std::size_t j = 0; j < series.lattice.size[1]; ++j)
    for (std::size_t i = 0; i < series.lattice.size[0]; ++i) {
      const Point p = series.lattice.node(double(i), double(j), double(k));
      double f = 0;
      for (std::size_t a = 0; a < 3; ++a)
        f += p[a] * p[a] / (axes[a] * axes[a]);
      const double value = 1000 + 4000 * (1 - std::min(f, 3.0));
      voxels.push_back(std::int16_t(std::lround((value - series.intercept) / series.slope)));
    }
  return voxels;
}

std::string name_of(std::size_t k) {
  return "IM" + std::to_string(900 - k) + (k % 2 == 0 ? ".dcm" : ""); // the order of names is not that of places
}

/// \param degrees  by which the gantry is tilted: each slice begins farther along its own rows' plane than the one before
Series tilted(double degrees) {
  Series series;
  const double angle = degrees * std::acos(-1.0) / 180;
  // rows along x, columns lean towards z; the table moves along z
  series.lattice.step = {Vector{1, 0, 0}, Vector{0, std::cos(angle), std::sin(angle)}, Vector{0, 0, 1}};
  series.lattice.size = {76, 66, 76};
  // so that the middle is at the origin
  const Point middle = series.lattice.node(37.5, 32.5, 37.5);
  series.lattice.origin = {-middle[0], -middle[1], -middle[2]};
  return series;
}

void write_series(const Temporary_folder& folder, const Series& series) {
  for (std::size_t k = 0; k < series.lattice.size[2]; ++k)
    write_slice(folder.file(name_of(k)), series, k, series.lattice.node(0, 0, double(k)),
                slice_of_ellipsoid(series, k));
}

/// a few voxels, for what is refused.
Series small() {
  Series series;
  series.lattice.size = {5, 6, 7};
  return series;
}

void write_small(const Temporary_folder& folder, const Series& series, std::size_t k, const Point& origin) {
  write_slice(folder.file(series.uid + "_" + std::to_string(k)), series, k, origin,
              std::vector<std::int16_t>(series.lattice.size[0] * series.lattice.size[1], std::int16_t(k)));
}

std::string refusal(const std::string& path) {
  try {
    read_image(path);
  } catch (const Io_error& error) {
    return error.what();
  }
  return "";
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

} // namespace

TEST(Dicom, gives_the_lattice_and_the_values_of_a_tilted_series) {
  Series series = tilted(20);
  series.slope = 2;
  series.intercept = -1024;
  series.lattice.size = {8, 9, 10};
  const Temporary_folder folder;
  write_series(folder, series);
  write_text(folder.file("README"), "no slice");
  for (const std::string& path : {folder.path(), folder.file(name_of(3))}) {
    const Image image = read_image(path);
    EXPECT_EQ(image.lattice.size, series.lattice.size);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(image.lattice.origin[i], series.lattice.origin[i], 1e-8);
      for (std::size_t a = 0; a < 3; ++a)
        EXPECT_NEAR(image.lattice.step[a][i], series.lattice.step[a][i], 1e-8) << a << i;
    }
    for (std::size_t k = 0, n = 0; k < 10; ++k)
      for (const std::int16_t stored : slice_of_ellipsoid(series, k))
        ASSERT_EQ(image.voxels[n++], float(2 * stored - 1024));
  }
}

// The truth of an ellipsoid: 6 extremal points at the ends of its axes, 4 umbilics, 16 edges, 8 cells.
TEST(Dicom, has_the_extremal_mesh_of_an_ellipsoid_however_the_gantry_is_tilted) {
  for (const double degrees : {0.0, 17.0, -25.0}) {
    const Temporary_folder folder;
    write_series(folder, tilted(degrees));
    Image_function_options image_options;
    image_options.iso = 1000;
    image_options.sigma = 2;
    const Image_function function(read_image(folder.path()), image_options);
    Extraction_options options;
    options.max_level = 8;
    options.max_line_level = 2;
    const Extremal_mesh mesh = extract_extremal_mesh(function, function.lattice(), options).mesh;
    EXPECT_TRUE(all_hold(check(mesh)));
    ASSERT_EQ(mesh.number_of_vertices(), 10U) << degrees;
    EXPECT_EQ(mesh.number_of_edges(), 16U);
    EXPECT_EQ(mesh.number_of_cells(), 8U);
    std::vector<Point> truth;
    for (std::size_t a = 0; a < 3; ++a)
      for (const double sign : {-1.0, 1.0}) {
        Point p{};
        p[a] = sign * axes[a];
        truth.push_back(p);
      }
    const auto square = [](double x) { return x * x; };
    const double a = square(axes[0]), b = square(axes[1]), c = square(axes[2]);
    for (const double s : {-1.0, 1.0})
      for (const double t : {-1.0, 1.0})
        truth.push_back({s * axes[0] * std::sqrt((a - b) / (a - c)), 0, t * axes[2] * std::sqrt((b - c) / (a - c))});
    for (const Point& p : truth) {
      double nearest = 1e9;
      for (std::size_t v = 0; v < 10; ++v) {
        const Point& q = mesh.vertex(v).point;
        nearest = std::min(nearest, std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]));
      }
      // Smoothing of a quadratic by σ moves the surface to f = 1 − σ²Σ1/a², that is by 0.25 mm or less; a wrong shear would by many.
      EXPECT_LT(nearest, 1) << degrees;
    }
  }
}

TEST(Dicom, is_read_by_the_program_from_a_folder_or_a_slice) {
  const Temporary_folder folder, results;
  write_series(folder, tilted(17));
  const auto run = [&](const std::string& input, const std::string& output) {
    const std::string command = std::string(EXTREMAL_MESH_3_PROGRAM) + " extract '" + input +
                                "' --iso 1000 --sigma 2 --quiet -o " + results.file(output) + " 2> " +
                                results.file("err");
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  };
  ASSERT_EQ(run(folder.path(), "folder.graphml"), 0) << read_text(results.file("err"));
  ASSERT_EQ(run(folder.file(name_of(5)), "slice.graphml"), 0) << read_text(results.file("err"));
  const Extremal_mesh of_folder = read_graphml(results.file("folder.graphml"));
  const Extremal_mesh of_slice = read_graphml(results.file("slice.graphml"));
  EXPECT_EQ(of_folder.number_of_vertices(), 10U);
  ASSERT_EQ(of_slice.number_of_vertices(), of_folder.number_of_vertices());
  for (std::size_t v = 0; v < of_folder.number_of_vertices(); ++v)
    EXPECT_EQ(of_slice.vertex(v).point, of_folder.vertex(v).point);

  std::filesystem::remove(folder.file(name_of(40)));
  EXPECT_EQ(run(folder.path(), "missing.graphml"), 1);
  EXPECT_TRUE(contains(read_text(results.file("err")), "1 of its slices is missing between"))
      << read_text(results.file("err"));
  EXPECT_FALSE(std::filesystem::exists(results.file("missing.graphml")));
}

TEST(Dicom, tells_of_missing_slices) {
  const Temporary_folder folder;
  for (const std::size_t k : {0, 1, 2, 5, 6, 7})
    write_small(folder, small(), k, {0, 0, double(k)});
  EXPECT_TRUE(contains(refusal(folder.path()), "2 of its slices are missing between '1.2.3.4_2' and '1.2.3.4_5'"))
      << refusal(folder.path());
}

TEST(Dicom, tells_of_unequal_distances) {
  const Temporary_folder folder;
  for (std::size_t k = 0; k < 7; ++k)
    write_small(folder, small(), k, {0, 0, k < 4 ? double(k) : double(k) + 0.3});
  EXPECT_TRUE(contains(refusal(folder.path()), "is 1.3, of others 1; expected equal ones")) << refusal(folder.path());
}

TEST(Dicom, tells_of_slices_in_the_same_place_and_of_shifted_ones) {
  const Temporary_folder same, shifted;
  for (std::size_t k = 0; k < 7; ++k) {
    write_small(same, small(), k, {0, 0, k < 6 ? double(k) : 3.0});
    write_small(shifted, small(), k, {k == 3 ? 0.5 : 0.0, 0, double(k)});
  }
  EXPECT_TRUE(contains(refusal(same.path()), "are in the same place")) << refusal(same.path());
  EXPECT_TRUE(contains(refusal(shifted.path()), "'1.2.3.4_3' is shifted by 0.5")) << refusal(shifted.path());
}

TEST(Dicom, tells_of_several_series_and_takes_that_of_a_slice) {
  const Temporary_folder folder;
  Series other = small();
  other.uid = "1.2.3.5";
  for (std::size_t k = 0; k < 7; ++k) {
    write_small(folder, small(), k, {0, 0, double(k)});
    write_small(folder, other, k, {0, 0, 2 * double(k)});
  }
  EXPECT_TRUE(contains(refusal(folder.path()), "the slices of 2 series are in it")) << refusal(folder.path());
  EXPECT_EQ(read_image(folder.file("1.2.3.5_4")).lattice.step[2], (Vector{0, 0, 2}));
}

TEST(Dicom, tells_of_slices_of_other_sizes_and_of_damaged_ones) {
  const Temporary_folder folder, damaged, empty;
  Series other = small();
  other.lattice.size[0] = 6;
  for (std::size_t k = 0; k < 7; ++k) {
    write_small(folder, k == 5 ? other : small(), k, {0, 0, double(k)});
    write_small(damaged, small(), k, {0, 0, double(k)});
  }
  EXPECT_TRUE(contains(refusal(folder.path()), "'1.2.3.4_5' has 6 x 6 voxels, '1.2.3.4_0' has 5 x 6"))
      << refusal(folder.path());
  const std::string text = read_text(damaged.file("1.2.3.4_2"));
  for (const std::size_t left : {std::size_t(140), text.size() / 2, text.size() - 30}) {
    write_text(damaged.file("1.2.3.4_2"), text.substr(0, left));
    EXPECT_TRUE(contains(refusal(damaged.path()), "'1.2.3.4_2'")) << left << refusal(damaged.path());
  }
  EXPECT_TRUE(contains(refusal(empty.path()), "without DICOM slices")) << refusal(empty.path());
}

// GDCM ends the program at one in fifty of these.
TEST(Dicom, whose_slice_is_changed_anywhere_is_read_or_refused) {
  const Temporary_folder folder;
  Series series = small();
  for (std::size_t k = 0; k < series.lattice.size[2]; ++k)
    write_small(folder, series, k, {0, 0, double(k)});
  const std::string file = folder.file(series.uid + "_3"), whole = read_text(file);
  std::mt19937 random(1);
  const auto number = [&](std::size_t n) { return std::size_t(random() % n); };
  std::size_t refused = 0;
  constexpr std::size_t mark = 132, times = repetitions(400);
  for (std::size_t t = 0; t < times; ++t) {
    std::string changed = whole;
    const std::size_t at = mark + number(whole.size() - mark - 8);
    switch (number(4)) {
    case 0:
      changed[at] = char(number(256));
      break;
    case 1:
      changed.erase(at, 1 + number(7));
      break;
    case 2:
      changed.insert(at, std::string(1 + number(7), char(number(256))));
      break;
    default:
      changed.replace(at, 8, whole, mark + number(whole.size() - mark - 8), 8);
    }
    write_text(file, changed);
    try {
      EXPECT_EQ(read_image(folder.path()).voxels.size(), 5U * 6U * 7U);
    } catch (const Io_error& error) {
      EXPECT_TRUE(contains(error.what(), folder.path())) << error.what();
      ++refused;
    }
  }
  EXPECT_GT(refused, times / 4);
  EXPECT_LT(refused, times);
}
