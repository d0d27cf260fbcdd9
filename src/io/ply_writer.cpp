// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The cells of an extremal mesh as Greg Turk's polygon file format: what MeshLab, CGAL and ParaView read of it are the colours, what
// we read again is all of it. Binary, as text of the same accuracy takes twice the room and ten times the time.
#include "../algorithms/patches.h"
#include "Text_file.h"
#include "cell_colours.h"

#include <CGAL/Extremal_mesh_3/io.h>

#include <algorithm>
#include <bit>
#include <cctype>
#include <cstring>
#include <stdexcept>

namespace CGAL::Extremal_mesh_3 {

namespace {

template <typename Number> void write_binary(Text_file& out, Number number) {
  std::array<char, sizeof(Number)> bytes;
  std::memcpy(bytes.data(), &number, sizeof(Number));
  if constexpr (std::endian::native == std::endian::big)
    std::reverse(bytes.begin(), bytes.end());
  out << std::string_view(bytes.data(), bytes.size());
}

/// a text that may stand in a comment, which ends with its line.
std::string in_one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return std::iscntrl(c) != 0; }, ' ');
  return text;
}

} // namespace

void write_ply(const std::string& file, const Cell_patches& patches, const Extremal_mesh& mesh,
               Cell_colouring colouring) {
  require_patches_of(mesh, patches);
  const std::vector<Colour> colours = cell_colours(mesh, colouring);
  std::size_t most_corners = 0;
  for (std::size_t i = 0; i < patches.cell.size(); ++i)
    most_corners = std::max(most_corners, polygon(patches, i).size());
  // Some readers know lists whose length is a byte only.
  const bool short_lists = most_corners <= 255;

  Text_file out(file);
  out << "ply\nformat binary_little_endian 1.0\ncomment the cells of an extremal mesh\n";
  if (!mesh.surface().frame.empty())
    out << "comment frame " << in_one_line(mesh.surface().frame) << "\n";
  out.print(FMT_COMPILE("element vertex {}\n"), patches.points.size());
  for (const std::string_view name : {"x", "y", "z", "nx", "ny", "nz"})
    out << "property double " << name << "\n";
  out.print(FMT_COMPILE("element face {}\n"), patches.cell.size());
  out << "property list " << (short_lists ? "uchar" : "int") << " int vertex_indices\n";
  for (const std::string_view name : {"red", "green", "blue"})
    out << "property uchar " << name << "\n";
  out << "property int cell\nend_header\n";

  for (std::size_t i = 0; i < patches.points.size(); ++i) {
    for (const double x : patches.points[i])
      write_binary(out, x);
    for (const double x : patches.normals[i])
      write_binary(out, x);
  }
  for (std::size_t i = 0; i < patches.cell.size(); ++i) {
    const auto corners = polygon(patches, i);
    if (short_lists)
      write_binary(out, std::uint8_t(corners.size()));
    else
      write_binary(out, std::int32_t(corners.size()));
    for (const std::uint32_t corner : corners)
      write_binary(out, std::int32_t(corner));
    for (const std::uint8_t part : colours[patches.cell[i]])
      write_binary(out, part);
    write_binary(out, std::int32_t(patches.cell[i]));
  }
  out.commit();
}

} // namespace CGAL::Extremal_mesh_3
