// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_BENCHMARK_COMPARISON_ELLIPSOID_H
#define EXTREMAL_MESH_3_BENCHMARK_COMPARISON_ELLIPSOID_H

#include <CGAL/Extremal_mesh_3/Differential_quantities.h>
#include <CGAL/Extremal_mesh_3/Functor_function.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

/// The errors of k and e on the surface that `make_inputs mesh` samples: root mean squares over those of the exact values.
class Ellipsoid_errors {
public:
  void add(const CGAL::Extremal_mesh_3::Point& p, const CGAL::Extremal_mesh_3::Principal_quantities& a) {
    using namespace CGAL::Extremal_mesh_3;
    static const auto f = make_function([](auto x, auto y, auto z) {
      using std::sin;
      return x * x + 2 * (y * y) + 4 * (z * z) - 1 + 0.1 * (sin(3 * x + 1) * sin(4 * y) + sin(5 * z) * sin(2 * x));
    });
    Derivatives d;
    f.derivatives(p, 3, d);
    const Principal_quantities b = principal_quantities(local_shape(d));
    k_ += std::pow(a.k1 - b.k1, 2) + std::pow(a.k2 - b.k2, 2);
    exact_k_ += b.k1 * b.k1 + b.k2 * b.k2;
    if (b.k1 - b.k2 < 0.1 * std::max(std::abs(b.k1), std::abs(b.k2)))
      return; // close to an umbilic directions, and so e, mean little
    const auto agrees = [](const Vector& s, const Vector& t) { return s[0] * t[0] + s[1] * t[1] + s[2] * t[2] >= 0; };
    const double e1 = agrees(a.t1, b.t1) ? a.e1 : -a.e1, e2 = agrees(a.t2, b.t2) ? a.e2 : -a.e2;
    e_ += std::pow(e1 - b.e1, 2) + std::pow(e2 - b.e2, 2);
    exact_e_ += b.e1 * b.e1 + b.e2 * b.e2;
  }
  void report() const {
    std::printf("{\"error of k\": %.4g, \"error of e\": %.4g}\n", std::sqrt(k_ / exact_k_), std::sqrt(e_ / exact_e_));
  }

private:
  double k_ = 0, exact_k_ = 0, e_ = 0, exact_e_ = 0;
};

#endif // EXTREMAL_MESH_3_BENCHMARK_COMPARISON_ELLIPSOID_H
