// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Byte_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <new>
#include <stdexcept>
#include <system_error>
#include <zlib.h>

namespace CGAL::Extremal_mesh_3 {

struct Byte_reader::Inflater {
  static constexpr int gzip_or_zlib = 32; // added to the window's size: zlib finds out by itself

  Inflater() {
    if (inflateInit2(&stream, gzip_or_zlib + MAX_WBITS) != Z_OK)
      throw std::bad_alloc();
  }
  ~Inflater() { inflateEnd(&stream); }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;

  z_stream stream{};
  bool at_end = false;
  std::vector<char> input = std::vector<char>(1 << 16);
};

Byte_reader::Byte_reader(const std::string& file, std::uint64_t offset, bool compressed, std::uint64_t size)
    : in_(file, std::ios::binary), left_(size) {
  if (!in_)
    throw std::runtime_error(fmt::format("'{}' cannot be opened ({})", file, std::generic_category().message(errno)));
  in_.seekg(static_cast<std::streamoff>(offset));
  if (compressed)
    inflater_ = std::make_unique<Inflater>();
}

Byte_reader::~Byte_reader() = default;

std::size_t Byte_reader::read_file(char* out, std::size_t n) {
  in_.read(out, static_cast<std::streamsize>(std::min<std::uint64_t>(n, left_)));
  left_ -= static_cast<std::uint64_t>(in_.gcount());
  return static_cast<std::size_t>(in_.gcount());
}

std::size_t Byte_reader::read(char* out, std::size_t n) {
  if (!inflater_)
    return read_file(out, n);
  z_stream& stream = inflater_->stream;
  std::size_t done = 0;
  while (done < n) {
    if (stream.avail_in == 0) {
      stream.next_in = reinterpret_cast<Bytef*>(inflater_->input.data());
      stream.avail_in = static_cast<uInt>(read_file(inflater_->input.data(), inflater_->input.size()));
      if (stream.avail_in == 0)
        break;
    }
    if (inflater_->at_end) { // gzip files may be put together from several
      if (*stream.next_in != 0x1f)
        break;
      inflateReset(&stream);
      inflater_->at_end = false;
    }
    const std::size_t room = std::min<std::size_t>(n - done, std::numeric_limits<uInt>::max());
    stream.next_out = reinterpret_cast<Bytef*>(out + done);
    stream.avail_out = static_cast<uInt>(room);
    const int status = inflate(&stream, Z_NO_FLUSH);
    done += room - stream.avail_out;
    if (status == Z_STREAM_END)
      inflater_->at_end = true;
    else if (status != Z_OK && status != Z_BUF_ERROR)
      throw std::runtime_error("its compressed data are damaged");
  }
  return done;
}

Byte_reader::Rest Byte_reader::rest(std::uint64_t most) {
  if (!inflater_)
    return Rest::whole;
  std::vector<char> bytes(1 << 16);
  std::uint64_t done = 0;
  while (const std::size_t n = read(bytes.data(), bytes.size())) {
    done += n;
    if (done > most)
      return Rest::long_one;
  }
  return inflater_->at_end ? Rest::whole : Rest::truncated;
}

} // namespace CGAL::Extremal_mesh_3
