// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_FITTING_JET_FITTER_H
#define EXTREMAL_MESH_3_SRC_FITTING_JET_FITTER_H

#include "Surface_walk.h"
#include "shape_of_jet.h"

#include <CGAL/Extremal_mesh_3/Vertex_shapes.h>

namespace CGAL::Extremal_mesh_3 {

/// The size of a neighbourhood: within a radius, or, if `rings` is not 0, within so many steps.
struct Extent {
  double radius = 0;
  int rings = 0;
};

/// Fits jets at vertices, growing neighbourhoods until they determine one. One object serves one thread.
class Jet_fitter {
public:
  Jet_fitter(const std::vector<Mesh_vertex>& vertices, const Adjacency& adjacency)
      : vertices_(vertices), walk_(vertices, adjacency) {}

  /// fits the vertices [first, last) and writes their entries of `result`.
  /// \param extent  extent(v) is that of the neighbourhood of v to begin with
  template <class Extent_of>
  void fit(std::uint32_t first, std::uint32_t last, const Extent_of& extent, Vertex_shapes& result) {
    for (std::uint32_t v = first; v < last; ++v)
      add({v, extent(v), 0, {}, 0}, result);
    while (batch_.size() > 0)
      fit_batch(result);
  }

private:
  /// A vertex on its way to a jet.
  struct Task {
    std::uint32_t vertex;
    Extent extent;
    int growths;
    Fit_frame frame;
    std::size_t points;
  };

  void add(Task task, Vertex_shapes& result);
  bool gather(Task& task);
  void fit_batch(Vertex_shapes& result);

  const std::vector<Mesh_vertex>& vertices_;
  Surface_walk walk_;
  Jet_batch batch_;
  std::array<Task, Jet_batch::lanes> tasks_{}; ///< of the lanes of the batch
  std::vector<double> weights_;
};

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_FITTING_JET_FITTER_H
