// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Hidden_parts.h"

#include "../differential/vector.h"
#include "../images/lanes.h"
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

void Hidden_parts::look(std::size_t first, const Slices& slices, Thread_pool& pool) {
  // What lies between two slices can be judged when the one after them is there, or if there is none.
  const std::size_t last = lattice_.size[2] - 1, begin = first < 2 ? 0 : first - 2;
  const std::size_t end = slices.end() > last ? last : slices.end() < 2 ? 0 : slices.end() - 2;
  std::vector<std::vector<Grid_cube>> found(end - std::min(begin, end));
  pool.for_each(found.size(), 1, [&](std::size_t i) { found[i] = suspects_between(slices, begin + i); });
  for (const auto& suspects : found)
    suspects_.insert(suspects_.end(), suspects.begin(), suspects.end());
}

// At the sides of the lattice the values beyond are taken to be those at the side.
std::vector<Grid_cube> Hidden_parts::suspects_between(const Slices& slices, std::size_t k) const {
  const std::size_t nx = lattice_.size[0], ny = lattice_.size[1];
  const double* const low = slices[k].values;
  const double* const high = slices[k + 1].values;
  const double* const before = k == 0 ? low : slices[k - 1].values;
  const double* const after = k + 2 == lattice_.size[2] ? high : slices[k + 2].values;
  std::vector<Grid_cube> suspects;
  // Of each row of cubes, by node: sums over the corners of the cubes, differences across them, sums of the values beyond.
  std::vector<double> sum(nx + 2), dy(nx), dz(nx), beyond_y(nx), beyond_z(nx);
  std::vector<double> room(nx); // by how much more the values may fall inside of a cube than they would have to for a 0
  for (std::size_t j = 0; j + 1 < ny; ++j) {
    const std::size_t r = j * nx, s = r + nx, r0 = j == 0 ? r : r - nx, s1 = j + 2 == ny ? s : s + nx;
    internal::on_widest_vectors([&]() __attribute__((always_inline)) {
#pragma GCC ivdep
      for (std::size_t i = 0; i < nx; ++i) {
        sum[i + 1] = (low[r + i] + low[s + i]) + (high[r + i] + high[s + i]);
        dy[i] = (low[s + i] - low[r + i]) + (high[s + i] - high[r + i]);
        dz[i] = (high[r + i] - low[r + i]) + (high[s + i] - low[s + i]);
        beyond_y[i] = (low[r0 + i] + high[r0 + i]) + (low[s1 + i] + high[s1 + i]);
        beyond_z[i] = (before[r + i] + before[s + i]) + (after[r + i] + after[s + i]);
      }
    });
    sum[0] = sum[1];
    sum[nx + 1] = sum[nx];
    // The model of the values in a cube around its middle: the sign that makes their mean positive, slopes and second differences
    // along the axes, the value in the middle.
    struct Model {
      double total, kx, ky, kz, gx, gy, gz, middle;
    };
    const auto model = [&](std::size_t i) __attribute__((always_inline)) {
      Model m;
      m.total = sum[i + 1] + sum[i + 2];
      const double sign = m.total >= 0 ? 0.125 : -0.125;
      m.kx = sign * (sum[i] + sum[i + 3] - m.total);
      m.ky = sign * (beyond_y[i] + beyond_y[i + 1] - m.total);
      m.kz = sign * (beyond_z[i] + beyond_z[i + 1] - m.total);
      m.gx = 2 * sign * (sum[i + 2] - sum[i + 1]);
      m.gy = 2 * sign * (dy[i] + dy[i + 1]);
      m.gz = 2 * sign * (dz[i] + dz[i + 1]);
      m.middle = sign * m.total - (m.kx + m.ky + m.kz) / 8;
      return m;
    };
    internal::on_widest_vectors([&]() __attribute__((always_inline)) {
#pragma GCC ivdep
      for (std::size_t i = 0; i + 1 < nx; ++i) {
        const Model m = model(i);
        const double slopes = std::abs(m.gx) + std::abs(m.gy) + std::abs(m.gz);
        const double bends = std::abs(m.kx) + std::abs(m.ky) + std::abs(m.kz);
        room[i] = slopes / 2 + bends / 8 - m.middle; // the least values below take off no more
      }
    });
    for (std::size_t i = 0; i + 1 < nx; ++i) {
      if (!(room[i] > 0))
        continue;
      const Model m = model(i);
      const Least x = least_of_parabola(m.gx, m.kx), y = least_of_parabola(m.gy, m.ky),
                  z = least_of_parabola(m.gz, m.kz);
      if (!(x.inside || y.inside || z.inside) || !(m.middle + x.value + y.value + z.value < 0))
        continue;
      const bool plus = m.total >= 0;
      bool same = true;
      for (const double* slice : {low, high})
        for (const std::size_t n : {r + i, r + i + 1, s + i, s + i + 1})
          same = same && std::isfinite(slice[n]) && (slice[n] >= 0) == plus;
      if (same)
        suspects.push_back(
            {{std::int64_t(i) * Octree::unit, std::int64_t(j) * Octree::unit, std::int64_t(k) * Octree::unit}, 0});
    }
  }
  return suspects;
}

void Hidden_parts::divide(const Function_3& f, const std::vector<Grid_cube>& cubes, Thread_pool& pool,
                          Octree& tree) const {
  std::vector<char> hides(suspects_.size()), between(cubes.size());
  pool.for_each(hides.size(), 32,
                [&](std::size_t i) { hides[i] = changes_sign_inside(f, lattice_, in_steps(suspects_[i])); });
  pool.for_each(between.size(), 32, [&](std::size_t i) { between[i] = changes_sign_between(f, lattice_, cubes[i]); });
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
