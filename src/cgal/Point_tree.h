// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_CGAL_POINT_TREE_H
#define EXTREMAL_MESH_3_SRC_CGAL_POINT_TREE_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

/// Finds the nearest of points in a space of any dimension: CGAL's k-d tree. Compiled for the dimensions 3 and 13. Queries can
/// be made from many threads at a time.
template <std::size_t dimension> class Point_tree {
public:
  using Coordinates = std::array<double, dimension>;
  struct Neighbour {
    std::uint32_t index = 0;
    double distance = 0;
  };

  /// \pre the coordinates are finite
  explicit Point_tree(const std::vector<Coordinates>& points);
  ~Point_tree();
  Point_tree(Point_tree&&) noexcept;
  Point_tree& operator=(Point_tree&&) noexcept;

  /// finds at most `k` points that are not farther than `within`, the nearest first; of several at the same distance, the first
  /// one comes first.
  std::vector<Neighbour> nearest(const Coordinates& p, std::size_t k, double within) const;
  /// finds all points that are not farther than `within`, in the order of their indices.
  std::vector<std::uint32_t> all_within(const Coordinates& p, double within) const;

private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_CGAL_POINT_TREE_H
