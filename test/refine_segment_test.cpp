// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../src/extraction/Sample.h"
#include "../src/extraction/refine_segment.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>

namespace {

using namespace CGAL::Extremal_mesh_3;

/// The plane z = 0 with fields that have nothing to do with each other at any two places.
class Noise : public Surface {
public:
  std::optional<Sample> sample(const Point& x, const Vector&, double, double, Detail) const override {
    Local_shape shape;
    shape.n = {0, 0, 1};
    shape.u = {1, 0, 0};
    std::uint64_t state = 1;
    for (const double c : {x[0], x[1]}) {
      std::uint64_t bits = 0;
      std::memcpy(&bits, &c, sizeof bits);
      state = (state ^ bits) * 0x9E3779B97F4A7C15U;
      state ^= state >> 29U;
    }
    const auto random = [&] {
      state = state * 6364136223846793005U + 1442695040888963407U;
      return double(state >> 11U) * 0x1p-53 - 0.5;
    };
    shape.Q = {random(), random()};
    shape.A1 = {random(), random()};
    shape.A3 = {random(), random()};
    return Sample({x[0], x[1], 0}, shape, true);
  }
  double extremality_derivative(const Sample&, int, double) const override { return 1; }
};

/// Fields that tell, whatever chord a line is looked for from, that it is nearly as far away as the chord is long: its pieces are
/// longer than the whole. Those of damaged images come near to that.
class Receding_line : public Surface {
public:
  std::optional<Sample> sample(const Point& x, const Vector&, double reach, double, Detail) const override {
    if (reach != reach_) { // another chord, and first the point on it
      reach_ = reach;
      on_chord_ = x;
    }
    const double off = std::hypot(x[0] - on_chord_[0], x[1] - on_chord_[1]) / reach;
    Local_shape shape;
    shape.n = {0, 0, 1};
    shape.u = {1, 0, 0};
    shape.Q = std::polar(1.0, (off - 1.8) / 3);
    shape.A3 = {1, 0};
    return Sample({x[0], x[1], 0}, shape, true);
  }
  double extremality_derivative(const Sample&, int, double) const override { return 1; }

private:
  mutable double reach_ = 0;
  mutable Point on_chord_{};
};

Segment segment(double sign_on_left, int family) {
  Segment s;
  for (std::size_t i = 0; i < 2; ++i) {
    s.ends[i].at.p = {double(i), 0, 0};
    s.ends[i].at.n = {0, 0, 1};
    s.ends[i].at.derivative = 1;
  }
  s.family = family;
  s.sign_on_left = sign_on_left;
  return s;
}

template <class Any_surface> void expect_an_end() {
  const Any_surface surface;
  for (const double sign : {1.0, -1.0})
    for (const int family : {1, 2}) {
      const Segment_points found = refine_segment(surface, segment(sign, family), 0);
      EXPECT_LE(found.points.size(), 2000U);
      for (const Line_point& point : found.points)
        EXPECT_TRUE(std::isfinite(point.p[0]) && std::isfinite(point.p[1]));
    }
}

TEST(Refine_segment, comes_to_an_end_where_the_phase_is_noise) {
  expect_an_end<Noise>();
}

TEST(Refine_segment, comes_to_an_end_where_pieces_are_longer_than_the_whole) {
  expect_an_end<Receding_line>();
}

} // namespace
