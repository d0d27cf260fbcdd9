// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../src/functions/sharp_bounds.h"

#include <CGAL/Extremal_mesh_3/Formula.h>
#include <CGAL/Extremal_mesh_3/Functor_function.h>
#include <CGAL/Extremal_mesh_3/Image_function.h>
#include <CGAL/Extremal_mesh_3/internal/interval_arithmetic.h>

#include "derivatives_list.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <vector>

using namespace CGAL::Extremal_mesh_3;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

class Random {
public:
  explicit Random(unsigned seed) : random_(seed) {}
  double uniform(double low, double high) { return low + (high - low) * (double(random_()) / 4294967295.0); }
  /// a box of a random size, down to tiny ones, in [low, high]³.
  Box_3 box(double low, double high) {
    const double size = (high - low) * std::pow(10, uniform(-4, 0));
    Box_3 b;
    for (std::size_t a = 0; a < 3; ++a) {
      b.low[a] = uniform(low, high - size);
      b.high[a] = b.low[a] + size * uniform(0, 1);
    }
    return b;
  }
  Point point(const Box_3& b) {
    Point p;
    for (std::size_t a = 0; a < 3; ++a)
      p[a] = std::min(b.high[a], uniform(b.low[a], b.high[a]));
    return p;
  }

private:
  std::mt19937 random_;
};

/// all bounds up to an order, one after the other as `list()` of derivatives has them.
std::vector<Interval> intervals(const Derivative_bounds& d, int order) {
  std::vector<Interval> all{d.value};
  const auto add = [&](const auto& block) { all.insert(all.end(), block.begin(), block.end()); };
  if (order >= 1)
    add(d.gradient);
  if (order >= 2)
    add(d.hessian);
  if (order >= 3)
    add(d.third);
  if (order >= 4)
    add(d.fourth);
  return all;
}

/// A formula and a cube of arguments, in most of which it is defined.
struct Case {
  std::string formula;
  double low, high;
};

const std::vector<Case> cases = {{"x^2/9 + y^2/4 + z^2 - 1", -3, 3},
                                 {"x^4+y^4+z^4-5*x^2-5*y^2-5*z^2+11.8", -3, 3},
                                 {"(x^2+y^2+z^2+0.84)^2-4*(x^2+y^2)+0.1*x^2+0.15*x*y*z+0.06*x^3", -2, 2},
                                 {"x^3*y - y^3*z + z^3*x", -1, 2},
                                 {"x^7 - y^5*z^2 + x*y*z", -1.5, 1.5},
                                 {"1/(1+x^2) + y/(2+z^2)", -2, 2},
                                 {"x/y + z", -2, 2},
                                 {"1/(x^2+y^2+z^2)^2", -1, 1},
                                 {"sqrt(x) + sqrt(x^2+y^2+z^2)", -1, 2},
                                 {"sqrt(x^2+y^2)-z", -1, 1},
                                 {"cbrt(x*y) + z", -2, 2},
                                 {"exp(-x^2-y^2) - z", -2, 2},
                                 {"exp(x*y)+exp(z)", -3, 3},
                                 {"log(x) + ln(y) + log2(z)", -1, 3},
                                 {"log10(x^2+y^2+z^2)", -1, 1},
                                 {"sin(x)*cos(y) + sin(y)*cos(z) + sin(z)*cos(x)", -7, 7},
                                 {"sin(20*x)+cos(30*y)", -7, 7},
                                 {"tan(x)+y*z", -4, 4},
                                 {"asin(x)+acos(y)+z", -1.5, 1.5},
                                 {"atan(x*y)+atan(z)", -3, 3},
                                 {"sinh(x)+cosh(y)*tanh(z)", -3, 3},
                                 {"tanh(x*y*z)", -1, 1},
                                 {"atan2(y, x) + z", -1, 1},
                                 {"atan2(x*y, z^2+1)", -2, 2},
                                 {"x^2.5 + y^(-0.7) + z^0.3", -0.5, 3},
                                 {"x^70 + abs(y)^65.5 + z", -1.1, 1.1},
                                 {"x^y + 2^z", -0.5, 2},
                                 {"hypot(x, y, z) - 1", -1, 1},
                                 {"pow(x^2+1, y)*z", -1, 1},
                                 {"e^(x-y)+pi*z", -2, 2}};
// With kinks or jumps: derivatives at a point are those of one branch.
const std::vector<Case> kinked = {{"abs(x) + abs(y*z)", -1, 1},
                                  {"min(x, y, z)", -1, 1},
                                  {"max(x^2, y) + min(z, 0.3)", -1, 1},
                                  {"max(x, 0)*min(y, 1) + sign(z)*z", -2, 2},
                                  {"sign(x) + sign(y*z)", -1, 1}};

