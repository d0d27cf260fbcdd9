// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Arithmetic of 3-vectors, for our own sources.
#ifndef EXTREMAL_MESH_3_SRC_DIFFERENTIAL_VECTOR_H
#define EXTREMAL_MESH_3_SRC_DIFFERENTIAL_VECTOR_H

#include <CGAL/Extremal_mesh_3/types.h>

#include <cmath>

namespace CGAL::Extremal_mesh_3 {

inline Vector operator+(const Vector& a, const Vector& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline Vector operator-(const Vector& a, const Vector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Vector operator-(const Vector& a) {
  return {-a[0], -a[1], -a[2]};
}
inline Vector operator*(double s, const Vector& a) {
  return {s * a[0], s * a[1], s * a[2]};
}
inline double dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline double norm(const Vector& a) {
  return std::sqrt(dot(a, a));
}
inline double distance(const Point& a, const Point& b) {
  return norm(a - b);
}
inline Vector normalized(const Vector& a) {
  return (1 / norm(a)) * a;
}

/// a unit vector orthogonal to the unit vector n.
inline Vector any_orthogonal(const Vector& n) {
  // Crossing with the axis that is farthest from n keeps the result well away from zero.
  const double x = std::abs(n[0]), y = std::abs(n[1]), z = std::abs(n[2]);
  const Vector axis = x <= y && x <= z ? Vector{1, 0, 0} : (y <= z ? Vector{0, 1, 0} : Vector{0, 0, 1});
  return normalized(cross(axis, n));
}

/// turns w by the smallest rotation that takes the unit vector a to the unit vector b: the parallel transport along the great circle
/// between two normals. Of the half-turns that take a to −a it is always the same one, and so for normals that are opposite up
/// to rounding.
inline Vector transport(const Vector& a, const Vector& b, const Vector& w) {
  const Vector axis = cross(a, b); // its length is the sine of the angle
  const double c = dot(a, b);
  if (1 + c < 1e-9) {
    const Vector half_turn = any_orthogonal(a);
    return 2 * dot(half_turn, w) * half_turn - w;
  }
  return c * w + cross(axis, w) + (dot(axis, w) / (1 + c)) * axis;
}

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_DIFFERENTIAL_VECTOR_H
