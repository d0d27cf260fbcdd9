// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_DERIVATIVES_H
#define CGAL_EXTREMAL_MESH_3_DERIVATIVES_H

#include <CGAL/Extremal_mesh_3/types.h>

namespace CGAL::Extremal_mesh_3 {

/// The partial derivatives, up to order 4, of a function of R³ at one point. Within an order they stand in
/// lexicographic order of the sorted indices. They are derivatives, not Taylor coefficients: `third[0]` is
/// ∂³f/∂x³. Orders that were not asked for are left as they were.
struct Derivatives {
  double value = 0;                ///< of the function itself
  Vector gradient{};               ///< x y z
  std::array<double, 6> hessian{}; ///< xx xy xz yy yz zz
  std::array<double, 10> third{};  ///< xxx xxy xxz xyy xyz xzz yyy yyz yzz zzz
  /// xxxx xxxy xxxz xxyy xxyz xxzz xyyy xyyz xyzz xzzz yyyy yyyz yyzz yzzz zzzz
  std::array<double, 15> fourth{};
};

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_DERIVATIVES_H