using Bound = std::function<bool(const Function_3&, const Box_3&, int, Derivative_bounds&)>;

bool plain(const Function_3& f, const Box_3& b, int order, Derivative_bounds& d) {
  return f.bounds(b, order, d);
}

/// asserts that the derivatives at random points of random boxes are within the bounds.
void expect_inclusion(const Case& c, const Bound& bound, int max_order) {
  SCOPED_TRACE(c.formula);
  const Formula f(c.formula);
  Random random(7);
  for (int n = 0; n < 600; ++n) {
    const Box_3 box = random.box(c.low, c.high);
    const int order = n % (max_order + 1);
    Derivative_bounds d;
    ASSERT_TRUE(bound(f, box, order, d));
    const std::vector<Interval> bounds = intervals(d, order);
    for (int k = 0; k < 12; ++k) {
      const Point p = k < 8 ? Point{(k & 1 ? box.high : box.low)[0], (k & 2 ? box.high : box.low)[1],
                                    (k & 4 ? box.high : box.low)[2]}
                            : random.point(box);
      Derivatives at;
      f.derivatives(p, std::max(order, 1), at);
      if (!std::isfinite(at.value))
        continue;
      const std::vector<double> values = list(at, order);
      for (std::size_t i = 0; i < values.size(); ++i) {
        if (!std::isfinite(values[i]))
          continue;
        // The derivatives are rounded, the bounds are not: what cancels in them is of the size of the bounds' ends.
        const double size = std::max(std::abs(bounds[i].low), std::abs(bounds[i].high));
        const double slack = std::isfinite(size) ? 1e-9 * (std::abs(values[i]) + 1e-3 * size) : 0;
        ASSERT_TRUE(bounds[i].low - slack <= values[i] && values[i] <= bounds[i].high + slack)
            << "order " << order << ", derivative " << i << ": " << values[i] << " is not in [" << bounds[i].low << ", "
            << bounds[i].high << "] at (" << p[0] << ", " << p[1] << ", " << p[2] << ") in the box from (" << box.low[0]
            << ", " << box.low[1] << ", " << box.low[2] << ") to (" << box.high[0] << ", " << box.high[1] << ", "
            << box.high[2] << ")";
      }
    }
  }
}

/// the largest width of bounds up to an order.
double width(const Derivative_bounds& d, int order) {
  double widest = 0;
  for (const Interval& i : intervals(d, order))
    widest = std::max(widest, i.width());
  return widest;
}

Box_3 cube(const Point& middle, double half) {
  return {{middle[0] - half, middle[1] - half, middle[2] - half},
          {middle[0] + half, middle[1] + half, middle[2] + half}};
}

} // namespace

TEST(Interval_arithmetic, holds_all_results_for_random_operands) {
  Random random(1);
  const auto interval = [&] {
    const double a = random.uniform(-2, 2), b = random.uniform(-2, 2);
    return Interval{std::min(a, b), std::max(a, b)};
  };
  for (int n = 0; n < 20000; ++n) {
    const Interval a = interval(), b = interval();
    const double x = std::min(a.high, random.uniform(a.low, a.high)),
                 y = std::min(b.high, random.uniform(b.low, b.high));
    ASSERT_TRUE((a + b).contains(x + y));
    ASSERT_TRUE((a - b).contains(x - y));
    ASSERT_TRUE((a * b).contains(x * y));
    ASSERT_TRUE((a / b).contains(x / y));
    ASSERT_TRUE(square(a).contains(x * x));
    ASSERT_TRUE(hull(a, b).contains(x) && hull(a, b).contains(y));
  }
}

TEST(Interval_arithmetic, rounds_outwards) {
  // 0.1 + 0.2, 0.1·0.1 and 1/3 are no doubles; long double holds the first two exactly, and the last better.
  const Interval a{0.1, 0.1}, b{0.2, 0.2};
  const auto strictly_holds = [](const Interval& i, long double x) {
    return static_cast<long double>(i.low) < x && x < static_cast<long double>(i.high);
  };
  EXPECT_TRUE(strictly_holds(a + b, 0.1L + 0.2L));
  EXPECT_TRUE(strictly_holds(a + b, static_cast<long double>(0.1) + static_cast<long double>(0.2)));
  EXPECT_TRUE(strictly_holds(a * a, static_cast<long double>(0.1) * static_cast<long double>(0.1)));
  EXPECT_TRUE(strictly_holds(1.0 / Interval{3, 3}, 1.0L / 3));
  EXPECT_LT((a + b).width(), 1e-15);
  // A product that underflows is not 0.
  const Interval tiny{1e-200, 1e-200};
  EXPECT_GT((tiny * tiny).high, 0);
}

