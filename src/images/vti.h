// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_SRC_IMAGES_VTI_H
#define CGAL_EXTREMAL_MESH_3_SRC_IMAGES_VTI_H

#include <CGAL/Extremal_mesh_3/Image.h>

#include <string>

namespace CGAL::Extremal_mesh_3 {

/// reads an image in VTK's XML format (ImageData, one piece): the values at points that are its scalars, or the first that are one value
/// a point; as text, base64 or raw bytes, also compressed by zlib.
/// \throws std::runtime_error saying what is wrong, without the file's name
Image read_vti(const std::string& file, const Image_reading_options& options);

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_SRC_IMAGES_VTI_H
