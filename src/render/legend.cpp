// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "lettering.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

namespace {

struct Entry {
  std::string_view text;
  Colour colour;
  bool is_line;
};

std::vector<Entry> entries_for(const Extremal_mesh& mesh, Shown_lines shown) {
  if (shown == Shown_lines::none)
    return {};
  if (shown == Shown_lines::crest)
    return {{to_string(Line_type::max_largest), line_colour(Line_type::max_largest), true}};
  std::array<bool, 4> lines{};
  for (std::size_t e = 0; e < mesh.number_of_edges(); ++e)
    for (const Line_type type : mesh.edge(e).segment_types)
      lines[static_cast<std::size_t>(type)] = true;
  std::array<bool, 5> kinds{};
  std::array<bool, 4> umbilics{};
  for (std::size_t v = 0; v < mesh.number_of_vertices(); ++v) {
    const Extremal_mesh_vertex& vertex = mesh.vertex(v);
    if (vertex.kind == Vertex_kind::umbilic)
      umbilics[static_cast<std::size_t>(vertex.umbilic_type)] = true;
    else
      kinds[static_cast<std::size_t>(vertex.kind)] = true;
  }

  std::vector<Entry> entries;
  for (std::size_t i = 0; i < lines.size(); ++i)
    if (lines[i])
      entries.push_back({to_string(static_cast<Line_type>(i)), line_colour(static_cast<Line_type>(i)), true});
  const auto add_dot = [&](const Extremal_mesh_vertex& vertex, std::string_view text) {
    entries.push_back({text, vertex_colour(vertex), false});
  };
  Extremal_mesh_vertex vertex;
  vertex.kind = Vertex_kind::umbilic;
  for (std::size_t i = 0; i < umbilics.size(); ++i)
    if (umbilics[i]) {
      vertex.umbilic_type = static_cast<Umbilic_type>(i);
      add_dot(vertex, i == 0 ? to_string(vertex.kind) : to_string(vertex.umbilic_type));
    }
  for (const Vertex_kind kind : {Vertex_kind::extremal_point, Vertex_kind::non_generic, Vertex_kind::boundary})
    if (kinds[static_cast<std::size_t>(kind)]) {
      vertex.kind = kind;
      add_dot(vertex, to_string(kind));
    }
  return entries;
}

} // namespace

void draw_legend(Picture& picture, const Extremal_mesh& mesh, Shown_lines shown) {
  const std::vector<Entry> entries = entries_for(mesh, shown);
  const int scale = picture.width() >= 1200 ? 2 : 1;
  const int row = 12 * scale, margin = 10 * scale, swatch = 18 * scale, longest = 14 * text_width("m", scale);
  int y = picture.height() - margin - row * int(entries.size());
  // a legend on more than a quarter of the picture would hide what it explains
  if (4 * (2 * margin + swatch + longest) > 2 * picture.width() || 2 * y < picture.height())
    return;
  for (const Entry& entry : entries) {
    const int middle = y + row / 2;
    if (entry.is_line)
      fill(picture, margin, middle - scale, swatch, 2 * scale, entry.colour);
    else
      fill(picture, margin + swatch / 2 - 3 * scale, middle - 3 * scale, 6 * scale, 6 * scale, entry.colour);
    write_text(picture, margin + swatch + 6 * scale, middle - 4 * scale, entry.text, scale);
    y += row;
  }
}

} // namespace CGAL::Extremal_mesh_3
