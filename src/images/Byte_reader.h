// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_SRC_IMAGES_BYTE_READER_H
#define CGAL_EXTREMAL_MESH_3_SRC_IMAGES_BYTE_READER_H

#include <cstdint>
#include <fstream>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

/// The bytes of a file, decompressed (gzip or zlib) if asked for.
class Byte_reader {
public:
  /// \param size  at most so many bytes of the file are read, from `offset` on
  /// \throws std::runtime_error if the file cannot be opened
  Byte_reader(const std::string& file, std::uint64_t offset, bool compressed,
              std::uint64_t size = std::numeric_limits<std::uint64_t>::max());
  ~Byte_reader();
  Byte_reader(const Byte_reader&) = delete;
  Byte_reader& operator=(const Byte_reader&) = delete;

  /// \return how many bytes were read; less than `n` only at the end of the data
  /// \throws std::runtime_error if the compressed data are damaged
  std::size_t read(char* out, std::size_t n);

  enum class Rest { whole, truncated, long_one };
  /// reads the rest, which shows whether compressed data are whole: they end with a checksum.
  /// \param most  the rest is not read on after so many bytes: it is a long one then
  Rest rest(std::uint64_t most);

private:
  struct Inflater;
  std::size_t read_file(char* out, std::size_t n);

  std::ifstream in_;
  std::uint64_t left_;
  std::unique_ptr<Inflater> inflater_;
};

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_SRC_IMAGES_BYTE_READER_H
