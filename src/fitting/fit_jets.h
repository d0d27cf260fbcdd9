// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_FITTING_FIT_JETS_H
#define EXTREMAL_MESH_3_SRC_FITTING_FIT_JETS_H

#include "../cells/parallel.h"
#include "Jet_fitter.h"

#include <functional>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

/// A mesh as the fits see it.
struct Fit_input {
  std::vector<Mesh_vertex> vertices;
  Adjacency adjacency;
  std::vector<double> sampling; ///< `sampling_distances()`
  double rounding = 0;          ///< of the coordinates, a length
};

/// The jets at all vertices.
struct Jets {
  Vertex_shapes shapes;
  std::size_t grown = 0; ///< vertices with a larger neighbourhood than was asked for
};

/// fits them.
/// \param extents  of the neighbourhoods to begin with, one per vertex
/// \param progress  called with the share of the work that is done, from one thread at a time
Jets fit_jets(const Fit_input& input, const std::vector<Extent>& extents, Thread_pool& pool,
              const std::function<void(double)>& progress);

/// Jets with the radius that suits the mesh.
struct Default_fit {
  Jets jets;
  double multiple = 0; ///< of the distance of neighbours: the radius
};

/// fits jets in neighbourhoods whose radius is the smallest multiple of the distance of neighbours for which the
/// noise in C is a small part of C.
Default_fit fit_jets_with_default_radius(const Fit_input& input, Thread_pool& pool,
                                         const std::function<void(double)>& progress);

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_FITTING_FIT_JETS_H
