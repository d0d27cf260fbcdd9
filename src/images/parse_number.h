// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_SRC_IMAGES_PARSE_NUMBER_H
#define CGAL_EXTREMAL_MESH_3_SRC_IMAGES_PARSE_NUMBER_H

#include <charconv>
#include <optional>
#include <string_view>

namespace CGAL::Extremal_mesh_3 {

/// reads a number, in any locale. NaN and infinity are numbers too.
/// \return nothing if the text is anything else
inline std::optional<double> parse_number(std::string_view text) {
  if (text.starts_with('+'))
    text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size())
    return std::nullopt;
  return value;
}

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_SRC_IMAGES_PARSE_NUMBER_H
