// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "derivatives_list.h"

#include <CGAL/Extremal_mesh_3/Formula.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

using namespace CGAL::Extremal_mesh_3;

namespace {

double at(const std::string& text, const Point& p = {0, 0, 0}) {
  return Formula(text).value(p);
}

Derivatives derivatives_at(const std::string& text, const Point& p, int order = 4) {
  Derivatives d;
  Formula(text).derivatives(p, order, d);
  return d;
}

std::string repeat(const std::string& s, int n) {
  std::string result;
  for (int i = 0; i < n; ++i)
    result += s;
  return result;
}

static_assert(!std::is_copy_constructible_v<Formula> && std::is_nothrow_move_constructible_v<Formula>);

} // namespace

TEST(Formula, follows_the_precedence_of_mathematics) {
  const Point p{3, 5, 7};
  EXPECT_EQ(at("x+y*z", p), 38);
  EXPECT_EQ(at("(x+y)*z", p), 56);
  EXPECT_EQ(at("x-y-z", p), -9);
  EXPECT_EQ(at("z/2/7", p), 0.5);
  EXPECT_EQ(at("x/2*4", p), 6);
  EXPECT_EQ(at("-x^2", p), -9);
  EXPECT_EQ(at("(-x)^2", p), 9);
  EXPECT_EQ(at("2^3^2"), 512);
  EXPECT_EQ(at("2**3**2"), 512);
  EXPECT_EQ(at("2^-1"), 0.5);
  EXPECT_EQ(at("2^-x^0", p), 0.5);
  EXPECT_EQ(at("-2^-2"), -0.25);
  EXPECT_EQ(at("x*-y", p), -15);
  EXPECT_EQ(at("x--y", p), 8);
  EXPECT_EQ(at("x-+-+y", p), 8);
  EXPECT_EQ(at("-x*y", p), -15);
  EXPECT_EQ(at("2*x^2*y", p), 90);
  EXPECT_EQ(at(" x\t+\n y\r", p), 8);
}

TEST(Formula, reads_numbers_and_constants) {
  EXPECT_EQ(at("1e-5"), 1e-5);
  EXPECT_EQ(at(".5"), 0.5);
  EXPECT_EQ(at("2."), 2);
  EXPECT_EQ(at("1.25E+2"), 125);
  EXPECT_EQ(at("0.1"), 0.1);
  EXPECT_EQ(at("123456789012345678901234567890"), 123456789012345678901234567890.0);
  EXPECT_EQ(at("pi"), std::numbers::pi);
  EXPECT_EQ(at("e"), std::numbers::e);
}

TEST(Formula, takes_an_equation_as_left_minus_right) {
  const Point p{3, 5, 7};
  EXPECT_EQ(at("x = y", p), -2);
  EXPECT_EQ(at("x^2 + y = z - 1", p), 8);
  EXPECT_EQ(at("x^2+y^2+z^2=1", p), 82);
}

TEST(Formula, knows_its_functions) {
  const Point p{0.3, 0.7, -2};
  const double x = p[0], y = p[1], z = p[2];
  const std::vector<std::pair<std::string, double>> values{
      {"sqrt(x)", std::sqrt(x)},
      {"cbrt(z)", std::cbrt(z)},
      {"exp(x)", std::exp(x)},
      {"log(x)", std::log(x)},
      {"ln(x)", std::log(x)},
      {"log2(x)", std::log2(x)},
      {"log10(x)", std::log10(x)},
      {"sin(x)", std::sin(x)},
      {"cos(x)", std::cos(x)},
      {"tan(x)", std::tan(x)},
      {"asin(x)", std::asin(x)},
      {"acos(x)", std::acos(x)},
      {"atan(z)", std::atan(z)},
      {"sinh(x)", std::sinh(x)},
      {"cosh(x)", std::cosh(x)},
      {"tanh(x)", std::tanh(x)},
      {"abs(z)", 2},
      {"sign(z)", -1},
      {"sign(0*x)", 0},
      {"pow(x, y)", std::pow(x, y)},
      {"x^y", std::pow(x, y)},
      {"pow(x, 2.5)", std::pow(x, 2.5)},
      {"e^x", std::exp(x)},
      {"2^x", std::pow(2, x)},
      {"atan2(y, z)", std::atan2(y, z)},
      {"hypot(x, y)", std::sqrt(x * x + y * y)},
      {"hypot(x, y, z)", std::sqrt(x * x + y * y + z * z)},
      {"min(x, y)", x},
      {"max(x, y)", y},
      {"min(x, y, z, 4)", z},
      {"max(z, x, y, -4)", y},
  };
  for (const auto& [text, expected] : values)
    EXPECT_DOUBLE_EQ(at(text, p), expected) << text; // the compiler's own cbrt(-2) differs by a rounding
}

