// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cube.h"

#include "../differential/vector.h"

#include <cmath>

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

bool is_left_handed(const Lattice& lattice) {
  return dot(lattice.step[0], cross(lattice.step[1], lattice.step[2])) < 0;
}

} // namespace CGAL::Extremal_mesh_3
