// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_TEST_RANDOM_SURFACES_H
#define CGAL_EXTREMAL_MESH_3_TEST_RANDOM_SURFACES_H

#include <CGAL/Extremal_mesh_3/Functor_function.h>

#include "surfaces.h"

#include <array>
#include <cmath>
#include <random>
#include <vector>

/// Surfaces with random cubic and quartic terms.
namespace random_surfaces {

using namespace CGAL::Extremal_mesh_3;

/// cubic and quartic terms in x, y and z with coefficients up to `size`.
template <typename T> T random_terms(const std::array<double, 25>& t, const T& x, const T& y, const T& z) {
  const auto xx = x * x, yy = y * y, zz = z * z, xy = x * y, xz = x * z, yz = y * z;
  return x * (t[0] * xx + t[1] * xy + t[2] * xz + t[3] * yy + t[4] * yz + t[5] * zz) +
         y * (t[6] * yy + t[7] * yz + t[8] * zz) + t[9] * z * zz +
         xx * (t[10] * xx + t[11] * xy + t[12] * xz + t[13] * yy + t[14] * yz + t[15] * zz) +
         yy * (t[16] * xy + t[17] * xz + t[18] * yy + t[19] * yz + t[20] * zz) +
         zz * (t[21] * xy + t[22] * xz + t[23] * yz + t[24] * zz);
}

/// numbers from −size to size, the same with every library.
class Random {
public:
  explicit Random(unsigned seed) : random_(seed) {}
  double uniform(double low, double high) { return low + (high - low) * (double(random_()) / 4294967295.0); }
  std::array<double, 25> coefficients(double size) {
    std::array<double, 25> t;
    for (double& x : t)
      x = uniform(-size, size);
    return t;
  }

private:
  std::mt19937 random_;
};

/// x² + b y² + c z² + (cubic and quartic terms) − 1, as a functor.
inline auto ellipsoid_functor(unsigned seed) {
  Random random(seed);
  const auto t = random.coefficients(0.12);
  const double b = random.uniform(1, 2), c = random.uniform(1, 3);
  return [t, b, c](auto x, auto y, auto z) { return x * x + b * y * y + c * z * z - 1 + random_terms(t, x, y, z); };
}
inline auto ellipsoid(unsigned seed) {
  return make_function(ellipsoid_functor(seed));
}
/// the same surface, moved.
/// \pre the motion keeps lengths
inline auto ellipsoid(unsigned seed, const surfaces::Motion& motion) {
  return make_function([f = ellipsoid_functor(seed), R = motion.R, t = motion.translation](auto x, auto y, auto z) {
    const auto dx = x - t[0], dy = y - t[1], dz = z - t[2];
    return f(R[0][0] * dx + R[1][0] * dy + R[2][0] * dz, R[0][1] * dx + R[1][1] * dy + R[2][1] * dz,
             R[0][2] * dx + R[1][2] * dy + R[2][2] * dz);
  });
}

/// a torus with radii 1 and about 0.4, disturbed.
inline auto torus(unsigned seed) {
  Random random(seed);
  const auto t = random.coefficients(0.03);
  const double r = random.uniform(0.35, 0.45), b = random.uniform(1, 1.2);
  return make_function([t, r, b](auto x, auto y, auto z) {
    const auto s = x * x + b * y * y + z * z + 1 - r * r;
    return s * s - 4 * (x * x + b * y * y) + random_terms(t, x, y, z);
  });
}

/// a surface of genus 2, disturbed.
inline auto double_torus(unsigned seed) {
  Random random(seed);
  const auto t = random.coefficients(0.002);
  return make_function([t](auto x, auto y, auto z) {
    const auto lemniscate = x * x * (1 - x * x) - y * y;
    return lemniscate * lemniscate + 0.5 * z * z - 0.025 * (x * x + y * y + z * z) - 0.025 + random_terms(t, x, y, z);
  });
}

/// a box with all of the component around the origin, and nothing else.
inline surfaces::Box box_of(const Function_3& f) {
  std::vector<Point> points;
  for (int i = 0; i < 400; ++i) { // Fibonacci's spiral
    const double z = (i + 0.5) / 200 - 1, angle = 2.399963229728653 * i, r = std::sqrt(1 - z * z);
    const Vector d{r * std::cos(angle), r * std::sin(angle), z};
    double t = 0;
    while (t < 3 && f.value(surfaces::along({0, 0, 0}, t, d)) < 0)
      t += 0.01;
    points.push_back(surfaces::along({0, 0, 0}, t, d));
  }
  return surfaces::box_of(points).widened(0.02);
}

} // namespace random_surfaces

#endif // CGAL_EXTREMAL_MESH_3_TEST_RANDOM_SURFACES_H
