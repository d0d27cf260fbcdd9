// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Extremal_mesh_3/read_mesh.h>

#include "file_content.h"
#include "repair.h"
#include "soup_readers.h"
#include "weld.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <stdexcept>

namespace CGAL::Extremal_mesh_3 {

namespace {

struct Format {
  std::string_view extension;
  Polygon_soup (*read)(std::string_view content);
};

constexpr std::array<Format, 5> formats{
    {{".off", read_off}, {".obj", read_obj}, {".ply", read_ply}, {".stl", read_stl}, {".om", read_om}}};

const Format* format_of(const std::string& file) {
  std::string extension = std::filesystem::path(file).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const auto* found =
      std::find_if(formats.begin(), formats.end(), [&](const Format& format) { return format.extension == extension; });
  return found == formats.end() ? nullptr : found;
}

/// With larger ones, sums of products of coordinates would not be finite any more.
constexpr double largest_coordinate = 1e100;

/// Larger ones are not faces of a surface that anybody could use, but mistakes or attacks.
constexpr std::size_t most_corners = 1U << 16U;

double largest(const Polygon_soup& soup) {
  double size = 0;
  for (const Point& p : soup.points)
    size = std::max({size, std::abs(p[0]), std::abs(p[1]), std::abs(p[2])});
  return size;
}

Polygon_soup read_soup(const Format& format, const std::string& file) {
  Polygon_soup soup = format.read(content_of(file));
  if (const double size = largest(soup); size > largest_coordinate)
    throw std::runtime_error(
        fmt::format("expected coordinates of at most {}, found one of {}", largest_coordinate, size));
  const auto polygon = std::find_if(soup.polygons.begin(), soup.polygons.end(),
                                    [](const Polygon& p) { return p.size() > most_corners; });
  if (polygon != soup.polygons.end())
    throw std::runtime_error(fmt::format("expected faces of at most {} vertices, found {} at face {} (of {})",
                                         most_corners, polygon->size(), polygon - soup.polygons.begin() + 1,
                                         soup.polygons.size()));
  if (format.read == read_stl)
    weld(soup, 0);
  return soup;
}

double weld_tolerance(const Format& format, const Polygon_soup& soup, const Mesh_reading_options& options) {
  constexpr double two_units_in_the_last_place = 0x1p-22; // of a float
  if (!options.weld_tolerance)
    return format.read == read_stl ? two_units_in_the_last_place * largest(soup) : 0;
  const double most = diagonal(soup.points) / 100;
  if (!(*options.weld_tolerance >= 0 && *options.weld_tolerance <= most))
    throw std::invalid_argument(
        fmt::format("the tolerance for welding is {}; for this mesh it must be from 0 to {:.3g}, a "
                    "hundredth of its size",
                    *options.weld_tolerance, most));
  return *options.weld_tolerance;
}

} // namespace

bool is_mesh_file(const std::string& file) {
  return format_of(file) != nullptr;
}

Mesh read_mesh(const std::string& file, const Mesh_reading_options& options) {
  Polygon_soup soup;
  const Format* format = format_of(file);
  with_name_in_errors(file, [&] {
    if (!format)
      throw std::runtime_error("its name has none of the extensions that are read: .off .obj .ply .stl .om");
    soup = read_soup(*format, file);
  });
  const double tolerance = weld_tolerance(*format, soup, options);
  return with_name_in_errors(file, [&] { return repair(std::move(soup), tolerance); });
}

} // namespace CGAL::Extremal_mesh_3
