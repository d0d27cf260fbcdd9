// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Extremal_mesh_3/select.h>

#include "require.h"

#include <algorithm>

namespace CGAL::Extremal_mesh_3 {

std::vector<std::uint32_t> vertices_of_kind(const Extremal_mesh& mesh, Vertex_kind kind) {
  std::vector<std::uint32_t> found;
  for (std::uint32_t v = 0; v < mesh.number_of_vertices(); ++v)
    if (mesh.vertex(v).kind == kind)
      found.push_back(v);
  return found;
}

std::string_view to_string(Line_measure measure) {
  switch (measure) {
  case Line_measure::length:
    return "length";
  case Line_measure::strength:
    return "strength";
  case Line_measure::sharpness:
    return "sharpness";
  case Line_measure::mean_curvature:
    return "mean_curvature";
  case Line_measure::extreme_curvature:
    return "extreme_curvature";
  case Line_measure::stability:
    return "stability";
  }
  return "unknown";
}

double value_of(const Line_measures& measures, Line_measure measure) {
  switch (measure) {
  case Line_measure::length:
    return measures.length;
  case Line_measure::strength:
    return measures.strength;
  case Line_measure::sharpness:
    return measures.sharpness;
  case Line_measure::mean_curvature:
    return measures.mean_curvature;
  case Line_measure::extreme_curvature:
    return measures.extreme_curvature;
  case Line_measure::stability:
    return measures.stability;
  }
  return 0;
}

std::vector<std::uint32_t> select_edges(const Extremal_mesh& mesh, const Edge_selection& selection) {
  if (selection.family && *selection.family != 1 && *selection.family != 2)
    throw std::invalid_argument(fmt::format("the family is {}; it must be 1 or 2", *selection.family));
  for (const Measure_range& range : selection.ranges)
    if (std::isnan(range.min) || std::isnan(range.max))
      throw std::invalid_argument(fmt::format("a bound of the {} is not a number", to_string(range.measure)));

  std::vector<std::uint32_t> found;
  for (std::uint32_t e = 0; e < mesh.number_of_edges(); ++e) {
    const Extremal_mesh_edge& edge = mesh.edge(e);
    if ((selection.type && edge.type != *selection.type) || (selection.family && edge.family != *selection.family))
      continue;
    if (!selection.ranges.empty()) {
      const Line_measures measures = edge_measures(mesh, e);
      if (!std::all_of(selection.ranges.begin(), selection.ranges.end(), [&](const Measure_range& range) {
            const double value = value_of(measures, range.measure);
            return value >= range.min && value <= range.max;
          }))
        continue;
    }
    found.push_back(e);
  }
  return found;
}

} // namespace CGAL::Extremal_mesh_3