TEST(Interval_arithmetic, takes_infinite_bounds_as_limits) {
  const Interval all = internal::all_numbers, none = internal::no_number;
  EXPECT_EQ((Interval{0, 0} * all).contains(0), true);
  EXPECT_LT((Interval{0, 0} * all).width(), 1e-300);
  EXPECT_EQ(Interval(0, 1) * all, all);
  EXPECT_EQ(all + all, all);
  EXPECT_EQ(all - all, all);
  EXPECT_EQ(all / all, all);
  EXPECT_EQ((Interval{1, 2} / Interval{0, 1}).high, infinity);
  EXPECT_NEAR((Interval{1, 2} / Interval{0, 1}).low, 1, 1e-15);
  EXPECT_NEAR((Interval{1, 2} / Interval{-1, 0}).high, -1, 1e-15);
  EXPECT_EQ(Interval(1, 2) / Interval(-1, 1), all);
  EXPECT_EQ((Interval{1e300, 1e300} * Interval{1e300, 1e300}), all); // beyond the doubles
  for (const Interval& i : {none + all, all - none, none * all, all / none, square(none)})
    EXPECT_TRUE(i.is_empty());
}

TEST(Bounds, of_formulas_hold_at_random_points_of_random_boxes) {
  for (const Case& c : cases)
    expect_inclusion(c, plain, 4);
}

TEST(Bounds, of_formulas_with_kinks_hold_at_random_points_of_random_boxes) {
  for (const Case& c : kinked)
    expect_inclusion(c, plain, 4);
}

TEST(Bounds, by_mean_values_hold_at_random_points_of_random_boxes) {
  for (const std::vector<Case>& all : {cases, kinked})
    for (const Case& c : all)
      expect_inclusion(c, internal::sharp_bounds, 3);
}

TEST(Bounds, get_tight_as_boxes_get_small) {
  for (const Case& c : cases) {
    SCOPED_TRACE(c.formula);
    const Formula f(c.formula);
    Random random(3);
    for (int n = 0; n < 10; ++n) {
      const double m = (c.low + 3 * c.high) / 4, r = (c.high - c.low) / 8; // where all are defined
      const Point p{random.uniform(m - r, m + r), random.uniform(m - r, m + r), random.uniform(m - r, m + r)};
      Derivatives at;
      f.derivatives(p, 4, at);
      Derivative_bounds wide, narrow;
      ASSERT_TRUE(f.bounds(cube(p, 1e-4), 3, wide) && f.bounds(cube(p, 1e-5), 3, narrow));
      // The width is that of the derivatives' change, in proportion to the size, from a size on.
      if (std::isfinite(at.value) && std::isfinite(width(wide, 3))) {
        EXPECT_LT(width(narrow, 3), 0.11 * width(wide, 3));
        EXPECT_GT(width(narrow, 3), 0.09 * width(wide, 3));
      }
    }
  }
}

TEST(Bounds, by_mean_values_are_too_wide_by_the_square_of_the_size) {
  // The range of a polynomial that cancels, found by sampling: at 1 it changes hardly, but its terms do.
  const Formula f("x^4 - 4*x^3 + 6*x^2 - 4*x + 1 + 0.001*x + y*0 + z*0");
  for (const double half : {1e-2, 1e-3, 1e-4}) {
    Derivative_bounds natural, centred;
    const Box_3 box = cube({1, 1, 1}, half);
    ASSERT_TRUE(f.bounds(box, 0, natural) && internal::sharp_bounds(f, box, 0, centred));
    EXPECT_GT(natural.value.width(), 30 * half);
    EXPECT_LT(centred.value.width(), 0.0021 * half + 200 * half * half);
  }
}

TEST(Bounds, are_empty_where_a_formula_is_not_defined) {
  for (const std::string formula : {"sqrt(x)+y", "log(x)*0+z", "asin(x-5)", "acos(x-5)^2", "x^1.5 + y^2"}) {
    Derivative_bounds d;
    ASSERT_TRUE(Formula(formula).bounds({{-2, -2, -2}, {-1, 2, 2}}, 1, d));
    EXPECT_TRUE(d.value.is_empty()) << formula;
  }
}

TEST(Bounds, are_infinite_across_poles_and_the_ends_of_a_domain) {
  const Box_3 box{{-1, -1, -1}, {1, 1, 1}};
  for (const std::string formula : {"1/x", "sqrt(x)", "tan(2*x)", "log(x)", "x^1.5", "atan2(y, x)", "asin(2*x)"}) {
    Derivative_bounds d;
    ASSERT_TRUE(Formula(formula).bounds(box, 1, d));
    EXPECT_EQ(d.gradient[0].width(), infinity) << formula;
  }
}

