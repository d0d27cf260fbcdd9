// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_SIMPLIFICATION_STEP_FINDER_H
#define EXTREMAL_MESH_3_SRC_SIMPLIFICATION_STEP_FINDER_H

#include "Simplifier.h"
#include "islands.h"

#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>

#include <optional>
#include <queue>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

/// Finds the steps of a simplification, the cheapest first.
class Step_finder {
public:
  /// \param graph  outlives it
  Step_finder(const Embedded_graph& graph, Simplification_measure measure);

  /// the cheapest step that is possible now; none if there is none.
  std::optional<Candidate> next();
  /// to be told of every vertex around which something has changed.
  void look_around(std::uint32_t vertex);

  using Tree_point = boost::geometry::model::point<double, 3, boost::geometry::cs::cartesian>;

private:
  using Tree_value = std::pair<Tree_point, std::uint32_t>;
  using Tree = boost::geometry::index::rtree<Tree_value, boost::geometry::index::quadratic<16>>;
  struct Dearer {
    bool operator()(const Candidate& a, const Candidate& b) const;
  };

  void push(const std::optional<Candidate>& candidate);
  std::optional<Candidate> pair(Half_edge h) const;
  std::optional<Candidate> triple(Half_edge first, Half_edge second) const;
  std::optional<Candidate> drop(Half_edge h) const;
  std::optional<Candidate> islands(std::uint32_t a, std::uint32_t b) const;
  void look_for_island(std::uint32_t vertex, bool around);
  std::optional<Candidate> nearest_partner(std::uint32_t vertex) const;
  Point centre(const Island& island) const;
  std::optional<Candidate> evaluate(const Candidate& candidate) const;
  double difference_along(std::uint32_t edge) const;
  /// a step by the measure, if what vanishes lives so long.
  Candidate priced(Candidate step, double life_time) const;
  double life_time(std::uint32_t vertex) const { return graph_.vertices()[vertex].life_time; }
  bool all_free(std::uint32_t vertex) const;

  const Embedded_graph& graph_;
  Simplification_measure measure_;
  std::vector<std::uint32_t> component_;         ///< of the surface, of each cell
  std::unordered_set<std::uint32_t> registered_; ///< the first vertices of the islands in the trees
  Tree bumps_, saddles_;                         ///< the centres of islands, some of which are no more
  std::priority_queue<Candidate, std::vector<Candidate>, Dearer> queue_;
};

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_SIMPLIFICATION_STEP_FINDER_H
