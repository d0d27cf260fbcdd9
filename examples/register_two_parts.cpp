// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where does one part of a surface lie in another scan? Two parts of a surface that overlap, the second one turned and
// moved, are registered by their extremal meshes alone.
#include <CGAL/Extremal_mesh_3/Functor_function.h>
#include <CGAL/Extremal_mesh_3/compare.h>
#include <CGAL/Extremal_mesh_3/extract_extremal_mesh.h>
#include <CGAL/Extremal_mesh_3/register.h>

#include <cmath>
#include <iostream>

using namespace CGAL::Extremal_mesh_3;

namespace {

constexpr auto stone = [](auto x, auto y, auto z) {
  using std::cos;
  using std::sin;
  return x * x / 9 + y * y / 4 + z * z + 0.01 * sin(4 * x) * cos(5 * y + 1) + 0.05 * x * y * z - 1;
};

} // namespace

int main() {
  // The second scan has the stone turned by 90 degrees about z, and moved by (1, 2, 3).
  const auto first = make_function(stone);
  const auto second = make_function([](auto x, auto y, auto z) { return stone(y - 2.0, 1.0 - x, z - 3.0); });
  const Extremal_mesh before = extract_extremal_mesh(first, make_lattice({-3.4, -2.4, -1.3}, {1.2, 2.4, 1.3}, 48)).mesh;
  const Extremal_mesh after = extract_extremal_mesh(second, make_lattice({-1.4, 1.0, 1.7}, {3.4, 5.4, 4.3}, 48)).mesh;

  const Registration registration = register_extremal_meshes(before, after);
  if (!registration.found)
    std::cout << "nothing in common: " << registration.reason << '\n';
  for (const auto& row : registration.transform.matrix())
    std::cout << row[0] << ' ' << row[1] << ' ' << row[2] << ' ' << row[3] << '\n';

  Comparison_options options;
  options.transform = registration.transform;
  std::cout << to_text(compare_extremal_meshes(before, after, options));
  return registration.found ? 0 : 1;
}
