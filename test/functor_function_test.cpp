// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "derivatives_list.h"

#include <CGAL/Extremal_mesh_3/Formula.h>
#include <CGAL/Extremal_mesh_3/Functor_function.h>
#include <CGAL/Extremal_mesh_3/Jet.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace CGAL::Extremal_mesh_3;

namespace {

const Point p{0.3, 0.7, -0.4};
const Jet x = Jet::variable(p[0], 0), y = Jet::variable(p[1], 1), z = Jet::variable(p[2], 2);

void expect_near(const Jet& u, const Jet& v, const std::string& what) {
  for (std::size_t i = 0; i < Jet::size; ++i)
    EXPECT_NEAR(u[i], v[i], 1e-13 * (1 + std::abs(v[i]))) << what << ", coefficient " << i;
}

/// called with double as with jets, in the way the documentation advises.
struct Blob {
  template <class T> T operator()(const T& u, const T& v, const T& w) const {
    using std::abs, std::atan2, std::cbrt, std::cos, std::exp, std::hypot, std::log, std::max, std::min, std::pow,
        std::sin, std::sqrt, std::tanh;
    return sqrt(1 + u * u) * exp(-v) + pow(w, 2) + pow(2 + u, 1.5) + log(2 + sin(v)) / hypot(u, v) + cbrt(w) +
           atan2(u, w) - cos(2 * w) + max(u, 0.5 * v) + min(v, T(0.1)) + abs(w) + tanh(u - 1);
  }
};
const std::string blob = "sqrt(1 + x^2)*exp(-y) + z^2 + (2 + x)^1.5 + log(2 + sin(y))/hypot(x, y) + cbrt(z) + "
                         "atan2(x, z) - cos(2*z) + max(x, 0.5*y) + min(y, 0.1) + abs(z) + tanh(x - 1)";

} // namespace

TEST(Jet, multiplies_as_polynomials_do) {
  const Jet u = (1 + x) * (y - z) * (x * x + 2);
  EXPECT_DOUBLE_EQ(u.value(), 1.3 * 1.1 * 2.09);
  Derivatives d = Derivatives(pow(x, 4) + 5 * x * y * z * z);
  EXPECT_EQ(d.fourth[0], 24);
  EXPECT_EQ(d.fourth[8], 10);       // xyzz
  EXPECT_EQ(d.third[5], 10 * p[1]); // xzz
}

TEST(Jet, divides_as_the_inverse_of_multiplication) {
  const Jet u = exp(x * y) + z, v = 2 + sin(z) * x;
  expect_near(u / v * v, u, "u/v*v");
  expect_near((1 / v) * u, u / v, "1/v*u");
  expect_near(v / v, 1, "v/v");
  Jet w = u;
  w /= v;
  w *= v;
  expect_near(w, u, "assignments");
}

TEST(Jet, mixes_with_numbers) {
  const Jet u = x * y + 1;
  expect_near(u + 2, 2 + u, "sum");
  expect_near(2 - u, -(u - 2), "difference");
  expect_near(u * 3, 3 * u, "product");
  expect_near(u / 4, u * 0.25, "quotient");
  expect_near(3 / u, 3 * pow(u, -1), "reciprocal");
  Jet v = u;
  v += 1;
  v -= 2.5;
  v *= 2;
  v /= 4;
  expect_near(v, (u - 1.5) / 2, "assignments");
}

TEST(Jet, compares_by_value) {
  EXPECT_TRUE(x < y && y > x && x <= 0.3 && 0.3 == x && x != y && z < 0 && 1 > x);
  EXPECT_TRUE(x == Jet(0.3));
}

TEST(Jet, satisfies_the_identities_of_its_functions) {
  const Jet u = x * y + z * z + 0.5 * x * z;
  expect_near(square(sin(u)) + square(cos(u)), 1, "sin² + cos²");
  expect_near(sin(u) / cos(u), tan(u), "tan");
  expect_near(square(cosh(u)) - square(sinh(u)), 1, "cosh² - sinh²");
  expect_near(sinh(u) / cosh(u), tanh(u), "tanh");
  expect_near(exp(log(u + 2)), u + 2, "exp log");
  expect_near(log2(u + 2) * std::log(2), log(u + 2), "log2");
  expect_near(log10(u + 2) * std::log(10), log(u + 2), "log10");
  expect_near(square(sqrt(u + 2)), u + 2, "sqrt");
  expect_near(pow(cbrt(u - 2), 3), u - 2, "cbrt");
  expect_near(asin(sin(u)), u, "asin");
  expect_near(acos(cos(u + 1)), u + 1, "acos");
  expect_near(atan(tan(u)), u, "atan");
  expect_near(atan2(sin(u + 2), cos(u + 2)), u + 2, "atan2");
  expect_near(square(hypot(x, y)), x * x + y * y, "hypot");
  expect_near(pow(u + 2, 2.5), square(u + 2) * sqrt(u + 2), "pow real");
  expect_near(pow(u + 2, y), exp(y * log(u + 2)), "pow jet");
  expect_near(pow(2, u), exp(u * std::log(2)), "pow of a number");
  expect_near(pow(u, 5), u * u * u * u * u, "pow integer");
  expect_near(pow(u + 2, -2), 1 / square(u + 2), "pow negative integer");
  expect_near(pow(u, 3.0), pow(u, 3), "pow integral real");
  expect_near(pow(u, 0), 1, "pow 0");
}

