// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "change_of_coordinates.h"

namespace CGAL::Extremal_mesh_3 {
namespace {

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

} // namespace

std::optional<Matrix> inverse_of_columns(const std::array<Vector, 3>& columns) {
  // Cramer's rule on unit vectors: neither large nor small units of length overflow.
  std::array<Vector, 3> unit = columns;
  Vector length;
  for (std::size_t a = 0; a < 3; ++a) {
    length[a] = std::hypot(columns[a][0], columns[a][1], columns[a][2]);
    for (double& x : unit[a])
      x /= length[a];
  }
  Matrix inverse{cross(unit[1], unit[2]), cross(unit[2], unit[0]), cross(unit[0], unit[1])};
  const double determinant = dot(unit[0], inverse[0]);
  constexpr double least = 1e-6;        // sine of the angle between a step and the plane of the others: flat beyond use
  if (!(std::abs(determinant) > least)) // also when it is not a number
    return std::nullopt;
  for (std::size_t a = 0; a < 3; ++a)
    for (double& x : inverse[a])
      x /= determinant * length[a];
  return inverse;
}

} // namespace CGAL::Extremal_mesh_3
