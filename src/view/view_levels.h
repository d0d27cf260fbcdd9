// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_VIEW_VIEW_LEVELS_H
#define EXTREMAL_MESH_3_SRC_VIEW_VIEW_LEVELS_H

#include <CGAL/Extremal_mesh_3/cell_patches.h>
#include <CGAL/Extremal_mesh_3/simplify.h>

#include "../io/colours.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

/// What a page needs to show a mesh at some levels of its simplification, told for the elements of the mesh itself.
struct View_levels {
  std::vector<std::size_t> levels;     ///< of the simplification, ascending; the first one is 0
  std::vector<double> persistence;     ///< of each level: that of the last step done; 0 for the first
  std::vector<std::size_t> vertices;   ///< how many each level has
  std::vector<std::size_t> edges;      ///< the same
  std::vector<std::size_t> cells;      ///< the same
  std::vector<std::uint8_t> of_vertex; ///< the last of these levels at which the vertex is there, counted from 0
  /// the same for each segment of the lines, edge by edge: the last one at which a line runs along it
  std::vector<std::uint8_t> of_segment;
  std::vector<Colour> colours; ///< of the mesh's cells, level by level
};

/// looks at up to `most` levels, at even distances in the number of steps. O(levels × size of the mesh).
/// \pre most is at most 255
View_levels view_levels(const Extremal_mesh& mesh, const Simplification& simplification, Cell_colouring colouring,
                        std::size_t most);

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_VIEW_VIEW_LEVELS_H
