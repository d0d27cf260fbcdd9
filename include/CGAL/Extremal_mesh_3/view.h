// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_VIEW_H
#define CGAL_EXTREMAL_MESH_3_VIEW_H

#include <CGAL/Extremal_mesh_3/Extremal_mesh.h>
#include <CGAL/Extremal_mesh_3/cell_patches.h>
#include <CGAL/Extremal_mesh_3/errors.h>

#include <string>

namespace CGAL::Extremal_mesh_3 {

/// How a page begins.
struct View_options {
  Vector view{-0.5, 0.75, -0.35};                  ///< the direction of sight
  Vector up{0, 0, 1};                              ///< what points upwards, and the axis around which one turns
  Cell_colouring colouring = Cell_colouring::sign; ///< of the surface
};

/// writes a page of HTML that shows an extremal mesh in any browser, without a network: surface, lines by type, vertices by
/// class, to be turned, zoomed, filtered and asked. All is in the one file. Positions are shown to single precision.
/// \param patches  the surface; empty: the lines are shown alone
/// \param file  the name of the file to write
/// \param mesh  an extremal mesh
/// \param options  how the page begins
/// \throws Io_error if the file cannot be written
/// \throws std::invalid_argument if the direction of sight is zero, not finite or along `up`, or a patch makes no sense
void write_view(const std::string& file, const Extremal_mesh& mesh, const Cell_patches& patches,
                const View_options& options = {});

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_VIEW_H
