// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_TEST_FUZZ_MEMORY_FILE_H
#define EXTREMAL_MESH_3_TEST_FUZZ_MEMORY_FILE_H

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <span>
#include <stdexcept>
#include <string>
#include <unistd.h>

namespace fuzz {

/// A file for readers that want a name, in memory where the system has a place for that. Its content changes.
class Memory_file {
public:
  explicit Memory_file(const std::string& extension) {
    const std::filesystem::path memory = "/dev/shm";
    const auto folder = std::filesystem::is_directory(memory) ? memory : std::filesystem::temp_directory_path();
    name_ = (folder / ("extremal_mesh_fuzz_" + std::to_string(::getpid()) + extension)).string();
  }
  Memory_file(const Memory_file&) = delete;
  Memory_file& operator=(const Memory_file&) = delete;
  ~Memory_file() { ::unlink(name_.c_str()); }

  void fill(std::span<const std::uint8_t> bytes) {
    std::ofstream out(name_, std::ios::binary | std::ios::trunc);
    out.write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
    if (!out.flush())
      throw std::runtime_error("cannot write " + name_);
  }
  const std::string& name() const { return name_; }

private:
  std::string name_;
};

} // namespace fuzz

#endif // EXTREMAL_MESH_3_TEST_FUZZ_MEMORY_FILE_H
