// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_CELLS_SLICES_H
#define EXTREMAL_MESH_3_SRC_CELLS_SLICES_H

#include "Active_cubes.h"

#include <cstdint>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

/// The values at the nodes of a slice of a lattice, and which of them are not negative: 1, or else 0.
struct Slice_values {
  const double* values = nullptr;
  const std::uint8_t* signs = nullptr;
};

/// The values of a function at the nodes of a lattice around active cubes, a block of slices at a time.
class Slices {
public:
  /// so many slices before a block are still there
  static constexpr std::size_t kept = 3;

  Slices(const Function_3& f, const Lattice& lattice, const Active_cubes& active);

  /// computes the next slices.
  void compute_more(Thread_pool& pool);
  /// the first slice that has not been computed yet.
  std::size_t end() const { return end_; }
  /// slice k, one of the last block or of those kept before it.
  Slice_values operator[](std::size_t k) const {
    const std::size_t at = (k - first_) * nodes_;
    return {values_.data() + at, signs_.data() + at};
  }

private:
  void compute(std::size_t k, double* values, std::uint8_t* signs) const;

  const Function_3& f_;
  const Lattice& lattice_;
  const Active_cubes& active_;
  std::size_t nodes_, block_, first_ = 0, end_ = 0; ///< slices [first_, end_) are there
  std::vector<double> values_;
  std::vector<std::uint8_t> signs_;
};

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_CELLS_SLICES_H
