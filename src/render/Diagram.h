// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_RENDER_DIAGRAM_H
#define EXTREMAL_MESH_3_SRC_RENDER_DIAGRAM_H

#include "../io/colours.h"

#include <string>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

/// A plane drawing. x to the right and y downwards from the upper left corner, in pixels. What stands later in a list is
/// drawn over what stands before, dots over rectangles and lines, texts over all.
struct Diagram {
  enum class Align : std::uint8_t { left, middle, right };
  struct Rectangle {
    double x, y, width, height;
    Colour colour;
  };
  struct Line {
    double x1, y1, x2, y2, width;
    Colour colour;
    bool dashed;
  };
  /// Dots of one kind.
  struct Dots {
    std::string name; ///< for who looks into the SVG
    Colour colour;
    std::vector<std::array<double, 2>> centres;
  };
  /// A line of text; y is that of its middle. Letters of ASCII only.
  struct Text {
    double x, y;
    Align align;
    std::string text;
  };

  int width = 900, height = 600;
  double dot_radius = 3;
  std::vector<Rectangle> rectangles;
  std::vector<Line> lines;
  std::vector<Dots> dots;
  std::vector<Text> texts;

  /// \throws Io_error
  void write_svg(const std::string& file) const;
  /// \throws Io_error
  void write_png(const std::string& file) const;
};

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_RENDER_DIAGRAM_H
