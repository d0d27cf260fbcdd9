// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// glTF 2.0: Khronos Group, "glTF 2.0 Specification", 2021. Lines and points have no width there; viewers choose it.
#include "../algorithms/patches.h"
#include "Line_points.h"
#include "Text_file.h"
#include "base64.h"
#include "colours.h"
#include "json_text.h"

#include <CGAL/Extremal_mesh_3/interchange.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>

namespace CGAL::Extremal_mesh_3 {

namespace {

using Json = nlohmann::ordered_json;
enum Mode { points = 0, lines = 1, triangles = 4 };
constexpr int float_type = 5126, unsigned_type = 5125, array_buffer = 34962, index_buffer = 34963;

/// light as glTF counts it, of a colour as screens do (IEC 61966-2-1).
double linear(std::uint8_t part) {
  const double c = part / 255.0;
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

/// A scene on its way to a file: the JSON, and the bytes of its arrays.
class Scene {
public:
  Scene() {
    json_["asset"] = {{"version", "2.0"}, {"generator", "Extremal_mesh_3"}};
    json_["scene"] = 0;
    json_["scenes"] = {{{"nodes", Json::array()}}};
    for (const char* name : {"nodes", "meshes", "materials", "accessors", "bufferViews"})
      json_[name] = Json::array();
  }

  std::size_t add_vectors(const std::vector<Vector>& vectors) {
    std::vector<float> numbers;
    Vector low{}, high{};
    for (std::size_t i = 0; i < vectors.size(); ++i)
      for (std::size_t a = 0; a < 3; ++a) {
        const double x = double(float(vectors[i][a]));
        numbers.push_back(float(x));
        low[a] = i == 0 ? x : std::min(low[a], x);
        high[a] = i == 0 ? x : std::max(high[a], x);
      }
    add_view(numbers, array_buffer);
    return add_accessor(
        {{"componentType", float_type}, {"count", vectors.size()}, {"type", "VEC3"}, {"min", low}, {"max", high}});
  }
  std::size_t add_indices(const std::vector<std::uint32_t>& indices) {
    add_view(indices, index_buffer);
    return add_accessor({{"componentType", unsigned_type}, {"count", indices.size()}, {"type", "SCALAR"}});
  }
  /// \param attributes  accessors by their names
  void add_mesh(std::string_view name, const Colour& colour, Mode mode, const Json& attributes, std::size_t indices) {
    Json material = {{"name", name},
                     {"pbrMetallicRoughness",
                      {{"baseColorFactor", {linear(colour[0]), linear(colour[1]), linear(colour[2]), 1}},
                       {"metallicFactor", 0},
                       {"roughnessFactor", 0.8}}},
                     {"doubleSided", true}};
    json_["materials"].push_back(std::move(material));
    json_["meshes"].push_back({{"name", name},
                               {"primitives", Json::array({{{"attributes", attributes},
                                                            {"indices", indices},
                                                            {"mode", static_cast<int>(mode)},
                                                            {"material", json_["materials"].size() - 1}}})}});
    json_["nodes"].push_back({{"name", name}, {"mesh", json_["meshes"].size() - 1}});
    json_["scenes"][0]["nodes"].push_back(json_["nodes"].size() - 1);
  }

  void write(const std::string& file) {
    const bool binary = file.ends_with(".glb") || file.ends_with(".GLB");
    Json buffer = {{"byteLength", bytes_.size()}};
    if (!binary)
      buffer["uri"] = "data:application/octet-stream;base64," + base64(std::string_view(bytes_));
    json_["buffers"] = Json::array({buffer});
    for (const char* name :
         {"nodes", "meshes", "materials", "accessors", "bufferViews"}) // empty arrays are not allowed
      if (json_[name].empty())
        json_.erase(name);
    if (bytes_.empty())
      json_.erase("buffers");
    if (json_["scenes"][0]["nodes"].empty())
      json_["scenes"][0].erase("nodes");
    std::string text = json_text(json_);
    Text_file out(file);
    if (!binary) {
      out << text << "\n";
    } else {
      text.resize((text.size() + 3) / 4 * 4, ' ');
      std::string header = "glTF";
      const std::size_t size = 12 + 8 + text.size() + (bytes_.empty() ? 0 : 8 + bytes_.size());
      append(header, std::vector<std::uint32_t>{2, std::uint32_t(size), std::uint32_t(text.size())});
      out << header << "JSON" << text;
      if (!bytes_.empty()) {
        std::string chunk;
        append(chunk, std::vector<std::uint32_t>{std::uint32_t(bytes_.size())});
        out << chunk << std::string_view("BIN\0", 4) << bytes_;
      }
    }
    out.commit();
  }

private:
  template <typename Number> static void append(std::string& bytes, const std::vector<Number>& numbers) {
    static_assert(sizeof(Number) == 4);
    for (const Number number : numbers) {
      std::uint32_t bits = 0;
      std::memcpy(&bits, &number, 4);
      for (unsigned shift = 0; shift < 32; shift += 8)
        bytes += char(bits >> shift & 255U);
    }
  }
  template <typename Number> void add_view(const std::vector<Number>& numbers, int target) {
    const std::size_t first = bytes_.size();
    append(bytes_, numbers);
    json_["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", first}, {"byteLength", bytes_.size() - first}, {"target", target}});
  }
  std::size_t add_accessor(Json accessor) {
    accessor["bufferView"] = json_["bufferViews"].size() - 1;
    json_["accessors"].push_back(std::move(accessor));
    return json_["accessors"].size() - 1;
  }

