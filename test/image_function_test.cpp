// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Most expected values are exact: convolving a monomial xᵃ with a Gaussian of width σ gives the heat polynomial m_a
// (m_0 = 1, m_1 = x, m_2 = x² + σ², m_3 = x³ + 3σ²x, …), whose derivative is a m_{a−1}, and a B-spline of degree 5
// holds every polynomial of degree 5.

#include <CGAL/Extremal_mesh_3/Image_function.h>

#include "derivatives_list.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <utility>

namespace CGAL::Extremal_mesh_3 {
namespace {

constexpr double degree_of_turn = 3.14159265358979323846 / 180;

Lattice cubic_lattice(std::size_t n) {
  return {{0, 0, 0}, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {n, n, n}};
}

Image sampled(const Lattice& lattice, const std::function<double(const Point&)>& f) {
  Image image{lattice, {}};
  for (std::size_t k = 0; k < lattice.size[2]; ++k)
    for (std::size_t j = 0; j < lattice.size[1]; ++j)
      for (std::size_t i = 0; i < lattice.size[0]; ++i)
        image.voxels.push_back(static_cast<float>(
            f(lattice.node(static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)))));
  return image;
}

Image noise(const Lattice& lattice, unsigned seed = 1) {
  std::mt19937 random(seed);
  return sampled(lattice, [&](const Point&) { return static_cast<double>(random() % 2000) - 1000; });
}

Image_function_options options_with(double sigma, int degree = 0) {
  Image_function_options options;
  options.sigma = sigma;
  options.degree = degree;
  return options;
}

std::vector<double> flat(const Derivatives& d) {
  return list(d, 4);
}

Derivatives derivatives(const Image_function& f, const Point& p) {
  Derivatives d;
  f.derivatives(p, 4, d);
  return d;
}

// The k-th derivative of the heat polynomial m_a.
double heat_polynomial(int a, int k, double x, double sigma) {
  if (k > a)
    return 0;
  double factor = 1;
  for (int i = 0; i < k; ++i)
    factor *= a - i;
  double before = 0, m = 1; // m_{n+1} = x m_n + n σ² m_{n−1}
  for (int n = 0; n < a - k; ++n)
    before = std::exchange(m, x * m + n * sigma * sigma * before);
  return factor * m;
}

struct Monomial {
  double factor;
  std::array<int, 3> power;
};

// Of total degree 5, with values of a few hundred some ten mm around the origin.
const std::vector<Monomial> polynomial{{3, {0, 0, 0}},      {2, {1, 0, 0}},     {-1, {0, 1, 0}},    {1.5, {0, 0, 1}},
                                       {0.3, {1, 1, 0}},    {-0.2, {0, 1, 1}},  {0.25, {2, 0, 0}},  {0.02, {3, 0, 0}},
                                       {0.03, {1, 1, 1}},   {-0.02, {0, 2, 1}}, {0.001, {2, 2, 0}}, {0.002, {0, 1, 3}},
                                       {0.0015, {0, 4, 0}}, {1e-4, {5, 0, 0}},  {-1e-4, {1, 2, 2}}, {1e-4, {0, 1, 4}}};

double polynomial_value(const Point& p) {
  double sum = 0;
  for (const auto& [factor, power] : polynomial)
    sum += factor * std::pow(p[0], power[0]) * std::pow(p[1], power[1]) * std::pow(p[2], power[2]);
  return sum;
}

// The derivatives of −(smoothed polynomial), in the order of flat().
std::vector<double> smoothed_polynomial(const Point& p, double sigma) {
  std::vector<double> all;
  for (int order = 0; order <= 4; ++order)
    for (int kx = order; kx >= 0; --kx)
      for (int ky = order - kx; ky >= 0; --ky) {
        double sum = 0;
        for (const auto& [factor, power] : polynomial)
          sum += factor * heat_polynomial(power[0], kx, p[0], sigma) * heat_polynomial(power[1], ky, p[1], sigma) *
                 heat_polynomial(power[2], order - kx - ky, p[2], sigma);
        all.push_back(-sum);
      }
  return all;
}

// The lattice of a box of half-width 13 around the origin, with the given steps.
Lattice centred(const std::array<Vector, 3>& step, const std::array<std::size_t, 3>& size) {
  Lattice lattice{{}, step, size};
  const Point middle = lattice.node(0.5 * static_cast<double>(size[0] - 1), 0.5 * static_cast<double>(size[1] - 1),
                                    0.5 * static_cast<double>(size[2] - 1));
  for (std::size_t a = 0; a < 3; ++a)
    lattice.origin[a] = -middle[a];
  return lattice;
}

std::vector<std::pair<std::string, Lattice>> lattices() {
  const double c = std::cos(20 * degree_of_turn), s = std::sin(20 * degree_of_turn);
  const double e = std::cos(50 * degree_of_turn), t = std::sin(50 * degree_of_turn);
  return {
      {"cubes", centred({{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {60, 60, 60})},
      {"permuted", centred({{{0, 1, 0}, {0, 0, 1}, {1, 0, 0}}}, {60, 60, 60})},
      {"left-handed", centred({{{1, 0, 0}, {0, -1, 0}, {0, 0, 1}}}, {60, 60, 60})},
      {"anisotropic", centred({{{1, 0, 0}, {0, 1, 0}, {0, 0, 0.5}}}, {60, 60, 110})},
      {"rotated", centred({{{c, s, 0}, {-s * e, c * e, t}, {s * t, -c * t, e}}}, {70, 70, 70})},
      {"rotated, left-handed, anisotropic",
       centred({{{0.8 * c, 0.8 * s, 0}, {-s * e, c * e, t}, {-0.5 * s * t, 0.5 * c * t, -0.5 * e}}}, {80, 70, 130})}};
}

} // namespace

TEST(Image_function, has_the_derivatives_of_a_smoothed_polynomial_on_any_lattice) {
  const std::vector<Point> points{{0, 0, 0}, {1.3, -2.7, 0.4}, {-3.5, 1.25, 4.1}, {4.9, 4.2, -4.7}};
  for (const auto& [name, lattice] : lattices()) {
    const Image image = sampled(lattice, polynomial_value);
    for (const auto& [sigma, degree] : {std::pair{1.0, 7}, {1.0, 5}, {1.5, 5}, {2.3, 5}, {2.3, 7}}) {
      const Image_function f(image, options_with(sigma, degree));
      for (const Point& p : points) {
        const auto expected = smoothed_polynomial(p, sigma);
        const auto found = flat(derivatives(f, p));
        for (std::size_t i = 0; i < found.size(); ++i) {
          // Coefficients within reach of the kernel are below 4e4, of which float keeps 6e-8 and the kernel 1e-7.
          EXPECT_NEAR(found[i], expected[i], 5e-3)
              << name << ", sigma " << sigma << ", degree " << degree << ", derivative " << i;
        }
      }
    }
  }
}

TEST(Image_function, follows_the_continuous_gaussian_closer_with_degree_7) {
  // A blob exp(−r²/2s²) has the third derivatives of a blob of variance s² + σ² when smoothed.
  const double s = 1.2, sigma = 1.5, variance = s * s + sigma * sigma;
  const Point centre{12.3, 11.8, 12.6};
  const Image image = sampled(cubic_lattice(25), [&](const Point& p) {
    return std::exp(-(std::pow(p[0] - centre[0], 2) + std::pow(p[1] - centre[1], 2) + std::pow(p[2] - centre[2], 2)) /
                    (2 * s * s));
  });
  const auto error_of = [&](int degree) {
    Image_function_options options = options_with(sigma, degree);
    options.iso = 0.5;
    const Image_function f(image, options);
    double worst = 0, largest = 0;
    for (double t = -4; t <= 4; t += 0.13) {
      const double x = t, y = 0.3;
      const double scale = -std::pow(s * s / variance, 1.5) * std::exp(-(x * x + 2 * y * y) / (2 * variance));
      const double expected = scale * (3 * x / (variance * variance) - x * x * x / std::pow(variance, 3));
      const double found = derivatives(f, {centre[0] + x, centre[1] + y, centre[2] + y}).third[0];
      worst = std::max(worst, std::abs(found - expected));
      largest = std::max(largest, std::abs(expected));
    }
    return worst / largest;
  };
  EXPECT_LT(error_of(5), 2e-2);
  EXPECT_LT(error_of(7), 2e-3);
}

TEST(Image_function, equals_the_sampled_gaussian_at_the_nodes) {
  const Image image = noise(cubic_lattice(33));
  for (double sigma : {0.9, 1.0, 1.4}) {
    const Image_function f(image, options_with(sigma));
    double sum = 0, weights = 0;
    for (std::size_t k = 0; k < 33; ++k)
      for (std::size_t j = 0; j < 33; ++j)
        for (std::size_t i = 0; i < 33; ++i) {
          const double x = static_cast<double>(i) - 16, y = static_cast<double>(j) - 16,
                       z = static_cast<double>(k) - 16;
          const double weight = std::exp(-(x * x + y * y + z * z) / (2 * sigma * sigma));
          sum += weight * static_cast<double>(image.voxels[i + 33 * (j + 33 * k)]);
          weights += weight;
        }
    EXPECT_NEAR(f.value({16, 16, 16}), -sum / weights, 1e-3) << sigma; // voxels up to 1000 in float
  }
}

TEST(Image_function, has_the_derivatives_of_its_values) {
  const Lattice lattice = lattices().back().second;
  for (int degree : {5, 7}) {
    const Image_function f(noise(lattice), options_with(1.2, degree));
    const Point p{0.37, -1.21, 2.03};
    const Derivatives d = derivatives(f, p);
    // Central differences: h² / 6 times the second-next derivative (about 1e3), and rounding 1e-13 / h.
    const double h = 1e-5, tolerance = 1e-5;
    const auto difference = [&](std::size_t axis, const auto& entry) {
      Point before = p, after = p;
      before[axis] -= h;
      after[axis] += h;
      return (entry(derivatives(f, after)) - entry(derivatives(f, before))) / (2 * h);
    };
    EXPECT_EQ(d.value, f.value(p));
    for (std::size_t a = 0; a < 3; ++a)
      EXPECT_NEAR(d.gradient[a], difference(a, [](const Derivatives& e) { return e.value; }), tolerance);
    const auto xy = [](const Derivatives& e) { return e.gradient[0]; };
    EXPECT_NEAR(d.hessian[0], difference(0, xy), tolerance);
    EXPECT_NEAR(d.hessian[1], difference(1, xy), tolerance);
    EXPECT_NEAR(d.hessian[2], difference(2, xy), tolerance);
    const auto yz = [](const Derivatives& e) { return e.hessian[4]; };
    EXPECT_NEAR(d.third[4], difference(0, yz), tolerance);
    EXPECT_NEAR(d.third[7], difference(1, yz), tolerance);
    EXPECT_NEAR(d.third[8], difference(2, yz), tolerance);
    const auto xyz = [](const Derivatives& e) { return e.third[4]; };
    EXPECT_NEAR(d.fourth[4], difference(0, xyz), tolerance);
    EXPECT_NEAR(d.fourth[7], difference(1, xyz), tolerance);
    EXPECT_NEAR(d.fourth[8], difference(2, xyz), tolerance);
  }
}

TEST(Image_function, gives_the_same_lower_orders_whatever_the_order) {
  const Image_function f(noise(cubic_lattice(20)), options_with(1.5));
  const Point p{9.3, 8.1, 10.7};
  const auto all = flat(derivatives(f, p));
  for (int order = 1; order <= 3; ++order) {
    Derivatives d;
    d.third.fill(-7);
    d.fourth.fill(-7);
    f.derivatives(p, order, d);
    const auto found = flat(d);
    const std::size_t n = order == 1 ? 4 : order == 2 ? 10 : 20;
    for (std::size_t i = 0; i < n; ++i)
      EXPECT_EQ(found[i], all[i]) << order;
    EXPECT_EQ(d.fourth[0], -7) << "orders that were not asked for are left alone";
  }
  Derivatives d;
  EXPECT_THROW(f.derivatives(p, 0, d), std::invalid_argument);
  EXPECT_THROW(f.derivatives(p, 5, d), std::invalid_argument);
}

TEST(Image_function, has_continuous_fourth_derivatives) {
  for (int degree : {5, 7}) {
    const Image_function f(noise(cubic_lattice(24)), options_with(1.5, degree));
    for (const Point& p : {Point{11, 9.4, 10.2}, Point{10.6, 12, 10.2}, Point{8, 9, 11}}) {
      constexpr double step = 1e-9; // times the fifth derivative, a few hundred
      const auto before = flat(derivatives(f, {p[0] - step, p[1] - step, p[2] - step}));
      const auto after = flat(derivatives(f, {p[0] + step, p[1] + step, p[2] + step}));
      for (std::size_t i = 0; i < before.size(); ++i)
        EXPECT_NEAR(before[i], after[i], 1e-5) << "derivative " << i;
    }
  }
}

TEST(Image_function, puts_nodes_between_slices_that_are_too_far_apart) {
  // A Gaussian of width s, smoothed, is one of width √(s² + σ²); slices are 1.5 σ apart.
  const double s = 3, sigma = 1, width = std::sqrt(s * s + sigma * sigma);
  const auto blob = [](double x, double w) { return std::exp(-x * x / (2 * w * w)) / w; };
  for (const std::size_t axis : {0U, 1U, 2U}) {
    Lattice lattice = centred({{{0.9, 0, 0}, {0, 0.9, 0}, {0, 0, 0.9}}}, {41, 41, 41});
    lattice.step[axis][axis] = 1.5;
    lattice.size[axis] = 25;
    lattice.origin[axis] = -18;
    Image_function_options options = options_with(sigma);
    options.iso = 0.001;
    const Image_function f(
        sampled(lattice, [&](const Point& p) { return blob(p[0], s) * blob(p[1], s) * blob(p[2], s); }), options);
    EXPECT_EQ(f.lattice().size[axis], 49U);
    for (const Point& p : {Point{0.3, 0.2, 1.1}, Point{-2.3, 1.9, 0.4}, Point{1.2, -3.1, -2.2}}) {
      const Derivatives d = derivatives(f, p);
      const double g = blob(p[0], width) * blob(p[1], width) * blob(p[2], width), w2 = width * width;
      EXPECT_NEAR(d.value, options.iso - g, 5e-4 * g); // the cubic spline: h⁴ max|g⁗|/384, h = s/2
      const double x = p[axis];
      EXPECT_NEAR(d.gradient[axis], g * x / w2, 1e-3 * g / width);
      const double third = g * (x * x * x / (w2 * w2 * w2) - 3 * x / (w2 * w2));
      const double found = d.third[axis == 0 ? 0 : axis == 1 ? 6 : 9];
      EXPECT_NEAR(found, third, 0.02 * g / (w2 * width));
    }
  }
}

TEST(Image_function, is_negative_inside_bright_regions) {
  const Image image = sampled(cubic_lattice(32), [](const Point& p) {
    return std::hypot(p[0] - 15.5, p[1] - 15.5, p[2] - 15.5) < 9 ? 100 : 0;
  });
  Image_function_options options = options_with(1.5);
  options.iso = 50;
  const Image_function f(image, options);
  EXPECT_NEAR(f.value({15.5, 15.5, 15.5}), -50, 1e-3);
  EXPECT_NEAR(f.value({1, 1, 1}), 50, 1e-3);
  EXPECT_GT(derivatives(f, {24.5, 15.5, 15.5}).gradient[0], 0) << "the normal points outwards";
}

TEST(Image_function, takes_sigma_in_mm) {
  // One function, sampled with voxels of 3.2 x 3.2 x 1.5 and of 1.6 x 1.6 x 1.5 mm.
  const auto wave = [](const Point& p) {
    return 100 * std::sin(p[0] / 9) * std::sin(p[1] / 11 + 1) * std::cos(p[2] / 10);
  };
  const Image coarse = sampled({{0, 0, 0}, {{{3.2, 0, 0}, {0, 3.2, 0}, {0, 0, 1.5}}}, {30, 30, 60}}, wave);
  const Image fine = sampled({{0, 0, 0}, {{{1.6, 0, 0}, {0, 1.6, 0}, {0, 0, 1.5}}}, {59, 59, 60}}, wave);
  const Image_function f(coarse, {});
  EXPECT_EQ(f.sigma(), 3.2) << "the largest side of a voxel";
  EXPECT_EQ(f.degree(), 7) << "sigma is one voxel";
  const Image_function g(fine, options_with(3.2));
  EXPECT_EQ(g.degree(), 5) << "sigma is two voxels";
  const Point p{47.1, 45.3, 43.2};
  // exp(−σ²ω²/2) along each axis
  const double damping = std::exp(-0.5 * 3.2 * 3.2 * (1 / 81.0 + 1 / 121.0 + 1 / 100.0));
  EXPECT_NEAR(f.value(p), -damping * wave(p), 1e-4);
  const auto on_coarse = flat(derivatives(f, p)), on_fine = flat(derivatives(g, p));
  for (std::size_t i = 0; i < on_coarse.size(); ++i)
    EXPECT_NEAR(on_coarse[i], on_fine[i], 1e-4) << i;
}

TEST(Image_function, has_the_same_bits_for_any_number_of_threads) {
  const Lattice lattice{{0, 0, 0}, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 2}}}, {37, 41, 29}};
  std::vector<std::vector<double>> all;
  for (int threads : {1, 2, 3, 8, 0}) {
    Image_function_options options = options_with(2.5);
    options.threads = threads;
    const Image_function f(noise(lattice), options);
    std::vector<double> values(37 * 41 * 29);
    for (std::size_t k = 0; k < 29; ++k)
      f.lattice_values(lattice, k, values.data() + 37 * 41 * k);
    all.push_back(values);
  }
  for (const auto& values : all)
    EXPECT_EQ(values, all.front());
}

