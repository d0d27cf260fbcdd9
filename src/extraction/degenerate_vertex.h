// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a surface shows where it is symmetric: umbilics of higher degree, on axes of four-fold and higher symmetry, and
// crossings of lines of one family, on mirror planes. Dividing cells never ends there, so such a point is located and
// recognised as what it is.
#ifndef EXTREMAL_MESH_3_SRC_EXTRACTION_DEGENERATE_VERTEX_H
#define EXTREMAL_MESH_3_SRC_EXTRACTION_DEGENERATE_VERTEX_H

#include "Flat_cell.h"
#include "analyse_cell.h"

#include <optional>

namespace CGAL::Extremal_mesh_3 {

/// So far from the border, in radii of the cell, such a point must lie: beside it the neighbours would have to be divided
/// far.
constexpr double least_distance_of_vertex = 0.03;

/// an umbilic in the cell at which the third-order form vanishes, too: Q = A1 = A3 = 0 up to rounding. All crossings of
/// the border lead to it, as they do on smaller copies of the border around it.
std::optional<Sample> find_flat_umbilic(const Refined_complex& complex, const std::vector<Half_edge>& border,
                                        const Border_crossings& met, const Sample& middle, const Flat_cell& flat);

/// a point in the cell at which two lines of one family cross: a saddle of the phase, on a level of it up to rounding. Its
/// four branches are all that crosses the border, and that of smaller copies of it.
/// \pre neither P nor Q vanishes in the cell
std::optional<Sample> find_crossing_of_lines(const Refined_complex& complex, const std::vector<Half_edge>& border,
                                             const Border_crossings& met, const Sample& middle, const Flat_cell& flat);

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_EXTRACTION_DEGENERATE_VERTEX_H
