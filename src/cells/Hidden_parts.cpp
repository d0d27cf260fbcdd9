// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Hidden_parts.h"

#include "../differential/vector.h"
#include "cube.h"

#include <algorithm>
#include <cmath>

namespace CGAL::Extremal_mesh_3 {

namespace {

/// The least value of g·t + k·t²/2 for |t| ≤ ½, and whether it is taken inside.
struct Least {
  double value;
  bool inside;
};
Least least_of_parabola(double g, double k) {
  if (k > 0 && std::abs(g) < k / 2)
    return {-g * g / (2 * k), true};
  return {-std::abs(g) / 2 + k / 8, false};
}

/// tells whether f takes another sign inside of a cube than at its corners: goes down the slope along each of the axes
/// of the lattice, from the middle.
bool changes_sign_inside(const Function_3& f, const Lattice& lattice, const std::array<double, 3>& base) {
  std::array<double, 3> u{0.5, 0.5, 0.5};
  const bool plus = f.value(lattice.node(base[0], base[1], base[2])) >= 0;
  Derivatives d;
  for (int i = 0; i < 8; ++i) {
    f.derivatives(lattice.node(base[0] + u[0], base[1] + u[1], base[2] + u[2]), 2, d);
    if (!std::isfinite(d.value))
      return false;
    if ((d.value >= 0) != plus)
      return true;
    const double sign = plus ? 1 : -1;
    const auto& h = d.hessian;
    double moved = 0;
    for (std::size_t a = 0; a < 3; ++a) {
      const Vector& s = lattice.step[a];
      const double g = sign * dot(d.gradient, s);
      const double k = sign * (s[0] * (h[0] * s[0] + 2 * (h[1] * s[1] + h[2] * s[2])) +
                               s[1] * (h[3] * s[1] + 2 * h[4] * s[2]) + h[5] * s[2] * s[2]);
      const double step = k > 0 ? -g / k : g > 0 ? -0.5 : 0.5;
      const double to = std::clamp(u[a] + step, 0.0, 1.0);
      moved += std::abs(to - u[a]);
      u[a] = to;
    }
    if (moved < 1e-3)
      return false;
  }
  return false;
}

/// tells whether an edge or a face without a change of sign at its corners has another one in its middle.
bool changes_sign_between(const Function_3& f, const Lattice& lattice, const Grid_cube& cube) {
  std::array<std::size_t, 3> base;
  for (std::size_t a = 0; a < 3; ++a)
    base[a] = std::size_t(cube.base[a] / Octree::unit);
  std::array<double, 27> values;
  const bool known = f.half_step_values(lattice, base, values);
  // In half steps.
  const auto value = [&](const std::array<std::size_t, 3>& at) {
    return known ? values[at[0] + 3 * at[1] + 9 * at[2]]
                 : f.value(lattice.node(double(base[0]) + 0.5 * double(at[0]), double(base[1]) + 0.5 * double(at[1]),
                                        double(base[2]) + 0.5 * double(at[2])));
  };
  std::array<bool, 8> plus;
  for (unsigned c = 0; c < 8; ++c)
    plus[c] = value({2 * (c & 1U), 2 * (c >> 1 & 1U), 2 * (c >> 2 & 1U)}) >= 0;
  const auto is_other = [&](const auto& corners) {
    std::array<std::size_t, 3> middle{};
    for (const int c : corners) {
      if (plus[std::size_t(c)] != plus[std::size_t(corners[0])])
        return false;
      for (std::size_t a = 0; a < 3; ++a)
        middle[a] += 2 * (unsigned(c) >> a & 1U);
    }
    for (std::size_t& m : middle)
      m /= corners.size();
    const double v = value(middle);
    return std::isfinite(v) && (v >= 0) != plus[std::size_t(corners[0])];
  };
  return std::any_of(edge_corners.begin(), edge_corners.end(), is_other) ||
         std::any_of(face_corners.begin(), face_corners.end(), is_other);
}

std::array<double, 3> in_steps(const Grid_cube& c) {
  constexpr double unit(Octree::unit);
  return {double(c.base[0]) / unit, double(c.base[1]) / unit, double(c.base[2]) / unit};
}

} // namespace

void Hidden_parts::add_slice(const double* values) {
  if (slices_.size() == 4) {
    std::rotate(slices_.begin(), slices_.begin() + 1, slices_.end());
    slices_.back().assign(values, values + slices_.back().size());
  } else
    slices_.emplace_back(values, values + lattice_.size[0] * lattice_.size[1]);
  if (slices_.size() == 3) // the first layer has no slice before it
    look_between(slices_[0].data(), slices_[0].data(), slices_[1].data(), slices_[2].data());
  else if (slices_.size() == 4)
    look_between(slices_[0].data(), slices_[1].data(), slices_[2].data(), slices_[3].data());
}

void Hidden_parts::end_slices() {
  const std::size_t n = slices_.size();
  if (n >= 2)
    look_between(slices_[n >= 3 ? n - 3 : 0].data(), slices_[n - 2].data(), slices_[n - 1].data(),
                 slices_[n - 1].data());
}

// At the sides of the lattice the values beyond are taken to be those at the side.
void Hidden_parts::look_between(const double* before, const double* low, const double* high, const double* after) {
  const std::size_t nx = lattice_.size[0], ny = lattice_.size[1];
  // Of each row of cubes, by node: sums over the corners of the cubes, differences across them, sums of the values beyond.
  std::vector<double> sum(nx + 2), dy(nx), dz(nx), beyond_y(nx), beyond_z(nx);
  for (std::size_t j = 0; j + 1 < ny; ++j) {
    const std::size_t r = j * nx, s = r + nx, r0 = j == 0 ? r : r - nx, s1 = j + 2 == ny ? s : s + nx;
    for (std::size_t i = 0; i < nx; ++i) {
      sum[i + 1] = (low[r + i] + low[s + i]) + (high[r + i] + high[s + i]);
      dy[i] = (low[s + i] - low[r + i]) + (high[s + i] - high[r + i]);
      dz[i] = (high[r + i] - low[r + i]) + (high[s + i] - low[s + i]);
      beyond_y[i] = (low[r0 + i] + high[r0 + i]) + (low[s1 + i] + high[s1 + i]);
      beyond_z[i] = (before[r + i] + before[s + i]) + (after[r + i] + after[s + i]);
    }
    sum[0] = sum[1];
    sum[nx + 1] = sum[nx];
    for (std::size_t i = 0; i + 1 < nx; ++i) {
      const double total = sum[i + 1] + sum[i + 2];
      const double sign = total >= 0 ? 0.125 : -0.125;
      const double kx = sign * (sum[i] + sum[i + 3] - total),
                   ky = sign * (beyond_y[i] + beyond_y[i + 1] - total),
                   kz = sign * (beyond_z[i] + beyond_z[i + 1] - total);
      const double mean = sign * total;
      const double gx = 2 * sign * (sum[i + 2] - sum[i + 1]), gy = 2 * sign * (dy[i] + dy[i + 1]),
                   gz = 2 * sign * (dz[i] + dz[i + 1]);
      const double middle = mean - (kx + ky + kz) / 8;
      const double slopes = std::abs(gx) + std::abs(gy) + std::abs(gz);
      const double bends = std::abs(kx) + std::abs(ky) + std::abs(kz);
      if (!(middle < slopes / 2 + bends / 8)) // what follows takes off no more
        continue;
      const Least x = least_of_parabola(gx, kx), y = least_of_parabola(gy, ky), z = least_of_parabola(gz, kz);
      if (!(x.inside || y.inside || z.inside) || !(middle + x.value + y.value + z.value < 0))
        continue;
      const bool plus = total >= 0;
      bool same = true;
      for (const double* slice : {low, high})
        for (const std::size_t n : {r + i, r + i + 1, s + i, s + i + 1})
          same = same && std::isfinite(slice[n]) && (slice[n] >= 0) == plus;
      if (same)
        suspects_.push_back(
            {{std::int64_t(i) * Octree::unit, std::int64_t(j) * Octree::unit, next_layer_ * Octree::unit}, 0});
    }
  }
  ++next_layer_;
}

void Hidden_parts::divide(const Function_3& f, const std::vector<Grid_cube>& cubes, Thread_pool& pool,
                          Octree& tree) const {
  std::vector<char> hides(suspects_.size()), between(cubes.size());
  pool.for_each(hides.size(), 32, [&](std::size_t i) {
    hides[i] = changes_sign_inside(f, lattice_, in_steps(suspects_[i]));
  });
  pool.for_each(between.size(), 32, [&](std::size_t i) {
    between[i] = changes_sign_between(f, lattice_, cubes[i]);
  });
  const auto divide_twice = [&](const Grid_cube& c) {
    tree.divide(c);
    for (unsigned k = 0; k < 8; ++k)
      tree.divide(Octree::child(c, k));
  };
  for (std::size_t i = 0; i < hides.size(); ++i)
    if (hides[i])
      divide_twice(suspects_[i]);
  for (std::size_t i = 0; i < between.size(); ++i)
    if (between[i])
      divide_twice(cubes[i]);
}

} // namespace CGAL::Extremal_mesh_3
