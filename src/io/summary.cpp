// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Extremal_mesh_3/summary.h>

#include "json_text.h"

#include <nlohmann/json.hpp>

namespace CGAL::Extremal_mesh_3 {

namespace {

using Json = nlohmann::ordered_json;

template <typename Enum, std::size_t n> Json by_name(const std::array<std::size_t, n>& counts, std::size_t first = 0) {
  Json object = Json::object();
  for (std::size_t i = first; i < n; ++i)
    object[std::string(to_string(static_cast<Enum>(i)))] = counts[i];
  return object;
}

std::string_view to_string(Surface_certainty certainty) {
  switch (certainty) {
  case Surface_certainty::tested:
    return "tested";
  case Surface_certainty::proved:
    return "proved";
  default:
    return "given";
  }
}

Json json_of(const Surface_report& report) {
  Json json = {{"certainty", to_string(report.certainty)},
               {"divided_cubes", report.divided_cubes},
               {"undecided_cubes", report.undecided_cubes}};
  if (report.undecided_cubes != 0)
    json["first_undecided"] = report.first_undecided;
  return json;
}

Json json_of(const Extraction_report& report) {
  Json json = {{"surface", json_of(report.surface)},
               {"surface_points", report.surface_points},
               {"surface_cells", report.surface_cells},
               {"refined_cells", report.refined_cells},
               {"accepted_cells", report.accepted_cells},
               {"uncertain_cells", report.uncertain_cells},
               {"interpolated_points", report.interpolated_points},
               {"degenerate_cells", report.degenerate_cells},
               {"rounds", report.rounds},
               {"line_segments", report.line_segments},
               {"straight_segments", report.straight_segments}};
  if (report.certified) {
    json["proved_empty_cells"] = report.proved_empty_cells;
    json["proved_vertex_free_cells"] = report.proved_vertex_free_cells;
  }
  return json;
}

/// the parameters as the object they should be, or as they are.
Json parameters_of(const std::string& text) {
  Json parameters = Json::parse(text, nullptr, false);
  return parameters.is_discarded() ? Json(text) : parameters;
}

} // namespace

Summary summarize(const Extremal_mesh& mesh) {
  Summary summary;
  for (std::size_t v = 0; v < mesh.number_of_vertices(); ++v) {
    const Extremal_mesh_vertex& vertex = mesh.vertex(v);
    ++summary.vertices[static_cast<std::size_t>(vertex.kind)];
    if (vertex.kind != Vertex_kind::umbilic)
      continue;
    ++summary.umbilics[static_cast<std::size_t>(vertex.umbilic_type)];
    summary.one_ridge += vertex.ridges == 1;
    summary.three_ridge += vertex.ridges == 3;
    summary.umbilic_index_sum += vertex.umbilic_index;
  }
  for (std::size_t e = 0; e < mesh.number_of_edges(); ++e) {
    ++summary.edges[static_cast<std::size_t>(mesh.edge(e).type)];
    for (const Type_change& change : mesh.edge(e).type_changes)
      ++summary.type_changes[static_cast<std::size_t>(change.kind)];
  }
  for (const Extremal_mesh_cell& cell : mesh.cells()) {
    std::size_t edges = 0;
    for (const std::vector<Half_edge>& walk : cell.boundary)
      edges += walk.size();
    ++summary.cells_by_edges[edges];
  }
  return summary;
}

std::string to_json(const Extremal_mesh& mesh, const std::vector<Check>& checks, const Extraction_report* report) {
  const Summary summary = summarize(mesh);
  const Surface_info& surface = mesh.surface();
  Json json;
  json["vertices"] = by_name<Vertex_kind>(summary.vertices);
  json["umbilics"] = by_name<Umbilic_type>(summary.umbilics, 1);
  json["umbilics"]["one_ridge"] = summary.one_ridge;
  json["umbilics"]["three_ridge"] = summary.three_ridge;
  json["edges"] = mesh.number_of_edges();
  json["edges_by_type"] = by_name<Line_type>(summary.edges);
  json["type_changes"] = by_name<Type_change_kind>(summary.type_changes);
  json["cells"] = mesh.number_of_cells();
  json["cells_by_edges"] = Json::object();
  for (const auto& [edges, cells] : summary.cells_by_edges)
    json["cells_by_edges"][std::to_string(edges)] = cells;
  json["components"] = surface.components;
  json["euler_characteristic"] = surface.euler_characteristic;
  json["closed"] = surface.closed;
  json["area"] = surface.area;
  json["degenerate_area"] = surface.degenerate_area;
  json["umbilic_index_sum"] = summary.umbilic_index_sum;
  json["checks"] = Json::object();
  json["details"] = Json::array();
  for (const Check& check : checks) {
    json["checks"][check.name] = !check.applies || check.holds;
    json["details"].push_back({{"check", check.name},
                               {"claim", check.claim},
                               {"applies", check.applies},
                               {"holds", check.holds},
                               {"detail", check.detail}});
  }
  json["ok"] = all_hold(checks);
  if (report)
    json["report"] = json_of(*report);
  json["source"] = surface.source;
  json["frame"] = surface.frame;
  json["parameters"] = parameters_of(surface.parameters);
  // a file's name need not be UTF-8
  return json_text(json, 2);
}

} // namespace CGAL::Extremal_mesh_3
