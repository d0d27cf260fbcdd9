// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_SIMPLIFICATION_INDICES_H
#define EXTREMAL_MESH_3_SRC_SIMPLIFICATION_INDICES_H

#include "Embedded_graph.h"

#include <cstdlib>

namespace CGAL::Extremal_mesh_3 {

/// The two indices of a vertex, which add up when vertices are taken together.
struct Indices {
  int half_turns = 0; ///< twice the index of the lines of curvature
  int field = 0;      ///< of V = R (e1 t1 − e2 t2)

  friend Indices operator+(const Indices& a, const Indices& b) {
    return {a.half_turns + b.half_turns, a.field + b.field};
  }
  friend bool operator==(const Indices&, const Indices&) = default;

  /// the least number of branches: Φ = P² Q winds half as often around the vertex.
  std::uint32_t number_of_branches() const { return std::uint32_t(std::abs(2 * half_turns - 4 * field)); }
  /// nothing, an extremal point, or a generic umbilic: one of index ½ has the field index 1, one of index −½ has ±1.
  bool is_empty_or_generic() const {
    return half_turns == 0   ? std::abs(field) <= 1
           : half_turns == 1 ? field == 1
                             : half_turns == -1 && std::abs(field) == 1;
  }
};

inline Indices indices(const Embedded_graph::Vertex& v) {
  return {v.half_turns, v.field_index};
}

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_SIMPLIFICATION_INDICES_H
