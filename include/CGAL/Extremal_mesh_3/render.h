// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_RENDER_H
#define CGAL_EXTREMAL_MESH_3_RENDER_H

#include <CGAL/Extremal_mesh_3/Extremal_mesh.h>
#include <CGAL/Extremal_mesh_3/cell_patches.h>
#include <CGAL/Extremal_mesh_3/errors.h>
#include <CGAL/Extremal_mesh_3/extract_extremal_mesh.h>

#include <cstdint>
#include <string>

namespace CGAL::Extremal_mesh_3 {

/// What of a mesh is in a picture, beside its surface.
enum class Shown_lines : std::uint8_t {
  all,   ///< all lines and vertices
  crest, ///< the pieces of lines that are of type `max_largest`
  none   ///< nothing: the sign of E_g alone is seen
};

/// How a picture is taken. The projection is orthographic.
struct Render_options {
  int width = 1600;               ///< pixels
  int height = 1200;              ///< pixels
  Vector view{-0.5, 0.75, -0.35}; ///< the direction of sight
  Vector up{0, 0, 1};             ///< what points upwards in the picture, as far as it is not along `view`
  double line_width = 0;          ///< pixels; 0: 3, or less where many lines are crowded
  double dot_radius = 0;          ///< pixels; 0: 6, or less where many vertices are crowded
  double min_strength = 0;        ///< lines of less strength are drawn thinner and paler
  Cell_colouring colouring = Cell_colouring::sign; ///< of the surface
  Shown_lines lines = Shown_lines::all;            ///< which lines are drawn; vertices, if it is all of them
  bool legend = true;                              ///< tell what the colours mean, if there is room
  int threads = 0; ///< 0: as many as there are cores. The picture does not depend on it.
};

/// draws surface (E_g > 0 and E_g < 0 in two tints, if not told otherwise), lines in the colours of Thirion's report (largest curvature
/// orange, second blue, maxima lighter than minima), extremal points and umbilics as dots, and writes a PNG. Needs no
/// display. Without patches the lines are drawn alone, those on the far side too.
/// \param file  the name of the file to write
/// \param mesh  an extremal mesh
/// \param patches  the surface cut along its lines; empty: none is drawn
/// \param options  from where, how large, and what is left out
/// \throws Io_error if the file cannot be written
/// \throws std::invalid_argument if a size is not in 16 … 16384, or an option or a patch makes no sense
void render_png(const std::string& file, const Extremal_mesh& mesh, const Cell_patches& patches,
                const Render_options& options = {});

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_RENDER_H
