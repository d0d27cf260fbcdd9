// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_TEST_MOTION_H
#define CGAL_EXTREMAL_MESH_3_TEST_MOTION_H

#include <CGAL/Extremal_mesh_3/types.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <random>

/// Vectors, and the motions that put surfaces anywhere.
namespace surfaces {

using namespace CGAL::Extremal_mesh_3;

inline double dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline double length(const Vector& a) {
  return std::sqrt(dot(a, a));
}
/// a + s·b.
inline Vector along(const Vector& a, double s, const Vector& b) {
  return {a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]};
}
inline double distance(const Point& a, const Point& b) {
  return length(along(a, -1, b));
}
inline Vector unit(const Vector& a) {
  return along({0, 0, 0}, 1 / length(a), a);
}

/// y = scale·R·x + translation, R orthogonal, a mirror if its determinant is −1.
struct Motion {
  std::array<Vector, 3> R{Vector{1, 0, 0}, Vector{0, 1, 0}, Vector{0, 0, 1}}; ///< rows
  Vector translation{0, 0, 0};
  double scale = 1;

  Vector turned(const Vector& v) const { return {dot(R[0], v), dot(R[1], v), dot(R[2], v)}; }
  Point operator()(const Point& x) const { return along(translation, scale, turned(x)); }
  Point back(const Point& y) const {
    const Vector d = along(y, -1, translation);
    Point x{};
    for (std::size_t i = 0; i < 3; ++i)
      x[i] = (R[0][i] * d[0] + R[1][i] * d[1] + R[2][i] * d[2]) / scale;
    return x;
  }
};

/// a uniformly random rotation and a translation by up to `reach` along each axis.
inline Motion random_motion(unsigned seed, double reach = 1) {
  std::mt19937 random(seed);
  // std's distributions differ between libraries; these are the same everywhere.
  const auto uniform = [&] { return 2 * (double(random()) / 4294967295.0) - 1; };
  std::array<double, 4> q;
  double norm2 = 0;
  do {
    for (double& x : q)
      x = uniform();
    norm2 = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
  } while (norm2 > 1 || norm2 < 0.01);
  const auto [w, x, y, z] = q;
  const double s = 2 / norm2;
  Motion m;
  m.R = {Vector{1 - s * (y * y + z * z), s * (x * y - w * z), s * (x * z + w * y)},
         Vector{s * (x * y + w * z), 1 - s * (x * x + z * z), s * (y * z - w * x)},
         Vector{s * (x * z - w * y), s * (y * z + w * x), 1 - s * (x * x + y * y)}};
  for (double& t : m.translation)
    t = reach * uniform();
  return m;
}

/// the same motion after the mirror x → −x.
inline Motion mirrored(Motion m) {
  for (Vector& row : m.R)
    row[0] = -row[0];
  return m;
}

} // namespace surfaces

#endif // CGAL_EXTREMAL_MESH_3_TEST_MOTION_H
