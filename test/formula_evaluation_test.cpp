// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Random formulas: one at a time, many points at once, in threads, against jets and against finite differences.

#include "derivatives_list.h"

#include <CGAL/Extremal_mesh_3/Formula.h>
#include <CGAL/Extremal_mesh_3/Jet.h>
#include <CGAL/Extremal_mesh_3/internal/Taylor_indices.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <thread>
#include <vector>

using namespace CGAL::Extremal_mesh_3;

namespace {

struct Random_formula {
  std::string text;
  std::function<Jet(const std::array<Jet, 3>&)> jet; ///< the same, computed with jets
};

/// makes formulas that are smooth everywhere, without large numbers.
class Generator {
public:
  explicit Generator(unsigned seed) : random_(seed) {}

  double number(double low, double high) {
    // Not a distribution of <random>: their results differ between libraries.
    return low + (high - low) * static_cast<double>(random_()) / 4294967296.0;
  }
  Point point() { return {number(-1.5, 1.5), number(-1.5, 1.5), number(-1.5, 1.5)}; }

  Random_formula make(int depth) {
    if (depth == 0)
      return leaf();
    if (pick(10) < 5)
      return binary(depth);
    return unary(depth);
  }

private:
  unsigned pick(unsigned n) { return static_cast<unsigned>(random_() % n); }

  Random_formula leaf() {
    if (pick(4) == 0) {
      const double c = 0.25 * (1 + pick(8));
      return {std::to_string(c), [c](const auto&) { return Jet(c); }};
    }
    const unsigned axis = pick(3);
    return {std::string(1, "xyz"[axis]), [axis](const auto& p) { return p[axis]; }};
  }

  Random_formula unary(int depth) {
    const Random_formula u = make(depth - 1);
    const auto f = [u](const std::string& before, const std::string& after, auto of) {
      return Random_formula{before + u.text + after, [u, of](const auto& p) { return Jet(of(u.jet(p))); }};
    };
    switch (pick(18)) {
    // clang-format off
    case 0: return f("-(", ")", [](Jet a) { return -a; });
    case 1: return f("(", ")^2", [](Jet a) { return square(a); });
    case 2: return f("sin(", ")^3", [](Jet a) { return pow(sin(a), 3); });
    case 3: return f("1/(2 + sin(", "))", [](Jet a) { return 1 / (2 + sin(a)); });
    case 4: return f("sqrt(1.5 + (", ")^2)", [](Jet a) { return sqrt(1.5 + a * a); });
    case 5: return f("cbrt(2 + cos(", "))", [](Jet a) { return cbrt(2 + cos(a)); });
    case 6: return f("exp(sin(", "))", [](Jet a) { return exp(sin(a)); });
    case 7: return f("log(1.2 + (", ")**2)", [](Jet a) { return log(1.2 + a * a); });
    case 8: return f("log10(3 + sin(", "))", [](Jet a) { return log10(3 + sin(a)); });
    case 9: return f("log2(3 + cos(", "))", [](Jet a) { return log2(3 + cos(a)); });
    case 10: return f("tan(0.7*sin(", "))", [](Jet a) { return tan(0.7 * sin(a)); });
    case 11: return f("asin(0.7*sin(", "))", [](Jet a) { return asin(0.7 * sin(a)); });
    case 12: return f("acos(0.7*cos(", "))", [](Jet a) { return acos(0.7 * cos(a)); });
    case 13: return f("atan(", ")", [](Jet a) { return atan(a); });
    case 14: return f("sinh(cos(", "))", [](Jet a) { return sinh(cos(a)); });
    case 15: return f("cosh(sin(", "))", [](Jet a) { return cosh(sin(a)); });
    case 16: return f("tanh(", ")", [](Jet a) { return tanh(a); });
    default: return f("(2 + sin(", "))^-1.7", [](Jet a) { return pow(2 + sin(a), -1.7); });
      // clang-format on
    }
  }

  Random_formula binary(int depth) {
    const Random_formula u = make(depth - 1), v = make(depth - 1);
    const auto f = [u, v](const std::string& before, const std::string& between, const std::string& after, auto of) {
      return Random_formula{before + u.text + between + v.text + after,
                            [u, v, of](const auto& p) { return Jet(of(u.jet(p), v.jet(p))); }};
    };
    switch (pick(8)) {
    // clang-format off
    case 0: return f("(", " + ", ")", [](Jet a, Jet b) { return a + b; });
    case 1: return f("(", " - (", "))", [](Jet a, Jet b) { return a - b; });
    case 2: return f("sin(", ")*cos(", ")", [](Jet a, Jet b) { return sin(a) * cos(b); });
    case 3: return f("(", ")*(", ")", [](Jet a, Jet b) { return a * b; });
    case 4: return f("(", ")/(2 + sin(", "))", [](Jet a, Jet b) { return a / (2 + sin(b)); });
    case 5: return f("(2 + sin(", "))^sin(", ")", [](Jet a, Jet b) { return pow(2 + sin(a), sin(b)); });
    case 6: return f("atan2(2 + sin(", "), ", ")", [](Jet a, Jet b) { return atan2(2 + sin(a), b); });
    default: return f("hypot(", ", 2 + sin(", "))", [](Jet a, Jet b) { return hypot(a, 2 + sin(b)); });
      // clang-format on
    }
  }

