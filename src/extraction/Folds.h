// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_EXTRACTION_FOLDS_H
#define EXTREMAL_MESH_3_SRC_EXTRACTION_FOLDS_H

#include "Sample.h"

#include <CGAL/Extremal_mesh_3/Extremal_mesh.h>

#include <unordered_map>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

class Refined_complex;

/// Parallel transport along edges and around cells.
///
/// It is transport along the great circles between normals, and the holonomy of a cell the area of its polygon of
/// normals on the sphere: the areas sum to 4π × the degree of the map of normals, which is 2πχ where the cells follow
/// the surface. Where they do not (the lattice joined two sheets that the surface keeps apart, and no finer cells would
/// undo it), normals contradict the cells, and the sum of the umbilics' indices would miss χ. There the edges
/// themselves carry the transport: it turns the direction in which an edge leaves one end into that in which it arrives
/// at the other, and the holonomy of a cell is 2π − Σ (π − inner angle). With one full turn of directions around each
/// point these sum to 2πF − 2πE + 2πV, always.
class Folds {
public:
  /// finds the points where normals contradict the cells, and the directions of the edges around them.
  const std::vector<char>& find(const Refined_complex& complex);

  /// e^{iα} for the transport along a half-edge, α being the angle from the basis at its target to that at its source.
  Complex transport(const Refined_complex& complex, Half_edge h) const;
  double holonomy(const Refined_complex& complex, const std::vector<Half_edge>& border) const;

private:
  double direction(const Refined_complex& complex, Half_edge h) const;
  double inner_angle(const Refined_complex& complex, Half_edge in, Half_edge out) const;
  bool folded(const Refined_complex& complex, Half_edge h) const;
  void spread(const Refined_complex& complex, const std::vector<Half_edge>& star);

  std::vector<char> folded_;                    ///< of each sample; empty: none
  std::unordered_map<Half_edge, double> given_; ///< directions where those in the tangent plane make no full turn
};

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_EXTRACTION_FOLDS_H
