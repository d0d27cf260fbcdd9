// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_SIMPLIFICATION_SIMPLIFIER_H
#define EXTREMAL_MESH_3_SRC_SIMPLIFICATION_SIMPLIFIER_H

#include "Embedded_graph.h"

#include <CGAL/Extremal_mesh_3/simplify.h>

#include <vector>

namespace CGAL::Extremal_mesh_3 {

/// A step that could be done.
///
/// The branches of a generic vertex are the word of families 1212… of length 4·|umbilic index − field index|, because Φ winds so
/// often around it. Taking an edge's ends together adds their indices; two neighbouring branches of one family can
/// then be detached as one line until as many are left as the sum of the indices wants.
struct Candidate {
  Simplification_operation operation{};
  double cost = 0;       ///< what decides which comes first: the difference, or a life time
  double difference = 0; ///< of curvatures, in 1/length: decides between equal costs
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

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_SIMPLIFICATION_SIMPLIFIER_H
