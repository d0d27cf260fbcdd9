// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_SRC_IMAGES_IMAGE_HEADERS_H
#define CGAL_EXTREMAL_MESH_3_SRC_IMAGES_IMAGE_HEADERS_H

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>

// ITK reads the headers, but what is wrong with a file it keeps to itself (a truncated NIfTI or VTK file leaves the
// memory as it was, a NaN in a NIfTI file becomes 0, a spacing of NaN becomes 1) or prints (all of MetaIO). So each
// header is looked through before ITK sees it, and the amount of data is known before memory is taken. Voxels it reads
// all at once, as they are stored, beside the floats that they become: where they are plain we read them ourselves.

namespace CGAL::Extremal_mesh_3 {

/// Where and how an image's voxels are stored.
struct Stored_voxels {
  enum class Encoding { raw, compressed, text };

  std::string file;
  std::uint64_t offset = 0; ///< of the first voxel in the file, before decompression
  std::uint64_t size = std::numeric_limits<std::uint64_t>::max(); ///< at most so many bytes of the file are theirs
  std::uint64_t skipped = 0;                                      ///< bytes after decompression before the first voxel
  Encoding encoding = Encoding::raw;
  std::uint64_t bytes_per_voxel = 0; ///< 0: those of the type that ITK reports
  bool are_floats = false;           ///< `bytes_per_voxel` being 4 or 8: their finiteness is to be checked
  bool are_swapped = false;          ///< in the byte order that is not the machine's
  bool is_plain = true;              ///< binary; nothing is skipped, scaled or added that only ITK knows of
};

/// looks through a header and finds the voxels.
/// \throws std::runtime_error saying what is wrong, without the file's name
Stored_voxels find_nrrd_voxels(const std::string& file);
Stored_voxels find_meta_voxels(const std::string& file);
Stored_voxels find_nifti_voxels(const std::string& file);
Stored_voxels find_vtk_voxels(const std::string& file);

/// checks that the file is large enough to hold as many voxels, compressed as well as can be, without reading it.
/// \throws std::runtime_error saying what is wrong, without the file's name
void require_possible_size(const Stored_voxels& stored, std::uint64_t voxels, std::uint64_t bytes_per_voxel);

/// checks that there are as many voxels as the header says, reading compressed and text files to the end.
/// \throws std::runtime_error saying what is wrong, without the file's name
void require_complete(const Stored_voxels& stored, std::uint64_t voxels, std::uint64_t bytes_per_voxel);

/// reads binary voxels from the first to the last, a piece at a time.
/// \param use  gets the bytes of one or more voxels, and how many voxels they are
/// \throws std::runtime_error if there are fewer, or compressed data have no end
void for_each_piece(const Stored_voxels& stored, std::uint64_t voxels, std::size_t bytes_per_voxel,
                    const std::function<void(const char* bytes, std::size_t count)>& use);

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_SRC_IMAGES_IMAGE_HEADERS_H
