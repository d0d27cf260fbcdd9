// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_SIMPLIFICATION_SIMPLIFIER_H
#define EXTREMAL_MESH_3_SRC_SIMPLIFICATION_SIMPLIFIER_H

#include "Embedded_graph.h"

#include <CGAL/Extremal_mesh_3/simplify.h>

#include <optional>
#include <queue>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

/// A step that could be done.
///
/// The branches of a generic vertex are the word of families 1212… of length 4·|umbilic index − field index|, because Φ winds so
/// often around it. Taking an edge's ends together adds their indices; two neighbouring branches of one family can
/// then be detached as one line until as many are left as the sum of the indices wants.
struct Candidate {
  Simplification_operation operation{};
  double cost = 0; ///< a difference of curvatures, in 1/length
  /// the edges that are contracted into the source of `first` (`second` none but when three vertices are merged); or
  /// the line that is dropped, with what vanishes on its left; or a half-edge of either island
  Half_edge first = Embedded_graph::none, second = Embedded_graph::none;
};

/// Does simplification steps on a graph.
class Simplifier {
public:
  explicit Simplifier(Embedded_graph graph) : graph_(std::move(graph)) {}

  /// does a step.
  /// \pre it is possible
  void apply(const Candidate& step);
  const Embedded_graph& graph() const { return graph_; }

  /// the vertices around which the last steps changed something; to be cleared by the caller.
  std::vector<std::uint32_t> touched;
  /// which cells became part of which.
  std::vector<std::pair<std::uint32_t, std::uint32_t>>& merged_cells() { return graph_.merged_cells; }

private:
  /// how k_j changes along the line that two branches become.
  struct Contracted {
    int family = 0;        ///< of the edge between two extremal points; 0 if it was something else
    bool umbilics = false; ///< the edge joined two umbilics
    double difference = 0;
  };
  void reduce(std::uint32_t v, const Contracted& contracted);
  double difference(Half_edge a, Half_edge b, const Contracted& contracted) const;
  void cancel_islands(const Candidate& step);
  void touch_ends_of_star(std::uint32_t v);
  void touch_sides(std::uint32_t cell);

  Embedded_graph graph_;
};

/// Finds the steps of a simplification, the cheapest first.
class Step_finder {
public:
  /// \param graph  outlives it
  explicit Step_finder(const Embedded_graph& graph);

  /// the cheapest step that is possible now; none if there is none.
  std::optional<Candidate> next();
  /// to be told of every vertex around which something has changed.
  void look_around(std::uint32_t vertex);
  /// to be told of every cell that has become part of another one.
  void merge_islands(std::uint32_t absorbed, std::uint32_t root);

private:
  struct Dearer {
    bool operator()(const Candidate& a, const Candidate& b) const;
  };

  void push(const std::optional<Candidate>& candidate);
  std::optional<Candidate> pair(Half_edge h) const;
  std::optional<Candidate> triple(Half_edge first, Half_edge second) const;
  std::optional<Candidate> drop(Half_edge h) const;
  std::optional<Candidate> islands(std::uint32_t a, std::uint32_t b) const;
  void look_for_island(std::uint32_t vertex, bool around);
  std::optional<Candidate> evaluate(const Candidate& candidate) const;
  double cost_of(std::uint32_t edge) const;
  bool all_free(std::uint32_t vertex) const;

  const Embedded_graph& graph_;
  std::vector<std::vector<std::uint32_t>> islands_; ///< in each cell: the first vertices of those it is the outer cell of
  std::priority_queue<Candidate, std::vector<Candidate>, Dearer> queue_;
};

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_SIMPLIFICATION_SIMPLIFIER_H