TEST(Image_function, smooths_a_part_as_the_whole) {
  const Image whole = noise(cubic_lattice(64));
  Image part{{{0, 0, 16}, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {64, 64, 40}}, {}};
  part.voxels.assign(whole.voxels.begin() + 16 * 64 * 64, whole.voxels.begin() + 56 * 64 * 64);
  const Image_function f(whole, options_with(1.5)), g(part, options_with(1.5));
  const Point p{30.25, 31.5, 36.75}; // farther from the part's border than the kernel reaches
  EXPECT_EQ(flat(derivatives(f, p)), flat(derivatives(g, p)));
}

TEST(Image_function, may_take_the_image_over) {
  Image image = noise(cubic_lattice(20));
  const Image_function f(image, options_with(1.5)), g(std::move(image), options_with(1.5));
  const Point p{9.3, 8.1, 10.7};
  EXPECT_EQ(flat(derivatives(f, p)), flat(derivatives(g, p)));
}

TEST(Image_function, gives_its_values_at_the_nodes_of_its_lattice) {
  const Lattice lattice{{5, -3, 2}, {{{1, 0, 0}, {0, 0, 1}, {0, 1.5, 0}}}, {19, 21, 11}};
  for (int degree : {5, 7}) {
    const Image_function f(noise(lattice), options_with(1.7, degree));
    std::vector<double> fast(19 * 21), slow(19 * 21);
    for (std::size_t k = 0; k < 11; ++k) {
      f.lattice_values(lattice, k, fast.data());
      f.Function_3::lattice_values(lattice, k, slow.data());
      for (std::size_t i = 0; i < fast.size(); ++i)
        EXPECT_NEAR(fast[i], slow[i], 1e-10) << k << ", " << i; // rounding of values up to 1000
    }
  }
}

