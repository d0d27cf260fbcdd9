// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cube.h"

#include "../differential/vector.h"

#include <CGAL/Extremal_mesh_3/internal/interval_arithmetic.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL::Extremal_mesh_3 {

bool plus_corners_joined(const Function_3& f, const Lattice& lattice, const std::array<double, 4>& value,
                         const std::array<double, 3>& base, const std::array<double, 3>& s,
                         const std::array<double, 3>& t) {
  const auto [v00, v10, v01, v11] = value;
  const double sum = (v00 - v10) + (v11 - v01);
  const double x = (v00 - v01) / sum, y = (v00 - v10) / sum;
  std::array<double, 3> at;
  for (std::size_t a = 0; a < 3; ++a)
    at[a] = base[a] + x * s[a] + y * t[a];
  const double middle = f.value(lattice.node(at[0], at[1], at[2]));
  return std::isfinite(middle) ? middle >= 0 : v00 * v11 - v10 * v01 >= 0;
}

Box_3 box_around(const Lattice& lattice, const std::array<double, 3>& low, const std::array<double, 3>& high) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Box_3 box{{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};
  for (unsigned corner = 0; corner < 8; ++corner) {
    const Point p =
        lattice.node(corner & 1 ? high[0] : low[0], corner & 2 ? high[1] : low[1], corner & 4 ? high[2] : low[2]);
    for (std::size_t a = 0; a < 3; ++a) {
      box.low[a] = std::min(box.low[a], internal::below(p[a]));
      box.high[a] = std::max(box.high[a], internal::above(p[a]));
    }
  }
  return box;
}

bool is_left_handed(const Lattice& lattice) {
  return dot(lattice.step[0], cross(lattice.step[1], lattice.step[2])) < 0;
}

} // namespace CGAL::Extremal_mesh_3