  Json json_;
  std::string bytes_;
};

void add_lines(Scene& scene, const Extremal_mesh& mesh, const Line_points& all, std::size_t positions) {
  std::array<std::vector<std::uint32_t>, 4> segments;
  for (std::size_t e = 0; e < mesh.number_of_edges(); ++e)
    for (std::size_t i = 0; i + 1 < all.edges[e].size(); ++i) {
      auto& ends = segments[static_cast<std::size_t>(mesh.edge(e).segment_types[i])];
      ends.insert(ends.end(), {all.edges[e][i], all.edges[e][i + 1]});
    }
  for (std::size_t i = 0; i < segments.size(); ++i)
    if (const auto type = static_cast<Line_type>(i); !segments[i].empty())
      scene.add_mesh(to_string(type), line_colour(type), lines, {{"POSITION", positions}},
                     scene.add_indices(segments[i]));
}

void add_vertices(Scene& scene, const Extremal_mesh& mesh, std::size_t positions) {
  std::map<std::string_view, std::vector<std::uint32_t>> classes;
  for (std::uint32_t v = 0; v < mesh.number_of_vertices(); ++v) {
    const Extremal_mesh_vertex& vertex = mesh.vertex(v);
    const bool typed = vertex.kind == Vertex_kind::umbilic && vertex.umbilic_type != Umbilic_type::none;
    classes[typed ? to_string(vertex.umbilic_type) : to_string(vertex.kind)].push_back(v);
  }
  for (const auto& [name, numbers] : classes)
    scene.add_mesh(name, vertex_colour(mesh.vertex(numbers.front())), points, {{"POSITION", positions}},
                   scene.add_indices(numbers));
}

void add_surface(Scene& scene, const Extremal_mesh& mesh, const Cell_patches& patches) {
  const Cell_patches surface = triangulate(patches);
  const std::size_t positions = scene.add_vectors(surface.points), normals = scene.add_vectors(surface.normals);
  for (const int sign : {1, -1}) {
    std::vector<std::uint32_t> corners;
    for (std::size_t i = 0; i < surface.cell.size(); ++i)
      if (mesh.cell(surface.cell[i]).sign == sign)
        for (const std::uint32_t corner : polygon(surface, i))
          corners.push_back(corner);
    if (!corners.empty())
      scene.add_mesh(sign > 0 ? "cells with E > 0" : "cells with E < 0", cell_colour(sign), triangles,
                     {{"POSITION", positions}, {"NORMAL", normals}}, scene.add_indices(corners));
  }
}

} // namespace

void write_gltf(const std::string& file, const Extremal_mesh& mesh, const Cell_patches& patches) {
  require_patches_of(mesh, patches);
  Scene scene;
  const Line_points all(mesh);
  if (!all.points.empty()) {
    const std::size_t positions = scene.add_vectors(all.points);
    add_lines(scene, mesh, all, positions);
    add_vertices(scene, mesh, positions);
  }
  if (!patches.cell.empty())
    add_surface(scene, mesh, patches);
  scene.write(file);
}

} // namespace CGAL::Extremal_mesh_3
