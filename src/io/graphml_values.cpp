// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "graphml_values.h"

#include <fmt/compile.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <initializer_list>

namespace CGAL::Extremal_mesh_3::graphml {

namespace {

constexpr bool is_space(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}

/// takes the next word off the front of `text`; empty at its end.
std::string_view next_word(std::string_view& text) {
  const auto begin = std::find_if_not(text.begin(), text.end(), is_space);
  const auto end = std::find_if(begin, text.end(), is_space);
  const std::string_view word(begin, end);
  text = std::string_view(end, text.end());
  return word;
}

std::string_view only_word(std::string_view text) {
  const std::string_view word = next_word(text);
  return next_word(text).empty() ? word : std::string_view();
}

/// a text as a message shows it: not too much of it.
std::string quoted(std::string_view text) {
  return text.size() <= 40 ? fmt::format("'{}'", text) : fmt::format("'{}…'", text.substr(0, 40));
}

template <typename T> T number(std::string_view word, std::string_view what) {
  T value{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size())
    throw Value_error(fmt::format("{} is not {}", quoted(word), what));
  return value;
}

double finite_number(std::string_view word) {
  const double value = number<double>(word, "a number");
  if (!std::isfinite(value))
    throw Value_error(fmt::format("{} is not a finite number", quoted(word)));
  return value;
}

template <typename Enum> void parse_name(std::string_view text, std::initializer_list<Enum> values, Enum& value) {
  const std::string_view word = only_word(text);
  for (const Enum candidate : values)
    if (word == to_string(candidate)) {
      value = candidate;
      return;
    }
  std::string expected;
  for (const Enum candidate : values)
    expected += fmt::format("{}{}", expected.empty() ? "" : ", ", to_string(candidate));
  throw Value_error(fmt::format("{} is not one of {}", quoted(text), expected));
}

template <typename Values, typename Append> void append_list(Text& out, const Values& values, Append append_value) {
  bool first = true;
  for (const auto& value : values) {
    if (!first)
      out.push_back(' ');
    first = false;
    append_value(value);
  }
}

/// the length of the UTF-8 sequence of one character that XML can hold at the front of `text`; 0 if there is none.
std::size_t character_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned lead = byte(0);
  if (lead < 0x80)
    return lead >= 0x20 || lead == '\t' || lead == '\n' || lead == '\r' ? 1 : 0;
  const std::size_t length = lead >= 0xF5 ? 0 : lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : lead >= 0xC2 ? 2 : 0;
  if (length == 0 || text.size() < length)
    return 0;
  unsigned code = lead & (0xFFU >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0U) != 0x80)
      return 0;
    code = code << 6 | (byte(i) & 0x3FU);
  }
  const bool overlong = (length == 3 && code < 0x800) || (length == 4 && code < 0x10000);
  const bool excluded = (code >= 0xD800 && code < 0xE000) || code == 0xFFFE || code == 0xFFFF || code > 0x10FFFF;
  return overlong || excluded ? 0 : length;
}

} // namespace

void append(Text& out, double value) {
  if (!std::isfinite(value))
    throw Value_error(fmt::format("{} is not a finite number", value));
  fmt::format_to(std::back_inserter(out), FMT_COMPILE("{}"), value);
}

void append(Text& out, bool value) {
  out.append(std::string_view(value ? "true" : "false"));
}

void append(Text& out, std::string_view value) {
  while (!value.empty()) {
    const std::size_t length = character_length(value);
    const std::string_view character = value.substr(0, std::max<std::size_t>(length, 1));
    value.remove_prefix(character.size());
    if (length == 0)
      out.append(std::string_view("\xEF\xBF\xBD"));
    else if (character == "&")
      out.append(std::string_view("&amp;"));
    else if (character == "<")
      out.append(std::string_view("&lt;"));
    else if (character == ">")
      out.append(std::string_view("&gt;"));
    else if (character == "\r") // as it stands it would be read as an end of line
      out.append(std::string_view("&#13;"));
    else
      out.append(character);
  }
}

