// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_EXTRACTION_CUTS_BETWEEN_BRANCHES_H
#define EXTREMAL_MESH_3_SRC_EXTRACTION_CUTS_BETWEEN_BRANCHES_H

#include "../differential/umbilic_lines.h"
#include "Refined_complex.h"

#include <vector>

namespace CGAL::Extremal_mesh_3 {

/// An umbilic and the fields around it, P and Q taken as linear in the tangent plane.
struct Umbilic_star {
  Point p{};
  Vector u{}, v{};
  Linear_field P, Q;
};

/// Where the border of a cell with a 3-ridge umbilic is to be cut so that between any two neighbouring branches there
/// is a sample. Two branches can leave in nearly the same direction; they then cross the same edge of a cell of any
/// size, and their crossings, a pair, are not seen.
/// \param most_edge_level  edges of this level are not cut
/// \return nothing if all branches are told apart already
std::vector<Edge_cut> cuts_between_branches(const Refined_complex& complex, const std::vector<Half_edge>& border,
                                            const Umbilic_star& star, int most_edge_level);

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_EXTRACTION_CUTS_BETWEEN_BRANCHES_H