TEST(Jet, takes_the_first_branch_at_a_kink) {
  const Jet t = Jet::variable(0, 0);
  expect_near(abs(t), t, "abs");
  expect_near(min(t, 2 * t), t, "min");
  expect_near(max(t, 2 * t), t, "max");
  expect_near(max(t, -1), t, "max with a number");
  expect_near(min(-1, t), -1, "min with a number");
  EXPECT_TRUE(std::isnan(max(t, log(t - 1)).value()));
}

TEST(Jet, is_NaN_or_infinite_where_derivatives_do_not_exist) {
  const Jet t = Jet::variable(0, 0);
  EXPECT_EQ(sqrt(t).value(), 0);
  EXPECT_FALSE(std::isfinite(sqrt(t)[1]));
  EXPECT_TRUE(std::isnan(sqrt(t - 1)[1]));
  EXPECT_TRUE(std::isnan(log(t - 1)[1]));
  EXPECT_EQ(pow(t, 3)[internal::taylor_index(3, 0, 0)], 1);
  EXPECT_EQ(pow(t, 1.5)[1], 0);
}

TEST(Lambda_function, agrees_with_the_formula) {
  const auto f = make_function(Blob());
  const Formula g(blob);
  EXPECT_NEAR(f.value(p), g.value(p), 1e-14);
  EXPECT_EQ(f.max_order(), 4);
  Derivatives expected;
  g.derivatives(p, 4, expected);
  for (int order = 1; order <= 4; ++order) {
    Derivatives d;
    f.derivatives(p, order, d);
    const std::vector<double> a = list(d, order), b = list(expected, order);
    const double largest = std::abs(*std::max_element(b.begin(), b.end()));
    for (std::size_t i = 0; i < a.size(); ++i)
      EXPECT_NEAR(a[i], b[i], 1e-13 * (1 + largest)) << order << ", entry " << i;
  }
}

TEST(Lambda_function, takes_a_generic_lambda) {
  const auto f = make_function([radius = 2](auto a, auto b, auto c) {
    using std::sqrt;
    return sqrt(a * a + b * b + c * c) - radius;
  });
  Derivatives d;
  f.derivatives({0, 3, 4}, 3, d);
  EXPECT_EQ(f.value({0, 3, 4}), 3);
  EXPECT_EQ(d.value, 3);
  EXPECT_DOUBLE_EQ(d.gradient[2], 0.8);
  EXPECT_DOUBLE_EQ(d.hessian[0], 0.2); // 1/r across the radius
}

TEST(Lambda_function, may_return_a_plain_number) {
  const auto f = make_function([](auto, auto, auto) { return 5; });
  Derivatives d;
  f.derivatives(p, 3, d);
  EXPECT_EQ(d.value, 5);
  EXPECT_EQ(d.gradient, (Vector{0, 0, 0}));
}

TEST(Lambda_function, refuses_orders_other_than_one_to_four) {
  const auto f = make_function([](auto a, auto, auto) { return a; });
  Derivatives d;
  EXPECT_THROW(f.derivatives(p, 0, d), std::invalid_argument);
  EXPECT_THROW(f.derivatives(p, 5, d), std::invalid_argument);
}

TEST(Functor_function, passes_on_what_the_functor_gives) {
  const auto plane = [](const Point& q, int order, Derivatives& d) {
    d.value = q[0] + 2 * q[1];
    if (order >= 1)
      d.gradient = {1, 2, 0};
  };
  const auto f = make_function(plane, 3);
  EXPECT_EQ(f.max_order(), 3);
  EXPECT_EQ(f.value({3, 5, 0}), 13);
  Derivatives d;
  f.derivatives({3, 5, 0}, 3, d);
  EXPECT_EQ(d.gradient, (Vector{1, 2, 0}));
  EXPECT_EQ(Functor_function(plane, 4).max_order(), 4);
  EXPECT_THROW(make_function(plane, 2), std::invalid_argument);
  EXPECT_THROW(make_function(plane, 5), std::invalid_argument);
}

TEST(Function_3, gives_lattice_values_by_default) {
  const auto f = make_function([](auto a, auto b, auto c) { return a + 10 * b + 100 * c; });
  std::vector<double> values(6);
  f.lattice_values({{0, 0, 0}, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {3, 2, 5}}, 4, values.data());
  EXPECT_EQ(values, (std::vector<double>{400, 401, 402, 410, 411, 412}));
}
