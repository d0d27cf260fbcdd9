// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_POLYGONS_PLY_NUMBERS_H
#define EXTREMAL_MESH_3_SRC_POLYGONS_PLY_NUMBERS_H

#include "../images/parse_number.h"
#include "Bytes.h"
#include "Word_reader.h"
#include "ply_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace CGAL::Extremal_mesh_3 {

/// The numbers after the header of a PLY file.
class Ply_numbers {
public:
  Ply_numbers(std::string_view content, const Ply_header& header)
      : is_text_(header.format == Ply_header::Format::ascii), words_(content.substr(header.size), 0, header.lines + 1),
        bytes_(content, header.size,
               header.format == Ply_header::Format::binary_big_endian ? std::endian::big : std::endian::little) {}

  /// \return a number of a type; integers of at most 32 bits are exact doubles
  double next(Ply_type type, const char* expected) {
    if (!is_text_)
      return next_binary(type, expected);
    word_ = words_.word();
    const auto value = parse_number(word_);
    if (!value)
      throw_expected(place(), expected, word_);
    return *value;
  }
  /// \throws std::runtime_error unless so many properties can follow
  void require(std::uint64_t n, std::size_t bytes, const char* expected) const {
    if (!is_text_)
      bytes_.require(n, bytes, expected);
    else if (n > (words_.rest().size() + 1) / 2) // a digit and a blank
      throw std::runtime_error(fmt::format("{}: expected {} times {}, which is more than the rest of the file can hold",
                                           place(), n, expected));
  }
  std::string place() const { return is_text_ ? line_name(words_.line()) : fmt::format("byte {}", bytes_.position()); }
  /// \throws std::runtime_error for the last number read
  [[noreturn]] void refuse(double value, const std::string& expected) const {
    throw_expected(place(), expected, is_text_ ? std::string(word_) : fmt::format("{}", value));
  }

private:
  double next_binary(Ply_type type, const char* expected) {
    switch (type) {
    case Ply_type::int8:
      return bytes_.next<std::int8_t>(expected);
    case Ply_type::uint8:
      return bytes_.next<std::uint8_t>(expected);
    case Ply_type::int16:
      return bytes_.next<std::int16_t>(expected);
    case Ply_type::uint16:
      return bytes_.next<std::uint16_t>(expected);
    case Ply_type::int32:
      return bytes_.next<std::int32_t>(expected);
    case Ply_type::uint32:
      return bytes_.next<std::uint32_t>(expected);
    case Ply_type::float32:
      return double(bytes_.next<float>(expected));
    case Ply_type::float64:
      break;
    }
    return bytes_.next<double>(expected);
  }

  bool is_text_;
  Word_reader words_;
  Bytes bytes_;
  std::string_view word_;
};

/// the number of bytes that a property takes at least.
inline std::size_t least_size(const Ply_header::Property& p) {
  return size_of(p.length.value_or(p.type));
}

/// calls each(number of a property, number of an element) for each property of each element, in the file's order.
template <typename Each>
void for_each_property(const Ply_header::Element& element, Ply_numbers& numbers, const Each& each) {
  if (element.properties.empty())
    return;
  std::size_t bytes = 0;
  for (const Ply_header::Property& property : element.properties)
    bytes += least_size(property);
  numbers.require(element.count, bytes, element.name.c_str());
  for (std::uint64_t i = 0; i < element.count; ++i)
    for (std::size_t p = 0; p < element.properties.size(); ++p)
      each(p, i);
}

/// reads how long a list is.
inline std::uint64_t list_length(const Ply_header::Property& property, Ply_numbers& numbers) {
  const double n = numbers.next(*property.length, "the length of a list");
  if (!(n >= 0 && n == std::floor(n)))
    numbers.refuse(n, "the length of a list");
  const auto length = std::uint64_t(std::min(n, 1e18));
  numbers.require(length, size_of(property.type), "a number of a list");
  return length;
}

/// reads a property that is not wanted.
inline void skip(const Ply_header::Property& property, Ply_numbers& numbers) {
  const std::uint64_t n = property.length ? list_length(property, numbers) : 1;
  for (std::uint64_t i = 0; i < n; ++i)
    numbers.next(property.type, "a number");
}

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_POLYGONS_PLY_NUMBERS_H
