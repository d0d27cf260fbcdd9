// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_IMAGE_H
#define CGAL_EXTREMAL_MESH_3_IMAGE_H

#include <CGAL/Extremal_mesh_3/Lattice.h>
#include <CGAL/Extremal_mesh_3/Voxels.h>
#include <CGAL/Extremal_mesh_3/errors.h>

#include <cstdint>
#include <limits>
#include <string>

namespace CGAL::Extremal_mesh_3 {

/// A 3D image: one value per node of a lattice. Positions are in world coordinates, LPS in mm when read from a file
/// (ITK's convention; NIfTI's RAS is converted). The lattice may be left-handed.
struct Image {
  Lattice lattice; ///< where the voxels are
  Voxels voxels;   ///< in the order of the lattice's nodes
};

/// How to read an image.
struct Image_reading_options {
  /// Voxels that take more than half of so many bytes, as floats, are kept in a temporary file instead, mapped into memory
  /// (`Voxel_allocator`). Those stored as text, scaled (NIfTI), with bytes to skip, or in VTK's XML format are not: an image with such is refused,
  /// before memory is taken, if it takes more than all of it.
  std::uint64_t memory_limit = std::numeric_limits<std::uint64_t>::max();
  /// of temporary files; empty: the system's, which the environment variable TMPDIR names
  std::string scratch_folder;
};

/// reads a 3D scalar image: NRRD (.nrrd, .nhdr; raw, gzip or ascii), MetaImage (.mha, .mhd; raw or compressed), NIfTI-1
/// (.nii, .nii.gz), VTK's legacy format (.vtk; structured points) and its XML format (.vti; one piece, not compressed or by zlib), with any type of number and in either byte order.
/// A folder is read as the DICOM series whose slices are in it, a DICOM slice as the series in its folder to which it belongs; the lattice is sheared if the
/// gantry was tilted, and as many slices as are missing, unequal distances, or several series in a folder are errors.
/// Four dimensions are read if there is only one volume; voxels in several files are not.
/// \return spacing, origin and directions as the lattice; numbers that NIfTI stores as float are taken for the shortest
///         decimals that they stand for (3.2, not 3.2000000477), as the other formats have them
/// \throws Io_error naming the file and what is wrong: it does not exist, is empty, truncated or damaged, is not an
/// image, is
///         not 3D with 4 nodes at least along each axis, has several values per voxel, a spacing that is not positive,
///         a singular direction matrix, a voxel that is not finite (as a float), is larger than memory, or changes while it
///         is read
/// A header that lies about the size of the data takes no memory; compressed data are not read on far beyond what it tells.
/// \param file  the name of the file to read
/// \param options  how much memory it may take
Image read_image(const std::string& file, const Image_reading_options& options = {});

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_IMAGE_H
