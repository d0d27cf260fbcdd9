// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_PATHS_H
#define CGAL_EXTREMAL_MESH_3_PATHS_H

#include <CGAL/Extremal_mesh_3/Extremal_mesh.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

/// A way along the lines.
struct Path {
  std::vector<Half_edge> half_edges; ///< each starts where the one before ends
  double length = 0;                 ///< in the input's unit
};

/// finds the shortest way along the lines from one vertex to another, by Dijkstra's algorithm with the lengths of the edges.
/// Of ways of equal length it is always the same. O((V + E) log V).
/// \param mesh  an extremal mesh
/// \param from,to  numbers of its vertices
/// \return nothing if no way leads there
/// \throws std::invalid_argument if there is no such vertex, or an edge of negative length
std::optional<Path> shortest_path(const Extremal_mesh& mesh, std::uint32_t from, std::uint32_t to);

/// Which vertices hang together by lines.
struct Connected_components {
  std::size_t number = 0;               ///< of components
  std::vector<std::uint32_t> of_vertex; ///< numbered in the order of their smallest vertex
};

/// finds the connected components of the graph. They are not those of the surface: a component of the surface has several
/// where lines do not meet, and none where it has no line. O(V + E).
/// \param mesh  an extremal mesh
/// \return the component of each vertex
Connected_components connected_components(const Extremal_mesh& mesh);

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_PATHS_H
