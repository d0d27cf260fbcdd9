// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_FITTING_SURFACE_WALK_H
#define EXTREMAL_MESH_3_SRC_FITTING_SURFACE_WALK_H

#include "Mesh_vertices.h"

#include <span>

namespace CGAL::Extremal_mesh_3 {

/// Finds the vertices that are reached from one over the surface. One object serves one thread.
class Surface_walk {
public:
  /// normals of one sheet of the surface are less than this apart: 101 degrees, so that both sides of a square edge
  /// belong to the neighbourhoods of vertices at it, and a crest line comes to lie there
  static constexpr double least_cosine = -0.2;

  Surface_walk(const std::vector<Mesh_vertex>& vertices, const Adjacency& adjacency)
      : vertices_(vertices), adjacency_(adjacency), visited_(vertices.size(), 0) {}

  /// the vertices on a connected piece of the sheet that v is on, inside the ball around v; v is the first.
  /// Valid until the next walk.
  /// \param normal  of the sheet there
  std::span<const std::uint32_t> within_distance(std::uint32_t v, const Vector& normal, double radius);

  /// the vertices on the same sheet within so many steps; v is the first.
  std::span<const std::uint32_t> within_rings(std::uint32_t v, const Vector& normal, int rings);

  /// tells whether more of them are found farther away than the last walk went.
  bool can_grow() const { return can_grow_; }

private:
  void start(std::uint32_t v);
  /// tells whether w is met for the first time.
  bool visit(std::uint32_t w) {
    if (visited_[w] == walk_)
      return false;
    visited_[w] = walk_;
    return true;
  }

  const std::vector<Mesh_vertex>& vertices_;
  const Adjacency& adjacency_;
  std::vector<std::uint32_t> visited_, found_; // visited: the number of the last walk that met the vertex
  std::uint32_t walk_ = 0;
  bool can_grow_ = false;
};

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_FITTING_SURFACE_WALK_H
