// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_QUERIES_REQUIRE_H
#define EXTREMAL_MESH_3_SRC_QUERIES_REQUIRE_H

#include <CGAL/Extremal_mesh_3/Extremal_mesh.h>

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string_view>

namespace CGAL::Extremal_mesh_3 {

/// \throws std::invalid_argument if a mesh that has so many elements of a kind has none with that number
inline void require_element(std::string_view kind, std::size_t id, std::size_t number) {
  if (id < number)
    return;
  throw std::invalid_argument(
      number == 0 ? fmt::format("there is no {} {}: the mesh has none", kind, id)
                  : fmt::format("there is no {} {}: the mesh has those from 0 to {}", kind, id, number - 1));
}
inline void require_vertex(const Extremal_mesh& mesh, std::size_t v) {
  require_element("vertex", v, mesh.number_of_vertices());
}
inline void require_edge(const Extremal_mesh& mesh, std::size_t e) {
  require_element("edge", e, mesh.number_of_edges());
}
inline void require_half_edge(const Extremal_mesh& mesh, std::size_t h) {
  require_element("half-edge", h, 2 * mesh.number_of_edges());
}
inline void require_cell(const Extremal_mesh& mesh, std::size_t c) {
  require_element("cell", c, mesh.number_of_cells());
}

inline bool is_finite(const Point& p) {
  return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
}
/// \throws std::invalid_argument if a coordinate is not finite
inline void require_finite(const Point& p) {
  if (!is_finite(p))
    throw std::invalid_argument(fmt::format("the point ({}, {}, {}) is not finite", p[0], p[1], p[2]));
}

/// \throws std::invalid_argument if there are more things than 32 bits can number
inline void require_number(std::size_t things) {
  if (things > std::numeric_limits<std::uint32_t>::max())
    throw std::invalid_argument(fmt::format("{} segments or triangles are more than can be searched", things));
}

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_QUERIES_REQUIRE_H
