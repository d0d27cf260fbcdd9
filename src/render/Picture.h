// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_RENDER_PICTURE_H
#define EXTREMAL_MESH_3_SRC_RENDER_PICTURE_H

#include <CGAL/Extremal_mesh_3/render.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

/// A finished picture: red, green and blue of each pixel, row by row from the top.
class Picture {
public:
  Picture(int width, int height)
      : width_(width), height_(height), bytes_(3 * std::size_t(width) * std::size_t(height)) {}

  int width() const { return width_; }
  int height() const { return height_; }
  /// the bytes of rows [first, last).
  std::span<std::uint8_t> rows(int first, int last) {
    const std::size_t row = 3 * std::size_t(width_);
    return std::span(bytes_).subspan(row * std::size_t(first), row * std::size_t(last - first));
  }
  std::uint8_t* pixel(int x, int y) {
    return bytes_.data() + 3 * (std::size_t(y) * std::size_t(width_) + std::size_t(x));
  }

  /// \throws Io_error
  void write_png(const std::string& file) const;

private:
  int width_, height_;
  std::vector<std::uint8_t> bytes_;
};

/// writes the names and colours of the types of lines and vertices that a mesh has, and that are shown, into the lower left
/// corner, if there is room.
void draw_legend(Picture& picture, const Extremal_mesh& mesh, Shown_lines shown);

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_RENDER_PICTURE_H
