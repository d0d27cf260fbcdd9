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
enum class Umbilic_type : std::uint8_t {
  none,    ///< not generic, or no umbilic
  lemon,   ///< index ½, one line of curvature of each family ends there
  monstar, ///< index ½, lines of curvature leave in three directions
  star     ///< index −½
};

/// The type of a piece of an extremal line [Thirion 1993, 2.5]: is |k_i| locally maximal or minimal along its own line
/// of curvature, and is it the larger or the smaller of |k1| and |k2|. `max_largest` lines are the crest lines.
enum class Line_type : std::uint8_t {
  max_largest, ///< a maximum of the larger |k_i|: a crest line
  min_largest, ///< a minimum of the larger |k_i|
  max_second,  ///< a maximum of the smaller |k_i|
  min_second   ///< a minimum of the smaller |k_i|
};

/// What makes the type of a line change at one of its points.
enum class Type_change_kind : std::uint8_t {
  turning_point,    ///< ∇e_i·t_i = 0: maxima become minima
  equal_curvatures, ///< |k1| = |k2|, the mean curvature is 0: the largest curvature becomes the second
  parabolic_point,  ///< k_i = 0: maxima of |k_i| become minima
  former_vertex     ///< a vertex was here before the mesh was simplified
};

/// \param kind  one of them
/// \return its name, as in files
std::string_view to_string(Vertex_kind kind);
/// \param type  one of them
/// \return its name, as in files
std::string_view to_string(Umbilic_type type);
/// \param type  one of them
/// \return its name, as in files
std::string_view to_string(Line_type type);
/// \param kind  one of them
/// \return its name, as in files
std::string_view to_string(Type_change_kind kind);

/// A point of an edge at which the type of the line changes.
struct Type_change {
  std::uint32_t point = 0;                                 ///< its index in the polyline
  Type_change_kind kind = Type_change_kind::turning_point; ///< what makes it change
  /// \return whether both are equal
  bool operator==(const Type_change&) const = default;
};

/// Half-edge `2e` runs along edge `e` from its source to its target, half-edge `2e+1` runs back.
using Half_edge = std::uint32_t;

/// A vertex of the extremal mesh.
struct Extremal_mesh_vertex {
  Vertex_kind kind = Vertex_kind::non_generic; ///< what it is
  Point point{};                               ///< on the surface
  Vector normal{};                             ///< unit
  double k1 = 0;                               ///< the larger principal curvature with respect to `normal`, in 1/length
  double k2 = 0;                               ///< the smaller one
  Vector t1{};                                 ///< principal direction of k1, unit; any tangent at an umbilic
  Vector t2{};                                 ///< principal direction of k2; (t1, t2, normal) is direct
  double umbilic_index = 0; ///< index of the line field of curvature: a multiple of ½, 0 but at umbilics
  int field_index = 0;      ///< index of the vector field V = R (e1 t1 − e2 t2) (0 at anchors and boundary vertices)
  Umbilic_type umbilic_type = Umbilic_type::none; ///< of umbilics
  int ridges = 0;                                 ///< lines through an umbilic: 1 or 3; 0 for other kinds
  /// the type of the lines of family 1 and of family 2 that cross at an extremal point
  std::array<Line_type, 2> extrema{};
  /// the outgoing half-edges, counter-clockwise seen from the side of the normal
  std::vector<Half_edge> star;
  /// ln(last σ / first σ) at which it is found, no unit; nothing if other scales were not looked at: see scale_space.h
  std::optional<double> life_time;
};

/// An extremal line between two vertices (an edge of the extremal mesh).
struct Extremal_mesh_edge {
  std::uint32_t id = 0;        ///< its number, from 0
  std::uint32_t source = 0;    ///< the vertex where half-edge 2·id begins
  std::uint32_t target = 0;    ///< the vertex where it ends
  int family = 1;              ///< e_family = 0 along the edge
  std::vector<Point> polyline; ///< on the surface, from source to target, both included
  std::vector<Vector> normals; ///< of the surface at the polyline's points, unit
  std::vector<double> k1;      ///< larger principal curvature at the polyline's points
  std::vector<double> k2;      ///< smaller principal curvature at the polyline's points
  /// |e_j| ≥ 0 of the other family j = 3 − family at the polyline's points, in 1/length²: 0 at extremal points; at
  /// umbilics, where it has no limit, that of the point beside
  std::vector<double> extremality;
  std::vector<Line_type> segment_types; ///< one per segment of the polyline
  /// where they change, in the order of the points: nowhere else but at vertices. There ∇e_i·t_i, k1 + k2 or k_i is 0, but
  /// for points of cells that stayed unresolved. Empty, too, in files of a version that did not tell
  std::vector<Type_change> type_changes;
  Line_type type = Line_type::max_largest; ///< the type of the greatest part of the length
  double length = 0;                       ///< of the polyline
  double strength = 0;                     ///< ∫|k_family| ds, no unit
  double sharpness = 0;                    ///< area of the surface × ∫|∇e_family·t_family| ds, no unit
  std::uint32_t left_cell = 0;             ///< walking from source to target with the normal upwards
  std::uint32_t right_cell = 0;            ///< the cell on the other side
  std::optional<double> life_time;         ///< as that of a vertex
};

