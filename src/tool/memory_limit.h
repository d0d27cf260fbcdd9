// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_TOOL_MEMORY_LIMIT_H
#define EXTREMAL_MESH_3_SRC_TOOL_MEMORY_LIMIT_H

#include <cstdint>
#include <string>

namespace CGAL::Extremal_mesh_3::tool {

/// How much memory may be taken.
class Memory_limit {
public:
  /// \param text  a number of bytes, or of K, M, G or T; empty: the memory that the machine has. If it is given, the system is told to
  ///              refuse the program more, which then ends with the message of any program that is out of memory
  /// \throws Usage_error if it is something else
  explicit Memory_limit(const std::string& text);

  std::uint64_t bytes() const { return bytes_; }
  /// \param bytes  an estimate that is rather too low
  /// \throws std::runtime_error telling how much `what` takes if that is more
  void require(double bytes, const std::string& what) const;

private:
  std::uint64_t bytes_;
  bool is_given_;
};

} // namespace CGAL::Extremal_mesh_3::tool

#endif // EXTREMAL_MESH_3_SRC_TOOL_MEMORY_LIMIT_H