void append(Text& out, std::span<const double> values) {
  append_list(out, values, [&](double value) { append(out, value); });
}

void append(Text& out, const std::vector<Point>& points) {
  append_list(out, points, [&](const Point& p) { append(out, std::span<const double>(p)); });
}

void append(Text& out, const std::vector<Line_type>& types) {
  append_list(out, types, [&](Line_type type) { append(out, type); });
}

void append(Text& out, const std::vector<Type_change>& changes) {
  append_list(out, changes, [&](const Type_change& change) {
    append(out, change.point);
    out.push_back(' ');
    append(out, change.kind);
  });
}

void append(Text& out, const std::vector<Half_edge>& half_edges) {
  append_list(out, half_edges, [&](Half_edge h) { append(out, h); });
}

void parse(std::string_view text, double& value) {
  value = finite_number(only_word(text));
}

void parse(std::string_view text, bool& value) {
  const std::string_view word = only_word(text);
  value = word == "true" || word == "True" || word == "1"; // Python writes True
  if (!value && word != "false" && word != "False" && word != "0")
    throw Value_error(fmt::format("{} is not true or false", quoted(text)));
}

void parse(std::string_view text, int& value) {
  value = number<int>(only_word(text), "an integer");
}
void parse(std::string_view text, std::uint32_t& value) {
  value = number<std::uint32_t>(only_word(text), "a non-negative integer");
}
void parse(std::string_view text, std::int64_t& value) {
  value = number<std::int64_t>(only_word(text), "an integer");
}
void parse(std::string_view text, std::size_t& value) {
  value = number<std::size_t>(only_word(text), "a non-negative integer");
}

void parse(std::string_view text, Vertex_kind& value) {
  using enum Vertex_kind;
  parse_name(text, {extremal_point, umbilic, non_generic, boundary, anchor}, value);
}

void parse(std::string_view text, Umbilic_type& value) {
  using enum Umbilic_type;
  parse_name(text, {none, lemon, monstar, star}, value);
}

void parse(std::string_view text, Line_type& value) {
  using enum Line_type;
  parse_name(text, {max_largest, min_largest, max_second, min_second}, value);
}

void parse(std::string_view text, Type_change_kind& value) {
  using enum Type_change_kind;
  parse_name(text, {turning_point, equal_curvatures, parabolic_point, former_vertex}, value);
}

void parse(std::string_view text, std::vector<double>& values) {
  values.clear();
  for (std::string_view word = next_word(text); !word.empty(); word = next_word(text))
    values.push_back(finite_number(word));
}

void parse(std::string_view text, std::vector<Point>& points) {
  std::vector<double> coordinates;
  parse(text, coordinates);
  if (coordinates.size() % 3 != 0)
    throw Value_error(fmt::format("{} coordinates are not a multiple of 3", coordinates.size()));
  points.resize(coordinates.size() / 3);
  for (std::size_t i = 0; i < coordinates.size(); ++i)
    points[i / 3][i % 3] = coordinates[i];
}

void parse(std::string_view text, std::vector<Line_type>& types) {
  types.clear();
  for (std::string_view word = next_word(text); !word.empty(); word = next_word(text))
    parse(word, types.emplace_back());
}

void parse(std::string_view text, std::vector<Type_change>& changes) {
  changes.clear();
  for (std::string_view word = next_word(text); !word.empty(); word = next_word(text)) {
    Type_change& change = changes.emplace_back();
    change.point = number<std::uint32_t>(word, "the number of a point");
    parse(next_word(text), change.kind);
  }
}

void parse(std::string_view text, std::vector<Half_edge>& half_edges) {
  half_edges.clear();
  for (std::string_view word = next_word(text); !word.empty(); word = next_word(text))
    half_edges.push_back(number<Half_edge>(word, "the number of a half-edge"));
}

} // namespace CGAL::Extremal_mesh_3::graphml
