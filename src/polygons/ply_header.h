// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_POLYGONS_PLY_HEADER_H
#define EXTREMAL_MESH_3_SRC_POLYGONS_PLY_HEADER_H

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

enum class Ply_type { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

/// What the header of a PLY file tells of what follows.
struct Ply_header {
  enum class Format { ascii, binary_little_endian, binary_big_endian };

  struct Property {
    std::string name;
    Ply_type type = {};
    std::optional<Ply_type> length; ///< of a list: the type of its length
  };

  struct Element {
    std::string name;
    std::uint64_t count = 0;
    std::vector<Property> properties;
  };

  Format format = {};
  std::vector<Element> elements;
  std::size_t size = 0; ///< in bytes
  std::size_t lines = 0;
};

/// the number of bytes of a number of this type.
std::size_t size_of(Ply_type type);

/// \throws std::runtime_error telling the line and what was expected
Ply_header read_ply_header(std::string_view content);

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_POLYGONS_PLY_HEADER_H
