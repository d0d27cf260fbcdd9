// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_EXTREMAL_MESH_H
#define CGAL_EXTREMAL_MESH_3_EXTREMAL_MESH_H

#include <CGAL/Extremal_mesh_3/types.h>

#include <boost/graph/adjacency_list.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

/// What a vertex of the extremal mesh is.
enum class Vertex_kind : std::uint8_t {
  extremal_point, ///< e1 = e2 = 0: four branches, families 1, 2, 1, 2
  umbilic,        ///< k1 = k2: two (1-ridge) or six (3-ridge) branches
  non_generic,    ///< anything else in which lines meet
  boundary,       ///< a line ends on the border of the surface; the only kind that may have odd degree
  anchor          ///< one on each closed line that has no vertex of its own; degree 2
};

/// The pattern of lines of curvature around a generic umbilic.
enum class Umbilic_type : std::uint8_t { none, lemon, monstar, star };

/// The type of a piece of an extremal line [Thirion 1993, 2.5]: is |k_i| locally maximal or minimal along its own line
/// of curvature, and is it the larger or the smaller of |k1| and |k2|. `max_largest` lines are the crest lines.
enum class Line_type : std::uint8_t { max_largest, min_largest, max_second, min_second };

/// What makes the type of a line change at one of its points.
enum class Type_change_kind : std::uint8_t {
  turning_point,    ///< ∇e_i·t_i = 0: maxima become minima
  equal_curvatures, ///< |k1| = |k2|, the mean curvature is 0: the largest curvature becomes the second
  parabolic_point,  ///< k_i = 0: maxima of |k_i| become minima
  former_vertex     ///< a vertex was here before the mesh was simplified
};

std::string_view to_string(Vertex_kind);
std::string_view to_string(Umbilic_type);
std::string_view to_string(Line_type);
std::string_view to_string(Type_change_kind);

/// A point of an edge at which the type of the line changes.
struct Type_change {
  std::uint32_t point = 0; ///< its index in the polyline
  Type_change_kind kind = Type_change_kind::turning_point;
  bool operator==(const Type_change&) const = default;
};

/// Half-edge `2e` runs along edge `e` from its source to its target, half-edge `2e+1` runs back.
using Half_edge = std::uint32_t;

/// A vertex of the extremal mesh.
struct Extremal_mesh_vertex {
  Vertex_kind kind = Vertex_kind::non_generic;
  Point point{};
  Vector normal{};          ///< unit
  double k1 = 0, k2 = 0;    ///< principal curvatures with respect to `normal`, k1 ≥ k2, in 1/length
  Vector t1{}, t2{};        ///< principal directions, (t1, t2, normal) direct; any such frame at an umbilic
  double umbilic_index = 0; ///< index of the line field of curvature: a multiple of ½, 0 but at umbilics
  int field_index = 0;      ///< index of the vector field V = R (e1 t1 − e2 t2) (0 at anchors and boundary vertices)
  Umbilic_type umbilic_type = Umbilic_type::none;
  int ridges = 0; ///< lines through an umbilic: 1 or 3; 0 for other kinds
  /// the type of the lines of family 1 and of family 2 that cross at an extremal point
  std::array<Line_type, 2> extrema{};
  /// the outgoing half-edges, counter-clockwise seen from the side of the normal
  std::vector<Half_edge> star;
  /// ln(last σ / first σ) at which it is found, no unit; nothing if other scales were not looked at: see scale_space.h
  std::optional<double> life_time;
};

/// An extremal line between two vertices (an edge of the extremal mesh).
struct Extremal_mesh_edge {
  std::uint32_t id = 0;
  std::uint32_t source = 0, target = 0; ///< the ends of half-edge 2·id
  int family = 1;                       ///< e_family = 0 along the edge
  std::vector<Point> polyline;          ///< on the surface, from source to target, both included
  std::vector<Vector> normals;          ///< of the surface at the polyline's points, unit
  std::vector<double> k1, k2;           ///< principal curvatures at the polyline's points
  /// |e_j| ≥ 0 of the other family j = 3 − family at the polyline's points, in 1/length²: 0 at extremal points; at
  /// umbilics, where it has no limit, that of the point beside
  std::vector<double> extremality;
  std::vector<Line_type> segment_types; ///< one per segment of the polyline
  /// where they change, in the order of the points: nowhere else but at vertices. There ∇e_i·t_i, k1 + k2 or k_i is 0, but
  /// for points of cells that stayed unresolved. Empty, too, in files of a version that did not tell
  std::vector<Type_change> type_changes;
  Line_type type = Line_type::max_largest; ///< the type of the greatest part of the length
  double length = 0;
  double strength = 0;                         ///< ∫|k_family| ds, no unit
  double sharpness = 0;                        ///< area of the surface × ∫|∇e_family·t_family| ds, no unit
  std::uint32_t left_cell = 0, right_cell = 0; ///< walking from source to target with the normal upwards
  std::optional<double> life_time;             ///< as that of a vertex
};

