// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vti.h"

#include "../differential/vector.h"
#include "../io/Xml_reader.h"
#include "change_of_coordinates.h"
#include "parse_number.h"
#include "vti_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

namespace {

constexpr std::size_t least_size = 4; // along an axis, as for other images

std::vector<std::string_view> words(std::string_view text) {
  std::vector<std::string_view> found;
  constexpr std::string_view space = " \t\r\n";
  for (std::size_t at = text.find_first_not_of(space); at != text.npos; at = text.find_first_not_of(space, at)) {
    const std::size_t end = std::min(text.find_first_of(space, at), text.size());
    found.push_back(text.substr(at, end - at));
    at = end;
  }
  return found;
}

/// the numbers of an attribute.
template <std::size_t N>
std::array<double, N> numbers(const Xml_reader& xml, std::string_view attribute,
                              const std::array<double, N>& otherwise) {
  const std::string_view text = xml.attribute(attribute);
  if (text.empty())
    return otherwise;
  std::array<double, N> result;
  const auto found = words(text);
  bool good = found.size() == N;
  for (std::size_t i = 0; i < N && good; ++i) {
    const auto number = parse_number(found[i]);
    good = number && std::isfinite(*number);
    result[i] = number.value_or(0);
  }
  if (!good)
    throw std::runtime_error(fmt::format("its {} is '{}'; expected {} numbers", attribute, text.substr(0, 100), N));
  return result;
}

/// the lattice of an ImageData element.
Lattice lattice_of(const Xml_reader& xml) {
  const auto extent = numbers<6>(xml, "WholeExtent", {});
  const auto origin = numbers<3>(xml, "Origin", {0, 0, 0}), spacing = numbers<3>(xml, "Spacing", {1, 1, 1});
  const auto direction = numbers<9>(xml, "Direction", {1, 0, 0, 0, 1, 0, 0, 0, 1});
  Lattice lattice;
  lattice.origin = origin;
  for (std::size_t a = 0; a < 3; ++a) {
    const double size = extent[2 * a + 1] - extent[2 * a] + 1;
    constexpr double largest = 1e9;
    if (!(size >= double(least_size) && size < largest && size == std::floor(size)))
      throw std::runtime_error(
          fmt::format("its size along axis {} is {}; expected at least {}", a + 1, size, least_size));
    if (!(spacing[a] > 0))
      throw std::runtime_error(
          fmt::format("its spacing along axis {} is {}; expected a positive number", a + 1, spacing[a]));
    lattice.size[a] = std::size_t(size);
    for (std::size_t i = 0; i < 3; ++i)
      lattice.step[a][i] = spacing[a] * direction[3 * i + a] + 0.0; // no −0
    lattice.origin = lattice.origin + extent[2 * a] * lattice.step[a];
  }
  if (!inverse_of_columns(lattice.step))
    throw std::runtime_error("its direction matrix is singular");
  return lattice;
}

/// calls use(Number()) for a type of number by VTK's name.
template <class Use> void with_number(std::string_view type, const Use& use) {
  if (type == "Int8")
    return use(std::int8_t());
  if (type == "UInt8")
    return use(std::uint8_t());
  if (type == "Int16")
    return use(std::int16_t());
  if (type == "UInt16")
    return use(std::uint16_t());
  if (type == "Int32")
    return use(std::int32_t());
  if (type == "UInt32")
    return use(std::uint32_t());
  if (type == "Int64")
    return use(std::int64_t());
  if (type == "UInt64")
    return use(std::uint64_t());
  if (type == "Float32")
    return use(float());
  if (type == "Float64")
    return use(double());
  throw std::runtime_error(fmt::format("its voxels are of the type '{}', which is not supported", type.substr(0, 40)));
}

void read_text(std::string_view text, Voxels& voxels, std::size_t n) {
  const auto found = words(text);
  if (found.size() != n)
    throw std::runtime_error(fmt::format("it has {} voxels as text; expected {}", found.size(), n));
  for (const std::string_view word : found) {
    const auto number = parse_number(word);
    if (!number)
      throw std::runtime_error(
          fmt::format("its voxel {} is '{}'; expected a number", voxels.size(), word.substr(0, 20)));
    voxels.push_back(float(*number));
  }
}

void convert(const std::string& bytes, std::string_view type, bool swapped, Voxels& voxels) {
  with_number(type, [&](auto number) {
    std::array<char, sizeof number> one;
    for (std::size_t i = 0; i + sizeof number <= bytes.size(); i += sizeof number) {
      std::memcpy(one.data(), bytes.data() + i, sizeof number);
      if (swapped)
        std::reverse(one.begin(), one.end());
      std::memcpy(&number, one.data(), sizeof number);
      voxels.push_back(static_cast<float>(number));
    }
  });
}

/// The array that holds the voxels.
struct Array {
  std::string type, format;
  std::optional<std::size_t> offset; ///< in the appended data
  std::string text;                  ///< otherwise
};

/// goes to the next start tag of that name.
/// \return false if there is none before the end of the text, or before the start of `before`
bool find_start(Xml_reader& xml, std::string_view name, std::string_view before = "") {
  for (Xml_reader::Tag tag = xml.next(); tag != Xml_reader::Tag::end_of_text; tag = xml.next())
    if (tag == Xml_reader::Tag::start) {
      if (xml.name() == name)
        return true;
      if (!before.empty() && xml.name() == before)
        return false;
    }
  return false;
}

/// reads the arrays of a PointData element up to the one that is meant.
Array find_array(Xml_reader& xml) {
  const std::string scalars(xml.attribute("Scalars"));
  bool has_vectors = false;
  for (Xml_reader::Tag tag = xml.next(); !(tag == Xml_reader::Tag::end && xml.name() == "PointData");
       tag = xml.next()) {
    if (tag == Xml_reader::Tag::end_of_text)
      break;
    if (tag != Xml_reader::Tag::start || xml.name() != "DataArray" ||
        (!scalars.empty() && xml.attribute("Name") != scalars))
      continue;
    const std::string_view components = xml.attribute("NumberOfComponents");
    if (!components.empty() && components != "1") {
      has_vectors = true;
      continue;
    }
    Array array{std::string(xml.attribute("type")), std::string(xml.attribute("format")), std::nullopt, ""};
    if (array.format == "appended") {
      const auto offset = parse_number(xml.attribute("offset"));
      if (!offset || !(*offset >= 0 && *offset < 1e18))
        throw std::runtime_error("its array of voxels has no offset");
      array.offset = std::size_t(*offset);
    } else {
      xml.next();
      array.text = xml.text();
    }
    return array;
  }
  throw std::runtime_error(has_vectors ? "it has several values per voxel; expected one"
                                       : "it holds no values at points");
}

std::string whole(const std::string& file, std::uint64_t limit) {
  std::ifstream in(file, std::ios::binary | std::ios::ate);
  const auto size = in.tellg();
  if (!in || size < 0)
    throw std::runtime_error("it cannot be opened");
  if (std::uint64_t(size) > limit)
    throw std::runtime_error("it is longer than the memory that it may take");
  std::string text(std::size_t(size), '\0');
  in.seekg(0);
  in.read(text.data(), size);
  if (in.gcount() != size)
    throw std::runtime_error("it became shorter while it was read");
  return text;
}

} // namespace

