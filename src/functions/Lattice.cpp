// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Extremal_mesh_3/Lattice.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

namespace CGAL::Extremal_mesh_3 {
namespace {

constexpr double max_nodes = 1099511627776.0; // 2^40

// A side that is a whole number of cubes up to the rounding of its end points and of the step gets that number, not one
// more. The slack is far above rounding and far below what anyone would miss at the border.
constexpr double slack = 1e-9;

double cubes_across(double side, double step) {
  return std::max(1.0, std::ceil(side / step - slack));
}

} // namespace

Lattice make_lattice(const Point& low, const Point& high, std::size_t resolution) {
  double longest = 0;
  for (std::size_t a = 0; a < 3; ++a) {
    const char axis = "xyz"[a];
    if (!std::isfinite(low[a]) || !std::isfinite(high[a]))
      throw std::invalid_argument(
          fmt::format("make_lattice: the box's {} range, {} to {}, is not finite", axis, low[a], high[a]));
    if (!(low[a] < high[a]))
      throw std::invalid_argument(
          fmt::format("make_lattice: the box's {} range is empty: low {} is not below high {}", axis, low[a], high[a]));
    longest = std::max(longest, high[a] - low[a]);
  }
  if (resolution == 0)
    throw std::invalid_argument("make_lattice: the resolution is 0; it is the number of cubes across the longest side");
  if (!std::isfinite(longest))
    throw std::invalid_argument("make_lattice: the box is too large for double precision");
  const double step = longest / static_cast<double>(resolution);
  for (std::size_t a = 0; a < 3; ++a)
    if (!(low[a] + step > low[a]) || !(high[a] - step < high[a]))
      throw std::invalid_argument(fmt::format(
          "make_lattice: at resolution {} the cubes' side, {}, is lost to rounding beside the coordinate {}",
          resolution, step, std::abs(low[a]) > std::abs(high[a]) ? low[a] : high[a]));

  Lattice lattice;
  lattice.origin = low;
  double nodes = 1;
  for (std::size_t a = 0; a < 3; ++a) {
    const double side = high[a] - low[a];
    const double cubes = side == longest ? static_cast<double>(resolution) : cubes_across(side, step);
    nodes *= cubes + 1;
    if (nodes > max_nodes)
      throw std::invalid_argument(
          fmt::format("make_lattice: a lattice of resolution {} would have more than 2^40 nodes", resolution));
    lattice.size[a] = static_cast<std::size_t>(cubes) + 1;
    lattice.step[a] = {0, 0, 0};
    lattice.step[a][a] = step;
  }
  return lattice;
}

} // namespace CGAL::Extremal_mesh_3
