// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_SRC_IMAGES_HALVE_SPACING_H
#define CGAL_EXTREMAL_MESH_3_SRC_IMAGES_HALVE_SPACING_H

#include <CGAL/Extremal_mesh_3/Image.h>

#include <cstddef>

namespace CGAL::Extremal_mesh_3 {

/// puts a node half way between every two neighbours along an axis, with the value of the cubic spline through the
/// nodes there; n nodes become 2n − 1. Beyond the ends the spline takes the last values for constant.
/// \param threads 0: as many as there are cores
void halve_spacing(Image& image, std::size_t axis, int threads);

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_SRC_IMAGES_HALVE_SPACING_H
