// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "summary_text.h"

#include "../io/json_text.h"

#include <CGAL/Extremal_mesh_3/summary.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace CGAL::Extremal_mesh_3::tool {

namespace {

/// a list of words that grows: "a, b, c".
void enumerate(std::string& list, const std::string& word) {
  list += (list.empty() ? "" : ", ") + word;
}

template <typename Enum, std::size_t n>
std::string counts(const std::array<std::size_t, n>& numbers, std::size_t first = 0) {
  std::string list;
  for (std::size_t i = first; i < n; ++i)
    if (numbers[i] != 0)
      enumerate(list, fmt::format("{} {}", numbers[i], to_string(static_cast<Enum>(i))));
  return list;
}

std::string line(std::string_view what, std::size_t count, const std::string& details) {
  return fmt::format("{:<10} {:>7}{}{}\n", what, count, details.empty() ? "" : "  ", details);
}

/// cells by their edges; those with more than six are counted together.
std::string cell_counts(const Summary& summary) {
  constexpr std::size_t listed = 6;
  std::string list;
  std::size_t larger = 0;
  for (const auto& [edges, cells] : summary.cells_by_edges) {
    if (edges <= listed)
      enumerate(list, fmt::format("{} with {} edge{}", cells, edges, edges == 1 ? "" : "s"));
    else
      larger += cells;
  }
  if (larger != 0)
    enumerate(list, fmt::format("{} with more", larger));
  return list;
}

using Json = nlohmann::ordered_json;

Json json_of(const Mesh_repairs& r) {
  return {{"isolated_vertices", r.isolated_vertices},
          {"welded_vertices", r.welded_vertices},
          {"degenerate_faces", r.degenerate_faces},
          {"duplicate_faces", r.duplicate_faces},
          {"non_manifold_edges", r.non_manifold_edges},
          {"non_manifold_vertices", r.non_manifold_vertices},
          {"flat_faces", r.flat_faces},
          {"turned_faces", r.turned_faces}};
}

Json json_of(const Fit_report& r) {
  return {{"sampling", r.sampling},     {"multiple", r.multiple},
          {"radius_min", r.radius_min}, {"radius_median", r.radius_median},
          {"radius_max", r.radius_max}, {"noise", r.noise},
          {"fitted", r.fitted},         {"grown", r.grown},
          {"not_fitted", r.not_fitted}};
}

std::string fit_text(const Fit_report& r) {
  std::string text =
      fmt::format("surface points with radius {:.3g} ({:.3g} to {:.3g})", r.radius_median, r.radius_min, r.radius_max);
  if (r.grown != 0)
    text += fmt::format(", {} of them with an enlarged one", r.grown);
  if (r.not_fitted != 0)
    text += fmt::format(", {} not fitted", r.not_fitted);
  return line("fitted", r.fitted, text);
}

/// what is known about the topology of the surface: nothing if its cells were given.
std::string certainty_text(const Surface_report& report) {
  if (report.certainty == Surface_certainty::given)
    return {};
  std::string text = report.certainty == Surface_certainty::proved ? "proved" : "tested, not proved";
  if (report.undecided_cubes != 0) {
    const Point& p = report.first_undecided;
    text += fmt::format(" but for {} undecided cube{}, one at ({:.6g}, {:.6g}, {:.6g})", report.undecided_cubes,
                        report.undecided_cubes == 1 ? "" : "s", p[0], p[1], p[2]);
  }
  return fmt::format("{:<10} {}\n", "topology", text);
}

std::string surface_text(const Surface_info& surface) {
  std::string text = fmt::format("{} surface, {} component{}, Euler characteristic {}, area {:.6g}",
                                 surface.closed ? "closed" : "bordered", surface.components,
                                 surface.components == 1 ? "" : "s", surface.euler_characteristic, surface.area);
  if (surface.degenerate_area > 0)
    text += fmt::format(", of which {:.3g} degenerate", surface.degenerate_area);
  return text;
}

} // namespace

std::string summary_text(const Extremal_mesh& mesh, const std::vector<Check>& checks, const Extraction_report* report) {
  const Summary summary = summarize(mesh);
  const std::size_t umbilics = summary.vertices[static_cast<std::size_t>(Vertex_kind::umbilic)];
  std::string text = line("vertices", mesh.number_of_vertices(), counts<Vertex_kind>(summary.vertices));
  if (umbilics != 0) {
    std::string kinds = counts<Umbilic_type>(summary.umbilics, 1);
    if (summary.one_ridge != 0)
      enumerate(kinds, fmt::format("{} one-ridge", summary.one_ridge));
    if (summary.three_ridge != 0)
      enumerate(kinds, fmt::format("{} three-ridge", summary.three_ridge));
    text += line("umbilics", umbilics, kinds);
  }
  text += line("edges", mesh.number_of_edges(), counts<Line_type>(summary.edges));
  std::size_t changes = 0;
  for (const std::size_t number : summary.type_changes)
    changes += number;
  if (changes != 0)
    text += line("changes", changes, counts<Type_change_kind>(summary.type_changes));
  text += line("cells", mesh.number_of_cells(), cell_counts(summary));
  text += fmt::format("{:<10} {}\n", "on a", surface_text(mesh.surface()));
  if (report)
    text += certainty_text(report->surface) +
            line("uncertain", report->uncertain_cells, fmt::format("of {} surface cells", report->refined_cells));
  if (report && report->certified)
    text += line("proved", report->proved_empty_cells + report->proved_vertex_free_cells,
                 fmt::format("{} without lines, {} more without vertices", report->proved_empty_cells,
                             report->proved_vertex_free_cells));

  std::string violated;
  std::size_t applicable = 0;
  for (const Check& check : checks) {
    applicable += check.applies;
    if (check.applies && !check.holds)
      enumerate(violated, check.name);
  }
  text += line("checks", applicable, violated.empty() ? "all hold" : "violated: " + violated);
  return text;
}

std::string result_text(const Result& result) {
  std::string text;
  if (result.repairs && result.repairs->any())
    text += to_string(*result.repairs) + "\n";
  if (result.fit)
    text += fit_text(*result.fit);
  return text + summary_text(result.extraction.mesh, result.checks, &result.extraction.report);
}

std::string report_json(const Result& result) {
  Json json = Json::parse(to_json(result.extraction.mesh, result.checks, &result.extraction.report));
  if (result.repairs)
    json["repairs"] = json_of(*result.repairs);
  if (result.fit)
    json["fit"] = json_of(*result.fit);
  return json_text(json, 2);
}

std::string checks_text(const std::vector<Check>& checks) {
  std::string text;
  for (const Check& check : checks)
    text += fmt::format("{:<22} {:<14} {}\n", check.name,
                        !check.applies ? "not applicable"
                        : check.holds  ? "holds"
                                       : "violated",
                        check.detail);
  return text;
}

} // namespace CGAL::Extremal_mesh_3::tool
