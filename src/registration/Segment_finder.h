// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_REGISTRATION_SEGMENT_FINDER_H
#define EXTREMAL_MESH_3_SRC_REGISTRATION_SEGMENT_FINDER_H

#include "../cgal/Box_tree.h"

#include <CGAL/Extremal_mesh_3/Extremal_mesh.h>

#include <functional>
#include <optional>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

/// Finds the segments of some of the lines of a mesh that are near to a point.
class Segment_finder {
public:
  /// A segment near a point.
  struct Near {
    std::uint32_t edge = 0, segment = 0;
    double distance = 0;
  };

  /// \param mesh  outlives it
  /// \param type  of the segments; none: all
  Segment_finder(const Extremal_mesh& mesh, std::optional<Line_type> type);

  /// the nearest, if there is one within a distance.
  std::optional<Near> nearest(const Point& p, double within) const;
  /// all within a distance, in no particular order.
  void for_each(const Point& p, double within, const std::function<void(const Near&)>& visit) const;
  bool empty() const { return segments_.empty(); }

private:
  double distance_to(std::uint32_t i, const Point& p) const;

  struct Segment {
    std::uint32_t edge, segment;
  };
  const Extremal_mesh& mesh_;
  std::vector<Segment> segments_;
  std::optional<Box_tree> tree_; ///< none: there are no segments
};

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_REGISTRATION_SEGMENT_FINDER_H
