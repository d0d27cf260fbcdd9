// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_EXTRACTION_HALVE_CELL_H
#define EXTREMAL_MESH_3_SRC_EXTRACTION_HALVE_CELL_H

#include "Flat_cell.h"

#include <optional>

namespace CGAL::Extremal_mesh_3 {

/// the two sides of a cell whose middles are to be joined to divide it in halves, if the shape bends far less within each of them than
/// within the cell, as where they lie along a crease.
/// \return nothing if the cell is better divided into quarters
std::optional<Side_pair> halving_of(const Refined_complex& complex, const Refined_cell& cell, const Sample& middle,
                                    const Flat_cell& flat);

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_EXTRACTION_HALVE_CELL_H
