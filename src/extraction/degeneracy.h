// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_EXTRACTION_DEGENERACY_H
#define EXTREMAL_MESH_3_SRC_EXTRACTION_DEGENERACY_H

#include "../cells/parallel.h"
#include "Sample.h"

#include <CGAL/Extremal_mesh_3/Cell_complex.h>
#include <CGAL/Extremal_mesh_3/Vertex_shapes.h>

#include <string>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

/// The part of a surface on which E_g is 0, up to rounding or to the errors of the shapes.
struct Degeneracy {
  std::vector<char> cells; ///< of each cell: it is degenerate
  double area = 0, total_area = 0;
  std::string name; ///< what it looks like: "as on a sphere or a plane", "as on a surface of revolution"…
};

/// finds the cells at all corners of which, and in the middle, E_g is 0 up to rounding.
Degeneracy find_degeneracy(const Surface& surface, const Cell_complex& cells, const std::vector<Sample>& samples,
                           Thread_pool& pool);

/// finds the areas, wider than the neighbourhoods of the fits, in which E_g is 0 up to rounding and the errors of the
/// fits: about an extremal line it is so, too, but in a narrow strip only.
/// \param quality  empty: the shapes are exact
Degeneracy find_degeneracy(const Cell_complex& cells, const std::vector<Sample>& samples,
                           const std::vector<Fit_quality>& quality, Thread_pool& pool);

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_EXTRACTION_DEGENERACY_H
