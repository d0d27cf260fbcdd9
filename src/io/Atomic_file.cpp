// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// POSIX: a rename within a folder replaces the file there in one step, and only `close()` tells of some full disks. Where the
// file system can (Linux's O_TMPFILE), the file has no name until it is whole, so that nothing is left of it however the program ends.
#include "Atomic_file.h"

#include <CGAL/Extremal_mesh_3/io.h>

#include <fmt/format.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <filesystem>
#include <system_error>
#include <unistd.h>

namespace CGAL::Extremal_mesh_3 {

namespace fs = std::filesystem;

namespace {

/// a name that no other file, thread or process uses. It is short, as the file's own name may be as long as names can
/// be.
fs::path temporary_name(const fs::path& folder) {
  static std::atomic<unsigned> counter{0};
  return folder / fmt::format(".extremal_mesh-{}-{}.part", ::getpid(), counter++);
}

/// opens a file without a name.
/// \return negative if that cannot be, or the file could not be named later
int open_unnamed(const fs::path& folder) {
  if (::access("/proc/self/fd", X_OK) != 0)
    return -1;
  return ::open(folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0666);
}

} // namespace

Atomic_file::Atomic_file(const std::string& file) : file_(file) {
  if (file.empty())
    throw Io_error("cannot write a file without a name");
  std::error_code error;
  fs::path place = fs::path(file);
  if (fs::is_symlink(fs::symlink_status(place, error)))
    place = fs::weakly_canonical(place, error);
  const fs::path folder = place.has_parent_path() ? place.parent_path() : fs::path(".");
  // /dev/stdout is a link to wherever the output goes, which must not be replaced by another file
  const std::string real_folder = fs::weakly_canonical(fs::path(file).parent_path(), error).string();
  if (real_folder == "/dev" || real_folder.starts_with("/proc/"))
    throw Io_error(fmt::format("cannot write '{}': it is not a regular file; give the name of one", file));
  if (!fs::is_directory(folder, error))
    throw Io_error(fmt::format("cannot write '{}': the folder '{}' does not exist", file, folder.string()));
  if (fs::is_directory(place, error))
    throw Io_error(fmt::format("cannot write '{}': it is a folder", file));
  if (fs::exists(place, error)) {
    if (!fs::is_regular_file(place, error))
      throw Io_error(fmt::format("cannot write '{}': it is not a regular file; give the name of one", file));
    if (::access(place.c_str(), W_OK) != 0)
      fail(errno);
  }
  place_ = place.string();
  folder_ = folder.string();
  descriptor_ = open_unnamed(folder);
  if (descriptor_ >= 0)
    return;
  do {
    temporary_ = temporary_name(folder).string();
    descriptor_ = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  } while (descriptor_ < 0 && errno == EEXIST);
  if (descriptor_ < 0) {
    const int reason = errno;
    temporary_.clear();
    fail(reason);
  }
}

Atomic_file::~Atomic_file() {
  if (descriptor_ >= 0)
    ::close(descriptor_);
  if (!temporary_.empty())
    std::remove(temporary_.c_str());
}

void Atomic_file::write(std::string_view bytes) {
  while (!bytes.empty()) {
    const ::ssize_t n = ::write(descriptor_, bytes.data(), bytes.size());
    if (n < 0 && errno != EINTR)
      fail(errno);
    if (n > 0)
      bytes.remove_prefix(std::size_t(n));
  }
}

void Atomic_file::give_name() {
  const std::string open_file = fmt::format("/proc/self/fd/{}", descriptor_);
  int status = 0;
  do {
    temporary_ = temporary_name(folder_).string();
    status = ::linkat(AT_FDCWD, open_file.c_str(), AT_FDCWD, temporary_.c_str(), AT_SYMLINK_FOLLOW);
  } while (status != 0 && errno == EEXIST);
  if (status != 0) {
    const int reason = errno;
    temporary_.clear();
    fail(reason);
  }
}

void Atomic_file::commit() {
  if (temporary_.empty())
    give_name();
  const int closed = ::close(descriptor_);
  descriptor_ = -1;
  if (closed != 0 || std::rename(temporary_.c_str(), place_.c_str()) != 0)
    fail(errno);
  temporary_.clear();
}

void Atomic_file::fail(int error) const {
  throw Io_error(fmt::format("cannot write '{}': {}", file_, std::generic_category().message(error)));
}

void check_writable(const std::string& file) {
  const Atomic_file probe(file);
}

void write_text_file(const std::string& file, const std::string& text) {
  Atomic_file out(file);
  out.write(text);
  out.commit();
}

} // namespace CGAL::Extremal_mesh_3
