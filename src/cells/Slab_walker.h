// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_CELLS_SLAB_WALKER_H
#define EXTREMAL_MESH_3_SRC_CELLS_SLAB_WALKER_H

#include "Active_cubes.h"
#include "Slices.h"
#include "refine_folds.h"

#include <CGAL/Extremal_mesh_3/Function_3.h>

#include <cstdint>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

/// makes the polygons between neighbouring slices of a lattice, from one slab to the next.
class Slab_walker {
public:
  Slab_walker(const Function_3& f, const Lattice& lattice, const Active_cubes& active);

  /// makes the polygons between slices k and k + 1.
  void walk(std::size_t k, const Slice_values& low, const Slice_values& high);

  Woven_cells woven;

private:
  /// The points on edges of the lattice that begin at the nodes of a slice, in one direction. Few are set: emptying costs
  /// what setting did.
  class Points {
  public:
    explicit Points(std::size_t nodes) : ids_(nodes, none) {}
    /// \param next  the number that a new point gets
    /// \return the number of the point, and whether it is new
    std::pair<std::uint32_t, bool> id_at(std::size_t node, std::size_t next) {
      const bool is_new = ids_[node] == none;
      if (is_new) {
        ids_[node] = std::uint32_t(next);
        set_.push_back(std::uint32_t(node));
      }
      return {ids_[node], is_new};
    }
    void clear() {
      for (const std::uint32_t node : set_)
        ids_[node] = none;
      set_.clear();
    }

  private:
    static constexpr std::uint32_t none = 0xffffffffU;
    std::vector<std::uint32_t> ids_, set_;
  };

  void row(std::size_t j, const Active_cubes::Range& cubes);
  void cube(std::size_t i, std::size_t j);
  bool plus_corners_joined(const std::array<int, 4>& face, const std::array<double, 8>& value, std::size_t i,
                           std::size_t j) const;
  std::uint32_t point_on(int edge, std::size_t i, std::size_t j, const std::array<double, 8>& value);

  const Function_3& f_;
  const Lattice& lattice_;
  const Active_cubes& active_;
  std::size_t nx_, ny_, k_ = 0;
  bool left_handed_ = false;
  std::array<Slice_values, 2> slices_;
  std::array<Points, 2> low_, high_; ///< along x, along y
  Points z_;
  std::vector<std::uint8_t> columns_; ///< of a row of cubes: the signs of the four nodes with the same i
};

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_CELLS_SLAB_WALKER_H
