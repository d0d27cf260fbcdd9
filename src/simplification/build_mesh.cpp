// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "build_mesh.h"

#include "../differential/vector.h"

#include <algorithm>
#include <array>

namespace CGAL::Extremal_mesh_3 {

namespace {

class Mesh_builder {
public:
  Mesh_builder(const Embedded_graph& graph, const Extremal_mesh& original) : graph_(graph), original_(original) {}

  Extremal_mesh build() {
    number_elements();
    for (std::uint32_t e = 0; e < graph_.edges().size(); ++e)
      if (graph_.edges()[e].alive)
        add_edge(e);
    for (std::uint32_t v = 0; v < graph_.vertices().size(); ++v)
      if (graph_.vertices()[v].alive)
        add_vertex(v);
    add_cells();
    return Extremal_mesh(std::move(vertices_), std::move(edges_), std::move(cells_), original_.surface());
  }

private:
  void number_elements() {
    const auto number = [](const auto& elements, std::vector<std::uint32_t>& number) {
      std::uint32_t count = 0;
      for (const auto& x : elements)
        number.push_back(x.alive ? count++ : Embedded_graph::none);
    };
    number(graph_.vertices(), vertex_);
    number(graph_.edges(), edge_);
    cell_ = graph_.numbered_cells();
  }

  Half_edge half_edge(Half_edge h) const { return 2 * edge_[h / 2] + h % 2; }

  void add_edge(std::uint32_t e) {
    const Embedded_graph::Edge& from = graph_.edges()[e];
    Extremal_mesh_edge edge;
    edge.id = edge_[e];
    edge.source = vertex_[graph_.source(2 * e)];
    edge.target = vertex_[graph_.target(2 * e)];
    edge.family = from.family;
    edge.left_cell = cell_[graph_.left_cell(2 * e)];
    edge.right_cell = cell_[graph_.left_cell(2 * e + 1)];
    std::array<double, 4> length_of_type{};
    for (const Half_edge h : graph_.walks().half_edges(from.walk)) {
      const Extremal_mesh_edge& piece = original_.edge(h / 2);
      append(edge, piece, h % 2 == 1);
      edge.length += piece.length;
      edge.strength += piece.strength;
      edge.sharpness += piece.sharpness;
      if (piece.life_time)
        edge.life_time = std::max(edge.life_time.value_or(0), *piece.life_time);
      for (std::size_t i = 0; i < piece.segment_types.size(); ++i)
        length_of_type[std::size_t(piece.segment_types[i])] += distance(piece.polyline[i], piece.polyline[i + 1]);
    }
    edge.type = Line_type(std::max_element(length_of_type.begin(), length_of_type.end()) - length_of_type.begin());
    edges_.push_back(std::move(edge));
  }

  /// appends a piece, whose first point is the last of the edge so far.
  static void append(Extremal_mesh_edge& edge, const Extremal_mesh_edge& piece, bool backwards) {
    const std::size_t skipped = edge.polyline.empty() ? 0 : 1;
    append_type_changes(edge, piece, backwards);
    const auto append_values = [&](auto& to, const auto& from, std::size_t skip) {
      if (backwards)
        to.insert(to.end(), from.rbegin() + std::ptrdiff_t(skip), from.rend());
      else
        to.insert(to.end(), from.begin() + std::ptrdiff_t(skip), from.end());
    };
    append_values(edge.polyline, piece.polyline, skipped);
    append_values(edge.normals, piece.normals, skipped);
    append_values(edge.k1, piece.k1, skipped);
    append_values(edge.k2, piece.k2, skipped);
    append_values(edge.extremality, piece.extremality, skipped);
    append_values(edge.segment_types, piece.segment_types, 0);
  }

  static void append_type_changes(Extremal_mesh_edge& edge, const Extremal_mesh_edge& piece, bool backwards) {
    const auto first = std::uint32_t(edge.polyline.empty() ? 0 : edge.polyline.size() - 1);
    const Line_type first_type = backwards ? piece.segment_types.back() : piece.segment_types.front();
    if (first > 0 && edge.segment_types.back() != first_type)
      edge.type_changes.push_back({first, Type_change_kind::former_vertex});
    const auto last = std::uint32_t(piece.polyline.size() - 1);
    if (backwards)
      for (auto change = piece.type_changes.rbegin(); change != piece.type_changes.rend(); ++change)
        edge.type_changes.push_back({first + last - change->point, change->kind});
    else
      for (const Type_change& change : piece.type_changes)
        edge.type_changes.push_back({first + change.point, change.kind});
  }

