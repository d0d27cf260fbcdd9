// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "spread_points.h"

#include "../differential/vector.h"
#include "Union_find.h"

#include <algorithm>
#include <limits>

namespace CGAL::Extremal_mesh_3 {

std::vector<std::vector<std::uint32_t>> spread_points(const Cell_complex& cells, std::size_t n) {
  Union_find sets(cells.points.size());
  for (const auto& [a, b] : cells.edges)
    sets.unite(a, b);
  std::vector<std::vector<std::uint32_t>> components;
  std::vector<std::size_t> number(cells.points.size()); // of the component, at its smallest point, which is met first
  for (std::uint32_t p = 0; p < cells.points.size(); ++p) {
    const std::uint32_t first = sets.find(p);
    if (first == p) {
      number[p] = components.size();
      components.emplace_back();
    }
    components[number[first]].push_back(p);
  }

  std::vector<double> away; // from the nearest of those chosen
  for (std::vector<std::uint32_t>& points : components) {
    std::vector<std::uint32_t> chosen;
    away.assign(points.size(), std::numeric_limits<double>::infinity());
    while (chosen.size() < std::min(n, points.size())) {
      const auto farthest = std::max_element(away.begin(), away.end());
      chosen.push_back(points[std::size_t(farthest - away.begin())]);
      for (std::size_t i = 0; i < points.size(); ++i)
        away[i] = std::min(away[i], distance(cells.points[points[i]], cells.points[chosen.back()]));
    }
    points = std::move(chosen);
  }
  return components;
}

} // namespace CGAL::Extremal_mesh_3
