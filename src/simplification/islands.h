// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_SIMPLIFICATION_ISLANDS_H
#define EXTREMAL_MESH_3_SRC_SIMPLIFICATION_ISLANDS_H

#include "indices.h"

#include <optional>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

/// A small part of the graph that lies, with all that it encloses, within a disk in the cell `outer`. A bump of the surface
/// may end up as one with the indices (1, 1), say two lemons and an extremal point between them; a saddle with (−1, −1).
struct Island {
  std::vector<std::uint32_t> vertices, edges;
  std::vector<std::uint32_t> inner; ///< the cells it encloses
  std::uint32_t outer = Embedded_graph::none;
  Indices sum;
};

/// finds the island that a vertex belongs to, if it is on one, of not too many edges, that is not kept.
std::optional<Island> find_island(const Embedded_graph& graph, std::uint32_t vertex);

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_SIMPLIFICATION_ISLANDS_H
