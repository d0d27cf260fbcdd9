// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Stereolithography files, text and binary: triangles without connection.
#include "Bytes.h"
#include "Word_reader.h"
#include "soup_readers.h"

#include <algorithm>
#include <cctype>

namespace CGAL::Extremal_mesh_3 {

namespace {

constexpr std::size_t header_size = 80, triangle_size = 50;

bool is(std::string_view word, std::string_view keyword) { // in any case
  return std::equal(word.begin(), word.end(), keyword.begin(), keyword.end(),
                    [](unsigned char a, char b) { return std::tolower(a) == b; });
}

/// Binary files may begin with "solid" too; their size tells.
bool is_text(std::string_view content) {
  if (!is(content.substr(0, 5), "solid"))
    return false;
  if (content.size() < header_size + 4)
    return true;
  const auto triangles = Bytes(content, header_size, std::endian::little).next<std::uint32_t>("");
  return content.size() != header_size + 4 + std::uint64_t(triangles) * triangle_size;
}

Polygon_soup read_binary(std::string_view content) {
  Polygon_soup soup;
  Bytes bytes(content, 0, std::endian::little);
  bytes.skip(1, header_size, "a header of 80 bytes");
  const auto triangles = bytes.next<std::uint32_t>("the number of triangles");
  bytes.require(triangles, triangle_size, "a triangle of 50 bytes");
  for (std::uint32_t t = 0; t < triangles; ++t) {
    bytes.skip(3, sizeof(float), "a normal");
    Polygon polygon;
    for (int corner = 0; corner < 3; ++corner) {
      const double x = bytes.coordinate<float>(), y = bytes.coordinate<float>(), z = bytes.coordinate<float>();
      polygon.push_back(std::uint32_t(soup.points.size()));
      soup.points.push_back({x, y, z});
    }
    soup.polygons.push_back(std::move(polygon));
    bytes.skip(1, 2, "an attribute");
  }
  return soup;
}

Polygon_soup read_text(std::string_view content) {
  Polygon_soup soup;
  Word_reader words(content);
  const auto expect = [&](const char* keyword) {
    if (const std::string_view word = words.word(); !is(word, keyword))
      throw_expected(line_name(words.line()), std::string("the word ") + keyword, word);
  };
  for (std::string_view word = words.word(); !word.empty(); word = words.word()) { // one solid after the other
    if (!is(word, "solid"))
      throw_expected(line_name(words.line()), "the word solid", word);
    words.skip_line(); // its name
    for (word = words.word(); !is(word, "endsolid"); word = words.word()) {
      if (!is(word, "facet"))
        throw_expected(line_name(words.line()), "the word facet or endsolid", word);
      words.skip_line(); // its normal
      expect("outer");
      expect("loop");
      Polygon polygon;
      for (word = words.word(); is(word, "vertex"); word = words.word()) {
        const double x = words.coordinate(), y = words.coordinate(), z = words.coordinate();
        polygon.push_back(std::uint32_t(soup.points.size()));
        soup.points.push_back({x, y, z});
      }
      if (!is(word, "endloop"))
        throw_expected(line_name(words.line()), "the word vertex or endloop", word);
      expect("endfacet");
      soup.polygons.push_back(std::move(polygon));
    }
    words.skip_line();
  }
  return soup;
}

} // namespace

Polygon_soup read_stl(std::string_view content) {
  return is_text(content) ? read_text(content) : read_binary(content);
}

} // namespace CGAL::Extremal_mesh_3