TEST(Image_function, knows_its_values_half_way_between_nodes) {
  const Lattice lattice{{5, -3, 2}, {{{1, 0, 0}, {0, 0, 1}, {0, 1.5, 0}}}, {12, 5, 4}};
  for (int degree : {5, 7}) {
    const Image_function f(noise(lattice), options_with(1.7, degree));
    std::array<double, 27> values;
    for (const std::array<std::size_t, 3>& cube : {std::array<std::size_t, 3>{0, 0, 0}, {4, 2, 1}, {10, 3, 2}}) {
      ASSERT_TRUE(f.half_step_values(lattice, cube, values));
      for (std::size_t i = 0; i < 27; ++i)
        EXPECT_NEAR(
            values[i],
            f.value(lattice.node(double(cube[0]) + 0.5 * double(i % 3), double(cube[1]) + 0.5 * double(i / 3 % 3),
                                 double(cube[2]) + 0.5 * double(i / 9))),
            1e-10); // rounding of values up to 1000
    }
    EXPECT_FALSE(f.half_step_values(cubic_lattice(12), {0, 0, 0}, values));
  }
}

TEST(Image_function, finds_roots_on_the_edges_of_its_lattice) {
  const Lattice lattice{{5, -3, 2}, {{{1, 0, 0}, {0, 0, 1}, {0, 1.5, 0}}}, {12, 9, 7}};
  for (int degree : {5, 7}) {
    const Image_function f(noise(lattice), options_with(1.7, degree));
    std::array<std::size_t, 3> found{};
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (std::size_t k = 0; k + 1 < 7; ++k)
        for (std::size_t j = 0; j + 1 < 9; ++j)
          for (std::size_t i = 0; i + 1 < 12; ++i) {
            const auto at = [&](double t) {
              return lattice.node(double(i) + (axis == 0 ? t : 0), double(j) + (axis == 1 ? t : 0),
                                  double(k) + (axis == 2 ? t : 0));
            };
            const double v0 = f.value(at(0)), v1 = f.value(at(1));
            if ((v0 >= 0) == (v1 >= 0))
              continue;
            const auto t = f.root_on_edge(lattice, {i, j, k}, axis, v0, v1);
            ASSERT_TRUE(t);
            EXPECT_TRUE(*t >= 0 && *t <= 1);
            EXPECT_NEAR(f.value(at(*t)), 0, 1e-10); // rounding of values up to 1000
            ++found[axis];
          }
    EXPECT_TRUE(found[0] > 9 && found[1] > 9 && found[2] > 9);
    EXPECT_FALSE(f.root_on_edge(cubic_lattice(12), {0, 0, 0}, 0, -1, 1));
  }
}

