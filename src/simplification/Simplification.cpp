// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../io/json_text.h"
#include "Step_finder.h"
#include "build_mesh.h"

#include <CGAL/Extremal_mesh_3/check.h>
#include <CGAL/Extremal_mesh_3/lines.h>
#include <CGAL/Extremal_mesh_3/simplify.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string_view>

namespace CGAL::Extremal_mesh_3 {

std::string_view to_string(Simplification_operation operation) {
  switch (operation) {
  case Simplification_operation::cancel_extremal_points:
    return "cancel_extremal_points";
  case Simplification_operation::cancel_umbilics:
    return "cancel_umbilics";
  case Simplification_operation::merge_vertices:
    return "merge_vertices";
  case Simplification_operation::cancel_islands:
    return "cancel_islands";
  case Simplification_operation::drop_loop:
    return "drop_loop";
  case Simplification_operation::drop_closed_line:
    return "drop_closed_line";
  case Simplification_operation::drop_border_line:
    return "drop_border_line";
  }
  return "unknown";
}

std::string_view to_string(Simplification_measure measure) {
  return measure == Simplification_measure::life_time ? "life_time" : "persistence";
}

namespace {

/// the vertices that a step may make vanish.
std::vector<std::uint32_t> involved_in(const Embedded_graph& graph, const Candidate& step) {
  std::vector<std::uint32_t> result = {graph.source(step.first), graph.target(step.first)};
  if (step.operation == Simplification_operation::cancel_islands) {
    result.clear();
    for (const Half_edge h : {step.first, step.second}) {
      const std::vector<std::uint32_t> vertices = find_island(graph, graph.source(h)).value().vertices;
      result.insert(result.end(), vertices.begin(), vertices.end());
    }
  } else if (step.second != Embedded_graph::none) {
    result.push_back(graph.target(step.second));
  }
  return result;
}

} // namespace

namespace {

/// steps rely on what these checks tell.
void require_consistent(const Extremal_mesh& mesh) {
  for (const Check& c : check(mesh))
    for (const std::string_view needed : {"stars", "walks", "geometry", "degrees", "alternation"})
      if (c.name == needed && !c.holds)
        throw std::invalid_argument(fmt::format("the mesh fails the check '{}': {}", c.name, c.detail));
}

void require_measure(const Extremal_mesh& mesh, Simplification_measure measure) {
  if (measure == Simplification_measure::persistence || mesh.number_of_vertices() == 0)
    return;
  for (std::size_t v = 0; v < mesh.number_of_vertices(); ++v)
    if (mesh.vertex(v).life_time)
      return;
  throw std::invalid_argument("its vertices have no life times; those of a scale space have");
}

} // namespace

struct Simplification::Data {
  Extremal_mesh mesh;
  Simplification_options options;
  Embedded_graph start;
  std::vector<Candidate> done;
  std::vector<Simplification_step> steps;

  Data(Extremal_mesh m, const Simplification_options& o)
      : mesh((require_consistent(m), require_measure(m, o.measure), std::move(m))), options(o), start(mesh) {
    keep_crest_lines();
    find_steps();
  }

