// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Extremal_mesh_3/Similarity.h>

#include "../differential/vector.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace CGAL::Extremal_mesh_3 {

namespace {

double determinant(const std::array<Vector, 3>& m) {
  return dot(m[0], cross(m[1], m[2]));
}

std::array<Vector, 3> transposed(const std::array<Vector, 3>& m) {
  return {Vector{m[0][0], m[1][0], m[2][0]}, Vector{m[0][1], m[1][1], m[2][1]}, Vector{m[0][2], m[1][2], m[2][2]}};
}

} // namespace

Vector Similarity::turned(const Vector& v) const {
  return {dot(rotation[0], v), dot(rotation[1], v), dot(rotation[2], v)};
}

Point Similarity::operator()(const Point& x) const {
  return scale * turned(x) + translation;
}

bool Similarity::mirrors() const {
  return determinant(rotation) < 0;
}

Similarity Similarity::inverse() const {
  Similarity result{transposed(rotation), {0, 0, 0}, 1 / scale};
  result.translation = -(1 / scale * result.turned(translation));
  return result;
}

std::array<std::array<double, 4>, 4> Similarity::matrix() const {
  std::array<std::array<double, 4>, 4> m{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j)
      m[i][j] = scale * rotation[i][j];
    m[i][3] = translation[i];
  }
  m[3][3] = 1;
  return m;
}

Similarity operator*(const Similarity& a, const Similarity& b) {
  Similarity result;
  const std::array<Vector, 3> columns = transposed(b.rotation);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      result.rotation[i][j] = dot(a.rotation[i], columns[j]);
  result.scale = a.scale * b.scale;
  result.translation = a(b.translation);
  return result;
}

double rotation_angle(const Similarity& s) {
  const auto& r = s.rotation;
  const double sign = s.mirrors() ? -1 : 1;
  // The sine is exact for small angles, where the cosine is not.
  const Vector axis{r[2][1] - r[1][2], r[0][2] - r[2][0], r[1][0] - r[0][1]};
  return std::atan2(norm(axis) / 2, (sign * (r[0][0] + r[1][1] + r[2][2]) - 1) / 2);
}

Similarity similarity_of_matrix(const std::array<std::array<double, 4>, 4>& m) {
  for (const auto& row : m)
    for (const double x : row)
      if (!std::isfinite(x))
        throw std::invalid_argument("the matrix has an entry that is not finite");
  constexpr double accuracy = 1e-6;
  if (std::max({std::abs(m[3][0]), std::abs(m[3][1]), std::abs(m[3][2]), std::abs(m[3][3] - 1)}) > accuracy)
    throw std::invalid_argument("the last row of the matrix is not 0 0 0 1");
  Similarity s;
  for (std::size_t i = 0; i < 3; ++i) {
    s.rotation[i] = {m[i][0], m[i][1], m[i][2]};
    s.translation[i] = m[i][3];
  }
  s.scale = std::cbrt(std::abs(determinant(s.rotation)));
  if (!(s.scale > 0))
    throw std::invalid_argument("the determinant of the matrix is 0");
  for (Vector& row : s.rotation)
    row = 1 / s.scale * row;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = i; j < 3; ++j)
      if (std::abs(dot(s.rotation[i], s.rotation[j]) - (i == j ? 1 : 0)) > accuracy)
        throw std::invalid_argument(
            fmt::format("rows {} and {} of the matrix are not those of a rotation times a scale", i + 1, j + 1));
  return s;
}

} // namespace CGAL::Extremal_mesh_3
