// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// 200 random surfaces, a quarter of each kind: ellipsoids and tori with random polynomial terms, and with random bumps.
// At two resolutions every identity holds and the graphs are isomorphic.
#include "graph_comparison.h"
#include "random_surfaces.h"
#include "repetitions.h"

#include <memory>

using namespace CGAL::Extremal_mesh_3;

namespace {

constexpr unsigned surfaces_in_a_test = 20;

/// The sum of six bumps a exp(−s |x − c|²).
struct Bumps {
  struct Bump {
    double x, y, z, height, narrow;
  };
  std::array<Bump, 6> bumps;

  Bumps(random_surfaces::Random& random, double size) {
    for (Bump& b : bumps) {
      b.x = random.uniform(-1, 1);
      b.y = random.uniform(-1, 1);
      b.z = random.uniform(-1, 1);
      b.height = random.uniform(-size, size);
      b.narrow = random.uniform(2, 6);
    }
  }
  template <class T> T operator()(const T& x, const T& y, const T& z) const {
    using std::exp;
    T sum(0.0);
    for (const Bump& b : bumps)
      sum = sum + b.height * exp(-b.narrow * ((x - b.x) * (x - b.x) + (y - b.y) * (y - b.y) + (z - b.z) * (z - b.z)));
    return sum;
  }
};

struct Surface {
  std::unique_ptr<Function_3> f;
  double half_size; ///< of a cube that holds it
};

template <class Functor> Surface make(const Functor& f, double half_size) {
  auto function = make_function(f);
  return {std::make_unique<decltype(function)>(function), half_size};
}

Surface surface(unsigned seed) {
  random_surfaces::Random random(seed * 7919U);
  const double b = random.uniform(1.1, 2), c = random.uniform(1.1, 3);
  const auto ellipsoid = [b, c](auto x, auto y, auto z) { return x * x + b * y * y + c * z * z - 1; };
  if (seed % 4 == 0) {
    const auto t = random.coefficients(0.12);
    return make([=](auto x, auto y, auto z) { return ellipsoid(x, y, z) + random_surfaces::random_terms(t, x, y, z); },
                1.6);
  }
  if (seed % 4 == 1) {
    const Bumps bumps(random, 0.15);
    return make([=](auto x, auto y, auto z) { return ellipsoid(x, y, z) + bumps(x, y, z); }, 1.6);
  }
  const double r = random.uniform(0.35, 0.45), d = random.uniform(1.05, 1.3);
  const auto torus = [r, d](auto x, auto y, auto z) {
    const auto s = x * x + d * y * y + z * z + 1 - r * r;
    return s * s - 4 * (x * x + d * y * y);
  };
  if (seed % 4 == 2) {
    const auto t = random.coefficients(0.05);
    return make([=](auto x, auto y, auto z) { return torus(x, y, z) + random_surfaces::random_terms(t, x, y, z); },
                1.8);
  }
  const Bumps bumps(random, 0.1);
  return make([=](auto x, auto y, auto z) { return torus(x, y, z) + bumps(x, y, z); }, 1.8);
}

} // namespace

class Many_surfaces : public testing::TestWithParam<unsigned> {};

TEST_P(Many_surfaces, have_the_same_mesh_at_two_resolutions) {
  for (unsigned i = 1; i <= repetitions(surfaces_in_a_test); ++i) {
    const unsigned seed = surfaces_in_a_test * GetParam() + i;
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Surface s = surface(seed);
    const double h = s.half_size;
    std::array<Extraction, 2> found;
    for (std::size_t k = 0; k < 2; ++k) {
      found[k] = extract_extremal_mesh(*s.f, surfaces::lattice_around(*s.f, {{-h, -h, -h}, {h, h, h}}, 40 << k));
      surfaces::expect_all_checks_hold(found[k].mesh);
      EXPECT_TRUE(found[k].mesh.surface().closed);
    }
    // Not one of the 200 is an exception, certain or not.
    EXPECT_TRUE(graph_comparison::isomorphic(found[0].mesh, found[1].mesh))
        << surfaces::counts_of(found[0].mesh) << '\n'
        << surfaces::counts_of(found[1].mesh);
  }
}

INSTANTIATE_TEST_SUITE_P(By_twenties, Many_surfaces, testing::Range(0U, 200 / surfaces_in_a_test));
