// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_EXTRACTION_PLAIN_CELL_H
#define EXTREMAL_MESH_3_SRC_EXTRACTION_PLAIN_CELL_H

#include "Refined_complex.h"

#include <optional>

namespace CGAL::Extremal_mesh_3 {

/// tells of cells in which the phase of Φ is so nearly linear that no model of them is needed: no line, or one, passes through.
/// \return the number of crossings of the border, 0 or 2; nothing if the cell is to be analysed
std::optional<int> crossings_of_plain_cell(const Refined_complex& complex, const Refined_cell& cell);

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_EXTRACTION_PLAIN_CELL_H