// Given the first derivative as another formula, the higher ones must agree as well.
TEST(Formula, differentiates_every_operation) {
  struct Case {
    std::string f, derivative_by_x;
    std::vector<double> points;
  };
  const std::vector<Case> cases{
      {"x + sin(x)", "1 + cos(x)", {0.4}},
      {"cos(x) - x", "-sin(x) - 1", {0.4}},
      {"-sin(x)", "-cos(x)", {0.4}},
      {"x*sin(x)", "sin(x) + x*cos(x)", {0.4, 0}},
      {"sin(x)/(1 + x^2)", "cos(x)/(1 + x^2) - 2*x*sin(x)/(1 + x^2)^2", {0.4, -3}},
      {"1/x", "-1/x/x", {0.4, -3}},
      {"x^7", "7*x^6", {0.4, 0, -3}},
      {"x^-3", "-3/x^4", {0.4, -3}},
      {"x^100", "100*x^99", {0.9, 0, -1.1}},
      {"x^-100", "-100*x^-101", {0.9, -1.1}},
      {"x^2.5", "2.5*x*sqrt(x)", {0.4, 3}},
      {"x^0.5", "1/(2*sqrt(x))", {0.4, 3}},
      {"x^x", "exp(x*log(x))*(log(x) + 1)", {0.4, 3}},
      {"3^x", "log(3)*exp(x*log(3))", {0.4, -3}},
      {"e^x", "exp(x)", {0.4, -3}},
      {"sqrt(x)", "1/(2*sqrt(x))", {0.4, 3}},
      {"cbrt(x)", "1/(3*cbrt(x)^2)", {0.4, -3}},
      {"exp(x)", "exp(x)", {0.4, -3}},
      {"log(x)", "1/x", {0.4, 3}},
      {"ln(x)", "1/x", {0.4, 3}},
      {"log2(x)", "1/(x*log(2))", {0.4, 3}},
      {"log10(x)", "1/(x*log(10))", {0.4, 3}},
      {"sin(x)", "cos(x)", {0.4, 0, -3}},
      {"cos(x)", "-sin(x)", {0.4, 0, -3}},
      {"tan(x)", "1/cos(x)^2", {0.4, 0, -3}},
      {"asin(x)", "1/sqrt(1 - x^2)", {0.4, 0, -0.9}},
      {"acos(x)", "-1/sqrt(1 - x^2)", {0.4, 0, -0.9}},
      {"atan(x)", "1/(1 + x^2)", {0.4, 0, -3}},
      {"atan2(x, 2)", "2/(4 + x^2)", {0.4, 0, -3}},
      {"atan2(3, x)", "-3/(9 + x^2)", {0.4, 0, -3}},
      {"atan2(-2, x)", "2/(4 + x^2)", {0.4, 0, -3}},
      {"atan2(sin(x), cos(x))", "1 + 0*x", {0.4, 0, -3}},
      {"atan2(x, x^2 - 4)", "-(x^2 + 4)/(x^4 - 7*x^2 + 16)", {0.4, 0, -3}},
      {"sinh(x)", "cosh(x)", {0.4, 0, -3}},
      {"cosh(x)", "sinh(x)", {0.4, 0, -3}},
      {"tanh(x)", "1/cosh(x)^2", {0.4, 0, -3}},
      {"abs(sin(x))", "sign(sin(x))*cos(x)", {0.4, -3}},
      {"sign(x)*x^2", "2*abs(x)", {0.4, -3}},
      {"min(x^2, x^3)", "min(2*x, 3*x^2)", {0.2, 0.6, 3}},
      {"max(x^2, sin(x), 0.1)", "2*x", {3, -1}},
      {"max(x^2, sin(x), 0.1)", "cos(x)", {0.4}},
      {"max(x^2, sin(x), 0.1)", "0*x", {0.01}},
      {"hypot(x, 2)", "x/sqrt(x^2 + 4)", {0.4, 0, -3}},
      {"hypot(x, 2, x)", "2*x/sqrt(2*x^2 + 4)", {0.4, 0, -3}},
  };
  for (const Case& c : cases)
    for (const double x : c.points) {
      const Derivatives f = derivatives_at(c.f, {x, 9, 9}), g = derivatives_at(c.derivative_by_x, {x, 9, 9});
      const std::array<double, 4> computed{f.gradient[0], f.hessian[0], f.third[0], f.fourth[0]};
      const std::array<double, 4> expected{g.value, g.gradient[0], g.hessian[0], g.third[0]};
      for (std::size_t k = 0; k < 4; ++k) // a few roundings, of terms that may cancel
        EXPECT_NEAR(computed[k], expected[k], 1e-13 * (1 + std::abs(expected[k])))
            << c.f << " at " << x << ": " << k + 1;
    }
}

