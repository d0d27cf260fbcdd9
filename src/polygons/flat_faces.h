// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_POLYGONS_FLAT_FACES_H
#define EXTREMAL_MESH_3_SRC_POLYGONS_FLAT_FACES_H

#include "../cells/Polygon_soup.h"

#include <cstddef>

namespace CGAL::Extremal_mesh_3 {

/// takes polygons whose corners lie on one line, up to rounding, into their neighbour at their longest side, on which
/// their other corners lie. Those whose longest side is at the border, or whose neighbour has one of the other corners
/// already, stay: to take them out would tear a hole or pinch the surface.
/// \pre the polygons are an oriented manifold
/// \param flags  one per polygon, of which those of the polygons that go are left out
/// \return how many have gone
std::size_t merge_flat_faces(Polygon_soup& soup, std::vector<bool>& flags);

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_POLYGONS_FLAT_FACES_H
