// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_IO_ATOMIC_FILE_H
#define CGAL_EXTREMAL_MESH_3_IO_ATOMIC_FILE_H

#include <string>
#include <string_view>

namespace CGAL::Extremal_mesh_3 {

/// A file that appears whole or not at all: written beside its place without a name, or under another one, put in place by
/// `commit()`, and removed if that is not reached.
class Atomic_file {
public:
  /// \throws Io_error if there is something else than a file in that place, or no file can be made there
  explicit Atomic_file(const std::string& file);
  Atomic_file(const Atomic_file&) = delete;
  Atomic_file& operator=(const Atomic_file&) = delete;
  ~Atomic_file();

  /// \throws Io_error if the disk is full
  void write(std::string_view bytes);
  /// \throws Io_error
  void commit();

private:
  void give_name(); ///< `temporary_`, to a file that has none
  [[noreturn]] void fail(int error) const;

  std::string file_;      ///< as the caller named it
  std::string place_;     ///< where it really is, symbolic links followed
  std::string folder_;    ///< in which `place_` is
  std::string temporary_; ///< empty while there is no such name
  int descriptor_ = -1;
};

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_IO_ATOMIC_FILE_H