  void add_vertex(std::uint32_t v) {
    const Embedded_graph::Vertex& from = graph_.vertices()[v];
    Extremal_mesh_vertex vertex;
    if (v < original_.number_of_vertices())
      vertex = original_.vertex(v);
    else
      place_on_line(vertex, half_edge(from.first));
    if (vertex.kind != from.kind || vertex.umbilic_index * 2 != from.half_turns ||
        vertex.field_index != from.field_index)
      change_kind(vertex, from);
    if (vertex.life_time)
      vertex.life_time = from.life_time;
    vertex.star.clear();
    for (const Half_edge h : graph_.star(v))
      vertex.star.push_back(half_edge(h));
    if (vertex.kind == Vertex_kind::umbilic)
      vertex.ridges = int(vertex.star.size() / 2);
    vertices_.push_back(std::move(vertex));
  }

  static void change_kind(Extremal_mesh_vertex& vertex, const Embedded_graph::Vertex& from) {
    const int old_half_turns = int(2 * vertex.umbilic_index);
    vertex.kind = from.kind;
    vertex.umbilic_index = from.half_turns / 2.0;
    vertex.field_index = from.field_index;
    if (from.kind != Vertex_kind::umbilic) {
      vertex.umbilic_type = Umbilic_type::none;
      vertex.ridges = 0;
    } else if (from.half_turns != old_half_turns || vertex.umbilic_type == Umbilic_type::none) {
      vertex.umbilic_type = from.half_turns > 0 ? Umbilic_type::lemon : Umbilic_type::star;
    }
    if (from.kind != Vertex_kind::extremal_point)
      vertex.extrema = {};
  }

  /// the anchor of a line that was closed where other lines ran before.
  void place_on_line(Extremal_mesh_vertex& vertex, Half_edge h) const {
    const Extremal_mesh_edge& edge = edges_[h / 2];
    const std::size_t i = h % 2 == 0 ? 0 : edge.polyline.size() - 1;
    vertex.point = edge.polyline[i];
    vertex.normal = edge.normals[i];
    vertex.k1 = edge.k1[i];
    vertex.k2 = edge.k2[i];
  }

  void add_cells() {
    cells_.resize(graph_.number_of_cells());
    std::vector<char> met(cells_.size(), 0);
    for (std::uint32_t c = 0; c < cell_.size(); ++c) {
      Extremal_mesh_cell& cell = cells_[cell_[c]];
      if (!met[cell_[c]]) { // the smallest stands for all
        met[cell_[c]] = 1;
        const Embedded_graph::Cell& from = graph_.cell(c);
        cell.sign = from.sign;
        cell.euler_characteristic = from.euler_characteristic;
        cell.touches_border = from.touches_border;
      }
      cell.area += original_.cell(c).area;
      cell.weight += original_.cell(c).weight;
    }
    std::vector<char> walked(graph_.edges().size() * 2, 0);
    for (Half_edge start = 0; start < walked.size(); ++start) {
      if (!graph_.edges()[start / 2].alive || walked[start])
        continue;
      auto& walk = cells_[cell_[graph_.left_cell(start)]].boundary.emplace_back();
      for (Half_edge h = start; !walked[h]; h = next_on_walk(h)) {
        walked[h] = 1;
        walk.push_back(half_edge(h));
      }
    }
  }

  Half_edge next_on_walk(Half_edge h) const {
    const Embedded_graph::Vertex& v = graph_.vertices()[graph_.target(h)];
    return v.kind == Vertex_kind::boundary ? graph_.vertices()[v.next_on_border].first : graph_.previous(h ^ 1U);
  }

  const Embedded_graph& graph_;
  const Extremal_mesh& original_;
  std::vector<std::uint32_t> vertex_, edge_, cell_; ///< numbers in the new mesh
  std::vector<Extremal_mesh_vertex> vertices_;
  std::vector<Extremal_mesh_edge> edges_;
  std::vector<Extremal_mesh_cell> cells_;
};

} // namespace

Extremal_mesh build_mesh(const Embedded_graph& graph, const Extremal_mesh& original) {
  return Mesh_builder(graph, original).build();
}

} // namespace CGAL::Extremal_mesh_3
