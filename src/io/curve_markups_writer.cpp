// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Markups of 3D Slicer: https://github.com/Slicer/Slicer, Modules/Loadable/Markups/Resources/Schema.
#include <CGAL/Extremal_mesh_3/interchange.h>
#include <CGAL/Extremal_mesh_3/io.h>
#include <CGAL/Extremal_mesh_3/lines.h>

#include "json_text.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace CGAL::Extremal_mesh_3 {

namespace {

using Json = nlohmann::ordered_json;

Json control_point(const std::string& label, const Point& position) {
  return {{"id", label}, {"label", label}, {"position", position}, {"positionStatus", "defined"}};
}

Json markup(const std::string& type, const std::string& name, Json points) {
  return {{"type", type},
          {"name", name},
          {"coordinateSystem", "LPS"},
          {"coordinateUnits", "mm"},
          {"labelFormat", "%N-%d"},
          {"controlPoints", std::move(points)}};
}

Json points_of(const Extremal_mesh& mesh, Vertex_kind kind) {
  Json points = Json::array();
  for (std::size_t v = 0; v < mesh.number_of_vertices(); ++v)
    if (mesh.vertex(v).kind == kind)
      points.push_back(control_point(fmt::format("{}", v), mesh.vertex(v).point));
  return points;
}

/// A closed curve of Slicer's joins its last point to its first by itself.
Json curve(const Extremal_mesh& mesh, const Extremal_line& line, std::size_t number) {
  std::vector<Point> along = polyline(mesh, line.half_edges);
  if (line.closed && along.size() > 2)
    along.pop_back();
  Json points = Json::array();
  for (std::size_t i = 0; i < along.size(); ++i)
    points.push_back(control_point(fmt::format("{}-{}", number, i + 1), along[i]));
  return markup(line.closed ? "ClosedCurve" : "Curve", fmt::format("crest line {}", number), std::move(points));
}

} // namespace

void write_markups(const std::string& file, const Extremal_mesh& mesh) {
  Json markups = Json::array();
  markups.push_back(markup("Fiducial", "extremal points", points_of(mesh, Vertex_kind::extremal_point)));
  markups.push_back(markup("Fiducial", "umbilics", points_of(mesh, Vertex_kind::umbilic)));
  for (const Extremal_line& line : strongest_crest_lines(mesh, mesh.number_of_edges()))
    markups.push_back(curve(mesh, line, markups.size() - 1));
  const Json json = {{"@schema", "https://raw.githubusercontent.com/slicer/slicer/master/Modules/Loadable/Markups/"
                                 "Resources/Schema/markups-schema-v1.0.3.json#"},
                     {"markups", std::move(markups)}};
  write_text_file(file, json_text(json, 1) + "\n");
}

} // namespace CGAL::Extremal_mesh_3
