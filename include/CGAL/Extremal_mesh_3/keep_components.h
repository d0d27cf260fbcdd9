// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_KEEP_COMPONENTS_H
#define CGAL_EXTREMAL_MESH_3_KEEP_COMPONENTS_H

#include <CGAL/Extremal_mesh_3/Cell_complex.h>

namespace CGAL::Extremal_mesh_3 {

/// Which connected components of a surface are of interest.
struct Component_options {
  bool largest = false; ///< only the one with the largest area; of several the one with the first point
  double min_area = 0;  ///< those of at least this area, in the square of the input's unit of length
};

/// leaves out connected components. The points and cells of the others keep their order. O(n).
/// \param cells  the surface
/// \param options  which components stay
/// \return what is left
/// \throws std::invalid_argument if the area is not finite, or negative
/// \throws Extraction_error naming the largest area if no component is left
Cell_complex keep_components(Cell_complex cells, const Component_options& options);

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_KEEP_COMPONENTS_H
