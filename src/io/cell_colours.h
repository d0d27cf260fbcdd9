// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_IO_CELL_COLOURS_H
#define EXTREMAL_MESH_3_SRC_IO_CELL_COLOURS_H

#include "colours.h"

#include <CGAL/Extremal_mesh_3/cell_patches.h>

#include <vector>

namespace CGAL::Extremal_mesh_3 {

/// the colour of each cell. O(V + E + F).
std::vector<Colour> cell_colours(const Extremal_mesh& mesh, Cell_colouring colouring);

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_IO_CELL_COLOURS_H
