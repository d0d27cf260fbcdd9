// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Loaded before the C library (LD_PRELOAD), lets one call of a program fail, as the environment tells:
//
//   FAULT_NEW=k                 the k-th request for memory by C++'s new
//   FAULT_WRITE=k               the k-th write to a file, as if the disk were full
//   FAULT_KILL=k                the program ends by SIGKILL just before its k-th write to a file
//   FAULT_RENAME=1              files cannot be renamed
//   FAULT_SHRINK=k:FILE         FILE loses half of its bytes just before the k-th read
//   FAULT_UNNAMED=1             no files without a name, as on file systems that cannot have them
//   FAULT_COUNT=FILE            nothing fails; FILE tells at the end how often new, write and read were called
//
// "File": not the standard streams.
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <dlfcn.h>
#include <fcntl.h>
#include <new>
#include <sys/stat.h>
#include <unistd.h>

namespace {

std::atomic<long> news{0}, writes{0}, reads{0};

long number(const char* name) {
  const char* const text = std::getenv(name);
  return text ? std::atol(text) : 0;
}

template <typename Function> Function next(const char* name) {
  return reinterpret_cast<Function>(::dlsym(RTLD_NEXT, name));
}

void shrink_file(long read) {
  const char* const text = std::getenv("FAULT_SHRINK");
  if (!text || std::atol(text) != read)
    return;
  const char* const file = std::strchr(text, ':') + 1;
  struct stat status {};
  if (::stat(file, &status) == 0 && ::truncate(file, status.st_size / 2) != 0)
    std::abort();
}

void* allocate(std::size_t size) {
  static const long failing = number("FAULT_NEW");
  if (++news == failing)
    throw std::bad_alloc();
  if (void* const memory = std::malloc(size == 0 ? 1 : size))
    return memory;
  throw std::bad_alloc();
}

struct At_end {
  ~At_end() {
    if (const char* const file = std::getenv("FAULT_COUNT"))
      if (std::FILE* const out = std::fopen(file, "w")) {
        std::fprintf(out, "%ld %ld %ld\n", news.load(), writes.load(), reads.load());
        std::fclose(out);
      }
  }
} at_end;

} // namespace

void* operator new(std::size_t size) {
  return allocate(size);
}
void* operator new[](std::size_t size) {
  return allocate(size);
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete[](void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
void operator delete[](void* memory, std::size_t) noexcept {
  std::free(memory);
}

extern "C" {

::ssize_t write(int descriptor, const void* bytes, std::size_t n) {
  static const auto real = next<::ssize_t (*)(int, const void*, std::size_t)>("write");
  static const long failing = number("FAULT_WRITE"), killing = number("FAULT_KILL");
  if (descriptor > STDERR_FILENO) {
    const long count = ++writes;
    if (count == killing)
      ::raise(SIGKILL);
    if (count == failing) {
      errno = ENOSPC;
      return -1;
    }
  }
  return real(descriptor, bytes, n);
}

::ssize_t read(int descriptor, void* bytes, std::size_t n) {
  static const auto real = next<::ssize_t (*)(int, void*, std::size_t)>("read");
  if (descriptor > STDERR_FILENO)
    shrink_file(++reads);
  return real(descriptor, bytes, n);
}

int rename(const char* from, const char* to) noexcept {
  static const auto real = next<int (*)(const char*, const char*)>("rename");
  if (number("FAULT_RENAME") != 0) {
    errno = EIO;
    return -1;
  }
  return real(from, to);
}

int open(const char* file, int flags, ...) {
  static const auto real = next<int (*)(const char*, int, ...)>("open");
  std::va_list arguments;
  va_start(arguments, flags);
  const auto mode = static_cast<::mode_t>(va_arg(arguments, unsigned));
  va_end(arguments);
  if ((flags & O_TMPFILE) == O_TMPFILE && number("FAULT_UNNAMED") != 0) {
    errno = EOPNOTSUPP;
    return -1;
  }
  return real(file, flags, mode);
}

} // extern "C"
