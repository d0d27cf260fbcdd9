// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_TOOL_QUERY_JSON_H
#define EXTREMAL_MESH_3_SRC_TOOL_QUERY_JSON_H

#include <CGAL/Extremal_mesh_3/cell_queries.h>
#include <CGAL/Extremal_mesh_3/lines.h>
#include <CGAL/Extremal_mesh_3/measures.h>

#include <nlohmann/json.hpp>

#include <cstdint>
#include <string>
#include <vector>

/// The parts of an extremal mesh as `query` prints them: what they are, then their measures.
namespace CGAL::Extremal_mesh_3::tool {

using Json = nlohmann::ordered_json;

Json json_of_vertex(const Extremal_mesh& mesh, std::uint32_t v);
Json json_of_edge(const Extremal_mesh& mesh, std::uint32_t e);
Json json_of_line(const Extremal_mesh& mesh, const Extremal_line& line);
/// \param sides  also the boundary walks
Json json_of_cell(const Extremal_mesh& mesh, std::uint32_t c, bool sides);

/// the vertices that half-edges, which follow each other, start from, and the end of the last one.
std::vector<std::uint32_t> vertices_along(const Extremal_mesh& mesh, const std::vector<Half_edge>& half_edges);

/// writes what is short on one line, and the parts of what is not on lines of their own.
std::string pretty(const Json& json);

} // namespace CGAL::Extremal_mesh_3::tool

#endif // EXTREMAL_MESH_3_SRC_TOOL_QUERY_JSON_H
