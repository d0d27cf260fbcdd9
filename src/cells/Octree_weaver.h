// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_CELLS_OCTREE_WEAVER_H
#define EXTREMAL_MESH_3_SRC_CELLS_OCTREE_WEAVER_H

#include "Octree.h"
#include "surface_points.h"

#include <CGAL/Extremal_mesh_3/Function_3.h>

#include <map>
#include <unordered_map>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

/// Weaves the polygons of the surface in the cubes of an octree. Faces and edges between cubes of different levels are
/// taken as finely as the finer side has them, so cubes of any levels fit together; a large cube beside small ones gets
/// polygons with more sides.
class Octree_weaver {
public:
  Octree_weaver(const Function_3& f, const Lattice& lattice, const Octree& tree)
      : f_(f), lattice_(lattice), tree_(tree) {}

  /// gives the value at a node of the lattice, where it is known.
  void set_value(const Grid_point& node, double value) { values_[node] = value; }
  /// gives the number of the surface point on an edge of the lattice.
  void set_point(const Grid_point& base, std::size_t axis, std::uint32_t id) { points_[{base, axis, 0}] = id; }
  /// what the next new surface point is numbered.
  void set_first_new_point(std::uint32_t id) { next_point_ = id; }

  /// adds the polygons in a cube, divided or not.
  void weave(const Grid_cube& cube);

  std::vector<Cut_edge> new_cut_edges;
  std::vector<Grid_cube> polygon_cubes; ///< the undivided cube in which each polygon lies
  std::vector<std::size_t> polygon_begin{0};
  std::vector<std::uint32_t> corners;
  /// Cubes beside finer ones whose polygons could be woven in several ways: a node of the finer ones, in the middle of a side, tells
  /// of more than the corners. Divided, they are not ambiguous.
  std::vector<Grid_cube> ambiguous_cubes;

private:
  struct Edge {
    Grid_point base;
    std::size_t axis = 0;
    int level = 0;
    bool operator==(const Edge&) const = default;
  };
  struct Edge_hash {
    std::size_t operator()(const Edge& e) const {
      return Grid_hash::mix(Grid_hash()(e.base), std::int64_t(3 * e.level) + std::int64_t(e.axis));
    }
  };
  /// A square seen with `first` × `second` towards the viewer.
  struct Face {
    Grid_point base;
    std::size_t first = 0, second = 1;
    int level = 0;
  };
  /// Where the border of a face crosses the surface: from + to − or back.
  struct Cut {
    std::uint32_t point;
    bool leaves_plus;
  };

  double value(const Grid_point& node);
  bool plainly_empty() const;
  void look_around(const Grid_cube& cube);
  bool divided(const Grid_cube& cube) const;
  double corner_value(const Grid_point& node);
  bool edge_divided(const Edge& edge) const;
  void cut(const Edge& edge, bool forward, std::vector<Cut>& cuts);
  void join(const Face& face, std::map<std::uint32_t, std::uint32_t>& next);
  bool ambiguous_face_joined(const Face& face);

  const Function_3& f_;
  const Lattice& lattice_;
  const Octree& tree_;
  std::unordered_map<Grid_point, double, Grid_hash> values_;
  std::unordered_map<Edge, std::uint32_t, Edge_hash> points_;
  std::uint32_t next_point_ = 0;
  // Of the cube at hand:
  Grid_cube cube_;
  std::array<double, 8> at_corner_{}; ///< the values
  std::uint32_t divided_around_ = 0;  ///< of those around it: if there are any its sides may be divided
  bool ambiguous_side_ = false;       ///< was met
};

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_CELLS_OCTREE_WEAVER_H
