// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a cell's model of Q, A1 and A3 is made of: how these change in the tangent plane of its middle.
#include "../src/differential/vector.h"
#include "../src/extraction/Flat_cell.h"
#include "../src/extraction/Implicit_surface.h"

#include "random_surfaces.h"

#include <gtest/gtest.h>

namespace {

using namespace CGAL::Extremal_mesh_3;

class Laid_flat : public testing::TestWithParam<unsigned> {};

TEST_P(Laid_flat, derivatives_are_those_of_what_is_laid_flat) {
  const auto f = random_surfaces::ellipsoid(GetParam());
  const Implicit_surface surface(f);
  random_surfaces::Random random(GetParam() + 1000);
  const Vector d = normalized({random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)});
  const auto middle = surface.sample(0.7 * d, d, 0.7, Surface::to_place, Detail::fourth_order);
  ASSERT_TRUE(middle);
  const Vector n = middle->shape.n, u = middle->shape.u, v = middle->shape.v();
  const double x = random.uniform(-0.15, 0.15), y = random.uniform(-0.15, 0.15);
  const auto above = [&](double dx, double dy) {
    const auto s =
        surface.sample(middle->p + (x + dx) * u + (y + dy) * v, n, 0.5, Surface::to_place, Detail::fourth_order);
    if (!s)
      throw std::runtime_error("no surface there");
    return laid_flat(*s, *middle);
  };
  constexpr double h = 1e-4;
  const Flat_shape here = above(0, 0), left = above(-h, 0), right = above(h, 0), below = above(0, -h),
                   over = above(0, h);
  const auto expect = [&](Flat_value Flat_shape::*field, const char* name) {
    const double size = std::abs((here.*field).f) + std::abs((here.*field).x) + std::abs((here.*field).y);
    EXPECT_LT(std::abs(((right.*field).f - (left.*field).f) / (2 * h) - (here.*field).x), 1e-5 * size) << name;
    EXPECT_LT(std::abs(((over.*field).f - (below.*field).f) / (2 * h) - (here.*field).y), 1e-5 * size) << name;
  };
  expect(&Flat_shape::Q, "Q");
  expect(&Flat_shape::A1, "A1");
  expect(&Flat_shape::A3, "A3");
}

INSTANTIATE_TEST_SUITE_P(random_surfaces, Laid_flat, testing::Range(1U, 21U));

} // namespace
