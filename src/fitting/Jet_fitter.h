// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_FITTING_JET_FITTER_H
#define EXTREMAL_MESH_3_SRC_FITTING_JET_FITTER_H

#include "Surface_walk.h"
#include "shape_of_jet.h"

#include <CGAL/Extremal_mesh_3/Vertex_shapes.h>

namespace CGAL::Extremal_mesh_3 {

/// The size of a neighbourhood: within a radius, or, if `rings` is not 0, within so many steps along edges.
struct Extent {
  double radius = 0;
  int rings = 0;
};

/// Fits jets at vertices, growing neighbourhoods until they determine one. One object serves one thread.
class Jet_fitter {
public:
  /// \param rounding  of coordinates: no fit is taken to be more exact
  Jet_fitter(const std::vector<Mesh_vertex>& vertices, const Adjacency& adjacency, double rounding)
      : vertices_(vertices), adjacency_(adjacency), rounding_(rounding), walk_(vertices, adjacency) {}

  /// fits a jet at v, now or when others come, and writes its entries of `result`.
  /// \param extent  of its neighbourhood to begin with
  void fit(std::uint32_t v, Extent extent, Vertex_shapes& result) { fit(v, extent, result, v); }
  /// \param entry  which entries of `result` are written
  void fit(std::uint32_t v, Extent extent, Vertex_shapes& result, std::uint32_t entry) {
    Task task{v, entry, extent, extent};
    task.normal = vertices_[v].n;
    add(task, result);
  }

  /// fits those that still wait.
  void finish(Vertex_shapes& result) {
    while (batch_.size() > 0)
      fit_batch(result);
  }

  /// how many vertices needed more than the extent they began with.
  std::size_t grown() const { return grown_; }

private:
  /// A vertex on its way to a jet.
  struct Task {
    std::uint32_t vertex = 0, entry = 0;
    Extent extent, first_extent;
    Vector normal{}; ///< of the sheet at the vertex
    bool begun_again = false;
    int growths = 0;
    std::size_t points = 0;
    bool can_grow = true;
    double first_reach = 0; ///< the distance of the farthest point, before it grew
    Fit_frame frame{};
  };

  void add(Task task, Vertex_shapes& result);
  bool gather(Task& task);
  bool lies_on_chain(std::uint32_t vertex) const;
  bool grow(Task& task);
  bool begin_again(Task& task);
  void fit_batch(Vertex_shapes& result);

  const std::vector<Mesh_vertex>& vertices_;
  const Adjacency& adjacency_;
  double rounding_;
  Surface_walk walk_;
  Jet_batch batch_;
  std::array<Task, lanes> tasks_{}; ///< of the lanes of the batch
  std::vector<double> weights_;
  std::size_t grown_ = 0;
};

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_FITTING_JET_FITTER_H