/// A cell of the extremal mesh: a component of the surface minus the lines, in which E_g keeps its sign.
struct Extremal_mesh_cell {
  int sign = 1;                 ///< of E_g
  double area = 0;              ///< in the square of the input's unit of length
  double weight = 0;            ///< ∫√|E_g| dA, no unit
  int euler_characteristic = 1; ///< of the open cell, the border of the surface excluded
  bool touches_border = false;  ///< the cell has a part of the border of the surface in its boundary
  /// the closed walks of half-edges with the cell on their left. A walk that reaches a boundary vertex goes on along
  /// the border of the surface to the next one.
  std::vector<std::vector<Half_edge>> boundary;
};

/// An edge of the dual graph: the two cells on the sides of `edge`.
struct Dual_edge {
  std::uint32_t edge = 0; ///< its number in the extremal mesh
};
/// A graph with a vertex per cell and an edge per edge of an extremal mesh.
using Dual_graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, boost::no_property, Dual_edge>;

/// What is known of the surface on which an extremal mesh was drawn.
struct Surface_info {
  std::int64_t euler_characteristic = 0; ///< of all components together
  bool closed = true;                    ///< no border
  std::size_t components = 0;            ///< connected ones
  double area = 0;                       ///< in the square of the input's unit of length
  double degenerate_area = 0;            ///< where E_g = 0 up to rounding and the lines mean nothing
  std::string source;                    ///< the formula or the file
  std::string parameters;                ///< how the mesh was made, as one JSON object
  std::string frame;                     ///< "LPS" for images in mm; empty: the input's own axes
};

/// The extremal mesh of a surface: a graph drawn on it, with its cells. [Thirion 1993]
///
/// `graph()` is an undirected Boost.Graph (multi-edges and self-loops occur) whose vertex descriptors are 0, 1, …,
/// whose bundled properties are `Extremal_mesh_vertex` and `Extremal_mesh_edge`, and whose edges are iterated in the
/// order of their ids. Copies share the graph; a mesh that was moved from can only be assigned to or destroyed.
class Extremal_mesh {
public:
  /// The graph, a model of Boost's concepts of graphs.
  using Graph =
      boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, Extremal_mesh_vertex, Extremal_mesh_edge>;
  using vertex_descriptor = boost::graph_traits<Graph>::vertex_descriptor; ///< 0, 1, …
  using edge_descriptor = boost::graph_traits<Graph>::edge_descriptor;     ///< see `edge_descriptor_of()`

  /// makes the mesh without anything.
  Extremal_mesh() : graph_(std::make_shared<const Graph>()) {}
  /// makes a mesh of its parts.
  /// \param vertices  with their stars
  /// \param edges  in the order of their ids
  /// \param cells  with their boundary walks
  /// \param surface  what is known of the surface
  /// \throws std::invalid_argument naming the element if an id, end, cell, star or boundary walk names one that does
  ///         not exist, or the arrays of an edge do not fit together
  Extremal_mesh(std::vector<Extremal_mesh_vertex> vertices, std::vector<Extremal_mesh_edge> edges,
                std::vector<Extremal_mesh_cell> cells, Surface_info surface);

  /// \return the graph
  const Graph& graph() const { return *graph_; }
  /// \return how many vertices there are
  std::size_t number_of_vertices() const { return boost::num_vertices(*graph_); }
  /// \return how many edges there are
  std::size_t number_of_edges() const { return edges_.size(); }
  /// \return how many cells there are
  std::size_t number_of_cells() const { return cells_.size(); }

  /// \param v  below `number_of_vertices()`
  /// \return the vertex
  const Extremal_mesh_vertex& vertex(std::size_t v) const { return (*graph_)[v]; }
  /// \param e  below `number_of_edges()`
  /// \return the edge
  const Extremal_mesh_edge& edge(std::size_t e) const { return (*graph_)[edges_[e]]; }
  /// \param e  below `number_of_edges()`
  /// \return what the graph knows the edge by
  edge_descriptor edge_descriptor_of(std::size_t e) const { return edges_[e]; }
  /// \param c  below `number_of_cells()`
  /// \return the cell
  const Extremal_mesh_cell& cell(std::size_t c) const { return cells_[c]; }
  /// \return all cells
  const std::vector<Extremal_mesh_cell>& cells() const { return cells_; }
  /// \return what is known of the surface
  const Surface_info& surface() const { return surface_; }

  /// \param h  a half-edge
  /// \return the vertex where it begins
  std::uint32_t source(Half_edge h) const { return h % 2 == 0 ? edge(h / 2).source : edge(h / 2).target; }
  /// \param h  a half-edge
  /// \return the vertex where it ends
  std::uint32_t target(Half_edge h) const { return source(h ^ 1U); }
  /// \param h  a half-edge
  /// \return the cell on its left
  std::uint32_t left_cell(Half_edge h) const { return h % 2 == 0 ? edge(h / 2).left_cell : edge(h / 2).right_cell; }

  /// records where the mesh comes from (`source`, `parameters`, `frame` of `surface()`).
  /// \param source  the formula or the file
  /// \param parameters  a JSON object
  /// \param frame  `LPS`, or empty
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
/// \param mesh  an extremal mesh
/// \return the dual graph, whose vertices are numbered as the cells
Dual_graph dual_graph(const Extremal_mesh& mesh);

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_EXTREMAL_MESH_H
