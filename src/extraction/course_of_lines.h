// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_EXTRACTION_COURSE_OF_LINES_H
#define EXTREMAL_MESH_3_SRC_EXTRACTION_COURSE_OF_LINES_H

#include "Cell_model.h"
#include "Planar_polygon.h"
#include "analyse_cell.h"

#include <vector>

namespace CGAL::Extremal_mesh_3 {

/// How lines run through a cell in which neither P nor Q vanishes.
struct Line_course {
  bool certain = false;
  bool no_closed_line = false;
  std::int8_t joined = 0;     ///< as in `Refined_cell`; if not certain, the likelier one
  std::vector<Edge_cut> cuts; ///< edges that two lines seem to cross where none was seen
};

/// finds it from the models of P and Q: where the border is crossed; that the phase has no extremum inside, around
/// which a line could close; and, where four crossings of one level can be joined in two ways, which sides of the
/// lines are connected, by a path on which the phase keeps off the level.
/// \param polygon  the border, in the plane of the model
/// \param most_edge_level  edges of this level are not cut
Line_course course_of_lines(const Refined_complex& complex, const std::vector<Half_edge>& border,
                            const Border_crossings& met, const Cell_model& model, const Planar_polygon& polygon,
                            int most_edge_level);

/// tells whether each edge of a cell with one vertex is crossed as often as it seems, and no line closes inside. The
/// branches of the vertex have then one way to go.
Line_course lines_around_vertex(const Refined_complex& complex, const std::vector<Half_edge>& border,
                                const Border_crossings& met, const Cell_model& model, const Planar_polygon& polygon,
                                int most_edge_level);

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_EXTRACTION_COURSE_OF_LINES_H
