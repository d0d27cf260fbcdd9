// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is compiled for several kinds of processors must be the same on each.
#include "../src/fitting/Jet_sums.h"
#include "../src/images/lanes.h"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <random>
#include <vector>

using namespace CGAL::Extremal_mesh_3;

namespace {

using Sum_up = void (*)(const Wide_point*, std::size_t, Jet_sums&);

void expect_the_same_bits_as_anywhere(Sum_up sum_up) {
  std::mt19937 random(1);
  const auto uniform = [&] { return double(random()) / 2147483648.0 - 1; };
  for (const std::size_t count : {1, 14, 15, 16, 19, 40, 300}) {
    std::vector<Wide_point> points(count);
    for (Wide_point& p : points)
      for (std::size_t l = 0; l < lanes; ++l) {
        p.x[l] = uniform();
        p.y[l] = l == 1 ? 0 : uniform(); // not determined in this lane
        p.z[l] = uniform();
        p.weight[l] = l == 2 ? 0 : 1 + uniform();
      }
    Jet_sums a, b;
    sum_up_anywhere(points.data(), count, a);
    sum_up(points.data(), count, b);
    for (std::size_t l = 0; l < lanes; ++l) {
      EXPECT_EQ(a.least_pivot[l] > 1e-11, count >= jet_size && (l == 0 || l == 3));
      if (!(a.least_pivot[l] > 1e-11))
        continue; // the rest means nothing, and signs of what is not a number may differ
      const auto expect_same = [&](const Wide& x, const Wide& y) {
        EXPECT_EQ(std::bit_cast<std::uint64_t>(double(x[l])), std::bit_cast<std::uint64_t>(double(y[l])));
      };
      for (std::size_t m = 0; m < jet_size; ++m)
        expect_same(a.coefficients[m], b.coefficients[m]);
      expect_same(a.inflation, b.inflation);
      expect_same(a.second_variance, b.second_variance);
      expect_same(a.third_variance, b.third_variance);
      expect_same(a.square, b.square);
      expect_same(a.weight2, b.weight2);
    }
  }
}

} // namespace

#ifdef __x86_64__

TEST(Jet_sums, are_the_same_bits_with_AVX2_as_without) {
  if (!__builtin_cpu_supports("avx2"))
    GTEST_SKIP() << "this processor has no AVX2";
  expect_the_same_bits_as_anywhere(sum_up_with_avx2);
}

TEST(Jet_sums, are_the_same_bits_with_AVX_512_as_without) {
  if (!internal::has_avx512())
    GTEST_SKIP() << "this processor has no AVX-512";
  expect_the_same_bits_as_anywhere(sum_up_with_avx512);
}

#endif
