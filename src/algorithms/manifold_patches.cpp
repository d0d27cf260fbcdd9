// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Extremal_mesh_3/internal/manifold_patches.h>

#include "../cells/Union_find.h"
#include "../differential/vector.h"
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
  const Cell_patches given = without_two_sided(patches);
  constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  // Corners become one point if one comes from the other by going around it, across sides that two polygons share.
  Union_find fans(given.corners.size());
  std::vector<std::uint32_t> twin(given.corners.size(), none); // of sides that need a point of their own
  const std::vector<Side> sides = sorted_sides(given);
  for (std::size_t first = 0, last = 0; first < sides.size(); first = last) {
    while (last < sides.size() && sides[last].low == sides[first].low && sides[last].high == sides[first].high)
      ++last;
    // Of a small closed line that crosses an edge of the extraction's polygons twice, both sides join the same points.
    // The pieces of such a polygon follow each other.
    for (std::size_t i = first; i + 1 < last; i += 2) {
      const Side &a = sides[i], &b = sides[i + 1];
      if ((last - first) % 2 != 0 || a.reversed == b.reversed)
        continue;
      fans.unite(a.corner, b.next);
      fans.unite(a.next, b.corner);
      if (i > first) {
        twin[a.corner] = b.corner;
        twin[b.corner] = a.corner;
      }
    }
  }

  Cell_patches result;
  result.cell = given.cell;
  std::vector<std::uint32_t> point_of_fan(given.corners.size(), none), middle(given.corners.size(), none);
  const auto add_point = [&](const Point& p, const Vector& n) {
    result.points.push_back(p);
    result.normals.push_back(n);
    return std::uint32_t(result.points.size() - 1);
  };
  for (std::size_t i = 0; i < given.cell.size(); ++i) {
    for (std::size_t j = given.begin[i]; j < given.begin[i + 1]; ++j) {
      const auto c = std::uint32_t(j);
      const std::uint32_t here = given.corners[c];
      std::uint32_t& point = point_of_fan[fans.find(c)];
      if (point == none)
        point = add_point(given.points[here], given.normals[here]);
      result.corners.push_back(point);
      if (twin[c] == none)
        continue;
      if (middle[c] == none) {
        const std::uint32_t there = given.corners[j + 1 < given.begin[i + 1] ? j + 1 : given.begin[i]];
        middle[c] = middle[twin[c]] = add_point(0.5 * (given.points[here] + given.points[there]), given.normals[here]);
      }
      result.corners.push_back(middle[c]);
    }
    result.begin.push_back(result.corners.size());
  }
  return result;
}

} // namespace CGAL::Extremal_mesh_3::internal
