// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_SIMPLIFICATION_EMBEDDED_GRAPH_H
#define EXTREMAL_MESH_3_SRC_SIMPLIFICATION_EMBEDDED_GRAPH_H

#include "../cells/Union_find.h"
#include "Walks.h"

#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

/// A graph drawn on a surface that can be changed locally: the topology of an extremal mesh (stars and cells), and along
/// which lines of that mesh each edge runs. Every change keeps the surface: V − E + Σ χ(cell) stays what it is.
class Embedded_graph {
public:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  struct Vertex {
    Vertex_kind kind;
    int half_turns; ///< twice the index of the lines of curvature
    int field_index;
    bool alive = true;
    bool frozen = false; ///< its branches contradict its indices: nothing is done to it
    std::uint32_t degree = 0;
    Half_edge first = none; ///< some half-edge of the star
    Point point{};
    double k1 = 0, k2 = 0;
    std::uint32_t next_on_border = none, previous_on_border = none;
    double life_time = 0; ///< the longest of what was merged
  };
  struct Edge {
    int family;
    bool alive = true;
    bool kept = false; ///< (part of) a crest line that must keep its course
    Walks::Walk walk;  ///< from the source of half-edge 2e to its target
    double length, strength;
    double slope;       ///< ∫|∇e_i·t_i| ds
    double extremality; ///< ∫|e_j| ds of the other family
    double difference;  ///< the same, but what was cancelled does not count: see Simplifier
    double split;       ///< the greatest k1 − k2
    double life_time;   ///< the longest of its pieces
  };
  struct Cell {
    int sign, euler_characteristic;
    bool touches_border;
    double area, weight;
    std::uint32_t sides = 0;    ///< half-edges with it on their left
    Half_edge exclusive_or = 0; ///< of them all: the only one, if there is one
    bool is_disk_with_one_side() const { return sides == 1 && euler_characteristic == 1; }
  };

  explicit Embedded_graph(const Extremal_mesh& mesh);

  const std::vector<Vertex>& vertices() const { return vertices_; }
  const std::vector<Edge>& edges() const { return edges_; }
  /// makes an edge keep its course.
  void keep(std::uint32_t edge) { edges_[edge].kept = true; }
  const Walks& walks() const { return walks_; }
  std::size_t number_of_vertices() const { return alive_vertices_; }
  std::size_t number_of_edges() const { return alive_edges_; }
  std::size_t number_of_cells() const { return alive_cells_; }

  std::uint32_t source(Half_edge h) const { return source_[h]; }
  std::uint32_t target(Half_edge h) const { return source_[h ^ 1U]; }
  Half_edge next(Half_edge h) const { return next_[h]; }         ///< counter-clockwise around the source
  Half_edge previous(Half_edge h) const { return previous_[h]; } ///< clockwise
  int family(Half_edge h) const { return edges_[h / 2].family; }
  std::uint32_t left_cell(Half_edge h) const { return cells_of_.find(cell_[h]); }
  const Cell& cell(std::uint32_t root) const { return cells_[root]; }
  std::uint32_t root(std::uint32_t cell) const { return cells_of_.find(cell); }
  /// the half-edges that leave a vertex, counter-clockwise.
  std::vector<Half_edge> star(std::uint32_t v) const;
  /// the walk of a half-edge.
  Walks::Walk walk(Half_edge h) const { return edges_[h / 2].walk ^ (h % 2); }
  /// the half-edges that have a cell on their left, in no order.
  std::vector<Half_edge> sides(std::uint32_t root) const;
  /// for each cell of the mesh, the cell it is part of now, numbered 0, 1, ….
  std::vector<std::uint32_t> numbered_cells() const;

  /// \name Changes
  /// @{
  /// takes the target of `h` into its source, which gets the sum of the indices. The branches of the target are led
  /// along h.
  /// \pre the ends of h differ
  void contract(Half_edge h);
  /// makes one line of the branches `a` and `b = next(a)` of a vertex, which passes it by on the side of the cell between
  /// them. The cells on the two other sides are joined. A loop becomes a closed line with an anchor.
  /// \param difference  of the line, unless it is a loop
  /// \return the half-edge along a backwards, then b
  Half_edge detach(Half_edge a, Half_edge b, double difference);
  /// removes the loop `h`, whose left cell is a disk without other sides.
  void remove_loop(Half_edge h);
  /// makes a vertex an extremal point or an umbilic, as its indices say.
  void become_generic(std::uint32_t v) {
    vertices_[v].kind = vertices_[v].half_turns == 0 ? Vertex_kind::extremal_point : Vertex_kind::umbilic;
  }
  /// makes one line of the two branches of a vertex that is no more. If they are one loop, it becomes an anchor.
  void dissolve(std::uint32_t v, double difference);
  /// removes a closed line with its anchor; the cell on the left of `h`, a disk, becomes part of that on its right.
  void drop_closed_line(Half_edge h);
  /// removes vertices with all their edges, which together with the cells `inner` make up a disk in the cell `outer`.
  void remove_disk(const std::vector<std::uint32_t>& vertices, const std::vector<std::uint32_t>& edges,
                   const std::vector<std::uint32_t>& inner, std::uint32_t outer);
  /// removes a line from border to border with both its ends; the cell on the left becomes part of that on the right.
  void drop_border_line(Half_edge h);
  /// @}

private:
  void remove_from_star(Half_edge h);
  void replace_in_star(Half_edge old, Half_edge h);
  void add_side(Half_edge h, std::uint32_t cell);
  void remove_side(Half_edge h);
  void kill_edge(std::uint32_t e);
  void kill_vertex(std::uint32_t v);
  void merge_cells(std::uint32_t kept, std::uint32_t other, int euler_characteristic);
  Half_edge add_edge(Half_edge a, Half_edge b, double difference);
  void unlink_from_border(std::uint32_t v);

  std::vector<Vertex> vertices_;
  std::vector<Edge> edges_;
  std::vector<Cell> cells_;                   ///< valid at the roots of `cells_of_`
  std::vector<std::vector<Half_edge>> sides_; ///< of each root, with some that are no more
  mutable Union_find cells_of_;
  std::vector<std::uint32_t> source_, cell_;
  std::vector<Half_edge> next_, previous_;
  Walks walks_;
  std::size_t alive_vertices_ = 0, alive_edges_ = 0, alive_cells_ = 0;
};

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_SIMPLIFICATION_EMBEDDED_GRAPH_H
