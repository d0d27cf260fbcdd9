// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_EXTRACTION_ANALYSE_CELL_H
#define EXTREMAL_MESH_3_SRC_EXTRACTION_ANALYSE_CELL_H

#include "Refined_complex.h"

#include <optional>

namespace CGAL::Extremal_mesh_3 {

/// Where the border of a cell meets a line.
struct Border_crossing {
  Half_edge half_edge;
  std::int32_t level; ///< the lifted phase is π·level there; odd: e1 = 0, even: e2 = 0
  bool rising;        ///< the phase rises, walking counter-clockwise
  int family() const { return level % 2 != 0 ? 1 : 2; }
};

/// the crossings of the lines with the border of a cell, counter-clockwise, and how far Φ winds around it.
struct Border_crossings {
  std::vector<Border_crossing> crossings;
  int winding_phi = 0;
};
Border_crossings border_crossings(const Refined_complex& complex, const std::vector<Half_edge>& border);

/// What was found out about a cell.
struct Cell_analysis {
  Content content = Content::undecided;
  bool certain = true;
  std::size_t crossings = 0;        ///< of the border
  int winding_P = 0, winding_Q = 0; ///< of P and Q around the border: a multiple of a full turn
  std::optional<Sample> sample;     ///< the vertex in the cell, or its middle
  std::int8_t joined = 0;           ///< as in `Refined_cell`
  Side_pair halved_between;         ///< as in `Refined_cell`
  std::vector<Edge_cut> cuts;       ///< cut these edges, then ask again; nothing else is told
};

/// tells whether what was found in a cell still holds after edges of it were divided: it was certain, and they are crossed as
/// often as it had seemed.
bool still_holds(const Refined_complex& complex, const Refined_cell& cell);

/// decides what a cell holds that is not plainly empty: windings of P and Q around its border count their zeros inside, and a linear model of
/// each, with its error measured at the samples, tells whether there can be more than the windings say.
/// \param may_divide  give up with `Content::undecided` when in doubt; otherwise the simplest content that the border
///        allows is taken
/// \param may_divide_lines  the same for cells that hold no vertex, if the lines may run in more than one way
/// \param most_edge_level  edges of this level are not cut any more
Cell_analysis analyse_cell(const Refined_complex& complex, const Refined_cell& cell, bool may_divide,
                           bool may_divide_lines, int most_edge_level);

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_EXTRACTION_ANALYSE_CELL_H
