// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_CELLS_HIDDEN_PARTS_H
#define EXTREMAL_MESH_3_SRC_CELLS_HIDDEN_PARTS_H

#include "Octree.h"
#include "Slices.h"
#include "parallel.h"

#include <CGAL/Extremal_mesh_3/Function_3.h>

#include <vector>

namespace CGAL::Extremal_mesh_3 {

/// Looks for parts of the surface that the signs at the nodes do not show, where f cannot be bounded. It finds what is
/// likely, and proves nothing.
class Hidden_parts {
public:
  explicit Hidden_parts(const Lattice& lattice) : lattice_(lattice) {}

  /// looks at the cubes between slices of the lattice: where values change by the second differences that those around
  /// have, do they reach 0 inside of a cube without a change of sign?
  /// \param first  the first slice that is new since the last time
  void look(std::size_t first, const Slices& slices, Thread_pool& pool);

  /// divides the suspects of `look()` in which f does change its sign, and the cubes that the surface is known to
  /// meet in which it does so twice between nodes: on an edge or in a face.
  /// \param cubes  in which there are polygons
  void divide(const Function_3& f, const std::vector<Grid_cube>& cubes, Thread_pool& pool, Octree& tree) const;

private:
  /// the suspects between slices k and k + 1.
  std::vector<Grid_cube> suspects_between(const Slices& slices, std::size_t k) const;

  const Lattice& lattice_;
  std::vector<Grid_cube> suspects_;
};

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_CELLS_HIDDEN_PARTS_H
