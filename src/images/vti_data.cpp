// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// "VTK XML formats", https://docs.vtk.org/en/latest/design_documents/VTKFileFormats.html. In front of an array stands its length in bytes or, if it
// is compressed, the number of its blocks, the length of a block, that of the last one if it is shorter, and the
// length of each when compressed. In base64, these numbers and what follows may each end with padding.
#include "vti_data.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

namespace {

/// The bytes of an array, one part after the other.
class Stored_bytes {
public:
  Stored_bytes(std::string_view stored, bool is_base64) : stored_(stored), is_base64_(is_base64) {}

  /// \throws std::runtime_error if there are fewer
  std::string take(std::size_t n) {
    if (n > stored_.size()) // base64 makes them longer, so this holds for both
      throw_truncated();
    std::string bytes;
    if (!is_base64_) {
      bytes = stored_.substr(0, n);
      stored_.remove_prefix(n);
      return bytes;
    }
    while (rest_.size() < n && decode_group(rest_))
      ;
    if (rest_.size() < n)
      throw_truncated();
    bytes = rest_.substr(0, n);
    rest_.erase(0, n);
    return bytes;
  }

private:
  [[noreturn]] static void throw_truncated() {
    throw std::runtime_error("it is truncated: its array of voxels has no end");
  }

  static int digit(char c) {
    if (c >= 'A' && c <= 'Z')
      return c - 'A';
    if (c >= 'a' && c <= 'z')
      return c - 'a' + 26;
    if (c >= '0' && c <= '9')
      return c - '0' + 52;
    return c == '+' ? 62 : c == '/' ? 63 : -1;
  }

  /// \return false at the end of the digits
  bool decode_group(std::string& out) {
    std::uint32_t group = 0;
    int digits = 0, padding = 0;
    while (digits + padding < 4) {
      if (stored_.empty())
        return false;
      const char c = stored_.front();
      if (c == '=' && digits >= 2)
        ++padding;
      else if (const int d = digit(c); d >= 0 && padding == 0) {
        group = group << 6U | std::uint32_t(d);
        ++digits;
      } else if (c != ' ' && c != '\n' && c != '\r' && c != '\t')
        return false;
      stored_.remove_prefix(1);
    }
    group <<= 6U * unsigned(padding);
    for (int i = 0; i < 3 - padding; ++i)
      out.push_back(char(group >> (16 - 8 * i) & 255U));
    return true;
  }

  std::string_view stored_;
  bool is_base64_;
  std::string rest_; ///< decoded already
};

std::uint64_t take_size(Stored_bytes& bytes, const Vti_encoding& encoding) {
  std::string number = bytes.take(encoding.bytes_of_sizes);
  if (!encoding.is_big_endian)
    std::reverse(number.begin(), number.end());
  std::uint64_t size = 0;
  for (const char byte : number)
    size = size << 8U | std::uint8_t(byte);
  return size;
}

void require_length(std::uint64_t found, std::size_t expected) {
  if (found != expected)
    throw std::runtime_error(fmt::format("its array of voxels has {} bytes; expected {}", found, expected));
}

} // namespace

std::string decode_vti_array(std::string_view stored, const Vti_encoding& encoding, std::size_t size) {
  Stored_bytes bytes(stored, encoding.is_base64);
  if (!encoding.is_compressed) {
    require_length(take_size(bytes, encoding), size);
    return bytes.take(size);
  }
  const std::uint64_t blocks = take_size(bytes, encoding), block_size = take_size(bytes, encoding),
                      last_size = take_size(bytes, encoding);
  if (blocks > size || block_size > size)
    throw std::runtime_error("its array of voxels is damaged: it has more, or longer, blocks than bytes");
  const std::uint64_t whole = blocks - (last_size > 0 ? 1 : 0);
  require_length(blocks == 0 ? 0 : whole * block_size + last_size, size);
  std::vector<std::uint64_t> compressed;
  for (std::uint64_t b = 0; b < blocks; ++b)
    compressed.push_back(take_size(bytes, encoding));
  std::string result(size, '\0');
  std::size_t done = 0;
  for (std::uint64_t b = 0; b < blocks; ++b) {
    const std::string block = bytes.take(compressed[b]);
    const std::uint64_t expected = b < whole ? block_size : last_size;
    uLongf length = uLongf(expected);
    if (::uncompress(reinterpret_cast<Bytef*>(result.data() + done), &length,
                     reinterpret_cast<const Bytef*>(block.data()), uLong(block.size())) != Z_OK ||
        length != expected)
      throw std::runtime_error("its compressed data are damaged");
    done += expected;
  }
  return result;
}

} // namespace CGAL::Extremal_mesh_3
