// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_PERSISTENCE_DIAGRAM_H
#define CGAL_EXTREMAL_MESH_3_PERSISTENCE_DIAGRAM_H

#include <CGAL/Extremal_mesh_3/errors.h>
#include <CGAL/Extremal_mesh_3/simplify.h>

#include <cstddef>
#include <string>

namespace CGAL::Extremal_mesh_3 {

/// whether the extension of the file's name, in upper or lower case, is one that `write_persistence_diagram()` knows: .svg,
/// .png or .csv.
/// \param file  a name
/// \return whether it can be given to `write_persistence_diagram()`
bool is_persistence_diagram_file(const std::string& file);

/// draws the persistence diagram of a simplification: a dot per step, at the number of vertices that are left after it and
/// its persistence, both on logarithmic scales, in the colour of its operation. A band marks the gap at
/// `level_at_gap()`, a dashed line the given level. Steps that cost (next to) nothing stand on the bottom line.
///
/// As CSV the same is a table: per step `level,vertices,persistence,operation,done,below_gap`, the last two 1 or 0.
/// \param file  the format follows from its extension
/// \throws std::invalid_argument if the extension is not known
///         std::out_of_range if there is no such level
///         Io_error
/// O(number of steps).
/// \param simplification  all steps
/// \param level  the one marked by a line
void write_persistence_diagram(const std::string& file, const Simplification& simplification, std::size_t level);

/// writes all steps of a simplification as CSV: per step
/// `level,operation,persistence,x,y,z,vertices,edges,cells,vanished`, where level is the one that the step leads to, the
/// counts are of the mesh of that level and `vanished` are the ids of vertices of the given mesh, with blanks between
/// them. Numbers read back to the same bits. O(number of steps).
/// \param file  the name of the file to write
/// \param simplification  all steps
/// \throws Io_error
void write_hierarchy(const std::string& file, const Simplification& simplification);

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_PERSISTENCE_DIAGRAM_H
