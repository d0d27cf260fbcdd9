// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// How long a formula takes for a value and for its derivatives, in nanoseconds a point: one by one and many at once.

#include <CGAL/Extremal_mesh_3/Formula.h>
#include <CGAL/Extremal_mesh_3/Functor_function.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>

using namespace CGAL::Extremal_mesh_3;

namespace {

const Lattice lattice = make_lattice({-1.1, -1.2, -1.3}, {1.1, 1.2, 1.3}, 40);

std::vector<Point> make_points() {
  std::vector<Point> points;
  for (std::size_t k = 0; k < 4; ++k)
    for (std::size_t j = 0; j < lattice.size[1]; ++j)
      for (std::size_t i = 0; i < lattice.size[0]; ++i)
        points.push_back(lattice.node(static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)));
  return points;
}

/// the shortest of several runs, in nanoseconds a point: the others were disturbed.
template <class Run> double nanoseconds(std::size_t points, const Run& run) {
  double best = std::numeric_limits<double>::infinity();
  for (int repeat = 0; repeat < 20; ++repeat) {
    const auto start = std::chrono::steady_clock::now();
    run();
    const std::chrono::duration<double, std::nano> time = std::chrono::steady_clock::now() - start;
    best = std::min(best, time.count() / static_cast<double>(points));
  }
  return best;
}

double sum; // printed at the end, so that no work can be left out

double time_values(const Function_3& f, const std::vector<Point>& points) {
  return nanoseconds(points.size(), [&] {
    for (const Point& p : points)
      sum += f.value(p);
  });
}

double time_slices(const Function_3& f) {
  std::vector<double> values(lattice.size[0] * lattice.size[1]);
  return nanoseconds(values.size(), [&] {
    f.lattice_values(lattice, 3, values.data());
    sum += values.back();
  });
}

double time_derivatives(const Function_3& f, const std::vector<Point>& points, int order) {
  Derivatives d;
  return nanoseconds(points.size(), [&] {
    for (const Point& p : points) {
      f.derivatives(p, order, d);
      sum += d.third[9];
    }
  });
}

double time_batch(const Formula& f, const std::vector<Point>& points, int order) {
  std::vector<Derivatives> d(points.size());
  return nanoseconds(points.size(), [&] {
    f.derivatives(points, order, d);
    sum += d.back().third[9];
  });
}

void print_row(const char* name, double value, double slice, double third, double fourth, double third_batch,
               double fourth_batch) {
  std::printf("%-22s %8.1f %8.1f %8.1f %8.1f %8.1f %8.1f\n", name, value, slice, third, fourth, third_batch,
              fourth_batch);
}

} // namespace

int main() {
  const std::vector<Point> points = make_points();
  std::printf("nanoseconds a point       value    slice  order 3  order 4  3, many  4, many\n");
  for (const auto& [name, text] : std::vector<std::pair<const char*, std::string>>{
           {"ellipsoid", "x^2/9 + y^2/4 + z^2 - 1"},
           {"tanglecube", "x^4 - 5*x^2 + y^4 - 5*y^2 + z^4 - 5*z^2 + 11.8"},
           {"gyroid", "sin(pi*x)*cos(pi*y) + sin(pi*y)*cos(pi*z) + sin(pi*z)*cos(pi*x)"},
           {"torus with a bump", "(sqrt(x^2 + y^2) - 1)^2 + z^2 - 0.1 + 0.3*exp(-(x - 1)^2 - y^2 - z^2)"}}) {
    const Formula f(text);
    print_row(name, time_values(f, points), time_slices(f), time_derivatives(f, points, 3),
              time_derivatives(f, points, 4), time_batch(f, points, 3), time_batch(f, points, 4));
  }
  const auto lambda = make_function([](auto x, auto y, auto z) { return x * x / 9 + y * y / 4 + z * z - 1; });
  std::printf("%-22s %8.1f %8.1f %8.1f %8.1f\n", "ellipsoid, lambda", time_values(lambda, points), time_slices(lambda),
              time_derivatives(lambda, points, 3), time_derivatives(lambda, points, 4));
  std::printf("(%g)\n", sum);
}
