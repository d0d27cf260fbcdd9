// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_TEST_ELLIPSOID_IMAGE_H
#define CGAL_EXTREMAL_MESH_3_TEST_ELLIPSOID_IMAGE_H

#include <CGAL/Extremal_mesh_3/Image.h>

#include "random_surfaces.h"

#include <algorithm>

/// a random ellipsoid, bright inside, on 64³ voxels of side 1.
inline CGAL::Extremal_mesh_3::Image image_of_ellipsoid(unsigned seed) {
  using namespace CGAL::Extremal_mesh_3;
  const auto f = random_surfaces::ellipsoid(seed);
  constexpr std::size_t n = 64;
  Image image{{{0, 0, 0}, {Vector{1, 0, 0}, Vector{0, 1, 0}, Vector{0, 0, 1}}, {n, n, n}}, {}};
  const surfaces::Box box = random_surfaces::box_of(f);
  double side = 0;
  for (std::size_t a = 0; a < 3; ++a)
    side = std::max(side, box.high[a] - box.low[a]);
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t i = 0; i < n; ++i) {
        Point p = image.lattice.node(double(i), double(j), double(k));
        for (std::size_t a = 0; a < 3; ++a) // six voxels of air on each side
          p[a] = (box.low[a] + box.high[a]) / 2 + (p[a] - 0.5 * (n - 1)) * side / (n - 13);
        // The gradient of f is about 2: the edge is about three voxels wide, as in a CT.
        image.voxels.push_back(float(-100 * std::clamp(f.value(p) * (n - 13) / (3 * side), -1.0, 1.0)));
      }
  return image;
}

#endif // CGAL_EXTREMAL_MESH_3_TEST_ELLIPSOID_IMAGE_H