  std::mt19937 random_;
};

std::array<Jet, 3> variables(const Point& p) {
  return {Jet::variable(p[0], 0), Jet::variable(p[1], 1), Jet::variable(p[2], 2)};
}

/// the largest absolute value, by which rounding errors of sums are measured.
double size(const std::vector<double>& numbers) {
  double largest = 0;
  for (const double number : numbers)
    largest = std::max(largest, std::abs(number));
  return largest;
}

} // namespace

TEST(Formula_evaluation, agrees_with_jets_on_random_formulas) {
  for (unsigned seed = 0; seed < 1000; ++seed) {
    Generator generator(seed);
    const Random_formula random = generator.make(1 + static_cast<int>(seed % 5));
    const Formula formula(random.text);
    const Point p = generator.point();
    Derivatives computed;
    formula.derivatives(p, 4, computed);
    const std::vector<double> a = list(computed, 4), b = list(Derivatives(random.jet(variables(p))), 4);
    for (std::size_t i = 0; i < a.size(); ++i)
      ASSERT_NEAR(a[i], b[i], 1e-11 * (1 + size(b))) << random.text << ", seed " << seed << ", entry " << i;
  }
}

TEST(Formula_evaluation, agrees_with_finite_differences_of_the_order_below) {
  // The central difference of order 8; with this step both its error and rounding's are about 1e-12 of the derivatives.
  constexpr double h = 1.0 / 64;
  constexpr std::array<double, 4> weight{4.0 / 5, -1.0 / 5, 4.0 / 105, -1.0 / 280};
  // where, in the list of all derivatives, one differentiates again by z, y, x: by the multi-index
  const auto index = [](int a, int b, int c) { return internal::taylor_index(a, b, c); };
  for (unsigned seed = 0; seed < 200; ++seed) {
    Generator generator(seed);
    const std::string text = generator.make(1 + static_cast<int>(seed % 3)).text;
    const Formula formula(text);
    const Point p = generator.point();
    Derivatives d;
    formula.derivatives(p, 4, d);
    const std::vector<double> exact = list(d, 4);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      std::vector<double> difference(20, 0);
      for (int s = 1; s <= 4; ++s)
        for (const int sign : {1, -1}) {
          Point q = p;
          q[axis] += sign * s * h;
          formula.derivatives(q, 3, d);
          const std::vector<double> there = list(d, 3);
          for (std::size_t i = 0; i < there.size(); ++i)
            difference[i] += sign * weight[static_cast<std::size_t>(s - 1)] * there[i] / h;
        }
      for (int a = 0; a <= 3; ++a)
        for (int b = 0; a + b <= 3; ++b)
          for (int c = 0; a + b + c <= 3; ++c)
            ASSERT_NEAR(difference[index(a, b, c)], exact[index(a + (axis == 0), b + (axis == 1), c + (axis == 2))],
                        1e-7 * (1 + size(exact)))
                << text << ", seed " << seed << ": derivative " << a << b << c << " by axis " << axis;
    }
  }
}

TEST(Formula_evaluation, gives_the_same_bits_for_one_point_and_many_at_every_order) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    Generator generator(seed);
    const Formula formula(generator.make(1 + static_cast<int>(seed % 5)).text);
    std::vector<Point> points(1 + seed % 19); // whole batches and parts of them
    for (Point& p : points)
      p = generator.point();
    for (int order = 1; order <= 4; ++order) {
      std::vector<Derivatives> many(points.size());
      formula.derivatives(points, order, many);
      for (std::size_t i = 0; i < points.size(); ++i) {
        Derivatives one;
        formula.derivatives(points[i], 4, one);
        ASSERT_EQ(bits(list(many[i], order)), bits(list(one, order))) << "seed " << seed << ", order " << order;
        ASSERT_EQ(bits({formula.value(points[i])}), bits({one.value})) << "seed " << seed;
      }
    }
  }
}

