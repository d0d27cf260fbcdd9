// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What simplification is for: two images of the same thing, moved and with noise, have the same simplified extremal mesh.
#include <CGAL/Extremal_mesh_3/Image_function.h>
#include <CGAL/Extremal_mesh_3/simplify.h>

#include "correspondence.h"
#include "graph_comparison.h"
#include "resampled_image.h"
#include "surfaces.h"

using namespace CGAL::Extremal_mesh_3;

namespace {

/// 1 − x² − 2y² − 4z² on 64³ voxels.
Image ellipsoid(double step) {
  Image image{{{-31.5 * step, -31.5 * step, -31.5 * step}, {{{step, 0, 0}, {0, step, 0}, {0, 0, step}}}, {64, 64, 64}},
              {}};
  for (std::size_t k = 0; k < 64; ++k)
    for (std::size_t j = 0; j < 64; ++j)
      for (std::size_t i = 0; i < 64; ++i) {
        const Point p = image.lattice.node(double(i), double(j), double(k));
        image.voxels.push_back(float(1 - p[0] * p[0] - 2 * p[1] * p[1] - 4 * p[2] * p[2]));
      }
  return image;
}

Simplification simplification_of(Image&& image, double sigma) {
  Image_function_options options;
  options.sigma = sigma;
  const Image_function f(std::move(image), options);
  return Simplification(extract_extremal_mesh(f, f.lattice()).mesh);
}

class Stability : public testing::TestWithParam<unsigned> {};

} // namespace

TEST_P(Stability, of_the_graph_that_persists) {
  const double step = 2.4 / 63;
  surfaces::Motion motion = surfaces::random_motion(GetParam(), 0.3);
  Image first = ellipsoid(step), second = resampled_image::moved(first, motion, -10);
  resampled_image::add_noise(first, 0.015, 2 * GetParam());
  resampled_image::add_noise(second, 0.015, 2 * GetParam() + 1);
  const Simplification a = simplification_of(std::move(first), 2 * step),
                       b = simplification_of(std::move(second), 2 * step);
  const correspondence::Way there{motion, [](const Point&) { return true; }};
  const auto share = [&](std::size_t level_a, std::size_t level_b) {
    const Extremal_mesh mesh_a = a.mesh_at(level_a), mesh_b = b.mesh_at(level_b);
    const correspondence::Neighbourhoods near_b(mesh_b, 2 * step);
    return correspondence::shares(mesh_a, near_b, there);
  };
  EXPECT_GT(a.mesh_at(0).number_of_vertices(), 50U);
  EXPECT_FALSE(graph_comparison::isomorphic(a.mesh_at(0), b.mesh_at(0)));
  EXPECT_TRUE(graph_comparison::isomorphic(a.mesh_at(a.level_at_gap()), b.mesh_at(b.level_at_gap())));
  // Extremal points, and lines through them, may still be found elsewhere: k_j hardly changes around its flat extrema.
  const auto after = share(a.level_at_gap(), b.level_at_gap());
  EXPECT_EQ(after[correspondence::vertices].all, 10);
  EXPECT_EQ(after[correspondence::umbilics_1].matched, 4);
}

INSTANTIATE_TEST_SUITE_P(Seeds, Stability, testing::Range(1U, 5U));
