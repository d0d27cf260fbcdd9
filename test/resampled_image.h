// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_TEST_RESAMPLED_IMAGE_H
#define CGAL_EXTREMAL_MESH_3_TEST_RESAMPLED_IMAGE_H

#include <CGAL/Extremal_mesh_3/Image.h>

#include "motion.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

/// A second image of the same thing: moved, on another lattice, with other noise.
namespace resampled_image {

using namespace CGAL::Extremal_mesh_3;

/// the index of a point on a lattice, as real numbers: the inverse of `Lattice::node()`.
class Lattice_index {
public:
  explicit Lattice_index(const Lattice& lattice) : origin_(lattice.origin) {
    const auto& s = lattice.step;
    const double det = surfaces::dot(s[0], surfaces::cross(s[1], s[2]));
    for (std::size_t a = 0; a < 3; ++a)
      dual_[a] = surfaces::along({0, 0, 0}, 1 / det, surfaces::cross(s[(a + 1) % 3], s[(a + 2) % 3]));
  }
  Point operator()(const Point& p) const {
    const Vector d = surfaces::along(p, -1, origin_);
    return {surfaces::dot(dual_[0], d), surfaces::dot(dual_[1], d), surfaces::dot(dual_[2], d)};
  }

private:
  Point origin_;
  std::array<Vector, 3> dual_;
};

/// length of the largest side of a voxel.
inline double largest_spacing(const Lattice& lattice) {
  return std::max(
      {surfaces::length(lattice.step[0]), surfaces::length(lattice.step[1]), surfaces::length(lattice.step[2])});
}

/// The cubic B-spline through the voxels of an image (Unser, "Splines: a perfect fit for signal and image processing",
/// 1999): unlike `Image_function` it smooths nothing. Beyond the border it goes on with the nearest value on it.
class Cubic_interpolation {
public:
  explicit Cubic_interpolation(const Image& image)
      : index_(image.lattice), size_(image.lattice.size), c_(image.voxels) {
    const auto [nx, ny, nz] = size_;
    for (std::size_t line = 0; line < ny * nz; ++line)
      prefilter(line * nx, 1, nx);
    for (std::size_t k = 0; k < nz; ++k)
      for (std::size_t i = 0; i < nx; ++i)
        prefilter(i + k * nx * ny, nx, ny);
    for (std::size_t line = 0; line < nx * ny; ++line)
      prefilter(line, nx * ny, nz);
  }

  double operator()(const Point& p) const {
    const Point x = index_(p);
    std::array<std::array<double, 4>, 3> weight;
    std::array<std::array<std::size_t, 4>, 3> node;
    for (std::size_t a = 0; a < 3; ++a) {
      const double t = std::clamp(x[a], 0.0, double(size_[a] - 1)), first = std::floor(t), s = t - first;
      weight[a] = {(1 - s) * (1 - s) * (1 - s) / 6, (4 - 6 * s * s + 3 * s * s * s) / 6,
                   (1 + 3 * s + 3 * s * s - 3 * s * s * s) / 6, s * s * s / 6};
      for (std::size_t i = 0; i < 4; ++i)
        node[a][i] = mirrored(std::int64_t(first) + std::int64_t(i) - 1, std::int64_t(size_[a]));
    }
    double sum = 0;
    for (std::size_t k = 0; k < 4; ++k)
      for (std::size_t j = 0; j < 4; ++j) {
        const float* row = &c_[size_[0] * (node[1][j] + size_[1] * node[2][k])];
        double part = 0;
        for (std::size_t i = 0; i < 4; ++i)
          part += weight[0][i] * double(row[node[0][i]]);
        sum += weight[1][j] * weight[2][k] * part;
      }
    return sum;
  }

private:
  static std::size_t mirrored(std::int64_t i, std::int64_t n) {
    if (n == 1)
      return 0;
    i = i < 0 ? -i : i;
    return std::size_t(i < n ? i : 2 * (n - 1) - i);
  }

  /// turns n values into the coefficients of the spline through them, which is mirrored at both ends.
  void prefilter(std::size_t begin, std::size_t stride, std::size_t n) {
    if (n == 1)
      return;
    const double z = std::sqrt(3.0) - 2; // the pole
    line_.resize(n);
    for (std::size_t i = 0; i < n; ++i)
      line_[i] = 6 * double(c_[begin + i * stride]);
    double power = 1, start = 0;
    for (std::size_t i = 0; i < std::min<std::size_t>(n, 30); ++i, power *= z) // z³⁰ < 1e-17
      start += power * line_[i];
    line_[0] = start;
    for (std::size_t i = 1; i < n; ++i)
      line_[i] += z * line_[i - 1];
    line_[n - 1] = z / (z * z - 1) * (line_[n - 1] + z * line_[n - 2]);
    for (std::size_t i = n - 1; i-- > 0;)
      line_[i] = z * (line_[i + 1] - line_[i]);
    for (std::size_t i = 0; i < n; ++i)
      c_[begin + i * stride] = float(line_[i]);
  }

