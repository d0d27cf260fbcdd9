// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_SRC_IMAGES_ITK_READING_H
#define CGAL_EXTREMAL_MESH_3_SRC_IMAGES_ITK_READING_H

#include <CGAL/Extremal_mesh_3/Voxels.h>

#include <itkImageIOBase.h>

#include <cstddef>
#include <cstdint>

namespace CGAL::Extremal_mesh_3 {

/// reads all voxels, of any type of number.
/// \throws std::runtime_error if one is not finite
Voxels read_voxels(itk::ImageIOBase& io, std::size_t n);

/// \throws std::runtime_error if so many bytes are more than allowed
void require_memory(double bytes, std::uint64_t limit);

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_SRC_IMAGES_ITK_READING_H
