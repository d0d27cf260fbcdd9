// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_SIMPLIFICATION_WALKS_H
#define EXTREMAL_MESH_3_SRC_SIMPLIFICATION_WALKS_H

#include <CGAL/Extremal_mesh_3/Extremal_mesh.h>

#include <cstdint>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

/// Walks along half-edges of an extremal mesh that can be joined in constant time: they share their parts, as the
/// nodes of binary trees. The number of a walk names its direction, too: `w ^ 1` is `w` walked backwards.
class Walks {
public:
  using Walk = std::uint32_t;

  /// \param edges  so many; walk h, for a half-edge h, is that half-edge
  explicit Walks(std::size_t edges) : edges_(edges) {}

  /// `first`, then `second`, which starts where `first` ends. O(1).
  Walk join(Walk first, Walk second) {
    parts_.push_back({first, second});
    return Walk(2 * (edges_ + parts_.size() - 1));
  }

  /// the half-edges of a walk in order. Where it turns back, what it goes to and fro is left out, but for its last
  /// half-edge.
  std::vector<Half_edge> half_edges(Walk walk) const {
    std::vector<Half_edge> result;
    std::vector<Walk> left_to_do = {walk};
    while (!left_to_do.empty()) {
      const Walk w = left_to_do.back();
      left_to_do.pop_back();
      if (w / 2 >= edges_) {
        const Parts& p = parts_[w / 2 - edges_];
        left_to_do.push_back(w % 2 == 0 ? p.second : p.first ^ 1U);
        left_to_do.push_back(w % 2 == 0 ? p.first : p.second ^ 1U);
      } else if (!result.empty() && result.back() == (w ^ 1U) && (result.size() > 1 || !left_to_do.empty())) {
        result.pop_back();
      } else {
        result.push_back(w);
      }
    }
    return result;
  }

private:
  struct Parts {
    Walk first, second;
  };
  std::size_t edges_;
  std::vector<Parts> parts_;
};

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_SIMPLIFICATION_WALKS_H