TEST(Formula, gives_mixed_derivatives_in_the_order_of_Derivatives) {
  // f = x y² z + 3 x z³: every entry by hand at (2, 3, 5)
  const Derivatives d = derivatives_at("x*y^2*z + 3*x*z^3", {2, 3, 5});
  EXPECT_EQ(d.value, 840);
  EXPECT_EQ(d.gradient, (Vector{420, 60, 468}));
  EXPECT_EQ(d.hessian, (std::array<double, 6>{0, 30, 234, 20, 12, 180}));
  EXPECT_EQ(d.third, (std::array<double, 10>{0, 0, 0, 10, 6, 90, 0, 4, 0, 36}));
  EXPECT_EQ(d.fourth, (std::array<double, 15>{0, 0, 0, 0, 0, 0, 0, 2, 0, 18, 0, 0, 0, 0, 0}));
}

TEST(Formula, differentiates_polynomials_exactly) {
  EXPECT_EQ(derivatives_at("x^4", {0.1, 0, 0}).fourth[0], 24);
  EXPECT_EQ(derivatives_at("y^4", {0, 0, 0}).fourth[10], 24);
  EXPECT_EQ(derivatives_at("(x+y+z)^4", {3, -7, 11}).fourth,
            (std::array<double, 15>{24, 24, 24, 24, 24, 24, 24, 24, 24, 24, 24, 24, 24, 24, 24}));
  const Derivatives d = derivatives_at("x^2*y^2 - z^3/3", {3, 5, 7});
  EXPECT_EQ(d.third, (std::array<double, 10>{0, 20, 0, 12, 0, 0, 0, 0, 0, -2}));
}

TEST(Formula, has_derivatives_at_zero_of_powers_that_have_them) {
  for (const std::string text : {"x^3", "x^2.5", "abs(x)^3", "x^65"}) {
    const Derivatives d = derivatives_at(text, {0, 0, 0});
    EXPECT_EQ(d.value, 0) << text;
    EXPECT_EQ(d.gradient[0], 0) << text;
    EXPECT_EQ(d.hessian[0], 0) << text;
  }
  EXPECT_EQ(derivatives_at("x^3", {0, 0, 0}).third[0], 6);
}

