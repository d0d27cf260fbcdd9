// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The headers that are lines of text: NRRD (https://teem.sourceforge.net/nrrd/format.html), MetaImage
// (https://itk.org/Wiki/ITK/MetaIO/Documentation) and VTK's legacy format (The VTK User's Guide, "File formats").

#include "image_headers.h"
#include "parse_number.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace CGAL::Extremal_mesh_3 {
namespace {

using Encoding = Stored_voxels::Encoding;

// Longer lines are not in a header: the file is not what its name says.
constexpr std::size_t longest_line = 1 << 16;
constexpr std::size_t longest_key = 80, longest_value = 1000; // of MetaImage

std::string lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t\r");
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::optional<std::string> read_line(std::istream& in) {
  std::string line;
  for (int c; (c = in.get()) != EOF && c != '\n';) {
    line.push_back(static_cast<char>(c));
    if (line.size() > longest_line)
      return std::nullopt;
  }
  return in || !line.empty() ? std::optional(trimmed(line)) : std::nullopt;
}

std::vector<std::string> words(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> found;
  for (std::string word; in >> word;)
    found.push_back(word);
  return found;
}

std::uint64_t position(std::istream& in) {
  in.clear(); // at the end of the file too
  return static_cast<std::uint64_t>(in.tellg());
}

// Finds the file that a header names, relative to its own folder.
std::string data_file(const std::string& header, const std::string& name) {
  if (name.find('%') != std::string::npos || lower_case(name).starts_with("list"))
    throw std::runtime_error("its voxels are in several files, which is not supported");
  const auto path = std::filesystem::path(header).parent_path() / name;
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error))
    throw std::runtime_error(fmt::format("its data file '{}' does not exist", path.string()));
  return path.string();
}

// Whether a value is `count` finite numbers.
bool are_numbers(const std::string& value, std::size_t count, double above = -std::numeric_limits<double>::infinity()) {
  const auto found = words(value);
  return found.size() == count && std::all_of(found.begin(), found.end(), [above](const std::string& word) {
           const auto number = parse_number(word);
           return number && std::isfinite(*number) && *number > above;
         });
}

} // namespace

Stored_voxels find_nrrd_voxels(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  auto line = read_line(in);
  if (!line || !line->starts_with("NRRD"))
    throw std::runtime_error("it is not an NRRD file");
  Stored_voxels stored;
  stored.file = file;
  while ((line = read_line(in)) && !line->empty()) {
    const auto colon = line->find(':');
    if (line->front() == '#' || colon == std::string::npos)
      continue;
    const std::string key = lower_case(line->substr(0, colon));
    const std::string value = trimmed(line->substr(colon + 1));
    if (key == "spacings") {
      if (words(value).size() == 3 && !are_numbers(value, 3, 0)) // ITK takes 1 for a NaN
        throw std::runtime_error(fmt::format("its spacing is '{}'; expected three positive numbers", value));
    } else if (key == "encoding") {
      const std::string encoding = lower_case(value);
      if (encoding == "raw")
        stored.encoding = Encoding::raw;
      else if (encoding == "gzip" || encoding == "gz")
        stored.encoding = Encoding::compressed;
      else if (encoding == "ascii" || encoding == "text" || encoding == "txt")
        stored.encoding = Encoding::text;
      else
        throw std::runtime_error(fmt::format("its encoding '{}' is not supported; expected raw, gzip or ascii", value));
    } else if (key == "data file" || key == "datafile") {
      stored.file = data_file(file, value);
    } else if (key == "line skip" || key == "lineskip" || key == "byte skip" || key == "byteskip") {
      stored.is_plain = false;
    }
  }
  if (!line && stored.file == file)
    throw std::runtime_error("it is truncated: its header has no end");
  // Lines and bytes to be skipped are left to ITK, which reports a truncated NRRD file: what matters here is the size.
  stored.offset = stored.file == file ? position(in) : 0;
  stored.is_plain = stored.is_plain && stored.encoding != Encoding::text;
  return stored;
}

