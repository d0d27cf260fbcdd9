// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_POLYGONS_FILE_CONTENT_H
#define EXTREMAL_MESH_3_SRC_POLYGONS_FILE_CONTENT_H

#include <CGAL/Extremal_mesh_3/errors.h>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <new>
#include <stdexcept>
#include <string>

namespace CGAL::Extremal_mesh_3 {

/// all bytes of a file.
/// \throws std::runtime_error if there are none
std::string content_of(const std::string& file);

/// does something with a file; what is wrong becomes an `Io_error`.
template <typename Action> auto with_name_in_errors(const std::string& file, const Action& action) {
  try {
    return action();
  } catch (const std::bad_alloc&) {
    throw Io_error(fmt::format("cannot read '{}': it is larger than memory", file));
  } catch (const std::exception& error) {
    std::string message = error.what(); // may quote the file, with anything in it
    std::replace_if(
        message.begin(), message.end(), [](unsigned char c) { return std::iscntrl(c) != 0; }, '?');
    throw Io_error(fmt::format("cannot read '{}': {}", file, message));
  }
}

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_POLYGONS_FILE_CONTENT_H
