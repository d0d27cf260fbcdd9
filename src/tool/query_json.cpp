// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "query_json.h"

#include "../io/json_text.h"

namespace CGAL::Extremal_mesh_3::tool {

namespace {

void add(Json& json, const Line_measures& m) {
  json["length"] = m.length;
  json["strength"] = m.strength;
  json["sharpness"] = m.sharpness;
  json["mean_curvature"] = m.mean_curvature;
  json["extreme_curvature"] = m.extreme_curvature;
  json["stability"] = m.stability;
}

Json json_of_side(const Extremal_mesh& mesh, const Cell_side& side) {
  return {{"half_edge", side.half_edge},       {"from", mesh.source(side.half_edge)},
          {"to", mesh.target(side.half_edge)}, {"family", side.family},
          {"type", to_string(side.type)},      {"length", mesh.edge(side.half_edge / 2).length},
          {"neighbour", side.neighbour}};
}

/// the points inside edges at which the type changes, in the order of a walk.
Json type_changes_of(const Extremal_mesh& mesh, const std::vector<Half_edge>& walk) {
  Json list = Json::array();
  for (const Half_edge h : walk) {
    const Extremal_mesh_edge& edge = mesh.edge(h / 2);
    const std::size_t n = edge.type_changes.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Type_change& change = edge.type_changes[h % 2 == 0 ? i : n - 1 - i];
      list.push_back({{"edge", h / 2}, {"kind", to_string(change.kind)}, {"point", edge.polyline[change.point]}});
    }
  }
  return list;
}

/// appends a value, of which the first line is indented already.
/// \param width  up to which it is written on one line
void append_pretty(std::string& out, const Json& json, std::size_t indent, std::size_t width) {
  const std::string line = json_text(json);
  if (!json.is_structured() || json.empty() || indent + line.size() <= width) {
    out += line;
    return;
  }
  out += json.is_object() ? "{" : "[";
  const char* separator = "\n";
  for (const auto& [key, value] : json.items()) {
    out += separator;
    out.append(indent + 2, ' ');
    if (json.is_object())
      out.append(json_text(Json(key))).append(": ");
    constexpr std::size_t width_of_member = 120, width_of_element = 400; // an element of a list is best on one line
    append_pretty(out, value, indent + 2, json.is_object() ? width_of_member : width_of_element);
    separator = ",\n";
  }
  out += '\n';
  out.append(indent, ' ');
  out += json.is_object() ? '}' : ']';
}

} // namespace

Json json_of_vertex(const Extremal_mesh& mesh, std::uint32_t v) {
  const Vertex_measures m = vertex_measures(mesh, v); // refuses vertices that are not there
  const Extremal_mesh_vertex& vertex = mesh.vertex(v);
  Json json = {{"id", v}, {"kind", to_string(vertex.kind)}, {"point", vertex.point}, {"normal", vertex.normal}};
  json["k1"] = vertex.k1;
  json["k2"] = vertex.k2;
  json["degree"] = vertex.star.size();
  if (vertex.kind == Vertex_kind::umbilic) {
    json["umbilic_type"] = to_string(vertex.umbilic_type);
    json["index"] = vertex.umbilic_index;
    json["ridges"] = vertex.ridges;
  }
  if (m.extrema) {
    json["extrema"] = to_string(*m.extrema);
    json["types"] = {to_string(vertex.extrema[0]), to_string(vertex.extrema[1])};
  }
  json["strength"] = m.strength;
  json["stability"] = m.stability;
  return json;
}

Json json_of_edge(const Extremal_mesh& mesh, std::uint32_t e) {
  const Line_measures m = edge_measures(mesh, e); // refuses edges that are not there
  const Extremal_mesh_edge& edge = mesh.edge(e);
  Json json = {{"id", e},
               {"source", edge.source},
               {"target", edge.target},
               {"family", edge.family},
               {"type", to_string(edge.type)},
               {"left_cell", edge.left_cell},
               {"right_cell", edge.right_cell}};
  add(json, m);
  json["type_changes"] = type_changes_of(mesh, {2 * e});
  return json;
}

std::vector<std::uint32_t> vertices_along(const Extremal_mesh& mesh, const std::vector<Half_edge>& half_edges) {
  std::vector<std::uint32_t> vertices;
  vertices.reserve(half_edges.size() + 1);
  for (const Half_edge h : half_edges)
    vertices.push_back(mesh.source(h));
  if (!half_edges.empty())
    vertices.push_back(mesh.target(half_edges.back()));
  return vertices;
}

Json json_of_line(const Extremal_mesh& mesh, const Extremal_line& line) {
  Json json = {{"closed", line.closed}};
  add(json, line_measures(mesh, line));
  json["half_edges"] = line.half_edges;
  json["vertices"] = vertices_along(mesh, line.half_edges);
  json["type_changes"] = type_changes_of(mesh, line.half_edges);
  return json;
}

Json json_of_cell(const Extremal_mesh& mesh, std::uint32_t c, bool sides) {
  const Cell_measures m = cell_measures(mesh, c); // refuses cells that are not there
  const Extremal_mesh_cell& cell = mesh.cell(c);
  Json json = {{"id", c},
               {"sign", cell.sign},
               {"euler_characteristic", cell.euler_characteristic},
               {"touches_border", cell.touches_border},
               {"area", m.area},
               {"weight", m.weight},
               {"mean_extremality", m.mean_extremality},
               {"perimeter", m.perimeter},
               {"sides", m.sides},
               {"compactness", m.compactness ? Json(*m.compactness) : Json()}};
  if (sides) {
    json["boundary"] = Json::array();
    for (const auto& walk : cell_sides(mesh, c)) {
      Json& list = json["boundary"].emplace_back(Json::array());
      for (const Cell_side& side : walk)
        list.push_back(json_of_side(mesh, side));
    }
  }
  return json;
}

std::string pretty(const Json& json) {
  std::string out;
  append_pretty(out, json, 0, 0);
  return out;
}

} // namespace CGAL::Extremal_mesh_3::tool