/// A cell of the extremal mesh: a component of the surface minus the lines, in which E_g keeps its sign.
struct Extremal_mesh_cell {
  int sign = 1; ///< of E_g
  double area = 0;
  double weight = 0;            ///< ∫√|E_g| dA, no unit
  int euler_characteristic = 1; ///< of the open cell, the border of the surface excluded
  bool touches_border = false;  ///< the cell has a part of the border of the surface in its boundary
  /// the closed walks of half-edges with the cell on their left. A walk that reaches a boundary vertex goes on along
  /// the border of the surface to the next one.
  std::vector<std::vector<Half_edge>> boundary;
};

/// An edge of the dual graph: the two cells on the sides of `edge`.
struct Dual_edge {
  std::uint32_t edge = 0;
};
using Dual_graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, boost::no_property, Dual_edge>;

/// What is known of the surface on which an extremal mesh was drawn.
struct Surface_info {
  std::int64_t euler_characteristic = 0;
  bool closed = true; ///< no border
  std::size_t components = 0;
  double area = 0;
  double degenerate_area = 0; ///< where E_g = 0 up to rounding and the lines mean nothing
  std::string source;         ///< the formula or the file
  std::string parameters;     ///< how the mesh was made, as one JSON object
  std::string frame;          ///< "LPS" for images in mm; empty: the input's own axes
};

/// The extremal mesh of a surface: a graph drawn on it, with its cells. [Thirion 1993]
///
/// `graph()` is an undirected Boost.Graph (multi-edges and self-loops occur) whose vertex descriptors are 0, 1, …,
/// whose bundled properties are `Extremal_mesh_vertex` and `Extremal_mesh_edge`, and whose edges are iterated in the
/// order of their ids. Copies share the graph; a mesh that was moved from can only be assigned to or destroyed.
class Extremal_mesh {
public:
  using Graph =
      boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, Extremal_mesh_vertex, Extremal_mesh_edge>;
  using vertex_descriptor = boost::graph_traits<Graph>::vertex_descriptor;
  using edge_descriptor = boost::graph_traits<Graph>::edge_descriptor;

  Extremal_mesh() : graph_(std::make_shared<const Graph>()) {}
  /// \throws std::invalid_argument naming the element if an id, end, cell, star or boundary walk names one that does
  ///         not exist, or the arrays of an edge do not fit together
  Extremal_mesh(std::vector<Extremal_mesh_vertex> vertices, std::vector<Extremal_mesh_edge> edges,
                std::vector<Extremal_mesh_cell> cells, Surface_info surface);

  const Graph& graph() const { return *graph_; }
  std::size_t number_of_vertices() const { return boost::num_vertices(*graph_); }
  std::size_t number_of_edges() const { return edges_.size(); }
  std::size_t number_of_cells() const { return cells_.size(); }

  const Extremal_mesh_vertex& vertex(std::size_t v) const { return (*graph_)[v]; }
  const Extremal_mesh_edge& edge(std::size_t e) const { return (*graph_)[edges_[e]]; }
  edge_descriptor edge_descriptor_of(std::size_t e) const { return edges_[e]; }
  const Extremal_mesh_cell& cell(std::size_t c) const { return cells_[c]; }
  const std::vector<Extremal_mesh_cell>& cells() const { return cells_; }
  const Surface_info& surface() const { return surface_; }

  std::uint32_t source(Half_edge h) const { return h % 2 == 0 ? edge(h / 2).source : edge(h / 2).target; }
  std::uint32_t target(Half_edge h) const { return source(h ^ 1U); }
  /// the cell on the left of a half-edge.
  std::uint32_t left_cell(Half_edge h) const { return h % 2 == 0 ? edge(h / 2).left_cell : edge(h / 2).right_cell; }

  /// records where the mesh comes from (`source`, `parameters`, `frame` of `surface()`).
  void set_provenance(std::string source, std::string parameters, std::string frame);

private:
  // Edge descriptors point into the graph, and a Boost 1.74 adjacency_list has no move constructor: copies and moved
  // meshes share the graph, which never changes, so that their descriptors stay good.
  std::shared_ptr<const Graph> graph_;
  std::vector<edge_descriptor> edges_;
  std::vector<Extremal_mesh_cell> cells_;
  Surface_info surface_;
};

/// makes the dual graph: one vertex per cell, one edge per edge of the mesh. It is bipartite by the sign of E_g.
Dual_graph dual_graph(const Extremal_mesh& mesh);

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_EXTREMAL_MESH_H
