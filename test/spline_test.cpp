// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../src/images/spline.h"

#include <gtest/gtest.h>

#include <random>

using namespace CGAL::Extremal_mesh_3;

namespace {

Spline_volume random_volume() {
  Spline_volume volume{{}, {17, 13, 11}};
  std::mt19937 random(1);
  for (std::size_t i = 0; i < 17 * 13 * 11; ++i)
    volume.coefficients.push_back(float(random() % 20001) / 7 - 1000);
  return volume;
}

/// at points inside, at and beyond the border.
template <class Evaluate> void expect_the_same_bits(const Evaluate& expect) {
  const Spline_volume volume = random_volume();
  std::mt19937 random(2);
  const auto coordinate = [&](double n) { return (double(random()) / 4294967296.0) * (n + 8) - 4; };
  for (int i = 0; i < 2000; ++i)
    expect(volume, Point{coordinate(17), coordinate(13), coordinate(11)});
}

template <int Order> void expect_equal(const Partials& a, const Partials& b) {
  for (std::size_t x = 0; x <= Order; ++x)
    for (std::size_t y = 0; x + y <= Order; ++y)
      for (std::size_t z = 0; x + y + z <= Order; ++z)
        EXPECT_EQ(a[x][y][z], b[x][y][z]) << x << y << z;
}

#ifdef __x86_64__

template <int Degree, int Order> void expect_that_avx2_gives_the_same_bits() {
  expect_the_same_bits([](const Spline_volume& volume, const Point& p) {
    Partials plain, wide;
    internal::evaluate_spline_here<Degree, Order>(volume, p, plain);
    internal::on_avx2([&]() __attribute__((always_inline)) {
      internal::evaluate_spline_here<Degree, Order>(volume, p, wide);
    });
    expect_equal<Order>(plain, wide);
  });
}

template <int Degree, int Order> void expect_that_avx512_gives_the_same_bits() {
  expect_the_same_bits([](const Spline_volume& volume, const Point& p) {
    Partials plain, wide;
    internal::evaluate_spline_here<Degree, Order>(volume, p, plain);
    internal::on_avx512([&]() __attribute__((always_inline)) {
      internal::evaluate_spline_here<Degree, Order>(volume, p, wide);
    });
    expect_equal<Order>(plain, wide);
  });
}

TEST(Spline, avx2_gives_the_bits_of_any_processor) {
  if (!__builtin_cpu_supports("avx2"))
    GTEST_SKIP() << "this processor has no AVX2";
  expect_that_avx2_gives_the_same_bits<5, 0>();
  expect_that_avx2_gives_the_same_bits<5, 3>();
  expect_that_avx2_gives_the_same_bits<5, 4>();
  expect_that_avx2_gives_the_same_bits<7, 1>();
  expect_that_avx2_gives_the_same_bits<7, 4>();
}

TEST(Spline, avx512_gives_the_bits_of_any_processor) {
  if (!internal::has_avx512())
    GTEST_SKIP() << "this processor has no AVX-512";
  expect_that_avx512_gives_the_same_bits<5, 0>();
  expect_that_avx512_gives_the_same_bits<5, 3>();
  expect_that_avx512_gives_the_same_bits<5, 4>();
  expect_that_avx512_gives_the_same_bits<7, 1>();
  expect_that_avx512_gives_the_same_bits<7, 4>();
}

#endif

} // namespace
