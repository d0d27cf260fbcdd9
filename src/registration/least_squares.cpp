// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "least_squares.h"

#include "../differential/vector.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace CGAL::Extremal_mesh_3 {

namespace {

/// A symmetric matrix diagonalised by Jacobi's rotations.
template <std::size_t n> struct Eigensystem {
  std::array<double, n> values{};
  std::array<std::array<double, n>, n> vectors{}; ///< columns

  explicit Eigensystem(std::array<std::array<double, n>, n> a) {
    for (std::size_t i = 0; i < n; ++i)
      vectors[i][i] = 1;
    bool changed = true;
    for (int sweep = 0; changed && sweep < 30; ++sweep) { // it converges quadratically: about 5 are needed
      changed = false;
      for (std::size_t p = 0; p < n; ++p)
        for (std::size_t q = p + 1; q < n; ++q)
          if (std::abs(a[p][q]) > 1e-17 * (std::abs(a[p][p]) + std::abs(a[q][q]))) {
            rotate(a, p, q);
            changed = true;
          }
    }
    for (std::size_t i = 0; i < n; ++i)
      values[i] = a[i][i];
  }
  std::size_t greatest() const { return std::size_t(std::max_element(values.begin(), values.end()) - values.begin()); }

private:
  void rotate(std::array<std::array<double, n>, n>& a, std::size_t p, std::size_t q) {
    const double theta = (a[q][q] - a[p][p]) / (2 * a[p][q]);
    const double t = (theta < 0 ? -1 : 1) / (std::abs(theta) + std::hypot(theta, 1));
    const double c = 1 / std::hypot(t, 1), s = t * c;
    for (std::size_t k = 0; k < n; ++k) {
      const double x = a[k][p], y = a[k][q];
      a[k][p] = c * x - s * y;
      a[k][q] = s * x + c * y;
    }
    for (std::size_t k = 0; k < n; ++k) {
      const double x = a[p][k], y = a[q][k];
      a[p][k] = c * x - s * y;
      a[q][k] = s * x + c * y;
      const double v = vectors[k][p], w = vectors[k][q];
      vectors[k][p] = c * v - s * w;
      vectors[k][q] = s * v + c * w;
    }
  }
};

/// of a unit quaternion.
std::array<Vector, 3> rotation_of(double w, double x, double y, double z) {
  return {Vector{w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)},
          Vector{2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)},
          Vector{2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z}};
}

} // namespace

void Normal_equations::add(const Unknowns& derivative, double residual, double weight) {
  for (std::size_t i = 0; i < unknowns; ++i) {
    for (std::size_t j = 0; j < unknowns; ++j)
      matrix[i][j] += weight * derivative[i] * derivative[j];
    right[i] -= weight * derivative[i] * residual;
  }
}

void Normal_equations::hold(std::size_t unknown) {
  for (std::size_t i = 0; i < unknowns; ++i)
    matrix[i][unknown] = matrix[unknown][i] = 0;
  matrix[unknown][unknown] = 1;
  right[unknown] = 0;
}

std::optional<Square_matrix> Normal_equations::inverse() const {
  // by Cholesky's L Lᵀ; an unknown of which nothing is known makes a pivot that is only rounding
  Square_matrix l{}, result{};
  for (std::size_t j = 0; j < unknowns; ++j)
    for (std::size_t i = j; i < unknowns; ++i) {
      double sum = matrix[i][j];
      for (std::size_t k = 0; k < j; ++k)
        sum -= l[i][k] * l[j][k];
      if (i == j) {
        if (!(sum > 1e-12 * matrix[j][j]))
          return std::nullopt;
        l[j][j] = std::sqrt(sum);
      } else {
        l[i][j] = sum / l[j][j];
      }
    }
  for (std::size_t column = 0; column < unknowns; ++column) {
    Unknowns y{};
    for (std::size_t i = 0; i < unknowns; ++i) {
      double sum = i == column ? 1 : 0;
      for (std::size_t k = 0; k < i; ++k)
        sum -= l[i][k] * y[k];
      y[i] = sum / l[i][i];
    }
    for (std::size_t i = unknowns; i-- > 0;) {
      double sum = y[i];
      for (std::size_t k = i + 1; k < unknowns; ++k)
        sum -= l[k][i] * result[k][column];
      result[i][column] = sum / l[i][i];
    }
  }
  return result;
}

Unknowns operator*(const Square_matrix& m, const Unknowns& v) {
  Unknowns result{};
  for (std::size_t i = 0; i < unknowns; ++i)
    for (std::size_t j = 0; j < unknowns; ++j)
      result[i] += m[i][j] * v[j];
  return result;
}

std::array<Vector, 3> nearest_rotation(const std::array<Vector, 3>& m) {
  // m[i][j] is Horn's S_ji: his vectors are taken from the left to the right system
  const double xx = m[0][0], xy = m[1][0], xz = m[2][0], yx = m[0][1], yy = m[1][1], yz = m[2][1], zx = m[0][2],
               zy = m[1][2], zz = m[2][2];
  const Eigensystem<4> e({{{xx + yy + zz, yz - zy, zx - xz, xy - yx},
                           {yz - zy, xx - yy - zz, xy + yx, zx + xz},
                           {zx - xz, xy + yx, yy - xx - zz, yz + zy},
                           {xy - yx, zx + xz, yz + zy, zz - xx - yy}}});
  const std::size_t i = e.greatest();
  return rotation_of(e.vectors[0][i], e.vectors[1][i], e.vectors[2][i], e.vectors[3][i]);
}

std::array<Vector, 3> uniform_rotation(std::size_t i, std::size_t n) {
  const double s = double(i) + 0.5, t = s / double(n);
  const double alpha = 2 * std::numbers::pi * s / std::numbers::sqrt2,
               beta = 2 * std::numbers::pi * s / 1.533751168755204;
  const double near = std::sqrt(t), far = std::sqrt(1 - t);
  return rotation_of(far * std::cos(beta), near * std::sin(alpha), near * std::cos(alpha), far * std::sin(beta));
}

std::array<Vector, 3> rotation_by(const Vector& turn) {
  const double angle = norm(turn);
  const double s = angle > 0 ? std::sin(angle / 2) / angle : 0.5, w = std::cos(angle / 2);
  return rotation_of(w, s * turn[0], s * turn[1], s * turn[2]);
}

} // namespace CGAL::Extremal_mesh_3
