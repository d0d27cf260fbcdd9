// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_IO_JSON_TEXT_H
#define CGAL_EXTREMAL_MESH_3_IO_JSON_TEXT_H

#include <string>

namespace CGAL::Extremal_mesh_3 {

/// the text of a JSON value of nlohmann's. Bytes that are no UTF-8, as names of files may have them, become U+FFFD, where dump() alone throws.
/// \param indent  of each depth; -1: all on one line
template <class Json> std::string json_text(const Json& value, int indent = -1) {
  return value.dump(indent, ' ', false, Json::error_handler_t::replace);
}

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_IO_JSON_TEXT_H
