// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_CELLS_UNION_FIND_H
#define EXTREMAL_MESH_3_SRC_CELLS_UNION_FIND_H

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

/// Disjoint sets, each named by its smallest element.
class Union_find {
public:
  explicit Union_find(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0U); }
  std::uint32_t find(std::uint32_t i) {
    while (parent_[i] != i) {
      parent_[i] = parent_[parent_[i]];
      i = parent_[i];
    }
    return i;
  }
  /// \return whether they were two sets
  bool unite(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    if (a < b)
      parent_[b] = a;
    else
      parent_[a] = b;
    return a != b;
  }

private:
  std::vector<std::uint32_t> parent_;
};

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_CELLS_UNION_FIND_H
