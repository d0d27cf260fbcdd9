// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// In frequencies: the Gaussian's samples G(ω) over the B-spline's samples B(ω). Dividing by B is the "direct B-spline
// transform" of M. Unser, A. Aldroubi, M. Eden, "B-spline signal processing", IEEE Trans. Signal Processing 41 (1993):
// a pair of recursions for each pole. Applied to the kernel instead of to the image, and then cut off, it leaves a
// finite filter, so that a part of an image is smoothed as the whole is.
//
// Relative error of the third derivative against the true Gaussian, root mean square over white noise (the hardest
// image), then over an image of edges (spectrum 1/ω):
//
//   sigma   Gaussian of variance σ² − ½, degree 5   this, degree 5     this, degree 7
//   0.9     3.4e-1  2.2e-1                          2.3e-1  1.5e-1     1.6e-1  9.6e-2
//   1.0     2.0e-1  1.2e-1                          1.6e-1  1.0e-1     1.0e-1  5.6e-2
//   1.2     8.2e-2  4.9e-2                          7.7e-2  4.7e-2     3.4e-2  1.7e-2
//   1.5     3.1e-2  2.0e-2                          3.0e-2  1.9e-2     6.4e-3  3.2e-3
//   2.0     1.0e-2  6.6e-3                          9.8e-3  6.3e-3     8.2e-4  4.4e-4
//
// The second derivative gains more (1.5: 9.3e-3, 7.2e-3, 1.7e-3), the value most (1.1e-3, 2.0e-4, 5.5e-5). The discrete
// Gaussian exp(−t) I_n(t) answers another question (it is exact for the discrete heat equation): 0.35 to 0.67.

#include "smoothing.h"

#include <cmath>
#include <cstdlib>

namespace CGAL::Extremal_mesh_3 {
namespace {

// The poles inside the unit circle of the B-splines' direct transforms.
constexpr std::array<double, 2> poles_5{-0.43057534709997379, -0.043096288203264654};
constexpr std::array<double, 3> poles_7{-0.53528043079643817, -0.12255461519232669, -0.0091486948096082769};

constexpr double truncation = 1e-7;

// Divides by (1 − z x)(1 − z/x) / ((1 − z)(1 − 1/z)), whose sum is 1; the ends of `k` are so far out that it is zero
// there.
void divide_by_pole(std::vector<double>& k, double z) {
  for (std::size_t i = 1; i < k.size(); ++i)
    k[i] += z * k[i - 1];
  for (std::size_t i = k.size() - 1; i-- > 0;)
    k[i] += z * k[i + 1];
  for (double& weight : k)
    weight *= (1 - z) * (1 - z);
}

} // namespace

Half_kernel gaussian_spline_kernel(double sigma, int degree) {
  // 8.5 σ: exp(−36) = 2e-16. The slowest pole's powers fall below that within 60.
  const auto reach = static_cast<std::size_t>(std::ceil(8.5 * sigma)) + 60;
  std::vector<double> k(2 * reach + 1);
  for (std::size_t i = 0; i < k.size(); ++i) {
    const double x = (static_cast<double>(i) - static_cast<double>(reach)) / sigma;
    k[i] = std::exp(-0.5 * x * x);
  }
  const std::span<const double> poles =
      degree == 5 ? std::span<const double>(poles_5) : std::span<const double>(poles_7);
  for (double z : poles)
    divide_by_pole(k, z);

  double total = 0;
  for (double weight : k)
    total += weight;
  std::size_t radius = reach;
  for (double cut_off = 0; radius > 0; --radius) {
    cut_off += 2 * std::abs(k[reach + radius]);
    if (cut_off > truncation * total)
      break;
  }
  double kept = k[reach];
  for (std::size_t j = 1; j <= radius; ++j)
    kept += 2 * k[reach + j];
  Half_kernel half(radius + 1);
  for (std::size_t j = 0; j <= radius; ++j)
    half[j] = static_cast<float>(k[reach + j] / kept);
  return half;
}

} // namespace CGAL::Extremal_mesh_3
