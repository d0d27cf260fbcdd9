// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Extremal_mesh_3/Voxels.h>
#include <CGAL/Extremal_mesh_3/errors.h>

#include <fmt/format.h>

#include <cerrno>
#include <cstdlib>
#include <fcntl.h>
#include <limits>
#include <new>
#include <sys/mman.h>
#include <sys/vfs.h>
#include <system_error>
#include <unistd.h>

namespace CGAL::Extremal_mesh_3 {

namespace {

/// A file that is open and has no name.
class Nameless_file {
public:
  explicit Nameless_file(const std::string& folder) {
    std::string name = folder + "/extremal_mesh_XXXXXX";
    id_ = ::mkostemp(name.data(), O_CLOEXEC);
    if (id_ >= 0)
      ::unlink(name.c_str());
  }
  ~Nameless_file() {
    if (id_ >= 0)
      ::close(id_);
  }
  Nameless_file(const Nameless_file&) = delete;
  Nameless_file& operator=(const Nameless_file&) = delete;
  int id() const { return id_; }

private:
  int id_ = -1;
};

[[noreturn]] void throw_no_room(const std::string& folder, std::size_t bytes, const std::string& why) {
  throw Io_error(
      fmt::format("the voxels, which are too many for memory, take a temporary file of {:.0f} MB, and none can be "
                  "made in '{}': {}. The environment variable TMPDIR names another folder",
                  double(bytes) / 0x1p20, folder, why));
}

[[noreturn]] void throw_no_room(const std::string& folder, std::size_t bytes, int error) {
  throw_no_room(folder, bytes, std::generic_category().message(error));
}

bool is_kept_in_memory(unsigned long type_of_file_system) {
  constexpr unsigned long tmpfs = 0x01021994, ramfs = 0x858458f6; // of Linux
  return type_of_file_system == tmpfs || type_of_file_system == ramfs;
}

float* mapped_file(const std::string& folder, std::size_t bytes) {
  const Nameless_file file(folder);
  if (file.id() < 0)
    throw_no_room(folder, bytes, errno);
  struct ::statfs system {};
  if (::fstatfs(file.id(), &system) == 0 && is_kept_in_memory(static_cast<unsigned long>(system.f_type)))
    throw_no_room(folder, bytes, "that folder is itself kept in memory");
  // All of it: a disk that is full later on could not be told of but by a signal.
  int error = 0;
  do
    error = ::posix_fallocate(file.id(), 0, ::off_t(bytes));
  while (error == EINTR);
  if (error != 0)
    throw_no_room(folder, bytes, error);
  void* const p = ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, file.id(), 0);
  if (p == MAP_FAILED)
    throw_no_room(folder, bytes, errno);
  return static_cast<float*>(p);
}

} // namespace

float* Voxel_allocator::allocate(std::size_t n) {
  if (n > std::size_t(std::numeric_limits<::off_t>::max()) / sizeof(float))
    throw std::bad_alloc();
  return is_in_file() && n > 0 ? mapped_file(folder_, n * sizeof(float))
                               : static_cast<float*>(::operator new(n * sizeof(float)));
}

void Voxel_allocator::deallocate(float* p, std::size_t n) noexcept {
  if (is_in_file() && n > 0)
    ::munmap(p, n * sizeof(float));
  else
    ::operator delete(p);
}

} // namespace CGAL::Extremal_mesh_3
