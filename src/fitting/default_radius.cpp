// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a radius R does, measured on the ellipsoid x² + 2y² + 4z² = 1 (benchmark/fit_benchmark.cpp prints a table).
// The error of C has two parts. Truncation: the surface is not its jet; in proportion to R², but smooth over the
// surface, so it moves lines a little and makes none. Noise: in proportion to R^−4, different at every vertex, so it
// makes lines where there are none. So R is as small as the noise allows, and the noise has to be known. Residuals
// are both, too: those of noise are nearly the same for any R, those of truncation grow with R^5 on smooth surfaces,
// and details of all sizes, on scanned objects, make them grow with R^1.5 or more. Two radii tell which it is.
#include "fit_jets.h"

#include "median.h"

#include <algorithm>
#include <cmath>

namespace CGAL::Extremal_mesh_3 {

namespace {

// 27 points for an even triangulation. With less than 2.5 many neighbourhoods have to grow; the larger, the more
// truncation.
constexpr double smallest_multiple = 2.75;
constexpr double step = 1.25;
constexpr int steps = 8; // up to 16.4, with 980 points
// Of C. With twice as much there are several times as many extremal points as the ellipsoid has, with half as much
// none too many.
constexpr double most_noise = 0.025;
// Where C is 0, as on spheres: the part of the curvatures by which noise in C changes them within a neighbourhood.
constexpr double most_noise_of_curvature = 1e-4;
// From the first radius to the second, by the powers of the radius with which they grow at least; noise because
// residuals are less than they should be for so few points.
const double growth_of_detail = std::pow(step, 1.5), growth_of_noise = std::pow(step, 0.3);
// The surface bends more than jets can follow where residuals are above this multiple of the noise,
constexpr double most_residual = 2;
// or the radius is more than that of curvature at most vertices. At a turn by 90 degrees a graph ends.
constexpr double most_bend = 1;

double multiple_at(int i) {
  return smallest_multiple * std::pow(step, i);
}

/// the neighbourhoods of the i-th multiple. The first two, for exact meshes, are as small as each vertex allows.
/// Where noise decides, R varies with the fourth root of the distance h of neighbours: noise in C is in proportion to
/// h/R⁴, so it becomes the same everywhere. Measured on an icosphere of 10242 vertices on the ellipsoid, where h
/// varies by 2, with noise of 1 % of an edge: with R in proportion to h, 13 to 27 vertices of lines too many; like
/// this, 2 to 5.
std::vector<Extent> extents_at(int i, const std::vector<double>& sampling) {
  const double typical = median(sampling);
  std::vector<Extent> extents;
  extents.reserve(sampling.size());
  for (const double h : sampling) {
    const double proportion = i <= 1 ? h : typical * std::sqrt(std::sqrt(h / typical));
    extents.push_back({std::max(smallest_multiple * h, multiple_at(i) * proportion), 0});
  }
  return extents;
}

/// the root of the mean of all but the largest hundredth of the squares: a few wild ones shall not decide.
double trimmed_rms(std::vector<double>& squares) {
  const std::size_t count = squares.size() - squares.size() / 100;
  if (count == 0)
    return 0;
  std::nth_element(squares.begin(), squares.begin() + std::ptrdiff_t(count - 1), squares.end());
  std::sort(squares.begin(), squares.begin() + std::ptrdiff_t(count)); // for a sum that does not depend on numbering
  double sum = 0;
  for (std::size_t i = 0; i < count; ++i)
    sum += squares[i];
  return std::sqrt(sum / double(count));
}

/// What jets look like, over the whole mesh.
struct Statistics {
  double residual = 0;  ///< standard deviation from the surface, median
  double error = 0;     ///< of C, if all of the residual were noise
  double C = 0;         ///< root mean square over the surface and all directions, noise included
  double curvature = 0; ///< root mean square
  double radius = 0;    ///< median
  double bend = 0;      ///< radius times the larger curvature, without what noise adds to it, median
};

Statistics statistics(const Vertex_shapes& shapes) {
  std::vector<double> residual, error, C, curvature, radius, bend;
  for (std::size_t v = 0; v < shapes.shapes.size(); ++v) {
    const Fit_quality& q = shapes.quality[v];
    if (!q.known())
      continue;
    const Local_shape& s = shapes.shapes[v];
    residual.push_back(q.residual / std::sqrt(double(q.points - jet_size) / double(q.points)));
    error.push_back(q.C_error * q.C_error);
    C.push_back((std::norm(s.A1) + std::norm(s.A3)) / 2);
    curvature.push_back(s.H * s.H + std::norm(s.Q));
    radius.push_back(q.radius);
    const double k = std::abs(s.H) + std::abs(s.Q);
    bend.push_back(q.radius * std::sqrt(std::max(0.0, k * k - 4 * q.L_error * q.L_error)));
  }
  return {median(residual), trimmed_rms(error), trimmed_rms(C), trimmed_rms(curvature), median(radius), median(bend)};
}

/// the part of the residuals that is noise.
double noise_of(const Statistics& a, const Statistics& b) {
  const double first = a.residual, second = b.residual / growth_of_noise;
  const double q = growth_of_detail * growth_of_detail / (growth_of_noise * growth_of_noise);
  const double square = (q * first * first - second * second) / (q - 1);
  return std::min(first, std::sqrt(std::max(0.0, square)));
}

/// the error of C that noise of this size makes.
double C_error(const Statistics& s, double noise) {
  return noise < s.residual ? s.error * (noise / s.residual) : s.error;
}

bool little(double C_error, const Statistics& s) {
  const double C = std::sqrt(std::max(0.0, s.C * s.C - C_error * C_error)); // without what noise adds
  return C_error <= most_noise * C || C_error * s.radius <= most_noise_of_curvature * s.curvature;
}

/// how many radii smaller the surface does not bend too much.
int steps_back(const Statistics& s, double noise) {
  double too_large = s.bend / most_bend; // about in proportion to the radius
  if (s.residual > most_residual * noise) {
    const double bound =
        (most_residual * most_residual - 1) * noise * noise; // of the part that grows with the fifth power
    too_large = std::max(too_large, std::pow((s.residual * s.residual - noise * noise) / bound, 0.1));
  }
  return too_large > 1 ? int(std::ceil(std::log(too_large) / std::log(step))) : 0;
}

} // namespace

Default_fit fit_jets_with_default_radius(const Fit_input& input, Thread_pool& pool,
                                         const std::function<void(double)>& progress) {
  double done = 0;
  const auto fit = [&](int i) {
    // How many more fits will follow is not known: each does half of what remains.
    Default_fit result{fit_jets(input, extents_at(i, input.sampling), pool,
                                [&](double part) { progress(done + (1 - done) / 2 * part); }),
                       multiple_at(i)};
    done += (1 - done) / 2;
    return result;
  };

  Default_fit first = fit(0);
  const Statistics a = statistics(first.jets.shapes);
  if (little(a.error, a))
    return first;
  int i = 1;
  Default_fit current = fit(i);
  Statistics s = statistics(current.jets.shapes);
  const double noise = noise_of(a, s);
  if (little(C_error(a, noise), a))
    return first;
  first = {};
  for (;;) {
    if (const int back = steps_back(s, noise); back > 0 && i > 1)
      return fit(std::max(1, i - back));
    const double error = C_error(s, noise);
    if (little(error, s) || i == steps)
      return current;
    // Noise falls with the fourth power of the radius; C, without the noise, is no more than what it is here with it.
    const double needed = std::log(error / (most_noise * s.C)) / (4 * std::log(step));
    i = std::clamp(i + int(std::ceil(needed)), i + 1, steps);
    current = fit(i);
    s = statistics(current.jets.shapes);
  }
}

} // namespace CGAL::Extremal_mesh_3
