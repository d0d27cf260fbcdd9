// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Extremal_mesh_3/errors.h>
#include <CGAL/Extremal_mesh_3/keep_components.h>

#include "../differential/vector.h"
#include "Union_find.h"
#include "remove_cells.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace CGAL::Extremal_mesh_3 {

namespace {

double area_of_cell(const Cell_complex& cells, std::size_t c) {
  const auto corner = [&](std::size_t h) -> const Point& { return cells.points[cells.source(cells.half_edges[h])]; };
  const std::size_t first = cells.cell_begin[c];
  Vector area{};
  for (std::size_t h = first + 1; h + 1 < cells.cell_begin[c + 1]; ++h)
    area = area + cross(corner(h) - corner(first), corner(h + 1) - corner(first));
  return 0.5 * norm(area);
}

} // namespace

Cell_complex keep_components(Cell_complex cells, const Component_options& options) {
  if (!(std::isfinite(options.min_area) && options.min_area >= 0))
    throw std::invalid_argument(fmt::format("the least area is {}, not an area of 0 or more", options.min_area));
  if (cells.number_of_cells() == 0 || (!options.largest && options.min_area == 0))
    return cells;
  Union_find sets(cells.points.size());
  for (const auto& [a, b] : cells.edges)
    sets.unite(a, b);
  const auto component = [&](std::size_t c) { return sets.find(cells.source(cells.half_edges[cells.cell_begin[c]])); };
  std::vector<double> area(cells.points.size(), 0); // of the component, at its smallest point
  for (std::size_t c = 0; c < cells.number_of_cells(); ++c)
    area[component(c)] += area_of_cell(cells, c);
  const auto largest = std::max_element(area.begin(), area.end());
  if (*largest < options.min_area)
    throw Extraction_error(fmt::format("no component of the surface has an area of {} or more; the largest has {:.6g}",
                                       options.min_area, *largest));
  const auto only = std::uint32_t(largest - area.begin());
  std::vector<char> removed(cells.number_of_cells());
  for (std::size_t c = 0; c < removed.size(); ++c) {
    const std::uint32_t of = component(c);
    removed[c] = options.largest ? of != only : area[of] < options.min_area;
  }
  if (std::find(removed.begin(), removed.end(), char(1)) == removed.end())
    return cells;
  return remove_cells(cells, removed).cells;
}

} // namespace CGAL::Extremal_mesh_3
