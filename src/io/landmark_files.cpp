// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Markups of 3D Slicer: https://github.com/Slicer/Slicer, Modules/Loadable/Markups/Resources/Schema.
#include <CGAL/Extremal_mesh_3/errors.h>
#include <CGAL/Extremal_mesh_3/io.h>
#include <CGAL/Extremal_mesh_3/landmarks.h>

#include "json_text.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <optional>
#include <sstream>

namespace CGAL::Extremal_mesh_3 {

namespace {

using Json = nlohmann::ordered_json;

std::string content_of(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  if (!in || !(text << in.rdbuf()))
    throw Io_error(fmt::format("'{}' cannot be read: is it there, and a file?", file));
  return text.str();
}

std::vector<Given_landmark> parse_markups(const std::string& file, const std::string& text) {
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_object() || !json.contains("markups") || !json["markups"].is_array())
    throw Io_error(fmt::format("'{}' is no file of markups: an object with \"markups\" is expected", file));
  std::vector<Given_landmark> result;
  for (const Json& markup : json["markups"]) {
    try {
      const std::string system = markup.value("coordinateSystem", "LPS");
      if (system != "LPS" && system != "RAS")
        throw Io_error(fmt::format("'{}': the coordinate system is '{}', not LPS or RAS", file, system));
      const double sign = system == "RAS" ? -1 : 1; // x and y point the other way
      for (const Json& point : markup.at("controlPoints")) {
        const auto position = point.at("position").get<std::array<double, 3>>();
        result.push_back({point.value("label", std::to_string(result.size() + 1)),
                          {sign * position[0], sign * position[1], position[2]}});
      }
    } catch (const Json::exception&) {
      throw Io_error(fmt::format("'{}': control point {} has no position of three numbers", file, result.size() + 1));
    }
  }
  return result;
}

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::string cell;
  std::istringstream in(line);
  while (std::getline(in, cell, ',')) {
    cell.erase(0, cell.find_first_not_of(" \t\""));
    cell.erase(cell.find_last_not_of(" \t\"\r") + 1);
    cells.push_back(cell);
  }
  return cells;
}

std::optional<double> number_in(const std::string& cell) {
  double value = 0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (error != std::errc() || end != cell.data() + cell.size() || !std::isfinite(value))
    return std::nullopt;
  return value;
}

std::vector<Given_landmark> parse_table(const std::string& file, const std::string& text) {
  std::vector<Given_landmark> result;
  std::array<std::size_t, 3> column{0, 1, 2};
  std::optional<std::size_t> label;
  std::istringstream in(text);
  std::string line;
  bool titled = false;
  for (std::size_t number = 1; std::getline(in, line); ++number) {
    if (line.empty() || line[0] == '#' || line == "\r")
      continue;
    const std::vector<std::string> cells = cells_of(line);
    if (result.empty() && !titled && !cells.empty() && !number_in(cells[0])) { // titles of columns
      const auto find = [&](const std::string& name) {
        return std::size_t(std::find(cells.begin(), cells.end(), name) - cells.begin());
      };
      titled = true;
      if (find("x") < cells.size())
        column = {find("x"), find("y"), find("z")};
      for (const char* name : {"id", "label", "name"})
        if (!label && find(name) < cells.size())
          label = find(name);
      continue;
    }
    Given_landmark landmark;
    for (std::size_t a = 0; a < 3; ++a) {
      const auto value = column[a] < cells.size() ? number_in(cells[column[a]]) : std::nullopt;
      if (!value)
        throw Io_error(fmt::format("'{}', line {}: a number is expected in column {}", file, number, column[a] + 1));
      landmark.point[a] = *value;
    }
    landmark.label = label && *label < cells.size() ? cells[*label] : std::to_string(result.size() + 1);
    result.push_back(std::move(landmark));
  }
  return result;
}

} // namespace

std::vector<Given_landmark> read_landmarks(const std::string& file) {
  const std::string text = content_of(file);
  std::vector<Given_landmark> result = file.ends_with(".json") ? parse_markups(file, text) : parse_table(file, text);
  if (result.empty())
    throw Io_error(fmt::format("'{}' holds no landmark", file));
  return result;
}

void write_markups(const std::string& file, const Extremal_mesh& mesh, const std::vector<Landmark>& landmarks) {
  Json points = Json::array();
  for (const Landmark& landmark : landmarks) {
    const Extremal_mesh_vertex& v = mesh.vertex(landmark.vertex);
    const Vector &x = v.t1, &y = v.t2, &z = v.normal; // the columns of the orientation
    points.push_back(
        {{"id", landmark.id},
         {"label", landmark.id},
         {"description", fmt::format("vertex {}, {}, k1 {:.4g}, k2 {:.4g}, persistence {:.4g}", landmark.vertex,
                                     to_string(v.kind), v.k1, v.k2, landmark.persistence)},
         {"associatedNodeID", ""},
         {"position", v.point},
         {"orientation", {x[0], y[0], z[0], x[1], y[1], z[1], x[2], y[2], z[2]}},
         {"selected", true},
         {"locked", false},
         {"visibility", true},
         {"positionStatus", "defined"}});
  }
  const Json markup = {{"type", "Fiducial"},
                       {"coordinateSystem", "LPS"},
                       {"coordinateUnits", "mm"},
                       {"locked", false},
                       {"fixedNumberOfControlPoints", false},
                       {"labelFormat", "%N-%d"},
                       {"lastUsedControlPointNumber", landmarks.size()},
                       {"controlPoints", std::move(points)},
                       {"measurements", Json::array()}};
  const Json json = {{"@schema", "https://raw.githubusercontent.com/slicer/slicer/master/Modules/Loadable/Markups/"
                                 "Resources/Schema/markups-schema-v1.0.3.json#"},
                     {"markups", Json::array({markup})}};
  write_text_file(file, json_text(json, 2) + "\n");
}

void write_landmarks_csv(const std::string& file, const Extremal_mesh& mesh, const std::vector<Landmark>& landmarks) {
  std::string csv = "id,kind,x,y,z,nx,ny,nz,t1x,t1y,t1z,t2x,t2y,t2z,k_max,k_min,persistence,strength,vertex\n";
  for (const Landmark& landmark : landmarks) {
    const Extremal_mesh_vertex& v = mesh.vertex(landmark.vertex);
    csv += fmt::format("{},{}", landmark.id, to_string(v.kind));
    for (const Vector* vector : {&v.point, &v.normal, &v.t1, &v.t2})
      csv += fmt::format(",{}", fmt::join(*vector, ","));
    csv += fmt::format(",{},{},{},{},{}\n", v.k1, v.k2, landmark.persistence, landmark.strength, landmark.vertex);
  }
  write_text_file(file, csv);
}

} // namespace CGAL::Extremal_mesh_3
