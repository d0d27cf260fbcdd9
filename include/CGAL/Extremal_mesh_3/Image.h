// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_IMAGE_H
#define CGAL_EXTREMAL_MESH_3_IMAGE_H

#include <CGAL/Extremal_mesh_3/Lattice.h>
#include <CGAL/Extremal_mesh_3/errors.h>

#include <string>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

/// A 3D image: one value per node of a lattice. Positions are in world coordinates, LPS in mm when read from a file (ITK's convention;
/// NIfTI's RAS is converted).
struct Image {
  Lattice lattice;
  std::vector<float> voxels;
};

/// reads a 3D scalar image: NRRD (.nrrd, .nhdr), MetaImage (.mha, .mhd), NIfTI (.nii, .nii.gz), VTK (.vtk).
/// \throws Io_error naming the file and what is wrong: it does not exist, is empty or truncated, is not an image, is not 3D, has several values per
///         voxel, holds values that are not finite, or is larger than memory
Image read_image(const std::string& file);

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_IMAGE_H