TEST(Formula_evaluation, gives_the_same_bits_on_a_lattice) {
  const Lattice lattice{{-1, -0.9, 0.1}, {{{0.1, 0.01, 0}, {-0.02, 0.13, 0}, {0, 0.003, 0.3}}}, {13, 11, 3}};
  for (unsigned seed = 0; seed < 50; ++seed) {
    const Formula formula(Generator(seed).make(3).text);
    for (std::size_t k = 0; k < lattice.size[2]; ++k) {
      std::vector<double> values(lattice.size[0] * lattice.size[1]), expected;
      formula.lattice_values(lattice, k, values.data());
      for (std::size_t j = 0; j < lattice.size[1]; ++j)
        for (std::size_t i = 0; i < lattice.size[0]; ++i)
          expected.push_back(
              formula.value(lattice.node(static_cast<double>(i), static_cast<double>(j), static_cast<double>(k))));
      ASSERT_EQ(bits(values), bits(expected)) << "seed " << seed;
    }
  }
}

TEST(Formula_evaluation, gives_the_same_bits_on_parts_of_a_lattice) {
  const Lattice lattice{{-1, -0.9, 0.1}, {{{0.1, 0.01, 0}, {-0.02, 0.13, 0}, {0, 0.003, 0.3}}}, {90, 4, 3}};
  const Formula formula("sin(3*x)*y + exp(z) - x^2");
  std::vector<double> whole(lattice.size[0] * lattice.size[1]), parts(whole.size(), 0);
  formula.lattice_values(lattice, 1, whole.data());
  const std::vector<Row_part> rows{{0, 3, 80}, {2, 0, 1}, {2, 50, 90}};
  formula.lattice_values(lattice, 1, rows, parts.data());
  std::vector<double> expected(whole.size(), 0);
  for (const Row_part& part : rows)
    for (std::size_t i = part.first; i < part.last; ++i)
      expected[part.j * 90 + i] = whole[part.j * 90 + i];
  EXPECT_EQ(bits(parts), bits(expected));
}

TEST(Formula_evaluation, gives_the_same_bits_with_special_values) {
  // kinks, borders of domains, zeros of both signs, infinities
  const std::vector<std::string> texts{"sqrt(x)", "log(x)*y", "min(x, y)", "max(x, y, z)", "abs(x)",      "-x*y",
                                       "x/y",     "x^y",      "x^2.5",     "x^-2",         "atan2(x, y)", "cbrt(x)"};
  const std::vector<double> special{0, -0.0, 1, -1, 1e300, -1e-300, HUGE_VAL, -HUGE_VAL};
  std::vector<Point> points;
  for (const double x : special)
    for (const double y : special)
      points.push_back({x, y, 1});
  for (const std::string& text : texts) {
    const Formula formula(text);
    std::vector<Derivatives> many(points.size());
    formula.derivatives(points, 4, many);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double value = formula.value(points[i]);
      if (std::isnan(value))
        EXPECT_TRUE(std::isnan(many[i].value)) << text;
      else
        EXPECT_EQ(bits({value}), bits({many[i].value})) << text << " at " << points[i][0] << ' ' << points[i][1];
    }
  }
}

TEST(Formula_evaluation, gives_the_same_bits_in_every_thread) {
  const Formula formula(Generator(7).make(5).text);
  const Formula other(Generator(8).make(6).text); // takes turns, so that scratch memory is shared
  Generator generator(9);
  std::vector<Point> points(500);
  for (Point& p : points)
    p = generator.point();
  const auto evaluate = [&] {
    std::vector<double> all;
    for (const Point& p : points) {
      Derivatives d;
      other.derivatives(p, 3, d);
      formula.derivatives(p, 4, d);
      const std::vector<double> one = list(d, 4);
      all.insert(all.end(), one.begin(), one.end());
      all.push_back(formula.value(p));
    }
    return bits(all);
  };
  const auto expected = evaluate();
  std::vector<std::vector<std::uint64_t>> results(4);
  std::vector<std::thread> threads;
  for (auto& result : results)
    threads.emplace_back([&] { result = evaluate(); });
  for (std::thread& thread : threads)
    thread.join();
  for (const auto& result : results)
    EXPECT_EQ(result, expected);
}

TEST(Formula_evaluation, shares_equal_subexpressions_without_changing_results) {
  // a tower in which every level is used twice
  std::string text = "x";
  for (int i = 0; i < 12; ++i)
    text = "(" + text + ")*(" + text + ")/2";
  Derivatives d;
  Formula(text).derivatives({2, 0, 0}, 4, d);
  EXPECT_EQ(d.value, 2);          // x = 2 is the fixed point of x²/2
  EXPECT_EQ(d.gradient[0], 4096); // where each level doubles the derivative
}