  Lattice_index index_;
  std::array<std::size_t, 3> size_;
  Voxels c_;
  std::vector<double> line_;
};

/// the smallest lattice with the given steps that holds the given one when moved, with a node where the first one's origin
/// would have one.
inline Lattice lattice_around_moved(const Lattice& lattice, const surfaces::Motion& motion,
                                    const std::array<Vector, 3>& steps) {
  const Lattice unbounded{lattice.origin, steps, {}};
  const Lattice_index index(unbounded);
  Point low{}, high{};
  for (int c = 0; c < 8; ++c) {
    const auto end = [&](std::size_t a) { return (c >> a & 1) != 0 ? double(lattice.size[a] - 1) : 0; };
    const Point x = index(motion(lattice.node(end(0), end(1), end(2))));
    for (std::size_t a = 0; a < 3; ++a) {
      low[a] = c == 0 ? std::floor(x[a]) : std::min(low[a], std::floor(x[a]));
      high[a] = c == 0 ? std::ceil(x[a]) : std::max(high[a], std::ceil(x[a]));
    }
  }
  Lattice around{unbounded.node(low[0], low[1], low[2]), steps, {}};
  for (std::size_t a = 0; a < 3; ++a)
    around.size[a] = std::size_t(high[a] - low[a]) + 1;
  return around;
}

/// the image, moved, on a lattice with the given steps; `outside` where it does not reach.
inline Image moved(const Image& image, const surfaces::Motion& motion, float outside,
                   const std::array<Vector, 3>& steps) {
  const Cubic_interpolation value(image);
  const Lattice_index index(image.lattice);
  Image result{lattice_around_moved(image.lattice, motion, steps), {}};
  const auto [nx, ny, nz] = result.lattice.size;
  result.voxels.reserve(nx * ny * nz);
  for (std::size_t k = 0; k < nz; ++k)
    for (std::size_t j = 0; j < ny; ++j)
      for (std::size_t i = 0; i < nx; ++i) {
        const Point p = motion.back(result.lattice.node(double(i), double(j), double(k))), x = index(p);
        bool inside = true;
        for (std::size_t a = 0; a < 3; ++a)
          inside = inside && x[a] > -0.5 && x[a] < double(image.lattice.size[a]) - 0.5;
        result.voxels.push_back(inside ? float(value(p)) : outside);
      }
  return result;
}

/// the image, moved; its lattice keeps the steps.
inline Image moved(const Image& image, const surfaces::Motion& motion, float outside) {
  return moved(image, motion, outside, image.lattice.step);
}

/// steps of another spacing in another order: the axes exchanged cyclically, one reversed, voxels of about the same volume.
inline std::array<Vector, 3> other_steps(const Lattice& lattice) {
  const auto& s = lattice.step;
  const auto scaled = [](double factor, const Vector& v) { return surfaces::along({0, 0, 0}, factor, v); };
  return {scaled(1.1, s[2]), scaled(-0.95, s[0]), scaled(1.05, s[1])};
}

/// the part of an image whose nodes have the indices [low, high) along an axis.
inline Image slab(const Image& image, std::size_t axis, std::size_t low, std::size_t high) {
  Image part{image.lattice, {}};
  std::array<std::size_t, 3> first{};
  first[axis] = low;
  part.lattice.origin = image.lattice.node(double(first[0]), double(first[1]), double(first[2]));
  part.lattice.size[axis] = high - low;
  const auto& n = image.lattice.size;
  const auto& m = part.lattice.size;
  part.voxels.reserve(m[0] * m[1] * m[2]);
  for (std::size_t k = 0; k < m[2]; ++k)
    for (std::size_t j = 0; j < m[1]; ++j)
      for (std::size_t i = 0; i < m[0]; ++i)
        part.voxels.push_back(image.voxels[first[0] + i + n[0] * (first[1] + j + n[1] * (first[2] + k))]);
  return part;
}

/// adds noise that is Gaussian but for its far tails: a sum of twelve uniform numbers, which is the same on all
/// platforms, as neither std's distributions nor logarithms and sines are.
inline void add_noise(Image& image, double deviation, unsigned seed) {
  std::mt19937 random(seed);
  for (float& voxel : image.voxels) {
    double sum = -6;
    for (int i = 0; i < 12; ++i)
      sum += double(random()) / 4294967295.0;
    voxel += float(deviation * sum);
  }
}

/// mean of the voxels above a value minus mean of those below.
inline double contrast(const Image& image, double iso) {
  double above = 0, below = 0;
  std::size_t n = 0;
  for (const float v : image.voxels) {
    (double(v) > iso ? above : below) += double(v);
    n += double(v) > iso;
  }
  return above / double(n) - below / double(image.voxels.size() - n);
}

} // namespace resampled_image

#endif // CGAL_EXTREMAL_MESH_3_TEST_RESAMPLED_IMAGE_H
