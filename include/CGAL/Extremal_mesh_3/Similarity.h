// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_SIMILARITY_H
#define CGAL_EXTREMAL_MESH_3_SIMILARITY_H

#include <CGAL/Extremal_mesh_3/types.h>

#include <array>

namespace CGAL::Extremal_mesh_3 {

/// y = scale · rotation · x + translation: a rigid motion if the scale is 1 and the rotation's determinant is 1; a mirror if
/// that is −1.
struct Similarity {
  std::array<Vector, 3> rotation{Vector{1, 0, 0}, Vector{0, 1, 0}, Vector{0, 0, 1}}; ///< rows; orthogonal
  Vector translation{0, 0, 0};                                                       ///< where the origin goes
  double scale = 1;                                                                  ///< positive

  /// \param x  a point
  /// \return where it goes
  Point operator()(const Point& x) const;
  /// turns a vector; its length stays as it is.
  /// \param v  a vector
  /// \return rotation · v
  Vector turned(const Vector& v) const;
  /// \return whether the rotation's determinant is negative
  bool mirrors() const;
  /// \return the way back
  Similarity inverse() const;
  /// \return 4×4, by rows: takes (x, y, z, 1)
  std::array<std::array<double, 4>, 4> matrix() const;
};

/// \param a,b  two motions
/// \return first b, then a
Similarity operator*(const Similarity& a, const Similarity& b);

/// the angle of the rotation, in [0, π]; of a mirror, that of its rotation by the negative of the matrix.
/// \param s  a motion
/// \return in radians
double rotation_angle(const Similarity& s);

/// understands a matrix.
/// \param matrix  4×4, by rows: takes (x, y, z, 1)
/// \return the motion
/// \throws std::invalid_argument telling what is wrong if the last row is not 0 0 0 1, or the rest is no multiple of an orthogonal
///         matrix up to 1e-6
Similarity similarity_of_matrix(const std::array<std::array<double, 4>, 4>& matrix);

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_SIMILARITY_H
