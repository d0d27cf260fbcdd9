// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the viewer shows, as columns: small ones as JSON, large ones in base64. Positions are taken from the middle of all, so that
// single precision is enough wherever the mesh lies.
#include "view_data.h"

#include "../io/json_text.h"
#include "view_levels.h"

#include "../differential/vector.h"
#include "../io/base64.h"
#include "../io/cell_colours.h"

#include <CGAL/Extremal_mesh_3/measures.h>
#include <CGAL/Extremal_mesh_3/simplify.h>
#include <CGAL/Extremal_mesh_3/summary.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <stdexcept>

namespace CGAL::Extremal_mesh_3 {

namespace {

using Json = nlohmann::ordered_json;

/// The box around all that is shown.
struct Box {
  Point low{}, high{};
  bool empty = true;
  void include(const Point& p) {
    for (std::size_t a = 0; a < 3; ++a) {
      low[a] = empty ? p[a] : std::min(low[a], p[a]);
      high[a] = empty ? p[a] : std::max(high[a], p[a]);
    }
    empty = false;
  }
  Point center() const { return 0.5 * (low + high); }
};

/// calls a function with all points that are shown.
template <typename Function>
void for_each_point(const Extremal_mesh& mesh, const Cell_patches& patches, const Function& function) {
  for (const Point& p : patches.points)
    function(p);
  for (std::size_t e = 0; e < mesh.number_of_edges(); ++e)
    for (const Point& p : mesh.edge(e).polyline)
      function(p);
  for (std::size_t v = 0; v < mesh.number_of_vertices(); ++v)
    function(mesh.vertex(v).point);
}

Box box_of(const Extremal_mesh& mesh, const Cell_patches& patches) {
  Box box;
  for_each_point(mesh, patches, [&](const Point& p) { box.include(p); });
  return box;
}

/// Arrays of points and unit normals.
struct Placed {
  std::vector<float> points;
  std::vector<std::int16_t> normals;
  void add(const Point& p, const Vector& n, const Point& center) {
    for (std::size_t a = 0; a < 3; ++a) {
      points.push_back(float(p[a] - center[a]));
      normals.push_back(std::int16_t(std::lround(32767 * std::clamp(n[a], -1.0, 1.0))));
    }
  }
};

/// The classes of vertices that can be switched on and off: kinds, umbilics by their type.
constexpr std::array<std::string_view, 8> class_names = {"extremal_point", "lemon",       "monstar",  "star",
                                                         "umbilic",        "non_generic", "boundary", "anchor"};

std::size_t class_of(const Extremal_mesh_vertex& vertex) {
  switch (vertex.kind) {
  case Vertex_kind::extremal_point:
    return 0;
  case Vertex_kind::umbilic:
    return vertex.umbilic_type == Umbilic_type::none ? 4 : static_cast<std::size_t>(vertex.umbilic_type);
  case Vertex_kind::non_generic:
    return 5;
  case Vertex_kind::boundary:
    return 6;
  case Vertex_kind::anchor:
    break;
  }
  return 7;
}

/// a vertex of each class, for its colour.
Extremal_mesh_vertex vertex_of_class(std::size_t i) {
  Extremal_mesh_vertex vertex;
  vertex.kind = i == 0   ? Vertex_kind::extremal_point
                : i <= 4 ? Vertex_kind::umbilic
                : i == 5 ? Vertex_kind::non_generic
                : i == 6 ? Vertex_kind::boundary
                         : Vertex_kind::anchor;
  vertex.umbilic_type = i <= 3 ? static_cast<Umbilic_type>(i) : Umbilic_type::none;
  return vertex;
}

/// nothing if the mesh is not one that can be simplified.
std::optional<Simplification> simplification_of(const Extremal_mesh& mesh) {
  try {
    return Simplification(mesh);
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

Json vertices_json(const Extremal_mesh& mesh, const Simplification* simplification, Json& classes) {
  std::array<std::size_t, class_names.size()> counts{};
  Json json;
  for (const char* name : {"class", "point", "k1", "k2", "index", "ridges", "degree", "strength"})
    json[name] = Json::array();
  Placed placed;
  for (std::uint32_t v = 0; v < mesh.number_of_vertices(); ++v) {
    const Extremal_mesh_vertex& vertex = mesh.vertex(v);
    ++counts[class_of(vertex)];
    json["class"].push_back(class_of(vertex));
    json["point"].push_back(vertex.point);
    json["k1"].push_back(vertex.k1);
    json["k2"].push_back(vertex.k2);
    json["index"].push_back(vertex.umbilic_index);
    json["ridges"].push_back(vertex.ridges);
    json["degree"].push_back(vertex.star.size());
    json["strength"].push_back(vertex_measures(mesh, v).strength);
    placed.add({}, vertex.normal, {});
  }
  json["normals"] = base64(placed.normals);
  json["persistence"] = nullptr;
  if (simplification)
    json["persistence"] = simplification->vertex_persistence(); // infinity becomes null
  for (std::size_t i = 0; i < class_names.size(); ++i)
    classes.push_back({{"name", class_names[i]}, {"colour", vertex_colour(vertex_of_class(i))}, {"count", counts[i]}});
  return json;
}

Json edges_json(const Extremal_mesh& mesh) {
  Json json;
  for (const char* name : {"points", "source", "target", "family", "type", "length", "strength", "sharpness",
                           "stability", "left", "right"})
    json[name] = Json::array();
  for (std::uint32_t e = 0; e < mesh.number_of_edges(); ++e) {
    const Extremal_mesh_edge& edge = mesh.edge(e);
    json["points"].push_back(edge.polyline.size());
    json["source"].push_back(edge.source);
    json["target"].push_back(edge.target);
    json["family"].push_back(edge.family);
    json["type"].push_back(static_cast<int>(edge.type));
    json["length"].push_back(edge.length);
    json["strength"].push_back(edge.strength);
    json["sharpness"].push_back(edge.sharpness);
    json["stability"].push_back(edge_measures(mesh, e).stability);
    json["left"].push_back(edge.left_cell);
    json["right"].push_back(edge.right_cell);
  }
  return json;
}

Json lines_json(const Extremal_mesh& mesh, const Point& center, Json& line_types) {
  Placed placed;
  std::vector<std::uint8_t> types;
  std::array<std::size_t, 4> segments{};
  for (std::size_t e = 0; e < mesh.number_of_edges(); ++e) {
    const Extremal_mesh_edge& edge = mesh.edge(e);
    for (std::size_t i = 0; i < edge.polyline.size(); ++i)
      placed.add(edge.polyline[i], edge.normals[i], center);
    for (const Line_type type : edge.segment_types) {
      types.push_back(static_cast<std::uint8_t>(type));
      ++segments[static_cast<std::size_t>(type)];
    }
  }
  const Summary summary = summarize(mesh);
  for (std::size_t i = 0; i < 4; ++i) {
    const auto type = static_cast<Line_type>(i);
    line_types.push_back({{"name", to_string(type)},
                          {"colour", line_colour(type)},
                          {"edges", summary.edges[i]},
                          {"segments", segments[i]}});
  }
  return {{"points", base64(placed.points)}, {"normals", base64(placed.normals)}, {"types", base64(types)}};
}

Json cells_json(const Extremal_mesh& mesh, Cell_colouring colouring) {
  Json json;
  for (const char* name : {"sign", "area", "weight", "edges", "euler_characteristic"})
    json[name] = Json::array();
  for (const Extremal_mesh_cell& cell : mesh.cells()) {
    std::size_t edges = 0;
    for (const std::vector<Half_edge>& walk : cell.boundary)
      edges += walk.size();
    json["sign"].push_back(cell.sign);
    json["area"].push_back(cell.area);
    json["weight"].push_back(cell.weight);
    json["edges"].push_back(edges);
    json["euler_characteristic"].push_back(cell.euler_characteristic);
  }
  std::vector<std::uint8_t> bytes;
  for (const Colour& colour : cell_colours(mesh, colouring))
    bytes.insert(bytes.end(), colour.begin(), colour.end());
  json["colours"] = base64(bytes);
  return json;
}

/// Levels of the simplification that can be looked at: more than these take long to make for a large mesh.
constexpr std::size_t most_levels = 25, most_levels_of_large_meshes = 13, large = 20000;

/// null if there is no level but the mesh itself.
Json levels_json(const Extremal_mesh& mesh, const Simplification* simplification, Cell_colouring colouring) {
  if (!simplification || simplification->steps().empty())
    return nullptr;
  const View_levels levels = view_levels(mesh, *simplification, colouring,
                                         mesh.number_of_edges() > large ? most_levels_of_large_meshes : most_levels);
  std::vector<std::uint8_t> colours;
  for (const Colour& colour : levels.colours)
    colours.insert(colours.end(), colour.begin(), colour.end());
  return {{"level", levels.levels},
          {"persistence", levels.persistence},
          {"vertices", levels.vertices},
          {"edges", levels.edges},
          {"cells", levels.cells},
          {"of_vertex", base64(levels.of_vertex)},
          {"of_segment", base64(levels.of_segment)},
          {"colours", base64(colours)}};
}

/// triangles in the order of their cells, with points that belong to one cell only.
Json surface_json(const Cell_patches& patches, const Point& center) {
  if (patches.cell.empty())
    return nullptr;
  const Cell_patches surface = triangulate(patches);
  std::vector<std::size_t> order(surface.cell.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t i, std::size_t j) { return surface.cell[i] < surface.cell[j]; });
  constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> last_cell(surface.points.size(), none), place(surface.points.size());
  std::vector<std::uint32_t> triangles, cells;
  Placed placed;
  for (const std::size_t i : order)
    for (std::size_t j = surface.begin[i]; j < surface.begin[i + 1]; ++j) {
      const std::uint32_t p = surface.corners[j], c = surface.cell[i];
      if (last_cell[p] != c) {
        last_cell[p] = c;
        place[p] = std::uint32_t(cells.size());
        cells.push_back(c);
        placed.add(surface.points[p], surface.normals[p], center);
      }
      triangles.push_back(place[p]);
    }
  return {{"points", base64(placed.points)},
          {"normals", base64(placed.normals)},
          {"cells", base64(cells)},
          {"triangles", base64(triangles)}};
}

} // namespace

std::string view_data(const Extremal_mesh& mesh, const Cell_patches& patches, const View_options& options) {
  const Box box = box_of(mesh, patches);
  const Point center = box.center();
  double radius = 0;
  for_each_point(mesh, patches, [&](const Point& p) { radius = std::max(radius, norm(p - center)); });
  const std::optional<Simplification> simplification = simplification_of(mesh);
  const Simplification* levels = simplification ? &*simplification : nullptr;
  Json json;
  json["source"] = mesh.surface().source;
  json["frame"] = mesh.surface().frame;
  json["closed"] = mesh.surface().closed;
  json["center"] = center;
  json["radius"] = radius;
  json["view"] = options.view;
  json["up"] = options.up;
  json["sign_colours"] = {cell_colour(1), cell_colour(-1)};
  json["vertex_classes"] = Json::array();
  json["line_types"] = Json::array();
  json["vertices"] = vertices_json(mesh, levels, json["vertex_classes"]);
  json["edges"] = edges_json(mesh);
  json["lines"] = lines_json(mesh, center, json["line_types"]);
  json["cells"] = cells_json(mesh, options.colouring);
  json["levels"] = levels_json(mesh, levels, options.colouring);
  json["surface"] = surface_json(patches, center);
  std::string text = json_text(json);
  for (std::size_t i = text.find('<'); i != text.npos; i = text.find('<', i))
    text.replace(i, 1, "\\u003c");
  return text;
}

} // namespace CGAL::Extremal_mesh_3
