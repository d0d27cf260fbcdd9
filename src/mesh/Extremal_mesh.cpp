// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The graph of the extremal mesh and its cells, with their cross-references validated.
#include <CGAL/Extremal_mesh_3/Extremal_mesh.h>

#include <fmt/format.h>

#include <limits>
#include <stdexcept>
#include <utility>

namespace CGAL::Extremal_mesh_3 {

std::string_view to_string(Vertex_kind kind) {
  switch (kind) {
  case Vertex_kind::extremal_point:
    return "extremal_point";
  case Vertex_kind::umbilic:
    return "umbilic";
  case Vertex_kind::non_generic:
    return "non_generic";
  case Vertex_kind::boundary:
    return "boundary";
  case Vertex_kind::anchor:
    return "anchor";
  }
  return "unknown";
}

std::string_view to_string(Umbilic_type type) {
  switch (type) {
  case Umbilic_type::none:
    return "none";
  case Umbilic_type::lemon:
    return "lemon";
  case Umbilic_type::monstar:
    return "monstar";
  case Umbilic_type::star:
    return "star";
  }
  return "unknown";
}

std::string_view to_string(Line_type type) {
  switch (type) {
  case Line_type::max_largest:
    return "max_largest";
  case Line_type::min_largest:
    return "min_largest";
  case Line_type::max_second:
    return "max_second";
  case Line_type::min_second:
    return "min_second";
  }
  return "unknown";
}

std::string_view to_string(Type_change_kind kind) {
  switch (kind) {
  case Type_change_kind::turning_point:
    return "turning_point";
  case Type_change_kind::equal_curvatures:
    return "equal_curvatures";
  case Type_change_kind::parabolic_point:
    return "parabolic_point";
  case Type_change_kind::former_vertex:
    return "former_vertex";
  }
  return "unknown";
}

namespace {

template <typename... Arguments>
void require(bool condition, fmt::format_string<Arguments...> message, Arguments&&... arguments) {
  if (!condition)
    throw std::invalid_argument(fmt::format(message, std::forward<Arguments>(arguments)...));
}

void validate(const Extremal_mesh_vertex& vertex, std::size_t v, std::size_t number_of_half_edges) {
  for (const Half_edge h : vertex.star)
    require(h < number_of_half_edges, "vertex {}: its star names half-edge {}, but there are only {}", v, h,
            number_of_half_edges);
}

void validate(const Extremal_mesh_edge& edge, std::size_t e, std::size_t number_of_vertices,
              std::size_t number_of_cells) {
  require(edge.id == e, "edge {}: its id is {}; ids must be 0, 1, 2, …", e, edge.id);
  for (const std::uint32_t v : {edge.source, edge.target})
    require(v < number_of_vertices, "edge {}: it ends at vertex {}, but there are only {} vertices", e, v,
            number_of_vertices);
  for (const std::uint32_t c : {edge.left_cell, edge.right_cell})
    require(c < number_of_cells, "edge {}: it borders cell {}, but there are only {} cells", e, c, number_of_cells);
  require(edge.family == 1 || edge.family == 2, "edge {}: its family is {}; it must be 1 or 2", e, edge.family);
  const std::size_t n = edge.polyline.size();
  require(n >= 2, "edge {}: its polyline has {} points; it needs at least 2", e, n);
  require(edge.k1.size() == n && edge.k2.size() == n, "edge {}: it has {} points, {} values of k1 and {} of k2", e, n,
          edge.k1.size(), edge.k2.size());
  require(edge.normals.size() == n && edge.extremality.size() == n,
          "edge {}: it has {} points, {} normals and {} values of the extremality", e, n, edge.normals.size(),
          edge.extremality.size());
  require(edge.segment_types.size() == n - 1, "edge {}: it has {} segments and {} segment types", e, n - 1,
          edge.segment_types.size());
  for (std::size_t i = 0; i < edge.type_changes.size(); ++i) {
    const std::uint32_t point = edge.type_changes[i].point;
    require(point > 0 && point + 1 < n,
            "edge {}: its type changes at point {}, which is not between the ends of {} points", e, point, n);
    require(i == 0 || edge.type_changes[i - 1].point <= point, "edge {}: its type changes at point {} after point {}",
            e, point, edge.type_changes[i == 0 ? 0 : i - 1].point);
  }
}

void validate(const Extremal_mesh_cell& cell, std::size_t c, std::size_t number_of_half_edges) {
  require(cell.sign == 1 || cell.sign == -1, "cell {}: its sign is {}; it must be 1 or -1", c, cell.sign);
  for (const std::vector<Half_edge>& walk : cell.boundary)
    for (const Half_edge h : walk)
      require(h < number_of_half_edges, "cell {}: its boundary names half-edge {}, but there are only {}", c, h,
              number_of_half_edges);
}

} // namespace

Extremal_mesh::Extremal_mesh(std::vector<Extremal_mesh_vertex> vertices, std::vector<Extremal_mesh_edge> edges,
                             std::vector<Extremal_mesh_cell> cells, Surface_info surface)
    : cells_(std::move(cells)), surface_(std::move(surface)) {
  const std::size_t number_of_half_edges = 2 * edges.size();
  require(number_of_half_edges <= std::numeric_limits<Half_edge>::max(), "{} edges are more than half-edges can number",
          edges.size());
  for (std::size_t v = 0; v < vertices.size(); ++v)
    validate(vertices[v], v, number_of_half_edges);
  for (std::size_t e = 0; e < edges.size(); ++e)
    validate(edges[e], e, vertices.size(), cells_.size());
  for (std::size_t c = 0; c < cells_.size(); ++c)
    validate(cells_[c], c, number_of_half_edges);

  auto graph = std::make_shared<Graph>(vertices.size());
  for (std::size_t v = 0; v < vertices.size(); ++v)
    (*graph)[v] = std::move(vertices[v]);
  edges_.reserve(edges.size());
  for (Extremal_mesh_edge& edge : edges) {
    edges_.push_back(boost::add_edge(edge.source, edge.target, *graph).first);
    (*graph)[edges_.back()] = std::move(edge);
  }
  graph_ = std::move(graph);
}

void Extremal_mesh::set_provenance(std::string source, std::string parameters, std::string frame) {
  surface_.source = std::move(source);
  surface_.parameters = std::move(parameters);
  surface_.frame = std::move(frame);
}

Dual_graph dual_graph(const Extremal_mesh& mesh) {
  Dual_graph dual(mesh.number_of_cells());
  for (std::uint32_t e = 0; e < mesh.number_of_edges(); ++e)
    boost::add_edge(mesh.edge(e).left_cell, mesh.edge(e).right_cell, Dual_edge{e}, dual);
  return dual;
}

} // namespace CGAL::Extremal_mesh_3
