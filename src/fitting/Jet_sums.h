// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_FITTING_JET_SUMS_H
#define EXTREMAL_MESH_3_SRC_FITTING_JET_SUMS_H

#include <cstddef>

namespace CGAL::Extremal_mesh_3 {

constexpr std::size_t jet_degree = 4;
constexpr std::size_t jet_size = 15; ///< coefficients of a polynomial of degree 4 in x and y

/// where x^a y^b stands in a polynomial: by degree, then by the power of y.
constexpr std::size_t monomial(std::size_t a, std::size_t b) {
  return (a + b) * (a + b + 1) / 2 + b;
}

/// Neighbourhoods whose jets are computed at once, one in each lane of the processor's vectors. As many as a register
/// of AVX2 holds: with 8, which take two, compilers moved all through memory, and a jet took three times as long.
constexpr std::size_t lanes = 4;

/// A number in each lane, in GCC's and Clang's own type: it compiles for any processor, and always to the same
/// operations in the same order. Plain loops over the lanes were as slow.
using Wide = double __attribute__((vector_size(8 * lanes)));

/// A point of each neighbourhood. How a `Wide` is aligned depends on the processor that is compiled for.
struct alignas(8 * lanes) Wide_point {
  Wide x, y, z, weight;
};

/// What is computed of a batch.
struct alignas(8 * lanes) Jet_sums {
  Wide weight, weight2; ///< sums of the weights and of their squares
  Wide coefficients[jet_size];
  Wide least_pivot;                     ///< over the diagonal; 0 or less: the rest means nothing
  Wide inflation;                       ///< largest variance inflation of a coefficient
  Wide second_variance, third_variance; ///< of derivatives, with weights that are inverse variances
  Wide square;                          ///< weighted sum of the squares of the residuals
};

/// The same function, compiled for any processor, for those with AVX2 and for those with AVX-512, whose vectors are as wide but
/// twice as many. The results are equal to the last bit: there is no fused multiplication and addition in any.
void sum_up_anywhere(const Wide_point* points, std::size_t count, Jet_sums& sums);
void sum_up_with_avx2(const Wide_point* points, std::size_t count, Jet_sums& sums);
void sum_up_with_avx512(const Wide_point* points, std::size_t count, Jet_sums& sums);

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_FITTING_JET_SUMS_H
