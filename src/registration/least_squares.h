// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The small linear algebra of registration: normal equations of at most seven unknowns, and the rotation nearest to a matrix.
#ifndef EXTREMAL_MESH_3_SRC_REGISTRATION_LEAST_SQUARES_H
#define EXTREMAL_MESH_3_SRC_REGISTRATION_LEAST_SQUARES_H

#include <CGAL/Extremal_mesh_3/types.h>

#include <array>
#include <cstddef>
#include <optional>

namespace CGAL::Extremal_mesh_3 {

/// A small turn (3, about the axes), a translation (3), and the logarithm of a scale.
inline constexpr std::size_t unknowns = 7;
using Unknowns = std::array<double, unknowns>;
using Square_matrix = std::array<Unknowns, unknowns>;

/// Σ w J Jᵀ and −Σ w J r over residuals r with the derivatives J.
struct Normal_equations {
  Square_matrix matrix{};
  Unknowns right{};

  void add(const Unknowns& derivative, double residual, double weight);
  /// does not let an unknown change.
  void hold(std::size_t unknown);
  /// of the matrix; nothing if it is singular up to rounding.
  std::optional<Square_matrix> inverse() const;
};

Unknowns operator*(const Square_matrix& m, const Unknowns& v);

/// the rotation R for which the trace of Rᵀ·m is greatest: that which takes vectors a to b best, if m = Σ w b aᵀ. [Horn, "Closed-form solution
/// of absolute orientation using unit quaternions", 1987]
std::array<Vector, 3> nearest_rotation(const std::array<Vector, 3>& m);

/// the i-th of n rotations that are spread evenly over all. [Alexa, "Super-Fibonacci spirals", 2022]
std::array<Vector, 3> uniform_rotation(std::size_t i, std::size_t n);

/// the rotation about a vector by its length.
std::array<Vector, 3> rotation_by(const Vector& turn);

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_REGISTRATION_LEAST_SQUARES_H
