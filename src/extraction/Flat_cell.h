// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_EXTRACTION_FLAT_CELL_H
#define EXTREMAL_MESH_3_SRC_EXTRACTION_FLAT_CELL_H

#include "Refined_complex.h"
#include "linear_fit.h"

#include <vector>

namespace CGAL::Extremal_mesh_3 {

/// A complex number that depends on the place in the plane, with its derivatives.
struct Flat_value {
  Complex f, x, y;
};

/// Q, A1 and A3 in a plane, their components being those in the basis of the middle.
struct Flat_shape {
  Flat_value Q, A1, A3;
};

/// lays the shape at s, which has its fourth-order form, in the tangent plane of the middle.
Flat_shape laid_flat(const Sample& s, const Sample& middle);

/// The samples of a cell, in the tangent plane of its middle, with P and Q in the basis there.
struct Flat_cell {
  Planar_points points; ///< border, then the middle, then what else was sampled
  std::vector<Complex> P, Q;
  std::size_t border = 0;
  bool flat = true;               ///< all normals are near to the middle's
  std::vector<Flat_shape> shapes; ///< of each point, where `has_derivatives`
  bool has_derivatives = true;    ///< all samples have their fourth-order forms

  void add(const Sample& middle, const Sample& s);
};

/// lays the border of a cell and its middle in the plane.
Flat_cell flatten(const Refined_complex& complex, const std::vector<Half_edge>& border, const Sample& middle);

/// adds the middles of up to three sides to cells with few samples. The corners and the middle of a quadrilateral see nothing of
/// a saddle x² − y² along its sides, and so would miss two lines that pass each other there.
bool add_sides(const Refined_complex& complex, const std::vector<Half_edge>& border, const Sample& middle,
               Flat_cell& flat);

/// adds samples at the middles of the sides, and half way from the middle of the cell to its corners.
void add_samples(const Refined_complex& complex, const std::vector<Half_edge>& border, const Sample& middle,
                 Flat_cell& flat);

/// the phase at the samples of the border, lifted to a real function by the edges' turns, and once more at the first
/// one, all the way around.
std::vector<double> border_phase(const Refined_complex& complex, const std::vector<Half_edge>& border);

/// the phase, lifted to a real function: along the border by the edges' turns, to the inner samples by the least turn
/// from each sample of the border. Empty if these do not agree.
std::vector<double> lifted_phase(const Refined_complex& complex, const std::vector<Half_edge>& border,
                                 const Flat_cell& flat);

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_EXTRACTION_FLAT_CELL_H
