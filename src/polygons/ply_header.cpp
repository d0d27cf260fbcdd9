// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ply_header.h"

#include "Word_reader.h"

#include <algorithm>
#include <array>
#include <utility>

namespace CGAL::Extremal_mesh_3 {

namespace {

constexpr std::array<std::size_t, 8> sizes{1, 1, 2, 2, 4, 4, 4, 8};
constexpr std::array<std::array<std::string_view, 2>, 8> type_names{{{"char", "int8"},
                                                                     {"uchar", "uint8"},
                                                                     {"short", "int16"},
                                                                     {"ushort", "uint16"},
                                                                     {"int", "int32"},
                                                                     {"uint", "uint32"},
                                                                     {"float", "float32"},
                                                                     {"double", "float64"}}};
constexpr std::array<std::string_view, 3> format_names{"ascii", "binary_little_endian", "binary_big_endian"};

Ply_type type_of(Word_reader& words) {
  const std::string_view word = words.word();
  const auto found = std::find_if(type_names.begin(), type_names.end(), [&](const auto& names) {
    return std::find(names.begin(), names.end(), word) != names.end();
  });
  if (found == type_names.end())
    throw_expected(line_name(words.line()), "the type of a property, such as float or int", word);
  return static_cast<Ply_type>(found - type_names.begin());
}

std::string name_of(Word_reader& words, const char* expected) {
  const std::string_view word = words.word();
  if (word.empty())
    throw_expected(line_name(words.line()), expected, word);
  return std::string(word);
}

Ply_header::Property property_of(Word_reader& words) {
  Ply_header::Property property;
  Word_reader ahead = words;
  if (ahead.word() == "list") {
    words = ahead;
    property.length = type_of(words);
  }
  property.type = type_of(words);
  property.name = name_of(words, "the name of a property");
  return property;
}

Ply_header::Format format_of(Word_reader& words) {
  const std::string_view word = words.word();
  const auto found = std::find(format_names.begin(), format_names.end(), word);
  if (found == format_names.end())
    throw_expected(line_name(words.line()), "ascii, binary_little_endian or binary_big_endian", word);
  return static_cast<Ply_header::Format>(found - format_names.begin());
}

} // namespace

std::size_t size_of(Ply_type type) {
  return sizes[static_cast<std::size_t>(type)];
}

Ply_header read_ply_header(std::string_view content) {
  Ply_header header;
  bool has_format = false;
  while (header.size < content.size()) {
    const std::size_t end = std::min(content.find('\n', header.size), content.size());
    Word_reader words(content.substr(header.size, end - header.size), 0, ++header.lines);
    header.size = std::min(end + 1, content.size());
    const std::string_view keyword = words.word();
    if (header.lines == 1) {
      if (keyword != "ply")
        throw_expected(line_name(1), "the word ply", keyword);
    } else if (keyword == "format") {
      header.format = format_of(words);
      has_format = true;
    } else if (keyword == "element") {
      header.elements.push_back({name_of(words, "the name of an element"), 0, {}});
      header.elements.back().count = words.number("the number of its elements");
    } else if (keyword == "property" && !header.elements.empty())
      header.elements.back().properties.push_back(property_of(words));
    else if (keyword == "end_header") {
      if (!has_format)
        throw_expected(line_name(header.lines), "the format, such as ascii, before", keyword);
      return header;
    } else if (keyword != "comment" && keyword != "obj_info" && !keyword.empty())
      throw_expected(line_name(header.lines), "format, element, property or end_header", keyword);
  }
  throw_expected(line_name(header.lines), "the word end_header", "");
}

} // namespace CGAL::Extremal_mesh_3
