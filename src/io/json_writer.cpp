// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The whole mesh as JSON, with the names that GraphML has.
#include <CGAL/Extremal_mesh_3/interchange.h>
#include <CGAL/Extremal_mesh_3/io.h>

#include "json_text.h"

#include <nlohmann/json.hpp>

namespace CGAL::Extremal_mesh_3 {

namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Extremal_mesh_vertex& vertex) {
  Json json = {{"kind", to_string(vertex.kind)},
               {"point", vertex.point},
               {"normal", vertex.normal},
               {"k_max", vertex.k1},
               {"k_min", vertex.k2},
               {"t1", vertex.t1},
               {"t2", vertex.t2},
               {"index", vertex.umbilic_index},
               {"field_index", vertex.field_index},
               {"degree", vertex.star.size()},
               {"star", vertex.star}};
  if (vertex.kind == Vertex_kind::umbilic) {
    json["umbilic_type"] = to_string(vertex.umbilic_type);
    json["ridges"] = vertex.ridges;
  }
  if (vertex.kind == Vertex_kind::extremal_point)
    json["extrema"] = {to_string(vertex.extrema[0]), to_string(vertex.extrema[1])};
  return json;
}

Json json_of(const Extremal_mesh_edge& edge) {
  Json json = {{"source", edge.source},         {"target", edge.target},
               {"family", edge.family},         {"type", to_string(edge.type)},
               {"length", edge.length},         {"strength", edge.strength},
               {"sharpness", edge.sharpness},   {"left_cell", edge.left_cell},
               {"right_cell", edge.right_cell}, {"polyline", edge.polyline},
               {"normals", edge.normals},       {"k_max_along", edge.k1},
               {"k_min_along", edge.k2},        {"extremality_along", edge.extremality}};
  json["segment_types"] = Json::array();
  for (const Line_type type : edge.segment_types)
    json["segment_types"].push_back(to_string(type));
  json["type_changes"] = Json::array();
  for (const Type_change& change : edge.type_changes)
    json["type_changes"].push_back({{"point", change.point}, {"kind", to_string(change.kind)}});
  return json;
}

Json json_of(const Extremal_mesh_cell& cell) {
  return {{"sign", cell.sign},
          {"area", cell.area},
          {"weight", cell.weight},
          {"euler_characteristic", cell.euler_characteristic},
          {"touches_border", cell.touches_border},
          {"boundary", cell.boundary}};
}

} // namespace

void write_json(const std::string& file, const Extremal_mesh& mesh) {
  const Surface_info& surface = mesh.surface();
  Json json;
  json["surface"] = {{"euler_characteristic", surface.euler_characteristic},
                     {"closed", surface.closed},
                     {"components", surface.components},
                     {"area", surface.area},
                     {"degenerate_area", surface.degenerate_area},
                     {"source", surface.source},
                     {"parameters", surface.parameters},
                     {"frame", surface.frame}};
  for (const char* name : {"vertices", "edges", "cells"})
    json[name] = Json::array();
  for (std::size_t v = 0; v < mesh.number_of_vertices(); ++v)
    json["vertices"].push_back(json_of(mesh.vertex(v)));
  for (std::size_t e = 0; e < mesh.number_of_edges(); ++e)
    json["edges"].push_back(json_of(mesh.edge(e)));
  for (const Extremal_mesh_cell& cell : mesh.cells())
    json["cells"].push_back(json_of(cell));
  write_text_file(file, json_text(json) + "\n");
}

} // namespace CGAL::Extremal_mesh_3