TEST(Formula, is_NaN_where_it_is_not_defined) {
  for (const auto& [text, x] : std::vector<std::pair<std::string, double>>{{"sqrt(x)", -1},
                                                                           {"log(x)", -1},
                                                                           {"log2(x)", -1},
                                                                           {"log10(x)", -1},
                                                                           {"asin(x)", 1.5},
                                                                           {"acos(x)", -1.5},
                                                                           {"x^0.3", -1},
                                                                           {"x^x", -1.5},
                                                                           {"min(1, sqrt(x))", -1},
                                                                           {"max(sqrt(x), 1)", -1},
                                                                           {"x - log(x)", -1}}) {
    const Derivatives d = derivatives_at(text, {x, 0, 0});
    EXPECT_TRUE(std::isnan(d.value)) << text;
    EXPECT_TRUE(std::isnan(d.gradient[0])) << text;
    EXPECT_TRUE(std::isnan(d.fourth[0])) << text;
  }
  const Derivatives root = derivatives_at("sqrt(x)", {0, 0, 0});
  EXPECT_EQ(root.value, 0);
  EXPECT_FALSE(std::isfinite(root.gradient[0]));
  EXPECT_TRUE(std::isnan(derivatives_at("x/y", {0, 0, 0}).value));
}

TEST(Formula, takes_the_first_branch_at_a_kink) {
  EXPECT_EQ(derivatives_at("abs(x)", {0, 0, 0}).gradient[0], 1);
  EXPECT_EQ(derivatives_at("min(x, 2*x)", {0, 0, 0}).gradient[0], 1);
  EXPECT_EQ(derivatives_at("max(3*x, 2*x)", {0, 0, 0}).gradient[0], 3);
}

TEST(Formula, may_be_constant) {
  const Derivatives d = derivatives_at("2*pi", {1, 2, 3});
  EXPECT_EQ(d.value, 2 * std::numbers::pi);
  EXPECT_EQ(d.gradient, (Vector{0, 0, 0}));
  EXPECT_EQ(d.fourth, (std::array<double, 15>{}));
}

TEST(Formula, leaves_higher_orders_as_they_were) {
  Derivatives d;
  d.third[3] = 42;
  Formula("x*y*z").derivatives({1, 2, 3}, 2, d);
  EXPECT_EQ(d.third[3], 42);
  EXPECT_EQ(d.hessian[1], 3);
}

TEST(Formula, refuses_orders_other_than_one_to_four) {
  const Formula f("x");
  Derivatives d;
  EXPECT_THROW(f.derivatives({0, 0, 0}, 0, d), std::invalid_argument);
  EXPECT_THROW(f.derivatives({0, 0, 0}, 5, d), std::invalid_argument);
  const std::vector<Point> two(2);
  std::vector<Derivatives> one(1);
  EXPECT_THROW(f.derivatives(two, 3, one), std::invalid_argument);
}

TEST(Formula, can_be_moved) {
  Formula f("x + 1");
  const Formula g(std::move(f));
  EXPECT_EQ(g.value({1, 0, 0}), 2);
}

