// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_EXTRACTION_JOIN_PAIRS_H
#define EXTREMAL_MESH_3_SRC_EXTRACTION_JOIN_PAIRS_H

#include "analyse_cell.h"

#include <vector>

namespace CGAL::Extremal_mesh_3 {

/// finds the crossings that a cell without zeros would have joined in pairs: neighbours at the same level of the phase, once
/// rising, once falling.
/// \param joined  where there are four of one level: the sign of E_g on the side of their lines that is connected
/// \param partner  for each crossing its partner, or −1 if it is left over
void join_pairs(const Border_crossings& met, int joined, std::vector<int>& partner);

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_EXTRACTION_JOIN_PAIRS_H