Stored_voxels find_meta_voxels(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  std::map<std::string, std::string> fields;
  while (!fields.contains("ElementDataFile")) {
    const auto line = read_line(in);
    if (!line)
      break;
    const auto equals = line->find('=');
    if (equals == std::string::npos) {
      if (line->empty())
        continue;
      break;
    }
    const std::string key = trimmed(line->substr(0, equals)), value = trimmed(line->substr(equals + 1));
    // MetaIO copies both to places of fixed sizes.
    if (key.size() > longest_key || value.size() > longest_value ||
        std::any_of(line->begin(), line->end(), [](unsigned char c) { return c < ' ' && c != '\t'; }))
      throw std::runtime_error(
          fmt::format("its header has a line '{}…', which is too long or no text", key.substr(0, 20)));
    fields[key] = value;
  }
  for (const char* key : {"NDims", "DimSize", "ElementType", "ElementDataFile"})
    if (!fields.contains(key))
      throw std::runtime_error(fmt::format("it is not a MetaImage file: its header has no {}", key));
  const auto dimension = parse_number(fields["NDims"]);
  if (!dimension || (*dimension != 3 && *dimension != 4))
    throw std::runtime_error(fmt::format("it has {} dimensions; expected 3", fields["NDims"]));
  const auto n = static_cast<std::size_t>(*dimension);
  const std::map<std::string, std::size_t> counts{{"DimSize", n},
                                                  {"ElementSpacing", n},
                                                  {"ElementSize", n},
                                                  {"Offset", n},
                                                  {"Position", n},
                                                  {"Origin", n},
                                                  {"TransformMatrix", n * n},
                                                  {"Rotation", n * n},
                                                  {"Orientation", n * n},
                                                  {"CenterOfRotation", n},
                                                  {"HeaderSize", 1},
                                                  {"CompressedDataSize", 1},
                                                  {"ElementNumberOfChannels", 1}};
  for (const auto& [key, count] : counts)
    if (fields.contains(key) && !are_numbers(fields[key], count))
      throw std::runtime_error(fmt::format("its {} is '{}'; expected {} numbers", key, fields[key], count));
  for (const char* key : {"DimSize", "ElementSpacing", "ElementSize"})
    if (fields.contains(key) && !are_numbers(fields[key], n, 0))
      throw std::runtime_error(fmt::format("its {} is '{}'; expected positive numbers", key, fields[key]));
  const auto is_true = [&](const char* key) {
    const std::string value = lower_case(fields[key]);
    return value.starts_with('t') || value.starts_with('1');
  };
  if (!is_true("BinaryData")) // text is what MetaIO takes for granted
    throw std::runtime_error("its voxels are stored as text, which is not supported for MetaImage");

  Stored_voxels stored;
  const bool is_big_endian = is_true("BinaryDataByteOrderMSB") || is_true("ElementByteOrderMSB");
  stored.are_swapped = is_big_endian == (std::endian::native == std::endian::little);
  const std::string& data = fields["ElementDataFile"];
  const bool is_local =
      data == "LOCAL" || data == "Local" || data == "local"; // MetaIO takes other spellings for a file
  stored.file = is_local ? file : data_file(file, data);
  stored.offset = is_local ? position(in) : 0;
  stored.encoding = is_true("CompressedData") ? Encoding::compressed : Encoding::raw;
  const double skipped = parse_number(fields["HeaderSize"]).value_or(0);
  if (skipped > 0) // −1: they end the file
    stored.offset += static_cast<std::uint64_t>(skipped);
  stored.is_plain = skipped >= 0;
  if (stored.encoding == Encoding::compressed) {
    if (const double size = parse_number(fields["CompressedDataSize"]).value_or(0); size > 0 && size < 1e18)
      stored.size = static_cast<std::uint64_t>(size);
    else if (is_local) // ITK would take the header for compressed data too
      throw std::runtime_error("its header has no CompressedDataSize");
  }
  return stored;
}

Stored_voxels find_vtk_voxels(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  auto line = read_line(in);
  if (!line || !line->starts_with("# vtk DataFile"))
    throw std::runtime_error("it is not a VTK file");
  read_line(in); // the title
  const std::string format = lower_case(read_line(in).value_or(""));
  if (format != "ascii" && format != "binary")
    throw std::runtime_error("its third line is neither ASCII nor BINARY");
  Stored_voxels stored;
  stored.file = file;
  stored.encoding = format == "ascii" ? Encoding::text : Encoding::raw;
  stored.is_plain = stored.encoding != Encoding::text;
  stored.are_swapped = std::endian::native == std::endian::little;
  while ((line = read_line(in))) {
    const auto parts = words(lower_case(*line));
    if (parts.empty())
      continue;
    if (parts[0] == "dataset" && (parts.size() < 2 || parts[1] != "structured_points"))
      throw std::runtime_error("it is not an image: expected DATASET STRUCTURED_POINTS");
    const bool is_length = parts[0] == "spacing" || parts[0] == "aspect_ratio" || parts[0] == "dimensions";
    if ((is_length && !are_numbers(line->substr(parts[0].size()), 3, 0)) ||
        (parts[0] == "origin" && !are_numbers(line->substr(parts[0].size()), 3)))
      throw std::runtime_error(
          fmt::format("its header has '{}'; expected three {}numbers", *line, is_length ? "positive " : ""));
    if (parts[0] == "vectors" || parts[0] == "color_scalars" || parts[0] == "tensors")
      throw std::runtime_error("it has several values per voxel; expected one");
    if (parts[0] != "scalars")
      continue;
    stored.offset = position(in);
    if (const auto next = read_line(in); next && lower_case(*next).starts_with("lookup_table"))
      stored.offset = position(in);
    return stored;
  }
  throw std::runtime_error("it holds no SCALARS");
}

} // namespace CGAL::Extremal_mesh_3
