// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_CELLS_USUAL_SIZE_H
#define EXTREMAL_MESH_3_SRC_CELLS_USUAL_SIZE_H

#include <CGAL/Extremal_mesh_3/Cell_complex.h>
#include <CGAL/Extremal_mesh_3/errors.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace CGAL::Extremal_mesh_3 {

/// tests that powers of the surface's size are numbers still.
/// \throws std::invalid_argument if a point is not finite; Extraction_error if the size is not from 1/most to most
inline void require_usual_size(const Cell_complex& cells, double most) {
  if (cells.points.empty())
    return;
  Point low = cells.points.front(), high = low;
  for (std::size_t v = 0; v < cells.points.size(); ++v)
    for (std::size_t a = 0; a < 3; ++a) {
      const Point& p = cells.points[v];
      if (!std::isfinite(p[a])) // which is neither less nor greater, and would not be seen
        throw std::invalid_argument(fmt::format("point {} is ({}, {}, {}), which is not finite", v, p[0], p[1], p[2]));
      low[a] = std::min(low[a], p[a]);
      high[a] = std::max(high[a], p[a]);
    }
  const double size = std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
  if (!(size >= 1 / most && size <= most))
    throw Extraction_error(
        fmt::format("the surface is {} long, where powers of lengths are beyond the range of numbers; choose a unit "
                    "in which it is from {} to {}",
                    size, 1 / most, most));
}

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_CELLS_USUAL_SIZE_H
