// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Least squares by normal equations. The entries of the matrix are moments Σ w x^a y^b, of which there are 45: far
// fewer operations than an orthogonal factorisation. What is lost in accuracy does not matter here: with coordinates
// below 1 and the diagonal scaled to 1 the condition of the matrix is about 1e4 to 1e6.
//
// Included where it is compiled for one kind of processor. All of it is local to there, and calls nothing of the
// standard library: a function that the linker takes for another file's may have instructions which the machine does
// not have.
#include "Jet_sums.h"

namespace CGAL::Extremal_mesh_3 {

namespace {

inline constexpr std::size_t moments = monomial(0, 2 * jet_degree) + 1;
constexpr std::size_t triangle(std::size_t i, std::size_t j) {
  return i * (i + 1) / 2 + j;
} // j ≤ i
inline constexpr std::size_t triangle_size = triangle(jet_size, 0);

/// the power of y in the monomial i, and its degree.
constexpr std::size_t degree(std::size_t i) {
  std::size_t d = 0;
  while (monomial(0, d) < i)
    ++d;
  return d;
}
constexpr std::size_t power_of_y(std::size_t i) {
  return i - monomial(degree(i), 0);
}

/// Which moment each entry of the matrix is.
struct Entries {
  unsigned char moment[triangle_size]{};
  constexpr Entries() {
    for (std::size_t i = 0; i < jet_size; ++i)
      for (std::size_t j = 0; j <= i; ++j) {
        const std::size_t b = power_of_y(i) + power_of_y(j);
        moment[triangle(i, j)] = static_cast<unsigned char>(monomial(degree(i) + degree(j) - b, b));
      }
  }
};
inline constexpr Entries entries;

#define INLINED inline __attribute__((always_inline))

/// the products s x^a y^b up to a degree.
template <std::size_t Degree> INLINED void multiply_out(const Wide& s, const Wide& x, const Wide& y, Wide* out) {
  out[0] = s;
#pragma GCC unroll 8
  for (std::size_t d = 1; d <= Degree; ++d) {
    const std::size_t to = d * (d + 1) / 2, from = to - d;
#pragma GCC unroll 8
    for (std::size_t i = 0; i < d; ++i)
      out[to + i] = out[from + i] * x;
    out[to + d] = out[to - 1] * y;
  }
}

class Least_squares {
  struct Term {
    std::size_t i, j;
    double factor;
  };

public:
  INLINED void sum_moments(const Wide_point* points, std::size_t count, Jet_sums& sums) {
    for (Wide& m : moment_)
      m = Wide{};
    for (Wide& r : right_)
      r = Wide{};
    Wide weight2{};
    for (std::size_t k = 0; k < count; ++k) {
      const Wide_point& p = points[k];
      Wide product[moments];
      multiply_out<2 * jet_degree>(p.weight, p.x, p.y, product);
#pragma GCC unroll 45
      for (std::size_t m = 0; m < moments; ++m)
        moment_[m] += product[m];
#pragma GCC unroll 15
      for (std::size_t m = 0; m < jet_size; ++m)
        right_[m] += product[m] * p.z;
      weight2 += p.weight * p.weight;
    }
    sums.weight = moment_[0];
    sums.weight2 = weight2;
  }

  /// finds L and D, L unit lower triangular, D diagonal, with L D Lᵀ the matrix; then L⁻¹ in the place of L.
  INLINED void factorise(Jet_sums& sums) {
    sums.least_pivot = Wide{} + 1;
    for (std::size_t i = 0; i < jet_size; ++i) {
      Wide row[jet_size]; // of L D
      for (std::size_t j = 0; j < i; ++j) {
        Wide sum = entry(i, j);
        for (std::size_t k = 0; k < j; ++k)
          sum -= row[k] * factor_[triangle(j, k)];
        row[j] = sum;
      }
      Wide pivot = entry(i, i);
      for (std::size_t j = 0; j < i; ++j) {
        factor_[triangle(i, j)] = row[j] * inverse_[j];
        pivot -= row[j] * factor_[triangle(i, j)];
      }
      const Wide part = pivot / entry(i, i); // not a number if the diagonal is 0, and all others then
      sums.least_pivot = ((part < sums.least_pivot) | (part != part)) ? part : sums.least_pivot;
      inverse_[i] = 1 / pivot;
    }
    for (std::size_t j = 0; j < jet_size; ++j)
      for (std::size_t i = j + 1; i < jet_size; ++i) {
        Wide sum = factor_[triangle(i, j)];
        for (std::size_t k = j + 1; k < i; ++k)
          sum += factor_[triangle(i, k)] * factor_[triangle(k, j)];
        // Row i of L is still needed to the right of this entry, column j above it no more.
        factor_[triangle(i, j)] = -sum;
      }
  }

