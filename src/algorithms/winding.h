// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_ALGORITHMS_WINDING_H
#define EXTREMAL_MESH_3_SRC_ALGORITHMS_WINDING_H

#include <CGAL/Extremal_mesh_3/Extremal_mesh.h>

namespace CGAL::Extremal_mesh_3 {

/// the half turns of Φ = P²Q around a vertex, by its lines and cells: 4·(umbilic index − field index) if all is right.
/// Im Φ has the sign of E_g, and on the lines Re Φ < 0 where e1 = 0, Re Φ > 0 where e2 = 0: each branch that a small
/// circle crosses tells in which direction Φ goes through the real axis, by half a turn.
inline int half_turns_of_phi(const Extremal_mesh& mesh, const Extremal_mesh_vertex& v) {
  int half_turns = 0;
  for (const Half_edge h : v.star) {
    const int before = mesh.cell(mesh.left_cell(h ^ 1U)).sign, after = mesh.cell(mesh.left_cell(h)).sign;
    half_turns += (mesh.edge(h / 2).family == 2 ? after - before : before - after) / 2;
  }
  return half_turns;
}

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_ALGORITHMS_WINDING_H
