// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_VERTEX_SHAPES_H
#define CGAL_EXTREMAL_MESH_3_VERTEX_SHAPES_H

#include <CGAL/Extremal_mesh_3/Differential_quantities.h>

#include <cstdint>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

/// How the shape at a vertex was found.
enum class Fit_state : std::uint8_t {
  given,          ///< by the caller
  fitted,         ///< by a jet of degree 4
  too_few_points, ///< too few vertices of the same sheet are near; there is no shape
  rank_deficient  ///< those near do not determine a jet (they lie on a few lines); there is no shape
};

/// How well a jet fits.
struct Fit_quality {
  Fit_state state = Fit_state::given; ///< how the shape was found
  std::uint32_t points = 0;           ///< in the neighbourhood, the vertex included
  double radius = 0;                  ///< of the neighbourhood, a length
  double condition = 1; ///< √ of the largest variance inflation of a coefficient: 4 to 10 are good, 80 on one side
  double residual = 0;  ///< weighted root mean square of the distances to the jet, a length
  /// standard error of L(t, t), root mean square over unit tangents t, that the residual implies if it is noise, in
  /// 1/length. With weights it is too large by 7 %, that of C by 28 %
  double L_error = 0;
  double C_error = 0; ///< the same of C(t, t, t), in 1/length²
  /// by how much C changes in a neighbourhood 1.4 times as wide, where an extremality is so small that it may be an
  /// error of the fit; 0 elsewhere
  double C_change = 0;

  /// \return whether there is a shape
  bool known() const { return state == Fit_state::given || state == Fit_state::fitted; }
};

/// The shape of a surface at each vertex of its cells.
struct Vertex_shapes {
  std::vector<Local_shape> shapes;       ///< one per vertex
  std::vector<Fourth_order_form> fourth; ///< empty: not known. Extraction takes differences of C unless all is exact
  std::vector<Fit_quality> quality;      ///< empty: all given and exact
};

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_VERTEX_SHAPES_H