TEST(Formula_error, names_the_place_and_what_was_expected) {
  struct Case {
    std::string text;
    std::size_t position;
    std::string message;
  };
  const std::vector<Case> cases{
      {"", 0, "the formula is empty"},
      {"  ", 0, "the formula is empty"},
      {"2x", 1, "write * for a product"},
      {"2 x", 2, "write * for a product"},
      {"(x)(y)", 3, "write * for a product"},
      {"x(y+1)", 1, "write * for a product"},
      {"2e", 1, "write * for a product"},
      {"(2 x)", 3, "write * for a product"},
      {"1.2.3", 3, "write * for a product"},
      {"xy", 0, "unknown name \"xy\"; did you mean x*y?"},
      {"X+1", 0, "unknown name \"X\"; did you mean x?"},
      {"1+Sin(x)", 2, "unknown name \"Sin\"; did you mean sin?"},
      {"1 + foo(x)", 4, "unknown name \"foo\"; known are x, y, z, pi, e, abs, acos"},
      {"t^2", 0, "unknown name \"t\""},
      {"x +", 3, "expected a number, a variable, a function or \"(\", not the end"},
      {"x * / y", 4, "expected a number, a variable, a function or \"(\", not \"/\""},
      {"x + )", 4, "expected a number, a variable"},
      {"x )", 2, "unexpected \")\" without a \"(\""},
      {"(x + y", 6, "expected an operator or the \")\" that closes column 1, not the end"},
      {"sqrt(x + y", 10, "\")\" that closes column 5"},
      {"sin x", 4, "expected \"(\" after sin, not \"x\""},
      {"sin", 3, "expected \"(\" after sin, not the end"},
      {"sqrt()", 5, "expected a number"},
      {"1 + sqrt(x, y)", 4, "sqrt takes 1 argument, not 2"},
      {"atan2(x)", 0, "atan2 takes 2 arguments, not 1"},
      {"min(x)", 0, "min takes 2 or more arguments, not 1"},
      {"1,5*x", 1, "write a decimal point"},
      {"x = y = z", 6, "a second \"=\""},
      {"x == y", 3, "expected a number"},
      {"(x = y)", 3, "unexpected \"=\" inside"},
      {"= x", 0, "expected a number"},
      {"x = ", 4, "expected a number"},
      {"1e999", 0, "out of the range of double precision"},
      {"1 + 1e-999", 4, "out of the range of double precision"},
      {"x²", 1, "unexpected character \"²\"; write ^2 instead"},
      {"2·x", 1, "unexpected character \"·\"; write * instead"},
      {"1 − x", 2, "unexpected character \"−\"; write - instead"},
      {"2*π", 2, "write pi instead"},
      {"|x|", 0, "write abs(...) instead"},
      {"[x]", 0, "write ( instead"},
      {"x + é", 4, "unexpected character \"é\""},
      {"x ! 2", 2, "unexpected character \"!\""},
      {"x + \xB2", 4, "unexpected byte 0xB2"},
      {"x + \xE2\x88", 4, "unexpected byte 0xE2"},
      {std::string("x\0y", 3), 1, "unexpected byte 0x00"},
      {".", 0, "unexpected character \".\""},
  };
  for (const Case& c : cases) {
    try {
      const Formula f(c.text);
      ADD_FAILURE() << "no error: " << c.text;
    } catch (const Formula_error& error) {
      EXPECT_EQ(error.position(), c.position) << c.text << ": " << error.what();
      const std::string message = error.what(), column = "column " + std::to_string(c.position + 1) + ": ";
      EXPECT_NE(message.find(column), std::string::npos) << c.text << ": " << message;
      EXPECT_NE(message.find(c.message), std::string::npos) << c.text << ": " << message;
    }
  }
}

TEST(Formula_error, limits_the_depth_of_nesting) {
  EXPECT_EQ(at(repeat("(", 999) + "x" + repeat(")", 999), {3, 0, 0}), 3);
  EXPECT_EQ(at(repeat("-", 999) + "x", {3, 0, 0}), -3);
  EXPECT_EQ(at("x" + repeat("^1", 999), {3, 0, 0}), 3);
  EXPECT_EQ(at(repeat("abs(", 999) + "x" + repeat(")", 999), {-3, 0, 0}), 3);
  for (const std::string unit : {"(", "-", "2^", "sin(", "1-("})
    try {
      const Formula f(repeat(unit, 100000) + "x");
      ADD_FAILURE() << "no error: " << unit;
    } catch (const Formula_error& error) {
      EXPECT_NE(std::string(error.what()).find("more than 1000 levels"), std::string::npos) << error.what();
      EXPECT_LE(error.position(), 1001 * unit.size());
    }
}

TEST(Formula, may_be_long) {
  EXPECT_EQ(at("x" + repeat("+x", 400000), {1, 0, 0}), 400001);
  EXPECT_EQ(at("0" + repeat("+x*y", 1000), {2, 3, 0}), 6000);
  EXPECT_THROW(Formula("x" + repeat("+x", 600000)), Formula_error);
}
