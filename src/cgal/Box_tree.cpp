// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Box_tree.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace CGAL::Extremal_mesh_3 {

namespace {

using Kernel = CGAL::Simple_cartesian<double>;

/// Model of CGAL's concept AABBPrimitive: a box and its number.
class Numbered_box {
public:
  using Id = std::uint32_t;
  using Point = Kernel::Point_3;
  using Datum = Kernel::Iso_cuboid_3;
  using Datum_reference = const Datum&;
  using Point_reference = Point;

  Numbered_box(Id id, const Bounding_box& box)
      : id_(id), box_(Point(box.low[0], box.low[1], box.low[2]), Point(box.high[0], box.high[1], box.high[2])) {}
  Id id() const { return id_; }
  Datum_reference datum() const { return box_; }
  Point_reference reference_point() const { return CGAL::midpoint(box_.min(), box_.max()); }

private:
  Id id_;
  Datum box_;
};

using Aabb_tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Numbered_box>>;

/// What the tree asks for while it is walked.
class Visit_near {
public:
  using Query = Kernel::Point_3;
  using Priority = double;

  explicit Visit_near(const std::function<double(std::uint32_t)>& visit) : visit_(visit) {}

  bool go_further() const { return true; }
  void intersection(const Query& p, const Numbered_box& box) {
    if (squared_distance_to(p, box.datum().bbox()) <= bound_)
      bound_ = visit_(box.id());
  }
  template <class Node> bool do_intersect(const Query& p, const Node& node) const {
    return squared_distance_to(p, node.bbox()) <= bound_;
  }
  template <class Node> std::pair<bool, Priority> do_intersect_with_priority(const Query& p, const Node& node) const {
    const double distance = squared_distance_to(p, node.bbox());
    return {distance <= bound_, -distance};
  }

private:
  static double squared_distance_to(const Query& p, const CGAL::Bbox_3& box) {
    double sum = 0;
    for (int i = 0; i < 3; ++i) {
      const double outside = std::max({box.min(i) - p[i], p[i] - box.max(i), 0.0});
      sum += outside * outside;
    }
    return sum;
  }

  const std::function<double(std::uint32_t)>& visit_;
  double bound_ = std::numeric_limits<double>::infinity();
};

} // namespace

struct Box_tree::Tree {
  Aabb_tree tree;
};

Box_tree::Box_tree(const std::vector<Bounding_box>& boxes) : tree_(std::make_unique<Tree>()) {
  for (std::uint32_t i = 0; i < boxes.size(); ++i)
    tree_->tree.insert(Numbered_box(i, boxes[i]));
  tree_->tree.build(); // here and not in the first of the queries, which may come from many threads
}
Box_tree::~Box_tree() = default;

void Box_tree::visit_near(const Point& p, const std::function<double(std::uint32_t)>& visit) const {
  Visit_near visitor(visit);
  tree_->tree.traversal_with_priority(Kernel::Point_3(p[0], p[1], p[2]), visitor);
}

} // namespace CGAL::Extremal_mesh_3
