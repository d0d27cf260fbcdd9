// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "file_content.h"

#include <filesystem>
#include <fstream>

namespace CGAL::Extremal_mesh_3 {

std::string content_of(const std::string& file) {
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (!std::filesystem::exists(status))
    throw std::runtime_error("it does not exist");
  if (std::filesystem::is_directory(status))
    throw std::runtime_error("it is a folder");
  if (!std::filesystem::is_regular_file(status))
    throw std::runtime_error("it is not a regular file");
  std::ifstream stream(file, std::ios::binary);
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (!stream || error)
    throw std::runtime_error("it cannot be opened");
  if (size == 0)
    throw std::runtime_error("it is empty");
  std::string content(size, '\0');
  stream.read(content.data(), std::streamsize(size));
  content.resize(std::size_t(stream.gcount())); // it may have become shorter
  return content;
}

} // namespace CGAL::Extremal_mesh_3