TEST(Image_function, gives_its_values_at_the_nodes_of_another_lattice) {
  const Image_function f(noise(cubic_lattice(20)), options_with(1.5));
  const Lattice other{{3.1, 4.2, 5.3}, {{{0.3, 0, 0}, {0, 0.4, 0}, {0, 0, 0.5}}}, {5, 4, 3}};
  std::vector<double> values(20);
  f.lattice_values(other, 2, values.data());
  EXPECT_EQ(values[3 + 5 * 1], f.value(other.node(3, 1, 2)));
}

TEST(Image_function, is_continued_by_its_border_values) {
  const Image_function f(noise(cubic_lattice(8)), options_with(1.5));
  const double far = f.value({4.5, 1000, 3.2});
  EXPECT_EQ(f.value({4.5, 20, 3.2}), far);
  EXPECT_EQ(f.value({4.5, 1e300, 3.2}), far);
  EXPECT_NEAR(derivatives(f, {4.5, 20, 3.2}).gradient[1], 0, 1e-10);
  EXPECT_TRUE(std::isfinite(f.value({-0.3, 7.9, -2})));
}

TEST(Image_function, is_not_a_number_where_the_point_is_not) {
  const Image_function f(noise(cubic_lattice(8)), options_with(1.5));
  EXPECT_TRUE(std::isnan(f.value({std::numeric_limits<double>::quiet_NaN(), 1, 1})));
  for (double x : flat(derivatives(f, {1, std::numeric_limits<double>::infinity(), 1})))
    EXPECT_TRUE(std::isnan(x));
}