  INLINED void solve(Jet_sums& sums) {
    Wide y[jet_size]; // D⁻¹ L⁻¹ right
    for (std::size_t i = 0; i < jet_size; ++i) {
      Wide sum = right_[i];
      for (std::size_t k = 0; k < i; ++k)
        sum += factor_[triangle(i, k)] * right_[k];
      y[i] = sum * inverse_[i];
    }
    sums.inflation = Wide{};
    for (std::size_t i = 0; i < jet_size; ++i) {
      Wide sum = y[i];
      for (std::size_t k = i + 1; k < jet_size; ++k)
        sum += factor_[triangle(k, i)] * y[k];
      sums.coefficients[i] = sum;
      Wide inflation{};
      add_covariance({i, i, 1}, inflation);
      inflation *= entry(i, i);
      sums.inflation = inflation > sums.inflation ? inflation : sums.inflation;
    }
    // The means over θ of the squares of D(t, t) and D(t, t, t), with t = (cos θ, sin θ) and D the derivatives, 2 and
    // 6 times the coefficients times powers of cos θ and sin θ. The means of the products of these are 3/8 and 1/8,
    // 5/16 and 1/16.
    constexpr Term second[]{{3, 3, 1.5}, {5, 5, 1.5}, {4, 4, 0.5}, {3, 5, 1}};
    constexpr Term third[]{{6, 6, 11.25}, {9, 9, 11.25}, {7, 7, 2.25}, {8, 8, 2.25}, {6, 8, 4.5}, {7, 9, 4.5}};
    sums.second_variance = sums.third_variance = Wide{};
    for (const Term& t : second)
      add_covariance(t, sums.second_variance);
    for (const Term& t : third)
      add_covariance(t, sums.third_variance);
  }

private:
  INLINED const Wide& entry(std::size_t i, std::size_t j) const {
    return moment_[entries.moment[triangle(i, j)]];
  }

  /// adds a multiple of the covariance of the coefficients i ≤ j, an entry of the inverse of the matrix.
  INLINED void add_covariance(const Term& t, Wide& to) const {
    const std::size_t i = t.i, j = t.j;
    Wide sum = i == j ? inverse_[j] : factor_[triangle(j, i)] * inverse_[j];
    for (std::size_t k = j + 1; k < jet_size; ++k)
      sum += factor_[triangle(k, i)] * factor_[triangle(k, j)] * inverse_[k];
    to += t.factor * sum;
  }

  Wide moment_[moments], right_[jet_size];
  Wide factor_[triangle_size]; ///< its diagonal, all 1, is not used
  Wide inverse_[jet_size];     ///< of D
};

/// Σ w (z − jet)²
INLINED void sum_residuals(const Wide_point* points, std::size_t count, Jet_sums& sums) {
  const Wide one = Wide{} + 1;
  Wide square{};
  for (std::size_t k = 0; k < count; ++k) {
    const Wide_point& p = points[k];
    Wide power[jet_size];
    multiply_out<jet_degree>(one, p.x, p.y, power);
    Wide residual = p.z;
#pragma GCC unroll 15
    for (std::size_t m = 0; m < jet_size; ++m)
      residual -= sums.coefficients[m] * power[m];
    square += p.weight * residual * residual;
  }
  sums.square = square;
}

INLINED void sum_up(const Wide_point* points, std::size_t count, Jet_sums& sums) {
  Least_squares s;
  s.sum_moments(points, count, sums);
  s.factorise(sums);
  s.solve(sums);
  sum_residuals(points, count, sums);
}

#undef INLINED

} // namespace

} // namespace CGAL::Extremal_mesh_3
