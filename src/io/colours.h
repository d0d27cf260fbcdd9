// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_IO_COLOURS_H
#define CGAL_EXTREMAL_MESH_3_IO_COLOURS_H

#include <CGAL/Extremal_mesh_3/Extremal_mesh.h>

#include <array>
#include <cstdint>

/// The colours of lines, cells and vertices, the same in files and in pictures: those of Thirion's report (largest
/// curvature orange, second blue, maxima lighter than minima) on two pale tints.
namespace CGAL::Extremal_mesh_3 {

using Colour = std::array<std::uint8_t, 3>; ///< red, green, blue

constexpr Colour line_colour(Line_type type) {
  constexpr std::array<Colour, 4> colours = {Colour{255, 140, 0}, {168, 68, 0}, {70, 165, 255}, {12, 60, 170}};
  return colours[static_cast<std::size_t>(type)];
}

/// warm ivory where E_g > 0, cool grey-blue where E_g < 0.
constexpr Colour cell_colour(int sign) {
  return sign > 0 ? Colour{245, 232, 205} : Colour{196, 210, 226};
}

constexpr Colour vertex_colour(const Extremal_mesh_vertex& vertex) {
  switch (vertex.kind) {
  case Vertex_kind::extremal_point:
    return {40, 40, 40};
  case Vertex_kind::umbilic:
    return vertex.umbilic_type == Umbilic_type::star    ? Colour{214, 39, 160}
           : vertex.umbilic_type == Umbilic_type::lemon ? Colour{30, 160, 60}
                                                        : Colour{110, 200, 40};
  case Vertex_kind::non_generic:
    return {215, 25, 28};
  case Vertex_kind::boundary:
  case Vertex_kind::anchor:
    break;
  }
  return {130, 130, 130};
}

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_IO_COLOURS_H
