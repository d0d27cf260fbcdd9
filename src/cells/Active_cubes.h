// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_CELLS_ACTIVE_CUBES_H
#define EXTREMAL_MESH_3_SRC_CELLS_ACTIVE_CUBES_H

#include "parallel.h"

#include <CGAL/Extremal_mesh_3/Function_3.h>

#include <span>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

/// The cubes of a lattice in which the surface may be, by blocks of cubes: with bounds of the function, the cost of the rest
/// does not depend on how many there are.
class Active_cubes {
public:
  /// Cubes [first, last) of a row along x.
  struct Range {
    std::size_t first, last;
  };

  /// all cubes.
  explicit Active_cubes(const Lattice& lattice);
  /// those in blocks in which the function's bounds have a zero.
  Active_cubes(const Function_3& f, const Lattice& lattice, Thread_pool& pool);

  bool are_all() const { return all_; }
  /// the active cubes (·, j, k), in order.
  std::span<const Range> row(std::size_t j, std::size_t k) const { return row_of_block(j / side, k / side); }
  /// the corners of active cubes among the nodes (·, ·, k), in order.
  std::vector<Row_part> nodes(std::size_t k) const;

private:
  static constexpr std::size_t side = 8;

  std::span<const Range> row_of_block(std::size_t j, std::size_t k) const { return ranges_[j + blocks_[1] * k]; }

  const Lattice& lattice_;
  std::array<std::size_t, 3> blocks_{};
  std::vector<std::vector<Range>> ranges_; ///< of the rows of blocks
  bool all_ = false;
};

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_CELLS_ACTIVE_CUBES_H
