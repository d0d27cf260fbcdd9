// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_SRC_IMAGES_ITK_READING_H
#define CGAL_EXTREMAL_MESH_3_SRC_IMAGES_ITK_READING_H

#include <CGAL/Extremal_mesh_3/Image.h>

#include <itkImageIOBase.h>

#include <cstddef>

namespace CGAL::Extremal_mesh_3 {

/// reads all voxels, of any type of number.
/// \throws std::runtime_error if one is not finite
Voxels read_voxels(itk::ImageIOBase& io, std::size_t n);

/// makes room for voxels: in memory, or in a temporary file if they would take more than half of what is allowed, as what is found on
/// the surface needs memory, too.
Voxels room_for_voxels(double number, const Image_reading_options& options);

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_SRC_IMAGES_ITK_READING_H
