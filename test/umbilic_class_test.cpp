// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Classes of umbilics and types of lines, against their definitions.
#include <CGAL/Extremal_mesh_3/Differential_quantities.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

using namespace CGAL::Extremal_mesh_3;

namespace {

using Complex = std::complex<double>;

/// The fields on a circle around the umbilic, from L's linear part alone [MATHEMATICS 3].
struct Circle {
  Complex A1, A3;
  static constexpr int steps = 20000;

  Complex direction(int i) const { return std::polar(1.0, 2 * std::numbers::pi * i / steps); }
  Complex Q(int i) const {
    // C from A1 and A3: C111 = Re(A1 + A3), C112 = Im(A1/3 + A3), C122 = Re(A1/3 − A3), C222 = Im(A1 − A3).
    const double c111 = (A1 + A3).real(), c112 = (A1 / 3.0 + A3).imag();
    const double c122 = (A1 / 3.0 - A3).real(), c222 = (A1 - A3).imag();
    const Complex z = direction(i);
    return z.real() * Complex((c111 - c122) / 2, c112) + z.imag() * Complex((c112 - c222) / 2, c122);
  }
  Complex V(int i) const { return std::conj(std::conj(A3) * Q(i) + A1 * std::conj(Q(i))); }
  double E(int i) const {
    const Complex P = std::conj(V(i));
    return (P * P * Q(i)).imag();
  }
  /// Lines of curvature point to the umbilic where a principal direction is radial: Im(Q z̄²) = 0.
  double radial(int i) const {
    const Complex z = std::conj(direction(i));
    return (Q(i) * z * z).imag();
  }

  template <class Field> int winding(const Field& field) const {
    double angle = 0;
    for (int i = 0; i < steps; ++i)
      angle += std::arg(field(i + 1) / field(i));
    return int(std::lround(angle / (2 * std::numbers::pi)));
  }
  template <class Function> int sign_changes(const Function& function) const {
    int changes = 0;
    for (int i = 0; i < steps; ++i)
      changes += (function(i) > 0) != (function(i + 1) > 0);
    return changes;
  }
};

} // namespace

TEST(Umbilic_class, agrees_with_the_fields_on_a_circle) {
  const unsigned seed = 5;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  const auto uniform = [&] { return 2 * (double(random()) / 4294967295.0) - 1; };
  std::array<int, 4> types{};
  std::array<int, 4> ridges{};
  for (int i = 0; i < 300; ++i) {
    const Circle circle{{uniform(), uniform()}, {uniform(), uniform()}};
    const Umbilic_class c = classify_umbilic(circle.A1, circle.A3);
    SCOPED_TRACE(testing::Message() << "A1 = " << circle.A1 << ", A3 = " << circle.A3);
    // |Q| has the phase of twice the lines of curvature, which wind half as often.
    EXPECT_EQ(c.index, 0.5 * circle.winding([&](int k) { return circle.Q(k); }));
    EXPECT_EQ(c.field_index, circle.winding([&](int k) { return circle.V(k); }));
    const int lines = circle.sign_changes([&](int k) { return circle.E(k); }) / 2;
    EXPECT_EQ(c.ridges, lines);
    const int separatrices = circle.sign_changes([&](int k) { return circle.radial(k); }) / 2;
    EXPECT_EQ(c.type, c.index < 0         ? Umbilic_type::star
                      : separatrices == 1 ? Umbilic_type::lemon
                                          : Umbilic_type::monstar);
    ++types[std::size_t(c.type)];
    ++ridges[std::size_t(c.ridges)];
  }
  // All of them were met.
  EXPECT_GT(types[std::size_t(Umbilic_type::lemon)], 0);
  EXPECT_GT(types[std::size_t(Umbilic_type::monstar)], 0);
  EXPECT_GT(types[std::size_t(Umbilic_type::star)], 0);
  EXPECT_GT(ridges[1], 0);
  EXPECT_GT(ridges[3], 0);
}

TEST(Umbilic_class, of_a_symmetric_saddle_is_a_star_and_of_a_bowl_a_lemon) {
  // The monkey saddle has A1 = 0; A3 = 0 is the elliptic paraboloid's cubic x(x² + y²).
  EXPECT_EQ(classify_umbilic({0.1, 0}, {1, 0}).type, Umbilic_type::star);
  EXPECT_EQ(classify_umbilic({0.1, 0}, {1, 0}).index, -0.5);
  EXPECT_EQ(classify_umbilic({1, 0}, {0.01, 0}).type, Umbilic_type::lemon);
  EXPECT_EQ(classify_umbilic({1, 0}, {0.01, 0}).index, 0.5);
}

TEST(Umbilic_class, is_none_where_third_derivatives_do_not_decide) {
  EXPECT_EQ(classify_umbilic(0, 0).type, Umbilic_type::none);
  EXPECT_EQ(classify_umbilic({3, 0}, {1, 0}).index, 0); // |A1| = 3|A3|
  EXPECT_EQ(classify_umbilic({1, 0}, {1, 0}).field_index, 0);
  EXPECT_EQ(classify_umbilic({1, 0}, {1, 0}).ridges, 0);
}

TEST(Line_type, follows_the_table_of_thirion_2_5) {
  // Maximum: ∇e·t < 0 and k > 0, or ∇e·t > 0 and k < 0. Largest: |k_i| is the larger one.
  for (const double k1 : {3.0, 1.0, -0.5, 0.5})
    for (const double k2 : {-2.0, -0.7, 0.3})
      for (const double derivative : {-1.0, 1.0})
        for (const int family : {1, 2}) {
          if (k1 < k2)
            continue;
          const double k = family == 1 ? k1 : k2, other = family == 1 ? k2 : k1;
          const bool maximum = (derivative < 0 && k > 0) || (derivative > 0 && k < 0);
          const bool largest = std::abs(k) > std::abs(other);
          const Line_type expected = maximum ? (largest ? Line_type::max_largest : Line_type::max_second)
                                             : (largest ? Line_type::min_largest : Line_type::min_second);
          EXPECT_EQ(line_type(k1, k2, family, derivative), expected)
              << k1 << ' ' << k2 << ' ' << family << ' ' << derivative;
        }
}
