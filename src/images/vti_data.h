// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_SRC_IMAGES_VTI_DATA_H
#define CGAL_EXTREMAL_MESH_3_SRC_IMAGES_VTI_DATA_H

#include <cstddef>
#include <string>
#include <string_view>

namespace CGAL::Extremal_mesh_3 {

/// How arrays are stored in a file of VTK's XML formats.
struct Vti_encoding {
  std::size_t bytes_of_sizes = 4; ///< 4 or 8: the numbers in front of an array that tell its length
  bool is_big_endian = false;
  bool is_compressed = false; ///< by zlib, in blocks
  bool is_base64 = false;
};

/// finds the bytes of an array of known length.
/// \param stored  the file from where the array begins; more may follow
/// \param size  in bytes
/// \throws std::runtime_error if it is truncated, damaged or of another length
std::string decode_vti_array(std::string_view stored, const Vti_encoding& encoding, std::size_t size);

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_SRC_IMAGES_VTI_DATA_H
