// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_DIFFERENTIAL_UMBILIC_LINES_H
#define EXTREMAL_MESH_3_SRC_DIFFERENTIAL_UMBILIC_LINES_H

#include <complex>

namespace CGAL::Extremal_mesh_3 {

/// A field near its zero: x·(value of x) + y·(value of y) in the tangent plane.
struct Linear_field {
  std::complex<double> x, y;
};

/// P and Q near an umbilic with the third-order form A1, A3, in the basis of these.
struct Umbilic_fields {
  Linear_field P, Q;
};
Umbilic_fields fields_at_umbilic(std::complex<double> A1, std::complex<double> A3);

/// the number of extremal lines through an umbilic at which P and Q are these: 1 or 3, or 0 if two of them coincide.
int lines_through_umbilic(const Linear_field& P, const Linear_field& Q);

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_DIFFERENTIAL_UMBILIC_LINES_H
