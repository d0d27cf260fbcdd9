// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_POLYGONS_BYTES_H
#define EXTREMAL_MESH_3_SRC_POLYGONS_BYTES_H

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>

namespace CGAL::Extremal_mesh_3 {

/// Binary numbers behind each other. Errors are `std::runtime_error`s that tell at which byte of the file.
class Bytes {
public:
  /// \param begin  what is to be read begins at this byte of the file
  Bytes(std::string_view file, std::size_t begin, std::endian order)
      : file_(file), at_(begin), reversed_(order != std::endian::native) {}

  template <typename Number> Number next(const char* expected) {
    require(1, sizeof(Number), expected);
    std::array<char, sizeof(Number)> bytes;
    std::memcpy(bytes.data(), file_.data() + at_, sizeof(Number));
    if (reversed_)
      std::reverse(bytes.begin(), bytes.end());
    at_ += sizeof(Number);
    return std::bit_cast<Number>(bytes);
  }
  template <typename Float> double coordinate() {
    const auto value = double(next<Float>("a coordinate"));
    if (!std::isfinite(value))
      throw std::runtime_error(
          fmt::format("byte {}: expected a finite coordinate, found {}", at_ - sizeof(Float), value));
    return value;
  }
  void skip(std::uint64_t n, std::size_t size, const char* expected) {
    require(n, size, expected);
    at_ += n * size;
  }
  /// \throws std::runtime_error unless `n` things of `size` bytes are left
  void require(std::uint64_t n, std::size_t size, const char* expected) const {
    if (n > (file_.size() - at_) / size)
      throw std::runtime_error(fmt::format("byte {}: expected {}{}, found the end after {} bytes", at_,
                                           n == 1 ? "" : fmt::format("{} times ", n), expected, file_.size() - at_));
  }
  std::size_t position() const { return at_; }

private:
  std::string_view file_;
  std::size_t at_;
  bool reversed_;
};

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_POLYGONS_BYTES_H
