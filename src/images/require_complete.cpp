// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Byte_reader.h"
#include "image_headers.h"
#include "parse_number.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <vector>

namespace CGAL::Extremal_mesh_3 {
namespace {

constexpr std::size_t chunk = 1 << 20;
constexpr std::uint64_t most_after_voxels = 1 << 24;
/// of what deflate stores: 258 bytes take at least two bits.
constexpr std::uint64_t best_compression = 1032;

[[noreturn]] void throw_truncated(std::uint64_t expected, std::uint64_t found, const char* what) {
  throw std::runtime_error(fmt::format("it is truncated: expected {} {}, found {}", expected, what, found));
}

template <typename Float>
void check_finite(const std::vector<char>& bytes, std::size_t n, bool swapped, std::uint64_t first_voxel) {
  for (std::size_t i = 0; i + sizeof(Float) <= n; i += sizeof(Float)) {
    char value_bytes[sizeof(Float)];
    std::memcpy(value_bytes, bytes.data() + i, sizeof(Float));
    if (swapped)
      std::reverse(value_bytes, value_bytes + sizeof(Float));
    Float value;
    std::memcpy(&value, value_bytes, sizeof(Float));
    if (!std::isfinite(value))
      throw std::runtime_error(
          fmt::format("its voxel {} is {}; expected a finite number", first_voxel + i / sizeof(Float), value));
  }
}

// Reads the voxels as bytes, in pieces that are whole voxels but for the last.
template <class Use>
void read_pieces(Byte_reader& reader, const Stored_voxels& stored, std::uint64_t bytes, const Use& use) {
  std::vector<char> buffer(chunk);
  const auto read = [&](std::uint64_t n) { return reader.read(buffer.data(), std::min<std::uint64_t>(n, chunk)); };
  for (std::uint64_t skipped = 0; skipped < stored.skipped;) {
    const std::size_t n = read(stored.skipped - skipped);
    if (n == 0)
      throw_truncated(bytes, 0, "bytes of voxels");
    skipped += n;
  }
  for (std::uint64_t done = 0; done < bytes;) {
    const std::size_t n = read(bytes - done);
    if (n == 0)
      throw_truncated(bytes, done, "bytes of voxels");
    use(buffer, n, done);
    done += n;
  }
}

Byte_reader reader_of(const Stored_voxels& stored) {
  return {stored.file, stored.offset, stored.encoding == Stored_voxels::Encoding::compressed, stored.size};
}

// What follows the voxels is read for the checksum at the end only: a bomb is not worth it.
void require_end(Byte_reader& reader, std::uint64_t bytes) {
  switch (reader.rest(std::max<std::uint64_t>(bytes, most_after_voxels))) {
  case Byte_reader::Rest::whole:
    return;
  case Byte_reader::Rest::truncated:
    throw std::runtime_error("it is truncated: its compressed data have no end");
  case Byte_reader::Rest::long_one:
    throw std::runtime_error(fmt::format("its compressed data go on long after the {} bytes of its voxels", bytes));
  }
}

// Counts and checks the voxels.
void read_through(const Stored_voxels& stored, std::uint64_t bytes, std::uint64_t bytes_per_voxel) {
  Byte_reader reader = reader_of(stored);
  read_pieces(reader, stored, bytes, [&](const std::vector<char>& buffer, std::size_t n, std::uint64_t done) {
    if (stored.are_floats && bytes_per_voxel == sizeof(float))
      check_finite<float>(buffer, n, stored.are_swapped, done / bytes_per_voxel);
    else if (stored.are_floats)
      check_finite<double>(buffer, n, stored.are_swapped, done / bytes_per_voxel);
  });
  require_end(reader, bytes);
}

void read_through_text(const Stored_voxels& stored, std::uint64_t voxels) {
  std::ifstream in(stored.file, std::ios::binary);
  in.seekg(static_cast<std::streamoff>(stored.offset));
  std::string word;
  for (std::uint64_t i = 0; i < voxels; ++i) {
    if (!(in >> word))
      throw_truncated(voxels, i, "voxels");
    if (!parse_number(word))
      throw std::runtime_error(fmt::format("its voxel {} is '{}'; expected a number", i, word.substr(0, 20)));
  }
}

} // namespace

void for_each_piece(const Stored_voxels& stored, std::uint64_t voxels, std::size_t bytes_per_voxel,
                    const std::function<void(const char* bytes, std::size_t count)>& use) {
  Byte_reader reader = reader_of(stored);
  const std::uint64_t bytes = voxels * bytes_per_voxel;
  read_pieces(reader, stored, bytes, [&](const std::vector<char>& buffer, std::size_t n, std::uint64_t done) {
    // Only a file that became shorter ends within a voxel.
    if (n % bytes_per_voxel != 0)
      throw_truncated(bytes, done + n, "bytes of voxels");
    use(buffer.data(), n / bytes_per_voxel);
  });
  require_end(reader, bytes);
}

void require_possible_size(const Stored_voxels& stored, std::uint64_t voxels, std::uint64_t bytes_per_voxel) {
  const std::uint64_t bytes = voxels * (stored.bytes_per_voxel != 0 ? stored.bytes_per_voxel : bytes_per_voxel);
  std::error_code error;
  const std::uint64_t size = std::filesystem::file_size(stored.file, error);
  if (error)
    throw std::runtime_error(fmt::format("'{}' cannot be read ({})", stored.file, error.message()));
  if (stored.encoding == Stored_voxels::Encoding::raw) {
    const std::uint64_t found = size - std::min(size, stored.offset + stored.skipped);
    if (found < bytes)
      throw_truncated(bytes, found, "bytes of voxels");
  } else if (stored.encoding == Stored_voxels::Encoding::compressed && bytes / best_compression > size)
    throw_truncated(bytes, size, "bytes of voxels, compressed");
}

void require_complete(const Stored_voxels& stored, std::uint64_t voxels, std::uint64_t bytes_per_voxel) {
  if (stored.encoding == Stored_voxels::Encoding::text)
    return read_through_text(stored, voxels);
  require_possible_size(stored, voxels, bytes_per_voxel);
  if (stored.bytes_per_voxel != 0)
    bytes_per_voxel = stored.bytes_per_voxel;
  if (stored.encoding == Stored_voxels::Encoding::compressed || stored.are_floats)
    read_through(stored, voxels * bytes_per_voxel, bytes_per_voxel);
}

} // namespace CGAL::Extremal_mesh_3
