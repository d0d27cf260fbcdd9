// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_SRC_IMAGES_DICOM_H
#define CGAL_EXTREMAL_MESH_3_SRC_IMAGES_DICOM_H

#include <CGAL/Extremal_mesh_3/Image.h>

#include <string>

namespace CGAL::Extremal_mesh_3 {

/// whether this is a folder, or a file with the mark of DICOM.
bool may_be_dicom(const std::string& path);

/// reads the slices of a DICOM series: of the one in a folder, or of that in the folder of a slice to which the slice belongs.
/// \pre nobody else uses ITK
/// \throws std::runtime_error saying what is wrong, without the name of the path
Image read_dicom(const std::string& path, const Image_reading_options& options);

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_SRC_IMAGES_DICOM_H
