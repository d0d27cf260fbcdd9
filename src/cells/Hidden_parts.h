// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_CELLS_HIDDEN_PARTS_H
#define EXTREMAL_MESH_3_SRC_CELLS_HIDDEN_PARTS_H

#include "Octree.h"
#include "parallel.h"

#include <CGAL/Extremal_mesh_3/Function_3.h>

#include <deque>

namespace CGAL::Extremal_mesh_3 {

/// Looks for parts of the surface that the signs at the nodes do not show, where f cannot be bounded. It finds what is
/// likely, and proves nothing.
class Hidden_parts {
public:
  explicit Hidden_parts(const Lattice& lattice) : lattice_(lattice) {}

  /// looks at the cubes between slices of the lattice, given one after the other: where values change by the second
  /// differences that those around have, do they reach 0 inside of a cube without a change of sign?
  void add_slice(const double* values);
  /// after the last slice.
  void end_slices();

  /// divides the suspects of `add_slice()` in which f does change its sign, and the cubes that the surface is known to
  /// meet in which it does so twice between nodes: on an edge or in a face.
  /// \param cubes  in which there are polygons
  void divide(const Function_3& f, const std::vector<Grid_cube>& cubes, Thread_pool& pool, Octree& tree) const;

private:
  void look_between(const double* before, const double* low, const double* high, const double* after);

  const Lattice& lattice_;
  std::deque<std::vector<double>> slices_; ///< the last ones, at most 4
  std::int64_t next_layer_ = 0;
  std::vector<Grid_cube> suspects_;
};

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_CELLS_HIDDEN_PARTS_H
