// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_IO_TEXT_FILE_H
#define CGAL_EXTREMAL_MESH_3_IO_TEXT_FILE_H

#include "Atomic_file.h"

#include <fmt/compile.h>
#include <fmt/format.h>

#include <iterator>
#include <string>
#include <string_view>
#include <utility>

namespace CGAL::Extremal_mesh_3 {

/// Text on its way to a file. Doubles are written with as few digits as read back to the same bits, whatever the
/// locale.
class Text_file {
public:
  explicit Text_file(const std::string& file) : file_(file) {}

  /// \param format  made by `FMT_COMPILE`
  template <typename Format, typename... Arguments> void print(const Format& format, Arguments&&... arguments) {
    fmt::format_to(std::back_inserter(buffer_), format, std::forward<Arguments>(arguments)...);
    flush_if_full();
  }
  Text_file& operator<<(std::string_view text) {
    buffer_.append(text);
    flush_if_full();
    return *this;
  }
  Text_file& operator<<(double number) {
    print(FMT_COMPILE("{}"), number);
    return *this;
  }

  /// puts the file in its place.
  void commit() {
    flush();
    file_.commit();
  }

private:
  void flush() {
    file_.write({buffer_.data(), buffer_.size()});
    buffer_.clear();
  }
  void flush_if_full() {
    if (buffer_.size() > (1U << 18))
      flush();
  }

  Atomic_file file_;
  fmt::memory_buffer buffer_;
};

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_IO_TEXT_FILE_H