  void keep_crest_lines();
  void find_steps();
  Embedded_graph graph_at(std::size_t level) const;
};

/// marks the crest lines that are strong enough.
void Simplification::Data::keep_crest_lines() {
  if (std::isinf(options.keep_crest))
    return;
  for (const Extremal_line& line : strongest_crest_lines(mesh, mesh.number_of_edges())) {
    double strength = 0;
    for (const Half_edge h : line.half_edges)
      strength += mesh.edge(h / 2).strength;
    if (strength >= options.keep_crest)
      for (const Half_edge h : line.half_edges)
        start.keep(h / 2);
  }
}

void Simplification::Data::find_steps() {
  Simplifier simplifier(start);
  const Embedded_graph& graph = simplifier.graph();
  Step_finder finder(graph, options.measure);
  // curvatures are told without their unit, logarithms have none
  const double unit = options.measure == Simplification_measure::life_time ? 1 : std::sqrt(mesh.surface().area);
  double persistence = 0;
  const std::size_t given = mesh.number_of_vertices();
  const auto place = [&](std::uint32_t v) {
    if (v < given)
      return mesh.vertex(v).point;
    const Half_edge h = graph.walks().half_edges(graph.walk(graph.vertices()[v].first)).front();
    return mesh.vertex(mesh.source(h)).point;
  };
  while (const std::optional<Candidate> next = finder.next()) {
    persistence = std::max(persistence, unit * next->cost);
    Simplification_step step{next->operation, persistence, place(graph.source(next->first)), {}, 0, 0, 0};
    std::vector<std::uint32_t> involved = involved_in(graph, *next);
    simplifier.apply(*next);
    std::sort(involved.begin(), involved.end());
    involved.erase(std::unique(involved.begin(), involved.end()), involved.end());
    for (const std::uint32_t v : involved)
      if (v < given && !graph.vertices()[v].alive)
        step.vanished.push_back(v);
    step.vertices = graph.number_of_vertices();
    step.edges = graph.number_of_edges();
    step.cells = graph.number_of_cells();
    steps.push_back(std::move(step));
    done.push_back(*next);
    std::vector<std::uint32_t>& touched = simplifier.touched;
    std::sort(touched.begin(), touched.end());
    touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
    for (const std::uint32_t v : touched)
      finder.look_around(v);
    touched.clear();
  }
}

Embedded_graph Simplification::Data::graph_at(std::size_t level) const {
  if (level > steps.size())
    throw std::out_of_range(fmt::format("there is no level {}; the last one is {}", level, steps.size()));
  Simplifier simplifier(start);
  for (std::size_t i = 0; i < level; ++i) {
    simplifier.apply(done[i]);
    simplifier.touched.clear();
  }
  return simplifier.graph();
}

Simplification::Simplification(Extremal_mesh mesh, const Simplification_options& options)
    : data_(std::make_unique<Data>(std::move(mesh), options)) {}
Simplification::~Simplification() = default;
Simplification::Simplification(Simplification&&) noexcept = default;
Simplification& Simplification::operator=(Simplification&&) noexcept = default;

const std::vector<Simplification_step>& Simplification::steps() const {
  return data_->steps;
}

std::size_t Simplification::level_of_persistence(double threshold) const {
  return std::size_t(std::partition_point(steps().begin(), steps().end(),
                                          [&](const auto& step) { return step.persistence <= threshold; }) -
                     steps().begin());
}

std::size_t Simplification::level_of_cells(std::size_t cells) const {
  if (data_->mesh.number_of_cells() <= cells)
    return 0;
  const auto found =
      std::find_if(steps().begin(), steps().end(), [&](const auto& step) { return step.cells <= cells; });
  return found == steps().end() ? steps().size() : std::size_t(found - steps().begin()) + 1;
}

std::size_t Simplification::level_of_vertices(std::size_t vertices) const {
  if (data_->mesh.number_of_vertices() <= vertices)
    return 0;
  const auto found =
      std::find_if(steps().begin(), steps().end(), [&](const auto& step) { return step.vertices <= vertices; });
  return found == steps().end() ? steps().size() : std::size_t(found - steps().begin()) + 1;
}

std::size_t Simplification::level_at_gap() const {
  std::size_t level = 0;
  double greatest = 0, before = 0;
  for (std::size_t i = 0; i < steps().size(); before = steps()[i++].persistence)
    if (steps()[i].persistence - before > greatest) {
      greatest = steps()[i].persistence - before;
      level = i;
    }
  return level;
}

Extremal_mesh Simplification::mesh_at(std::size_t level) const {
  Extremal_mesh mesh = build_mesh(data_->graph_at(level), data_->mesh);
  if (level > 0) {
    const Surface_info& surface = data_->mesh.surface();
    using Json = nlohmann::ordered_json;
    Json parameters = Json::parse(surface.parameters, nullptr, false);
    if (!parameters.is_object())
      parameters = surface.parameters.empty() ? Json::object() : Json{{"given", surface.parameters}};
    Json simplification = {{"level", level}, {"persistence", steps()[level - 1].persistence}};
    if (data_->options.measure != Simplification_measure::persistence)
      simplification["measure"] = to_string(data_->options.measure);
    if (!std::isinf(data_->options.keep_crest))
      simplification["keep_crest"] = data_->options.keep_crest;
    // a mesh that was simplified before keeps what was done then
    if (parameters.contains("simplification"))
      simplification["before"] = parameters["simplification"];
    parameters["simplification"] = std::move(simplification);
    mesh.set_provenance(surface.source, json_text(parameters), surface.frame);
  }
  return mesh;
}

std::vector<std::uint32_t> Simplification::cells_at(std::size_t level) const {
  return data_->graph_at(level).numbered_cells();
}

Cell_patches Simplification::patches_at(std::size_t level, const Cell_patches& patches) const {
  const std::vector<std::uint32_t> cell = cells_at(level);
  Cell_patches result = patches;
  for (std::uint32_t& c : result.cell)
    c = cell.at(c);
  return result;
}

std::vector<double> Simplification::vertex_persistence() const {
  std::vector<double> result(data_->mesh.number_of_vertices(), std::numeric_limits<double>::infinity());
  for (const Simplification_step& step : steps())
    for (const std::uint32_t v : step.vanished)
      result[v] = step.persistence;
  return result;
}

} // namespace CGAL::Extremal_mesh_3
