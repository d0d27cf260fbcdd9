// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_POLYGONS_WELD_H
#define EXTREMAL_MESH_3_SRC_POLYGONS_WELD_H

#include "../cells/Polygon_soup.h"

#include <cstddef>

namespace CGAL::Extremal_mesh_3 {

/// replaces points that are at most `tolerance` apart, also by way of others, by the first of them. Polygons may then meet a
/// point several times.
/// \return how many points are left out
std::size_t weld(Polygon_soup& soup, double tolerance);

/// leaves out points that no polygon has.
/// \return how many
std::size_t drop_isolated_points(Polygon_soup& soup);

/// the length of the diagonal of the points' bounding box.
double diagonal(const std::vector<Point>& points);

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_POLYGONS_WELD_H