TEST(Image_function, refuses_an_iso_value_outside_the_image_and_names_the_range) {
  const Image image = sampled(cubic_lattice(8), [](const Point& p) { return p[0] - 2; });
  Image_function_options options;
  for (double iso : {-2.0, 5.0, 17.0}) {
    options.iso = iso;
    try {
      const Image_function f(image, options);
      FAIL() << iso;
    } catch (const Extraction_error& error) {
      EXPECT_NE(std::string(error.what()).find("-2 to 5"), std::string::npos) << error.what();
    }
  }
}

TEST(Image_function, refuses_what_it_cannot_use) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Image good = noise(cubic_lattice(8));
  const auto refuses = [](const Image& image, const Image_function_options& options) {
    EXPECT_THROW(Image_function(image, options), std::invalid_argument);
  };
  for (double sigma : {-1.0, 0.2, 0.44, 9.0, nan})
    refuses(good, options_with(sigma));
  EXPECT_NO_THROW(Image_function(good, options_with(0.45)));
  refuses(good, options_with(1.5, 6));
  Image_function_options options;
  options.iso = nan;
  refuses(good, options);
  options = {};
  options.threads = -1;
  refuses(good, options);

  Image image = good;
  image.voxels.pop_back();
  refuses(image, {});
  image = good;
  image.voxels[77] = std::numeric_limits<float>::infinity();
  refuses(image, {});
  image = good;
  image.lattice.step[2] = image.lattice.step[1];
  refuses(image, {});
  image = good;
  image.lattice.step[0][0] = nan;
  refuses(image, {});
  image = good;
  image.lattice.origin[1] = nan;
  refuses(image, {});
  refuses(Image{}, {});
}

TEST(Image_function, names_the_smallest_sigma_that_works) {
  const Image image = noise({{0, 0, 0}, {{{3.2, 0, 0}, {0, 3.2, 0}, {0, 0, 1.5}}}, {8, 8, 8}});
  try {
    const Image_function f(image, options_with(1.4));
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("at least 1.44 mm"), std::string::npos) << error.what();
  }
}

TEST(Image_function, reports_progress_and_can_be_cancelled) {
  Image_function_options options = options_with(1.5);
  double last = 0;
  options.progress = [&](double share) {
    EXPECT_GT(share, last);
    last = share;
    return true;
  };
  const Image image = noise(cubic_lattice(40));
  EXPECT_NO_THROW(Image_function(image, options));
  EXPECT_EQ(last, 1);
  options.progress = [](double share) { return share < 0.3; };
  EXPECT_THROW(Image_function(image, options), Cancelled);
}

} // namespace CGAL::Extremal_mesh_3
