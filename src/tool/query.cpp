// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands.h"
#include "query_json.h"

#include <CGAL/Extremal_mesh_3/Line_locator.h>
#include <CGAL/Extremal_mesh_3/Patch_locator.h>
#include <CGAL/Extremal_mesh_3/io.h>
#include <CGAL/Extremal_mesh_3/paths.h>
#include <CGAL/Extremal_mesh_3/select.h>

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

namespace CGAL::Extremal_mesh_3::tool {

namespace {

/// the number of an element, if it can be one at all; the library tells whether the mesh has it.
std::uint32_t id_of(std::string_view kind, std::int64_t number) {
  if (number < 0 || number > std::numeric_limits<std::uint32_t>::max())
    throw Usage_error(fmt::format("there is no {} {}; numbers begin with 0", kind, number));
  return std::uint32_t(number);
}

/// the enumerator with a name, of the first `number` of them.
template <typename Enum> std::optional<Enum> named(const std::string& name, int number) {
  for (int i = 0; i < number; ++i)
    if (to_string(static_cast<Enum>(i)) == name)
      return static_cast<Enum>(i);
  return std::nullopt;
}

Json json_of(const Line_point& q) {
  return {{"edge", q.edge}, {"segment", q.segment}, {"t", q.t}, {"point", q.point}, {"distance", q.distance}};
}

Json cell_on_surface(const Extremal_mesh& mesh, const Query_options& options) {
  const auto found = Patch_locator(read_cell_patches(options.surface)).nearest(*options.cell_at);
  if (!found)
    return {{"point", *options.cell_at}, {"found_by", "surface"}, {"cell", nullptr}};
  if (found->cell >= mesh.number_of_cells())
    throw Io_error(fmt::format("{}: polygon {} is in cell {}, which {} does not have; expected the cells of that mesh",
                               options.surface, found->polygon, found->cell, options.file));
  return {{"point", *options.cell_at},
          {"found_by", "surface"},
          {"nearest", {{"polygon", found->polygon}, {"point", found->point}, {"distance", found->distance}}},
          {"cell", json_of_cell(mesh, found->cell, true)}};
}

Json cell_at(const Extremal_mesh& mesh, const Query_options& options) {
  if (!options.surface.empty())
    return cell_on_surface(mesh, options);
  const Line_locator locator(mesh);
  const auto cell = locator.cell_at(*options.cell_at, options.normal);
  const auto line = locator.nearest_line(*options.cell_at);
  return {{"point", *options.cell_at},
          {"found_by", "lines"},
          {"nearest", line ? json_of(*line) : Json()},
          {"cell", cell ? json_of_cell(mesh, *cell, true) : Json()}};
}

Json nearest(const Extremal_mesh& mesh, const Point& p) {
  const Line_locator locator(mesh);
  Json json = {{"point", p}, {"vertex", nullptr}, {"line", nullptr}};
  if (const auto vertex = locator.nearest_vertex(p)) {
    json["vertex"] = json_of_vertex(mesh, vertex->vertex);
    json["vertex"]["distance"] = vertex->distance;
  }
  if (const auto line = locator.nearest_line(p))
    json["line"] = json_of(*line);
  return json;
}

Json neighbours_of(const Extremal_mesh& mesh, std::uint32_t cell) {
  Json list = Json::array();
  for (const Cell_neighbour& neighbour : neighbours(mesh, cell)) {
    Json json = {{"common_length", neighbour.length}};
    json.update(json_of_cell(mesh, neighbour.cell, false));
    list.push_back(std::move(json));
  }
  return {{"cell", cell}, {"neighbours", list}};
}

Json around(const Extremal_mesh& mesh, std::uint32_t vertex) {
  Json json = {{"vertex", json_of_vertex(mesh, vertex)}, {"branches", Json::array()}};
  for (const Half_edge h : mesh.vertex(vertex).star) {
    const Extremal_mesh_edge& edge = mesh.edge(h / 2);
    json["branches"].push_back({{"half_edge", h},
                                {"to", mesh.target(h)},
                                {"family", edge.family},
                                {"type", to_string(edge.type)},
                                {"length", edge.length},
                                {"strength", edge.strength}});
  }
  json["cells"] = cells_around(mesh, vertex);
  return json;
}

Json line_through_edge(const Extremal_mesh& mesh, std::uint32_t edge) {
  const Extremal_line line = line_through(mesh, edge);
  Json json = {{"edge", edge}};
  json.update(json_of_line(mesh, line));
  json["polyline"] = polyline(mesh, line.half_edges);
  return json;
}

Json strongest(const Extremal_mesh& mesh, std::int64_t k) {
  if (k < 1)
    throw Usage_error(fmt::format("{} crest lines cannot be shown; give --strongest a number from 1", k));
  Json list = Json::array();
  for (const Extremal_line& line : strongest_crest_lines(mesh, std::size_t(k)))
    list.push_back(json_of_line(mesh, line));
  return {{"crest_lines", list}};
}

Json path(const Extremal_mesh& mesh, std::uint32_t from, std::uint32_t to) {
  const auto found = shortest_path(mesh, from, to);
  Json json = {{"from", from}, {"to", to}, {"found", found.has_value()}};
  if (found) {
    json["length"] = found->length;
    json["half_edges"] = found->half_edges;
    json["vertices"] = found->half_edges.empty() ? std::vector{from} : vertices_along(mesh, found->half_edges);
    json["polyline"] = polyline(mesh, found->half_edges);
  }
  return json;
}

Json vertices(const Extremal_mesh& mesh, const std::string& name) {
  constexpr int kinds = 5;
  const auto kind = named<Vertex_kind>(name, kinds);
  if (!kind && name != "all")
    throw Usage_error(fmt::format("'{}' is no kind of vertex; give --vertices extremal_point, umbilic, non_generic, "
                                  "boundary, anchor or all",
                                  name));
  Json list = Json::array();
  for (int i = 0; i < kinds; ++i)
    if (!kind || *kind == static_cast<Vertex_kind>(i))
      for (const std::uint32_t v : vertices_of_kind(mesh, static_cast<Vertex_kind>(i)))
        list.push_back(json_of_vertex(mesh, v));
  return {{"count", list.size()}, {"vertices", std::move(list)}};
}

Json edges(const Extremal_mesh& mesh, const Query_options& options) {
  const std::string& which = *options.edges;
  Edge_selection selection;
  selection.type = named<Line_type>(which, 4);
  if (which == "1" || which == "2")
    selection.family = which[0] - '0';
  else if (!selection.type && which != "all")
    throw Usage_error(fmt::format("'{}' is neither a type nor a family; give --edges max_largest, min_largest, "
                                  "max_second, min_second, 1, 2 or all",
                                  which));
  for (std::size_t i = 0; i < options.min.size(); ++i) {
    Measure_range range{static_cast<Line_measure>(i)};
    range.min = options.min[i].value_or(range.min);
    range.max = options.max[i].value_or(range.max);
    if (options.min[i] || options.max[i])
      selection.ranges.push_back(range);
  }
  Json list = Json::array();
  for (const std::uint32_t e : select_edges(mesh, selection))
    list.push_back(json_of_edge(mesh, e));
  return {{"count", list.size()}, {"edges", std::move(list)}};
}

Json components(const Extremal_mesh& mesh) {
  struct Component {
    std::size_t vertices = 0, edges = 0;
    std::uint32_t first_vertex = 0;
    double length = 0;
  };
  const Connected_components found = connected_components(mesh);
  std::vector<Component> sums(found.number);
  for (std::uint32_t v = 0; v < mesh.number_of_vertices(); ++v) {
    Component& sum = sums[found.of_vertex[v]];
    if (sum.vertices++ == 0)
      sum.first_vertex = v;
  }
  for (std::size_t e = 0; e < mesh.number_of_edges(); ++e) {
    Component& sum = sums[found.of_vertex[mesh.edge(e).source]];
    ++sum.edges;
    sum.length += mesh.edge(e).length;
  }
  Json list = Json::array();
  for (const Component& sum : sums)
    list.push_back(
        {{"first_vertex", sum.first_vertex}, {"vertices", sum.vertices}, {"edges", sum.edges}, {"length", sum.length}});
  return {{"count", list.size()}, {"components", std::move(list)}};
}

Json quads(const Extremal_mesh& mesh) {
  Json list = Json::array();
  std::map<std::string, std::size_t> by_types;
  for (const Quadrilateral& quad : quadrilaterals(mesh)) {
    std::string types;
    std::vector<Half_edge> half_edges;
    for (const Cell_side& side : quad.sides) {
      types.append(types.empty() ? "" : " ").append(to_string(side.type));
      half_edges.push_back(side.half_edge);
    }
    ++by_types[types];
    list.push_back({{"cell", quad.cell}, {"types", types}, {"half_edges", half_edges}});
  }
  return {{"cells", mesh.number_of_cells()},
          {"quadrilaterals", list.size()},
          {"by_types", by_types},
          {"list", std::move(list)}};
}

bool any(const std::array<std::optional<double>, 6>& bounds) {
  return std::any_of(bounds.begin(), bounds.end(), [](const auto& bound) { return bound.has_value(); });
}

/// refuses options that do not go together.
void require_one_question(const Query_options& o) {
  const int questions = o.cell_at.has_value() + o.cell.has_value() + o.neighbours.has_value() + o.around.has_value() +
                        o.line_through.has_value() + o.strongest.has_value() + o.path.has_value() +
                        o.nearest.has_value() + o.vertices.has_value() + o.edges.has_value() + o.components + o.quads;
  if (questions != 1)
    throw Usage_error(fmt::format("{} questions are asked; give one of the options that 'extremal_mesh query --help' "
                                  "shows",
                                  questions == 0 ? "no" : "several"));
  if (!o.surface.empty() && !o.cell_at)
    throw Usage_error("--surface tells nothing but --cell-at");
  if (o.normal && (!o.cell_at || !o.surface.empty()))
    throw Usage_error("--normal helps --cell-at without --surface only");
  if ((any(o.min) || any(o.max)) && !o.edges)
    throw Usage_error("measures select edges only; give --edges all with them");
}

Json answer(const Extremal_mesh& mesh, const Query_options& options) {
  if (options.cell_at)
    return cell_at(mesh, options);
  if (options.cell)
    return {{"cell", json_of_cell(mesh, id_of("cell", *options.cell), true)}};
  if (options.neighbours)
    return neighbours_of(mesh, id_of("cell", *options.neighbours));
  if (options.around)
    return around(mesh, id_of("vertex", *options.around));
  if (options.line_through)
    return line_through_edge(mesh, id_of("edge", *options.line_through));
  if (options.strongest)
    return strongest(mesh, *options.strongest);
  if (options.path)
    return path(mesh, id_of("vertex", options.path->at(0)), id_of("vertex", options.path->at(1)));
  if (options.nearest)
    return nearest(mesh, *options.nearest);
  if (options.vertices)
    return vertices(mesh, *options.vertices);
  if (options.edges)
    return edges(mesh, options);
  return options.components ? components(mesh) : quads(mesh);
}

} // namespace

int query(const Query_options& options) {
  require_one_question(options);
  const Extremal_mesh mesh = read_graphml(options.file);
  fmt::print("{}\n", pretty(answer(mesh, options)));
  return success;
}

} // namespace CGAL::Extremal_mesh_3::tool
