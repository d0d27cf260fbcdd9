// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Extremal_mesh_3/internal/manifold_patches.h>

#include "../cells/Union_find.h"
#include "patches.h"

#include <algorithm>
#include <limits>
#include <tuple>

namespace CGAL::Extremal_mesh_3::internal {

namespace {

/// A side of a polygon, from a corner to the next one of the same polygon.
struct Side {
  std::uint32_t low, high;    ///< points
  std::uint32_t corner, next; ///< indices into the corners
  bool reversed;              ///< from high to low
};

Cell_patches without_two_sided(const Cell_patches& patches) {
  Cell_patches result;
  result.points = patches.points;
  result.normals = patches.normals;
  for (std::size_t i = 0; i < patches.cell.size(); ++i) {
    const auto corners = polygon(patches, i);
    if (corners.size() < 3)
      continue;
    result.corners.insert(result.corners.end(), corners.begin(), corners.end());
    result.begin.push_back(result.corners.size());
    result.cell.push_back(patches.cell[i]);
  }
  return result;
}

std::vector<Side> sorted_sides(const Cell_patches& patches) {
  std::vector<Side> sides;
  sides.reserve(patches.corners.size());
  for (std::size_t i = 0; i < patches.cell.size(); ++i)
    for (std::size_t j = patches.begin[i]; j < patches.begin[i + 1]; ++j) {
      const auto next = std::uint32_t(j + 1 < patches.begin[i + 1] ? j + 1 : patches.begin[i]);
      const std::uint32_t a = patches.corners[j], b = patches.corners[next];
      sides.push_back({std::min(a, b), std::max(a, b), std::uint32_t(j), next, b < a});
    }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::tie(a.low, a.high, a.corner) < std::tie(b.low, b.high, b.corner);
  });
  return sides;
}

} // namespace

Cell_patches manifold_patches(const Cell_patches& patches) {
  require_consistent(patches);
  Cell_patches result = without_two_sided(patches);
  // Corners become one point if one comes from the other by going around it, across sides that two polygons share.
  Union_find fans(result.corners.size());
  const std::vector<Side> sides = sorted_sides(result);
  for (std::size_t first = 0, last = 0; first < sides.size(); first = last) {
    while (last < sides.size() && sides[last].low == sides[first].low && sides[last].high == sides[first].high)
      ++last;
    if (last - first != 2 || sides[first].reversed == sides[first + 1].reversed)
      continue;
    fans.unite(sides[first].corner, sides[first + 1].next);
    fans.unite(sides[first].next, sides[first + 1].corner);
  }
  constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> point_of_fan(result.corners.size(), none);
  std::vector<Point> points;
  std::vector<Vector> normals;
  for (std::uint32_t c = 0; c < result.corners.size(); ++c) {
    std::uint32_t& point = point_of_fan[fans.find(c)];
    if (point == none) {
      point = std::uint32_t(points.size());
      points.push_back(result.points[result.corners[c]]);
      normals.push_back(result.normals[result.corners[c]]);
    }
    result.corners[c] = point;
  }
  result.points = std::move(points);
  result.normals = std::move(normals);
  return result;
}

} // namespace CGAL::Extremal_mesh_3::internal
