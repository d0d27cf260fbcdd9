// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Large blocks of memory on huge pages. A volume and the cells of its surface take hundreds of megabytes, and the system gives them
// page by page, at the first touch of each: a volume of 256³ took 133 thousand pages of 4 kB, and takes 39 thousand faults this way. A program
// may choose so for itself, a library must not.
#if defined(__linux__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)

#include <cstdint>
#include <cstdlib>
#include <new>

#include <sys/mman.h>

namespace {

constexpr std::size_t huge_page = std::size_t(1) << 21;
/// Smaller ones would take much more than was asked for, as they begin and end at huge pages.
constexpr std::size_t least_size = 8 * huge_page;

/// \return null if there is no memory
void* block(std::size_t size) {
  if (size < least_size || size > SIZE_MAX - huge_page)
    return std::malloc(size != 0 ? size : 1);
  const std::size_t whole = (size + huge_page - 1) / huge_page * huge_page;
  void* const p = std::aligned_alloc(huge_page, whole);
  if (p)
    madvise(p, size / huge_page * huge_page, MADV_HUGEPAGE); // advice: nothing is lost where it is not taken
  return p;
}

} // namespace

void* operator new(std::size_t size) {
  for (;;) {
    if (void* const p = block(size))
      return p;
    const std::new_handler handler = std::get_new_handler();
    if (!handler)
      throw std::bad_alloc();
    handler();
  }
}

void operator delete(void* p) noexcept {
  std::free(p);
}

void operator delete(void* p, std::size_t) noexcept {
  std::free(p);
}

#endif
