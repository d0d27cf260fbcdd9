// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Quadratic_model.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <algorithm>

namespace CGAL::Extremal_mesh_3 {

namespace {

using Row = Eigen::Matrix<double, 6, 1>;

Row monomials(Complex z) {
  const double x = z.real(), y = z.imag();
  Row row;
  row << 1, x, y, x * x, x * y, y * y;
  return row;
}

} // namespace

Quadratic_model::Quadratic_model(const Flat_cell& flat) : scale_(flat.points.radius) {
  // Coordinates of size 1 keep the normal equations well enough conditioned.
  const auto& points = flat.points.z;
  Eigen::Matrix<double, 6, 6> A = Eigen::Matrix<double, 6, 6>::Zero();
  Eigen::Matrix<double, 6, 4> b = Eigen::Matrix<double, 6, 4>::Zero();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Row row = monomials(points[i] / scale_);
    A += row * row.transpose();
    b += row * Eigen::RowVector4d(flat.P[i].real(), flat.P[i].imag(), flat.Q[i].real(), flat.Q[i].imag());
  }
  const Eigen::Matrix<double, 6, 4> c = A.ldlt().solve(b);
  for (Eigen::Index k = 0; k < 6; ++k) {
    P_.c[std::size_t(k)] = {c(k, 0), c(k, 1)};
    Q_.c[std::size_t(k)] = {c(k, 2), c(k, 3)};
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    P_.residual = std::max(P_.residual, std::abs(flat.P[i] - P_(points[i] / scale_)));
    Q_.residual = std::max(Q_.residual, std::abs(flat.Q[i] - Q_(points[i] / scale_)));
  }
}

Quadratic_model::Slopes Quadratic_model::slopes(Complex z) const {
  // φ = Im(2 log P + log Q)
  Slopes s{};
  const auto add = [&](const Quadratic_field& F, double factor) {
    const Complex value = F(z), x = F.dx(z) / value, y = F.dy(z) / value;
    s.x += factor * x.imag();
    s.y += factor * y.imag();
    s.xx += factor * (2.0 * F.c[3] / value - x * x).imag();
    s.xy += factor * (F.c[4] / value - x * y).imag();
    s.yy += factor * (2.0 * F.c[5] / value - y * y).imag();
  };
  add(P_, 2);
  add(Q_, 1);
  return s;
}

} // namespace CGAL::Extremal_mesh_3
