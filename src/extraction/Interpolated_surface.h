// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_EXTRACTION_INTERPOLATED_SURFACE_H
#define EXTREMAL_MESH_3_SRC_EXTRACTION_INTERPOLATED_SURFACE_H

#include "Sample.h"

#include <CGAL/Extremal_mesh_3/Cell_complex.h>
#include <CGAL/Extremal_mesh_3/Vertex_shapes.h>

namespace CGAL::Extremal_mesh_3 {

/// A surface that is known at the points of its cells only. Between them L, C and the fourth-order form are interpolated:
/// along edges from their ends, and within a cell from its corners and its middle (see `interpolate()`).
class Interpolated_surface : public Surface {
public:
  std::optional<Sample> sample(const Point&, const Vector&, double, double, Detail) const override {
    return std::nullopt;
  }
  double extremality_derivative(const Sample& s, int family, double) const override {
    return CGAL::Extremal_mesh_3::extremality_derivative(s.shape, s.fourth, family);
  }
  bool interpolates() const override { return true; }

  /// \throws std::invalid_argument if there are not as many shapes as points, or one that is known is not finite or has no
  ///         orthonormal frame
  void require_valid(const Cell_complex& cells, const Vertex_shapes& shapes) const;

  /// the samples at the points of the cells.
  /// \pre the shapes are valid and all known
  std::vector<Sample> samples(const Cell_complex& cells, const Vertex_shapes& shapes) const;
};

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_EXTRACTION_INTERPOLATED_SURFACE_H
