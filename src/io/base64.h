// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_IO_BASE64_H
#define EXTREMAL_MESH_3_SRC_IO_BASE64_H

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

/// encodes bytes as RFC 4648 has it, padded.
inline std::string base64(std::string_view bytes) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::string_view part = bytes.substr(i, 3);
    std::uint32_t group = 0;
    for (std::size_t j = 0; j < 3; ++j)
      group = group << 8U | (j < part.size() ? std::uint8_t(part[j]) : 0U);
    for (std::size_t j = 0; j < 4; ++j)
      text += j <= part.size() ? digits[group >> (18 - 6 * j) & 63U] : '=';
  }
  return text;
}

/// the bytes of numbers, each with its least byte first.
template <typename Number> std::string little_endian(const std::vector<Number>& numbers) {
  std::string bytes;
  bytes.reserve(numbers.size() * sizeof(Number));
  for (const Number number : numbers) {
    std::array<char, sizeof(Number)> parts;
    std::memcpy(parts.data(), &number, sizeof(Number));
    if constexpr (std::endian::native == std::endian::big)
      std::reverse(parts.begin(), parts.end());
    bytes.append(parts.data(), parts.size());
  }
  return bytes;
}

/// encodes numbers, each with its least byte first.
template <typename Number> std::string base64(const std::vector<Number>& numbers) {
  return base64(std::string_view(little_endian(numbers)));
}

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_IO_BASE64_H
