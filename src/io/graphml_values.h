// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_IO_GRAPHML_VALUES_H
#define CGAL_EXTREMAL_MESH_3_IO_GRAPHML_VALUES_H

#include <CGAL/Extremal_mesh_3/Extremal_mesh.h>

#include <fmt/format.h>

#include <array>
#include <concepts>
#include <cstdint>
#include <iterator>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

/// The values of GraphML data elements: their text, and back.
namespace CGAL::Extremal_mesh_3::graphml {

/// A text that is not the value it should be; the message goes after the name of the element.
class Value_error : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

using Text = fmt::memory_buffer;

template <typename T>
constexpr std::string_view type_name = std::is_same_v<T, bool>                    ? "boolean"
                                       : std::is_floating_point_v<T>              ? "double"
                                       : std::is_same_v<T, std::optional<double>> ? "double"
                                       : !std::is_integral_v<T>                   ? "string"
                                       : sizeof(T) > sizeof(int)                  ? "long"
                                                                                  : "int";

/// \name Appends the text of a value.
/// \throws Value_error if a number is not finite
/// @{
void append(Text& out, double value);
void append(Text& out, bool value);
/// escapes what XML wants escaped; what it cannot hold (control characters, bytes that are not UTF-8) becomes U+FFFD.
void append(Text& out, std::string_view value);
void append(Text& out, std::span<const double> values);
void append(Text& out, const std::vector<Point>& points);
void append(Text& out, const std::vector<Line_type>& types);
void append(Text& out, const std::vector<Type_change>& changes);
void append(Text& out, const std::vector<Half_edge>& half_edges);
template <std::integral T> void append(Text& out, T value) {
  fmt::format_to(std::back_inserter(out), "{}", value);
}
template <typename T>
requires std::is_enum_v<T>
void append(Text& out, T value) {
  out.append(to_string(value));
}
inline void append(Text& out, const std::vector<double>& values) {
  append(out, std::span<const double>(values));
}
/// appends nothing if there is none.
inline void append(Text& out, const std::optional<double>& value) {
  if (value)
    append(out, *value);
}
/// @}

/// \name Reads a value from its text.
/// \throws Value_error
/// @{
void parse(std::string_view text, double& value);
void parse(std::string_view text, bool& value);
void parse(std::string_view text, int& value);
void parse(std::string_view text, std::uint32_t& value);
void parse(std::string_view text, std::int64_t& value);
void parse(std::string_view text, std::size_t& value);
void parse(std::string_view text, Vertex_kind& value);
void parse(std::string_view text, Umbilic_type& value);
void parse(std::string_view text, Line_type& value);
void parse(std::string_view text, Type_change_kind& value);
void parse(std::string_view text, std::vector<double>& values);
void parse(std::string_view text, std::vector<Point>& points);
void parse(std::string_view text, std::vector<Line_type>& types);
void parse(std::string_view text, std::vector<Type_change>& changes);
void parse(std::string_view text, std::vector<Half_edge>& half_edges);
inline void parse(std::string_view text, std::optional<double>& value) {
  parse(text, value.emplace());
}
inline void parse(std::string_view text, std::string& value) {
  value = text;
}
/// @}

} // namespace CGAL::Extremal_mesh_3::graphml

#endif // CGAL_EXTREMAL_MESH_3_IO_GRAPHML_VALUES_H
