// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bernstein's coefficients on [s, t] are values of the polar form: with j of the n arguments t and the others s.
// L. Ramshaw, "Blossoms are polar forms", Computer Aided Geometric Design 6 (1989).
#include "spline_bounds.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL::Extremal_mesh_3 {

namespace {

/// What rounding makes of sums of products with weights that add up to 1: relative to the largest coefficient.
constexpr double rounding = 1e-13;
/// A box that ends so little beyond a cell ends with it: polynomials of neighbouring cells are equal there to rounding.
constexpr double overlap = 1e-9;

/// The node before the first coefficient around cell `cell` is `cell - before`; there are degree + 1.
template <int Degree> constexpr int before = (Degree - 1) / 2;

struct Range {
  double low = std::numeric_limits<double>::infinity(), high = -std::numeric_limits<double>::infinity();
  void add(double x) {
    low = std::min(low, x);
    high = std::max(high, x);
  }
  Interval widened(double scale, double by) const { return {scale * low - by, scale * high + by}; }
};

/// The weights of the coefficients around a cell in the Bernstein coefficients on the part [s, t] of it.
template <int Degree> using Bernstein_weights = std::array<std::array<double, Degree + 1>, Degree + 1>;

template <int Degree> Bernstein_weights<Degree> bernstein_weights(double s, double t) {
  Bernstein_weights<Degree> weights;
  for (int j = 0; j <= Degree; ++j)
    for (int l = 0; l <= Degree; ++l) {
      std::array<double, Degree + 1> d{};
      d[std::size_t(l)] = 1;
      for (int r = 1; r <= Degree; ++r) { // de Boor's recursion, with an argument of its own in each round
        const double u = r <= j ? t : s;
        for (int i = Degree; i >= r; --i) {
          const double a = (u - double(i - Degree)) / double(Degree + 1 - r);
          d[std::size_t(i)] = (1 - a) * d[std::size_t(i - 1)] + a * d[std::size_t(i)];
        }
      }
      weights[std::size_t(j)][std::size_t(l)] = d[Degree];
    }
  return weights;
}

template <int Degree> Spline_bounds within_cell(const Spline_volume& volume, const Point& cell, const Box_3& part) {
  constexpr std::size_t n = Degree + 1;
  using Cube = std::array<std::array<std::array<double, n>, n>, n>;
  std::array<std::array<std::size_t, n>, 3> node;
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t l = 0; l < n; ++l)
      node[a][l] = std::size_t(std::clamp(cell[a] + double(l) - before<Degree>, 0.0, double(volume.size[a] - 1)));
  Cube b;
  double largest = 0;
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t i = 0; i < n; ++i) {
        b[k][j][i] =
            double(volume.coefficients[node[0][i] + volume.size[0] * (node[1][j] + volume.size[1] * node[2][k])]);
        largest = std::max(largest, std::abs(b[k][j][i]));
      }
  // Along each axis in turn, which each round moves to the end.
  for (int axis = 2; axis >= 0; --axis) {
    const auto w = bernstein_weights<Degree>(part.low[std::size_t(axis)], part.high[std::size_t(axis)]);
    Cube next;
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t j = 0; j < n; ++j)
        for (std::size_t i = 0; i < n; ++i) {
          double sum = 0;
          for (std::size_t l = 0; l < n; ++l)
            sum += w[i][l] * b[l][k][j];
          next[k][j][i] = sum;
        }
    b = next;
  }
  // Each round: [l][k][j] → [k][j][i], i from l. After z, y, x the indices are z, y, x again.
  Range value;
  std::array<Range, 3> difference;
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t i = 0; i < n; ++i) {
        value.add(b[k][j][i]);
        if (i > 0)
          difference[0].add(b[k][j][i] - b[k][j][i - 1]);
        if (j > 0)
          difference[1].add(b[k][j][i] - b[k][j - 1][i]);
        if (k > 0)
          difference[2].add(b[k][j][i] - b[k - 1][j][i]);
      }
  Spline_bounds bounds;
  bounds.value = value.widened(1, rounding * largest);
  for (std::size_t a = 0; a < 3; ++a) {
    const double scale = Degree / (part.high[a] - part.low[a]);
    bounds.gradient[a] = difference[a].widened(scale, 2 * scale * rounding * largest);
  }
  return bounds;
}

/// \param first,last  the cells along each axis
template <int Degree> Spline_bounds over_cells(const Spline_volume& volume, const Point& first, const Point& last) {
  std::array<std::vector<std::size_t>, 3> node;
  for (std::size_t a = 0; a < 3; ++a)
    for (double x = first[a] - before<Degree>; x <= last[a] + Degree - before<Degree>; ++x)
      node[a].push_back(std::size_t(std::clamp(x, 0.0, double(volume.size[a] - 1))));
  Range value;
  std::array<Range, 3> difference;
  const auto at = [&](std::size_t i, std::size_t j, std::size_t k) {
    return double(volume.coefficients[node[0][i] + volume.size[0] * (node[1][j] + volume.size[1] * node[2][k])]);
  };
  for (std::size_t k = 0; k < node[2].size(); ++k)
    for (std::size_t j = 0; j < node[1].size(); ++j)
      for (std::size_t i = 0; i < node[0].size(); ++i) {
        const double c = at(i, j, k);
        value.add(c);
        if (i > 0)
          difference[0].add(c - at(i - 1, j, k));
        if (j > 0)
          difference[1].add(c - at(i, j - 1, k));
        if (k > 0)
          difference[2].add(c - at(i, j, k - 1));
      }
  const double by = rounding * std::max(std::abs(value.low), std::abs(value.high));
  return {value.widened(1, by),
          {difference[0].widened(1, by), difference[1].widened(1, by), difference[2].widened(1, by)}};
}

template <int Degree> Spline_bounds bound(const Spline_volume& volume, const Box_3& box) {
  Point first, last;
  Box_3 part;
  bool is_within = true;
  for (std::size_t a = 0; a < 3; ++a) {
    // Farther out the spline is constant.
    const double n = double(volume.size[a]) + Degree;
    const double low = std::clamp(box.low[a], -n, n), high = std::clamp(box.high[a], -n, n);
    first[a] = std::floor(low + overlap);
    last[a] = std::max(first[a], std::ceil(high - overlap) - 1);
    is_within = is_within && first[a] == last[a];
    part.low[a] = low - first[a];
    part.high[a] = std::max(high - first[a], part.low[a] + overlap); // not so flat that differences are lost
  }
  return is_within ? within_cell<Degree>(volume, first, part) : over_cells<Degree>(volume, first, last);
}

} // namespace

Spline_bounds bound_spline(const Spline_volume& volume, int degree, const Box_3& box) {
  return degree == 5 ? bound<5>(volume, box) : bound<7>(volume, box);
}

} // namespace CGAL::Extremal_mesh_3
