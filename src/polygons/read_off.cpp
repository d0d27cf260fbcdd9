// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Geomview's object file format (http://www.geomview.org/docs/html/OFF.html), as text.
#include "Word_reader.h"
#include "soup_readers.h"

#include <stdexcept>

namespace CGAL::Extremal_mesh_3 {

namespace {

/// reads the word "OFF" with the letters before it that tell what else the vertices have; it may be missing.
/// \return the content from the counts on
Word_reader after_header(std::string_view content) {
  Word_reader words(content, '#');
  std::string_view header = words.word();
  if (!header.empty() && header.front() >= '0' && header.front() <= '9' && !header.ends_with("OFF"))
    return Word_reader(content, '#');
  if (!header.ends_with("OFF"))
    throw_expected(line_name(words.line()), "the word OFF", header);
  header.remove_suffix(3);
  for (const std::string_view attribute : {"ST", "C", "N"}) // texture coordinates, colours, normals: after x y z
    if (header.starts_with(attribute))
      header.remove_prefix(attribute.size());
  if (!header.empty())
    throw_expected(line_name(words.line()), "OFF with vertices x y z", header);
  Word_reader ahead = words;
  if (ahead.word() == "BINARY")
    throw_expected(line_name(ahead.line()), "OFF as text", "BINARY");
  return words;
}

} // namespace

Polygon_soup read_off(std::string_view content) {
  Word_reader words = after_header(content);
  // "0 0 0" takes six characters with the end of the line, "0" two.
  const std::uint64_t vertices = words.count("the number of vertices", 6);
  const std::uint64_t faces = words.count("the number of faces", 2);
  words.skip_line(); // the number of edges, which nobody needs

  Polygon_soup soup;
  for (std::uint64_t i = 0; i < vertices; ++i) {
    const double x = words.coordinate(), y = words.coordinate(), z = words.coordinate();
    soup.points.push_back({x, y, z});
    words.skip_line();
  }
  for (std::uint64_t i = 0; i < faces; ++i) {
    Polygon polygon(words.count("a face's number of vertices", 2));
    for (std::uint32_t& corner : polygon)
      corner = words.index("the index of a vertex", vertices);
    soup.polygons.push_back(std::move(polygon));
    words.skip_line();
  }
  return soup;
}

} // namespace CGAL::Extremal_mesh_3
