// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Greg Turk's polygon file format: the elements vertex and face; all else in it is left out.
#include "../images/parse_number.h"
#include "Bytes.h"
#include "Word_reader.h"
#include "ply_header.h"
#include "soup_readers.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace CGAL::Extremal_mesh_3 {

namespace {

using Element = Ply_header::Element;
using Property = Ply_header::Property;

/// The numbers after the header.
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

std::size_t least_size(const Property& p) {
  return size_of(p.length.value_or(p.type));
}

/// calls each(property) as often as there are elements, for each property.
template <typename Each> void for_each_property(const Element& element, Ply_numbers& numbers, const Each& each) {
  if (element.properties.empty())
    return;
  std::size_t bytes = 0;
  for (const Property& property : element.properties)
    bytes += least_size(property);
  numbers.require(element.count, bytes, element.name.c_str());
  for (std::uint64_t i = 0; i < element.count; ++i)
    for (std::size_t p = 0; p < element.properties.size(); ++p)
      each(p, i);
}

std::uint64_t list_length(const Property& property, Ply_numbers& numbers) {
  const double n = numbers.next(*property.length, "the length of a list");
  if (!(n >= 0 && n == std::floor(n)))
    numbers.refuse(n, "the length of a list");
  const auto length = std::uint64_t(std::min(n, 1e18));
  numbers.require(length, size_of(property.type), "a number of a list");
  return length;
}

void skip(const Property& property, Ply_numbers& numbers) {
  const std::uint64_t n = property.length ? list_length(property, numbers) : 1;
  for (std::uint64_t i = 0; i < n; ++i)
    numbers.next(property.type, "a number");
}

void read_vertices(const Element& element, Ply_numbers& numbers, std::vector<Point>& points) {
  constexpr std::size_t none = 3;
  std::vector<std::size_t> axis; // of each property
  std::array<bool, 3> known{};
  for (const Property& property : element.properties) {
    const std::size_t a = property.name.size() == 1 && !property.length ? std::size_t(property.name[0] - 'x') : none;
    axis.push_back(std::min(a, none));
    if (a < none)
      known[a] = true;
  }
  if (!known[0] || !known[1] || !known[2])
    throw std::runtime_error("its header: expected properties x, y and z of the element vertex");
  for_each_property(element, numbers, [&](std::size_t p, std::uint64_t i) {
    if (axis[p] == none)
      return skip(element.properties[p], numbers);
    if (points.size() == i)
      points.emplace_back();
    const double value = numbers.next(element.properties[p].type, "a coordinate");
    if (!std::isfinite(value))
      numbers.refuse(value, "a finite coordinate");
    points.back()[axis[p]] = value;
  });
}

void read_faces(const Element& element, Ply_numbers& numbers, std::uint64_t vertices, std::vector<Polygon>& polygons) {
  const auto is_list_of_corners = [](const Property& property) {
    return property.length && (property.name == "vertex_indices" || property.name == "vertex_index");
  };
  const auto corners = std::find_if(element.properties.begin(), element.properties.end(), is_list_of_corners);
  if (corners == element.properties.end())
    throw std::runtime_error("its header: expected a list vertex_indices of the element face");
  for_each_property(element, numbers, [&](std::size_t p, std::uint64_t) {
    const Property& property = element.properties[p];
    if (&property != &*corners)
      return skip(property, numbers);
    polygons.emplace_back(list_length(property, numbers));
    for (std::uint32_t& corner : polygons.back()) {
      const double value = numbers.next(property.type, "the index of a vertex");
      if (!(value >= 0 && value < double(vertices) && value == std::floor(value)))
        numbers.refuse(value, fmt::format("the index of a vertex from 0 to {}", std::int64_t(vertices) - 1));
      corner = std::uint32_t(value);
    }
  });
}

} // namespace

Polygon_soup read_ply(std::string_view content) {
  const Ply_header header = read_ply_header(content);
  const auto count = [&](std::string_view name) -> std::uint64_t {
    const auto found = std::find_if(header.elements.begin(), header.elements.end(),
                                    [&](const Element& element) { return element.name == name; });
    if (found == header.elements.end())
      throw std::runtime_error(fmt::format("its header: expected an element {}", name));
    return found->count;
  };
  const std::uint64_t vertices = count("vertex");
  count("face");

  Polygon_soup soup;
  Ply_numbers numbers(content, header);
  for (const Element& element : header.elements)
    if (element.name == "vertex" && soup.points.empty())
      read_vertices(element, numbers, soup.points);
    else if (element.name == "face" && soup.polygons.empty())
      read_faces(element, numbers, vertices, soup.polygons);
    else
      for_each_property(element, numbers, [&](std::size_t p, std::uint64_t) { skip(element.properties[p], numbers); });
  return soup;
}

} // namespace CGAL::Extremal_mesh_3