TEST(Bounds, know_that_a_potential_has_no_zero_at_its_pole) {
  Derivative_bounds d;
  ASSERT_TRUE(Formula("1/sqrt(x^2+y^2+z^2) - 0.1").bounds({{-1, -1, -1}, {1, 1, 1}}, 0, d));
  EXPECT_GT(d.value.low, 0.4);
}

TEST(Bounds, of_a_point_are_its_derivatives_to_rounding) {
  for (const Case& c : cases) {
    SCOPED_TRACE(c.formula);
    const Formula f(c.formula);
    const double m = (c.low + 3 * c.high) / 4;
    const Point p{m, m + 0.01, m - 0.013};
    Derivatives at;
    f.derivatives(p, 4, at);
    Derivative_bounds d;
    ASSERT_TRUE(f.bounds({p, p}, 4, d));
    const std::vector<double> values = list(at, 4);
    const std::vector<Interval> bounds = intervals(d, 4);
    for (std::size_t i = 0; i < values.size(); ++i) {
      EXPECT_NEAR(bounds[i].low, values[i], 1e-9 * (1 + std::abs(values[i])));
      EXPECT_NEAR(bounds[i].high, values[i], 1e-9 * (1 + std::abs(values[i])));
    }
  }
}

TEST(Bounds, of_images_hold_at_random_points_of_random_boxes) {
  for (const int degree : {5, 7}) {
    Random random(11);
    // 9 × 10 × 11 voxels of random values, on a turned lattice with sides of different lengths.
    Image image;
    image.lattice.size = {9, 10, 11};
    image.lattice.origin = {1, -2, 3};
    image.lattice.step = {Vector{0.8, 0.6, 0}, Vector{-0.54, 0.72, 0}, Vector{0, 0, 1.1}};
    for (std::size_t i = 0; i < 9U * 10 * 11; ++i)
      image.voxels.push_back(float(random.uniform(-100, 100)));
    Image_function_options options;
    options.degree = degree;
    options.sigma = 1.2;
    const Image_function f(image, options);
    for (int n = 0; n < 1000; ++n) {
      // Beyond the image, too; from boxes of many voxels to small parts of one.
      const Point p = image.lattice.node(random.uniform(-2, 11), random.uniform(-2, 12), random.uniform(-2, 13));
      const double size = std::pow(10, random.uniform(-3, 1));
      const Box_3 box{p, {p[0] + size, p[1] + size * random.uniform(0.1, 1), p[2] + size * random.uniform(0.1, 1)}};
      Derivative_bounds d;
      ASSERT_TRUE(f.bounds(box, 1, d));
      for (int k = 0; k < 20; ++k) {
        Derivatives at;
        f.derivatives(random.point(box), 1, at);
        ASSERT_TRUE(d.value.contains(at.value));
        for (std::size_t a = 0; a < 3; ++a)
          ASSERT_TRUE(d.gradient[a].contains(at.gradient[a]));
      }
    }
  }
}

TEST(Bounds, of_images_are_tight_within_a_voxel) {
  // Voxels of x² + y: the spline is it (up to a constant and to the border), as smoothing leaves the second derivative.
  Image image;
  image.lattice.size = {20, 20, 20};
  for (std::size_t i = 0; i < 8000; ++i)
    image.voxels.push_back(float(double(i % 20) * double(i % 20) + double(i / 20 % 20)));
  Image_function_options options;
  options.iso = 50;
  options.sigma = 1;
  const Image_function f(image, options);
  Derivative_bounds d;
  ASSERT_TRUE(f.bounds({{9, 9, 9}, {10, 10, 10}}, 1, d));
  EXPECT_NEAR(d.gradient[0].low, -20, 0.1);
  EXPECT_NEAR(d.gradient[0].high, -18, 0.1);
  EXPECT_NEAR(d.gradient[1].low, -1, 0.05);
  EXPECT_NEAR(d.gradient[1].high, -1, 0.05);
  EXPECT_NEAR(d.value.width(), 20, 0.5); // 10² − 9² in x, 1 in y
}

TEST(Bounds, of_a_functor_are_not_known) {
  const auto f = make_function([](auto x, auto y, auto z) { return x * x + y * y + z * z - 1; });
  Derivative_bounds d;
  EXPECT_EQ(f.bounds_cost(), Bounds_cost::unknown);
  EXPECT_FALSE(f.bounds({{0, 0, 0}, {1, 1, 1}}, 1, d));
}

TEST(Bounds, refuse_an_order_that_does_not_exist) {
  Derivative_bounds d;
  EXPECT_THROW(Formula("x").bounds({}, 5, d), std::invalid_argument);
  EXPECT_THROW(Formula("x").bounds({}, -1, d), std::invalid_argument);
}
