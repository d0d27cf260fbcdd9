// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_CGAL_BOX_TREE_H
#define EXTREMAL_MESH_3_SRC_CGAL_BOX_TREE_H

#include <CGAL/Extremal_mesh_3/types.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

/// The axis-parallel box around some points.
struct Bounding_box {
  Point low{}, high{};
};

/// Finds what is near to a point: CGAL's AABB tree, for anything that has a bounding box. What the things are, and how far, only
/// the caller knows.
class Box_tree {
public:
  /// \pre the coordinates are finite
  explicit Box_tree(const std::vector<Bounding_box>& boxes);
  ~Box_tree();

  /// visits the indices of boxes, roughly the nearest first, and all that may be within a distance of the point.
  /// \param visit  is given the index, and returns the square of that distance as it is from now on; it may only fall
  void visit_near(const Point& p, const std::function<double(std::uint32_t)>& visit) const;

private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_CGAL_BOX_TREE_H