Image read_vti(const std::string& file, const Image_reading_options& options) {
  const std::string text = whole(file, options.memory_limit);
  Xml_reader xml("line", text);
  if (!find_start(xml, "VTKFile") || xml.attribute("type") != "ImageData")
    throw std::runtime_error("it is not an image in VTK's XML format");
  Vti_encoding encoding;
  encoding.is_big_endian = xml.attribute("byte_order") == "BigEndian";
  encoding.bytes_of_sizes = xml.attribute("header_type") == "UInt64" ? 8 : 4;
  const std::string compressor(xml.attribute("compressor"));
  encoding.is_compressed = !compressor.empty();
  if (!find_start(xml, "ImageData"))
    throw std::runtime_error("it holds no ImageData");
  Image image;
  image.lattice = lattice_of(xml);
  const auto extent = numbers<6>(xml, "WholeExtent", {});
  if (!find_start(xml, "Piece") || numbers<6>(xml, "Extent", {}) != extent)
    throw std::runtime_error("its voxels are in several pieces, which is not supported");
  if (!find_start(xml, "PointData", "AppendedData"))
    throw std::runtime_error("it holds no values at points");
  const Array array = find_array(xml);
  if (encoding.is_compressed && array.format != "ascii" && compressor != "vtkZLibDataCompressor")
    throw std::runtime_error(
        fmt::format("it is compressed by {}, which is not supported; expected zlib", compressor.substr(0, 40)));

  const double voxels = double(image.lattice.size[0]) * double(image.lattice.size[1]) * double(image.lattice.size[2]);
  constexpr double best_compression = 1032, memory_of_voxel = 2 * sizeof(double); // stored, and as floats
  if (voxels > best_compression * double(text.size()))
    throw std::runtime_error(fmt::format("it is truncated: expected {} voxels, found {} bytes", voxels, text.size()));
  if (voxels * memory_of_voxel + double(text.size()) > double(options.memory_limit))
    throw std::runtime_error("to read it takes more memory than it may take");
  const auto n = std::size_t(voxels);
  image.voxels.reserve(n);
  if (array.format == "ascii") {
    read_text(array.text, image.voxels, n);
  } else {
    std::size_t size = 0;
    with_number(array.type, [&](auto number) { size = n * sizeof number; });
    std::string bytes;
    if (array.offset) {
      if (!find_start(xml, "AppendedData"))
        throw std::runtime_error("it is truncated: it has no appended data");
      encoding.is_base64 = xml.attribute("encoding") != "raw";
      // what is not XML any more begins behind an underscore
      const std::size_t tag = text.find("<AppendedData"), begin = text.find('_', text.find('>', tag));
      if (begin == text.npos || *array.offset >= text.size() - begin - 1)
        throw std::runtime_error("it is truncated: its appended data end before its voxels");
      bytes = decode_vti_array(std::string_view(text).substr(begin + 1 + *array.offset), encoding, size);
    } else {
      encoding.is_base64 = true;
      bytes = decode_vti_array(array.text, encoding, size);
    }
    convert(bytes, array.type, encoding.is_big_endian == (std::endian::native == std::endian::little), image.voxels);
  }
  for (std::size_t i = 0; i < n; ++i)
    if (!std::isfinite(image.voxels[i]))
      throw std::runtime_error(fmt::format("its voxel {} is {}; expected a finite number", i, image.voxels[i]));
  return image;
}

} // namespace CGAL::Extremal_mesh_3
