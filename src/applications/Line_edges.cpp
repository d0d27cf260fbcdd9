// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Line_edges.h"

#include "../algorithms/patches.h"
#include "../differential/vector.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace CGAL::Extremal_mesh_3 {

Line_edges::Line_edges(const Cell_patches& surface) {
  for (std::uint32_t i = 0; i < surface.points.size(); ++i)
    point_at_.emplace(surface.points[i], i);
  for (std::size_t i = 0; i < surface.cell.size(); ++i) {
    const auto corners = polygon(surface, i);
    for (std::size_t j = 0; j < corners.size(); ++j) {
      const auto [a, b] = std::minmax(corners[j], corners[(j + 1) % corners.size()]);
      edges_.insert({a, b});
    }
  }
}

bool Line_edges::has(std::uint32_t a, std::uint32_t b) const {
  return edges_.contains({std::min(a, b), std::max(a, b)});
}

std::vector<std::uint32_t> Line_edges::points_at(const Point& p) const {
  std::vector<std::uint32_t> points;
  const auto [first, last] = point_at_.equal_range(p);
  for (auto i = first; i != last; ++i)
    points.push_back(i->second);
  return points;
}

std::vector<std::array<std::uint32_t, 2>> Line_edges::along(const std::vector<Point>& polyline,
                                                            std::size_t edge) const {
  std::vector<std::array<std::uint32_t, 2>> found;
  const auto find = [&](const Point& p, const Point& q) {
    const auto here = points_at(p), there = points_at(q), middles = points_at(0.5 * (p + q)),
               others = points_at(0.5 * (q + p));
    for (const std::uint32_t a : here)
      for (const std::uint32_t b : there)
        if (has(a, b)) {
          found.push_back({a, b});
          return true;
        }
    for (const auto* list : {&middles, &others})
      for (const std::uint32_t m : *list)
        for (const std::uint32_t a : here)
          for (const std::uint32_t b : there)
            if (has(a, m) && has(m, b)) {
              found.push_back({a, m});
              found.push_back({m, b});
              return true;
            }
    return false;
  };
  for (std::size_t i = 0; i + 1 < polyline.size(); ++i)
    if (polyline[i] != polyline[i + 1] && !find(polyline[i], polyline[i + 1]))
      throw std::invalid_argument(
          fmt::format("the surface is not cut along edge {} of the extremal mesh: it has no edge from "
                      "{:.6g} {:.6g} {:.6g} to {:.6g} {:.6g} {:.6g}",
                      edge, polyline[i][0], polyline[i][1], polyline[i][2], polyline[i + 1][0], polyline[i + 1][1],
                      polyline[i + 1][2]));
  return found;
}

} // namespace CGAL::Extremal_mesh_3
