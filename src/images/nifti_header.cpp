// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The fields of NIfTI-1 (https://nifti.nimh.nih.gov/nifti-1): 348 bytes, in either byte order.

#include "Byte_reader.h"
#include "change_of_coordinates.h"
#include "image_headers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <fstream>
#include <stdexcept>

namespace CGAL::Extremal_mesh_3 {
namespace {

constexpr std::size_t header_size = 348;

class Header {
public:
  Header(const std::string& file, bool compressed) {
    const std::size_t n = Byte_reader(file, 0, compressed).read(bytes_.data(), bytes_.size());
    if (n < header_size)
      throw std::runtime_error(
          fmt::format("it is truncated: expected a NIfTI header of {} bytes, found {}", header_size, n));
    if (get<std::int32_t>(0) != static_cast<std::int32_t>(header_size)) {
      swapped_ = true;
      const auto size = get<std::int32_t>(0);
      swapped_ = size == static_cast<std::int32_t>(header_size);
      if (!swapped_ && (size == 540 || get<std::int32_t>(0) == 540))
        throw std::runtime_error("it is a NIfTI-2 file, which is not supported; expected NIfTI-1");
      if (!swapped_)
        throw std::runtime_error("it is not a NIfTI file");
    }
  }

  bool is_swapped() const { return swapped_; }
  bool has_magic(const char* magic) const { return std::memcmp(bytes_.data() + 344, magic, 4) == 0; }

  template <typename Number> Number get(std::size_t offset) const {
    std::array<char, sizeof(Number)> bytes;
    std::copy_n(bytes_.begin() + static_cast<std::ptrdiff_t>(offset), sizeof(Number), bytes.begin());
    if (swapped_)
      std::reverse(bytes.begin(), bytes.end());
    Number number;
    std::memcpy(&number, bytes.data(), sizeof(Number));
    return number;
  }

private:
  std::array<char, header_size> bytes_{};
  bool swapped_ = false;
};

std::uint64_t bytes_of_type(int type) {
  switch (type) {
  case 2:   // uint8
  case 256: // int8
    return 1;
  case 4:   // int16
  case 512: // uint16
    return 2;
  case 8:   // int32
  case 768: // uint32
  case 16:  // float
    return 4;
  case 64:   // double
  case 1024: // int64
  case 1280: // uint64
    return 8;
  case 32:  // complex
  case 128: // RGB
  case 1792:
  case 2304: // RGBA
    throw std::runtime_error("it has several values per voxel; expected one");
  default:
    throw std::runtime_error(fmt::format("its voxels are of NIfTI's type {}, which is not supported", type));
  }
}

void check_orientation(const Header& header) {
  const bool has_qform = header.get<std::int16_t>(252) > 0, has_sform = header.get<std::int16_t>(254) > 0;
  std::array<Vector, 3> columns; // of the sform
  for (std::size_t offset = 256; offset < 328; offset += 4) {
    const auto number = header.get<float>(offset);
    // ITK's matrices end the program at what is not finite, never end at what overflows a float when squared, and print
    // on the console at what is not a normal number.
    const bool is_usable = number == 0 || (std::isnormal(number) && std::abs(number) < 1e9F);
    if (!is_usable && (offset < 280 ? has_qform : has_sform))
      throw std::runtime_error(fmt::format("its orientation has the number {}", number));
    if (const std::size_t entry = (offset - 280) / 4; offset >= 280 && entry % 4 < 3)
      columns[entry % 4][entry / 4] = static_cast<double>(number);
  }
  // With no other orientation to fall back to, ITK would take the identity.
  if (has_sform && !has_qform && !inverse_of_columns(columns))
    throw std::runtime_error("its direction matrix is singular");
}

} // namespace

Stored_voxels find_nifti_voxels(const std::string& file) {
  std::array<char, 2> start{};
  Byte_reader(file, 0, false).read(start.data(), start.size());
  const bool compressed = start[0] == '\x1f' && start[1] == '\x8b';
  if (compressed && !file.ends_with('z') && !file.ends_with('Z'))
    throw std::runtime_error("it is compressed; its name must then end in .nii.gz");
  const Header header(file, compressed);
  if (!header.has_magic("n+1"))
    throw std::runtime_error("it is not a NIfTI file of header and voxels together");
  const int dimensions = header.get<std::int16_t>(40);
  if (dimensions < 3 || dimensions > 7)
    throw std::runtime_error(fmt::format("it has {} dimensions; expected 3", dimensions));
  for (std::size_t i = 1; i <= static_cast<std::size_t>(dimensions); ++i) {
    const int size = header.get<std::int16_t>(40 + 2 * i);
    const auto spacing = static_cast<double>(header.get<float>(76 + 4 * i));
    if (size <= 0)
      throw std::runtime_error(fmt::format("its size along axis {} is {}", i, size));
    if (i <= 3 && !(spacing > 0 && std::isfinite(spacing))) // ITK takes 1 for 0
      throw std::runtime_error(fmt::format("its spacing along axis {} is {}; expected a positive number", i, spacing));
  }
  check_orientation(header);

  Stored_voxels stored;
  stored.file = file;
  const int type = header.get<std::int16_t>(70);
  stored.bytes_per_voxel = bytes_of_type(type);
  stored.are_floats = type == 16 || type == 64;
  stored.are_swapped = header.is_swapped();
  stored.encoding = compressed ? Stored_voxels::Encoding::compressed : Stored_voxels::Encoding::raw;
  const float slope = header.get<float>(112), intercept = header.get<float>(116);
  stored.is_plain = slope == 0 || (slope == 1 && intercept == 0);
  const auto offset = static_cast<double>(header.get<float>(108));
  if (!(offset >= 0 && offset < 1e9))
    throw std::runtime_error(fmt::format("its voxels begin at byte {}", offset));
  stored.skipped = std::max(static_cast<std::uint64_t>(offset), std::uint64_t{header_size});
  return stored;
}

} // namespace CGAL::Extremal_mesh_3
