// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_LINES_H
#define CGAL_EXTREMAL_MESH_3_LINES_H

#include <CGAL/Extremal_mesh_3/Extremal_mesh.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

/// A smooth line of the mesh: edges that continue each other straight through the vertices between them.
struct Extremal_line {
  std::vector<Half_edge> half_edges; ///< each starts where the one before ends; no edge twice
  bool closed = false;               ///< the last one goes on into the first
};

/// tells by which half-edge the line of a half-edge goes on beyond its target.
///
/// - At an extremal point that is the opposite branch, of the same family.
/// - At an umbilic with two or six branches it is the opposite one as well. The lines through an umbilic are smooth there
///   but change family, also at those with three ridges.
/// - At an anchor it is the other branch.
/// - At a boundary vertex, and at a non-generic one, where nothing tells which branches belong together, the line ends.
///
/// `next_on_line(next_on_line(h) ^ 1) == h ^ 1`: a line is the same in both directions. O(degree).
/// \throws std::invalid_argument if there is no such half-edge
/// \param mesh  an extremal mesh
/// \param h  a half-edge of it
/// \return nothing where the line ends
std::optional<Half_edge> next_on_line(const Extremal_mesh& mesh, Half_edge h);

/// gathers the whole line through an edge, in the direction of that edge. A closed line begins with the edge. O(E).
/// \param mesh  an extremal mesh
/// \param edge  its number
/// \return the line
/// \throws std::invalid_argument if there is no such edge
Extremal_line line_through(const Extremal_mesh& mesh, std::uint32_t edge);

/// gathers all lines, each once: every edge is in exactly one. They come in the order of, and run in the direction of,
/// the edge with the smallest id in each. O(V + E).
/// \param mesh  an extremal mesh
/// \return the lines
std::vector<Extremal_line> all_lines(const Extremal_mesh& mesh);

/// gathers the crest lines: maximal chains of edges of type `max_largest` that continue each other straight.
/// \return the `k` of the greatest strength (all if there are fewer), strongest first; those of equal strength in the
///         order of their smallest edge id. O(E log E)
/// \param mesh  an extremal mesh
/// \param k  how many
std::vector<Extremal_line> strongest_crest_lines(const Extremal_mesh& mesh, std::size_t k);

/// joins the polylines of half-edges that follow each other, as those of a line or a path do. The point between two of
/// them comes once; of a closed line the first point is also the last.
/// \param mesh  an extremal mesh
/// \param half_edges  each starts where the one before ends
/// \return the points
/// \throws std::invalid_argument if there is no such half-edge, or one does not start where the one before ends
std::vector<Point> polyline(const Extremal_mesh& mesh, const std::vector<Half_edge>& half_edges);

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_LINES_H
