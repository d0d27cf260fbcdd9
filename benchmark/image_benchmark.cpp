// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a smoothed 256³ image costs: its coefficients, its values at all nodes, and the derivatives at the points of its
// surface. One thread. Times of the scan and of the points are the best of three.

#include <CGAL/Extremal_mesh_3/Image_function.h>

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <sys/resource.h>
#include <utility>

using namespace CGAL::Extremal_mesh_3;

namespace {

constexpr std::size_t n = 256;
constexpr double voxels = n * n * n;

double nanoseconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start).count();
}

double best_of_three(double pieces, const std::function<void()>& work) {
  double best = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    const auto start = std::chrono::steady_clock::now();
    work();
    best = std::min(best, nanoseconds_since(start));
  }
  return best / pieces;
}

double peak_in_float_volumes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) * 1024 / (voxels * sizeof(float));
}

// A bumpy thick shell with some noise, about as much surface as a skull has.
Image make_image() {
  Image image{{{0, 0, 0}, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {n, n, n}}, {}};
  image.voxels.reserve(n * n * n);
  std::mt19937 random(1);
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t i = 0; i < n; ++i) {
        const double x = static_cast<double>(i) - 127.5, y = static_cast<double>(j) - 127.5,
                     z = static_cast<double>(k) - 127.5;
        const double r = std::sqrt(x * x + 1.3 * y * y + z * z);
        const double bumps = 4 * std::sin(x / 9) * std::sin(y / 8) * std::sin(z / 10);
        const double noise = static_cast<double>(random() % 1024) / 1024 - 0.5;
        image.voxels.push_back(static_cast<float>(1000 / (1 + std::exp(std::abs(r - 100 + bumps) - 8)) + 50 * noise));
      }
  return image;
}

void run(double sigma, int degree) {
  Image_function_options options;
  options.iso = 500;
  options.sigma = sigma;
  options.degree = degree;
  options.threads = 1;
  Image image = make_image();

  const auto start = std::chrono::steady_clock::now();
  const Image_function function(std::move(image), options);
  const double smoothing = nanoseconds_since(start) / voxels;

  std::vector<double> slice(n * n);
  std::size_t changes = 0;
  const double scan = best_of_three(voxels, [&] {
    std::size_t count = 0;
    for (std::size_t k = 0; k < n; ++k) {
      double* const f = slice.data();
      function.lattice_values(function.lattice(), k, f);
      for (std::size_t i = 0; i + 1 < n * n; ++i)
        count += (f[i] < 0) != (f[i + 1] < 0);
    }
    changes = count;
  });

  std::vector<Point> points; // on the edges along x through the surface
  points.reserve(changes);
  for (std::size_t k = 0; k < n; ++k) {
    function.lattice_values(function.lattice(), k, slice.data());
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t i = 0; i + 1 < n; ++i)
        if ((slice[n * j + i] < 0) != (slice[n * j + i + 1] < 0))
          points.push_back(
              function.lattice().node(static_cast<double>(i) + 0.4, static_cast<double>(j), static_cast<double>(k)));
  }

  double sum = 0;
  const auto time_per_point = [&](auto&& evaluate) {
    return best_of_three(static_cast<double>(points.size()), [&] {
      sum = 0;
      for (const Point& p : points)
        sum += evaluate(p);
    });
  };
  const double value = time_per_point([&](const Point& p) { return function.value(p); });
  Derivatives d;
  const double order_3 = time_per_point([&](const Point& p) { return function.derivatives(p, 3, d), d.third[4]; });
  const double order_4 = time_per_point([&](const Point& p) { return function.derivatives(p, 4, d), d.fourth[4]; });
  fmt::print("{:5.1f} {:7} {:10.2f} {:8.2f} {:8.0f} {:9.0f} {:9.0f} {:10} {:8.2f} {:12.4g}\n", sigma, degree, smoothing,
             scan, value, order_3, order_4, points.size(), peak_in_float_volumes(), sum);
}

} // namespace

int main() {
  fmt::print("A volume of {0} x {0} x {0} voxels, one thread. Memory: the peak so far, in float volumes.\n", n);
  fmt::print("{:>5} {:>7} {:>10} {:>8} {:>8} {:>9} {:>9} {:>10} {:>8} {:>12}\n", "", "", "smoothing", "scan", "value",
             "order 3", "order 4", "", "", "");
  fmt::print("{:>5} {:>7} {:>10} {:>8} {:>8} {:>9} {:>9} {:>10} {:>8} {:>12}\n", "sigma", "degree", "ns/voxel",
             "ns/voxel", "ns/point", "ns/point", "ns/point", "points", "memory", "sum");
  run(1.5, 5);
  run(1.5, 7);
  run(1.0, 7);
}
