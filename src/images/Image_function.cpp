// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Extremal_mesh_3/Image_function.h>

#include "change_of_coordinates.h"
#include "halve_spacing.h"
#include "node_values.h"
#include "smoothing.h"
#include "spline.h"
#include "spline_bounds.h"
#include "spline_on_lattice.h"

#include "../functions/root_in_bracket.h"

#include <CGAL/Extremal_mesh_3/internal/interval_arithmetic.h>

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace CGAL::Extremal_mesh_3 {

struct Image_function::Implementation {
  Lattice lattice;
  Matrix to_lattice; // from mm to units of the lattice
  Spline_volume volume;
  double iso = 0, sigma = 0;
  int degree = 5;

  Point lattice_coordinates(const Point& p) const {
    Point u;
    for (std::size_t a = 0; a < 3; ++a)
      u[a] = to_lattice[a][0] * (p[0] - lattice.origin[0]) + to_lattice[a][1] * (p[1] - lattice.origin[1]) +
             to_lattice[a][2] * (p[2] - lattice.origin[2]);
    return u;
  }

  template <int Order> void derivatives(const Point& p, Derivatives& d) const;
};

namespace {

// Below this many voxels the sampled Gaussian is not the continuous one any more: its derivatives are off by a fifth. Then
// nodes are put between the voxels, once.
constexpr double least_sigma_of_nodes = 0.9;
constexpr double least_sigma = least_sigma_of_nodes / 2;
constexpr double least_sigma_for_degree_5 = 1.2;
constexpr double rounding = 1e-9; // so that σ = 0.9·spacing passes

double length(const Vector& v) {
  return std::hypot(v[0], v[1], v[2]);
}

bool is_finite(const Point& p) {
  return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
}

void check_image(const Image& image) {
  const auto& size = image.lattice.size;
  // One factor after the other, so that no product can overflow.
  std::size_t nodes = image.voxels.size();
  for (std::size_t n : size)
    nodes = n == 0 || nodes % n != 0 ? 0 : nodes / n;
  if (nodes != 1)
    throw std::invalid_argument(fmt::format("the image has {} values for a lattice of {} x {} x {} nodes",
                                            image.voxels.size(), size[0], size[1], size[2]));
  if (!is_finite(image.lattice.origin))
    throw std::invalid_argument("the origin of the image's lattice is not finite");
}

void check_options(const Image_function_options& options) {
  if (!std::isfinite(options.iso))
    throw std::invalid_argument(fmt::format("iso is {}", options.iso));
  if (!std::isfinite(options.sigma) || options.sigma < 0)
    throw std::invalid_argument(
        fmt::format("sigma is {} mm; it must be positive, or 0 for the size of a voxel", options.sigma));
  if (options.degree != 0 && options.degree != 5 && options.degree != 7)
    throw std::invalid_argument(
        fmt::format("the spline's degree is {}; it must be 5, 7 or 0 for either", options.degree));
  if (options.threads < 0)
    throw std::invalid_argument(fmt::format("the number of threads is {}", options.threads));
}

void check_sigma(double sigma, const Vector& spacing, const std::array<std::size_t, 3>& size) {
  const double largest = std::max({spacing[0], spacing[1], spacing[2]});
  if (sigma < least_sigma * largest * (1 - rounding))
    throw std::invalid_argument(
        fmt::format("sigma is {} mm, too small for voxels of {} mm; it must be at least {:.6g} mm", sigma, largest,
                    least_sigma * largest));
  double side = 0;
  for (std::size_t a = 0; a < 3; ++a)
    side = std::max(side, spacing[a] * static_cast<double>(size[a]));
  if (sigma > side)
    throw std::invalid_argument(fmt::format("sigma is {} mm, larger than the image ({:.6g} mm)", sigma, side));
  const double least = std::min({spacing[0], spacing[1], spacing[2]});
  constexpr double most_voxels = 10000; // the Gaussian is stored, with several values a voxel
  if (!(sigma <= most_voxels * least))
    throw std::invalid_argument(fmt::format("sigma is {} mm, more than {} times the {} mm of a voxel's shortest side",
                                            sigma, most_voxels, least));
}

void check_iso(double iso, const Voxels& voxels) {
  float low = voxels[0], high = voxels[0];
  for (std::size_t i = 0; i < voxels.size(); ++i) {
    if (!std::isfinite(voxels[i]))
      throw std::invalid_argument(fmt::format("voxel {} of the image is {}", i, voxels[i]));
    low = std::min(low, voxels[i]);
    high = std::max(high, voxels[i]);
  }
  if (!(low < iso && iso < high))
    throw Extraction_error(
        fmt::format("the iso value {} is outside the range of the image's values, {} to {}", iso, low, high));
}

bool same(const Lattice& a, const Lattice& b) {
  return a.origin == b.origin && a.step == b.step && a.size == b.size;
}

template <std::size_t N> void fill_with_nan(std::array<double, N>& values) {
  values.fill(std::numeric_limits<double>::quiet_NaN());
}

} // namespace

Image_function::Image_function(const Image& image, const Image_function_options& options)
    : Image_function(Image(image), options) {}

namespace {

Vector spacing_of(const Lattice& lattice) {
  return {length(lattice.step[0]), length(lattice.step[1]), length(lattice.step[2])};
}

} // namespace

Image_function::Image_function(Image&& image, const Image_function_options& options)
    : implementation_(std::make_unique<Implementation>()) {
  check_options(options);
  check_image(image);
  if (!inverse_of_columns(image.lattice.step))
    throw std::invalid_argument("the steps of the image's lattice are not three independent finite vectors");
  Vector spacing = spacing_of(image.lattice);
  const double sigma = options.sigma > 0 ? options.sigma : std::max({spacing[0], spacing[1], spacing[2]});
  check_sigma(sigma, spacing, image.lattice.size);
  check_iso(options.iso, image.voxels);
  for (std::size_t a = 0; a < 3; ++a)
    if (sigma < least_sigma_of_nodes * spacing[a] * (1 - rounding))
      halve_spacing(image, a, options.threads);
  spacing = spacing_of(image.lattice);

  Implementation& self = *implementation_;
  self.lattice = image.lattice;
  self.to_lattice = *inverse_of_columns(image.lattice.step);
  self.iso = options.iso;
  self.sigma = sigma;
  self.degree = options.degree;
  if (self.degree == 0)
    self.degree =
        sigma < least_sigma_for_degree_5 * std::max({spacing[0], spacing[1], spacing[2]}) * (1 - rounding) ? 7 : 5;
  std::array<Half_kernel, 3> kernels;
  for (std::size_t a = 0; a < 3; ++a)
    kernels[a] = gaussian_spline_kernel(sigma / spacing[a], self.degree);
  self.volume = {std::move(image.voxels), image.lattice.size};
  convolve(self.volume.coefficients, self.volume.size, kernels, options.threads, options.progress);
}

Image_function::~Image_function() = default;
Image_function::Image_function(Image_function&&) noexcept = default;

template <int Order> void Image_function::Implementation::derivatives(const Point& p, Derivatives& d) const {
  const Point u = lattice_coordinates(p);
  if (!is_finite(u)) {
    d.value = std::numeric_limits<double>::quiet_NaN();
    if constexpr (Order >= 1)
      fill_with_nan(d.gradient);
    if constexpr (Order >= 2)
      fill_with_nan(d.hessian);
    if constexpr (Order >= 3)
      fill_with_nan(d.third);
    if constexpr (Order >= 4)
      fill_with_nan(d.fourth);
    return;
  }
  Partials partials;
  if (degree == 5)
    evaluate_spline<5, Order>(volume, u, partials);
  else
    evaluate_spline<7, Order>(volume, u, partials);
  d.value = iso - partials[0][0][0];
  if constexpr (Order >= 1)
    change_coordinates<1>(partials, to_lattice, -1, d.gradient);
  if constexpr (Order >= 2)
    change_coordinates<2>(partials, to_lattice, -1, d.hessian);
  if constexpr (Order >= 3)
    change_coordinates<3>(partials, to_lattice, -1, d.third);
  if constexpr (Order >= 4)
    change_coordinates<4>(partials, to_lattice, -1, d.fourth);
}

double Image_function::value(const Point& p) const {
  Derivatives d;
  implementation_->derivatives<0>(p, d);
  return d.value;
}

void Image_function::derivatives(const Point& p, int order, Derivatives& d) const {
  switch (order) {
  case 1:
    return implementation_->derivatives<1>(p, d);
  case 2:
    return implementation_->derivatives<2>(p, d);
  case 3:
    return implementation_->derivatives<3>(p, d);
  case 4:
    return implementation_->derivatives<4>(p, d);
  default:
    throw std::invalid_argument(fmt::format("the order of derivatives is {}; it must be 1 to 4", order));
  }
}

void Image_function::lattice_values(const Lattice& lattice, std::size_t k, double* out) const {
  const Implementation& self = *implementation_;
  if (!same(lattice, self.lattice))
    return Function_3::lattice_values(lattice, k, out);
  if (self.degree == 5)
    node_values<5>(self.volume, k, self.iso, out);
  else
    node_values<7>(self.volume, k, self.iso, out);
}

bool Image_function::half_step_values(const Lattice& lattice, const std::array<std::size_t, 3>& cube,
                                      std::array<double, 27>& out) const {
  const Implementation& self = *implementation_;
  if (!same(lattice, self.lattice))
    return false;
  internal::on_widest_vectors([&]() __attribute__((always_inline)) {
    if (self.degree == 5)
      Extremal_mesh_3::half_step_values<5>(self.volume, cube, out);
    else
      Extremal_mesh_3::half_step_values<7>(self.volume, cube, out);
  });
  for (double& value : out)
    value = self.iso - value;
  return true;
}

namespace {

template <int Degree>
double root_on_edge_of_spline(const Spline_volume& volume, double iso, const std::array<std::size_t, 3>& node,
                              std::size_t axis, double v0, double v1) {
  Polynomial<Degree> p;
  internal::on_widest_vectors([&]() __attribute__((always_inline)) {
    p = polynomial_on_edge<Degree>(volume, node, axis);
  });
  p[0] -= iso;
  return root_in_bracket(v0, v1, [&](double t) {
    double value = p[Degree], slope = 0;
    for (std::size_t m = Degree; m-- > 0;) {
      slope = slope * t + value;
      value = value * t + p[m];
    }
    return std::pair(-value, -slope);
  });
}

} // namespace

std::optional<double> Image_function::root_on_edge(const Lattice& lattice, const std::array<std::size_t, 3>& node,
                                                   std::size_t axis, double v0, double v1) const {
  const Implementation& self = *implementation_;
  if (!same(lattice, self.lattice))
    return std::nullopt;
  return self.degree == 5 ? root_on_edge_of_spline<5>(self.volume, self.iso, node, axis, v0, v1)
                          : root_on_edge_of_spline<7>(self.volume, self.iso, node, axis, v0, v1);
}

bool Image_function::bounds(const Box_3& box, int order, Derivative_bounds& d) const {
  const Implementation& self = *implementation_;
  Box_3 on_lattice;
  for (std::size_t a = 0; a < 3; ++a) {
    Interval u;
    for (std::size_t b = 0; b < 3; ++b)
      u = u + self.to_lattice[a][b] * (Interval{box.low[b], box.high[b]} - self.lattice.origin[b]);
    on_lattice.low[a] = u.low;
    on_lattice.high[a] = u.high;
  }
  const Spline_bounds spline = bound_spline(self.volume, self.degree, on_lattice);
  d.value = self.iso - spline.value;
  if (order >= 1)
    for (std::size_t b = 0; b < 3; ++b) {
      Interval sum;
      for (std::size_t a = 0; a < 3; ++a)
        sum = sum - self.to_lattice[a][b] * spline.gradient[a];
      d.gradient[b] = sum;
    }
  if (order >= 2)
    d.hessian.fill(internal::all_numbers);
  if (order >= 3)
    d.third.fill(internal::all_numbers);
  if (order >= 4)
    d.fourth.fill(internal::all_numbers);
  return true;
}

const Lattice& Image_function::lattice() const {
  return implementation_->lattice;
}
double Image_function::sigma() const {
  return implementation_->sigma;
}
int Image_function::degree() const {
  return implementation_->degree;
}

} // namespace CGAL::Extremal_mesh_3
