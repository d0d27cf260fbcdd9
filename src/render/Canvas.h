// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_RENDER_CANVAS_H
#define EXTREMAL_MESH_3_SRC_RENDER_CANVAS_H

#include "../io/colours.h"
#include "Camera.h"

#include <array>
#include <span>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

/// A corner of a triangle: where it is, and its normal as (right, up, towards the eye).
struct Corner {
  Screen_point at;
  Vector normal{};
};

/// A horizontal band of a picture while it is drawn: samples with colour and depth. Bands are independent of each
/// other, so that they can be drawn at the same time and a large picture never exists in samples as a whole.
class Canvas {
public:
  static constexpr int samples = 3; ///< to a pixel, along each axis

  /// \param width,height  of the whole picture in pixels
  /// \param first,last  the rows [first, last) of the band
  Canvas(int width, int height, int first, int last);

  double first_sample_row() const { return first_ * samples; }
  double last_sample_row() const { return last_ * samples; }

  /// draws a shaded triangle.
  void triangle(const Corner& a, const Corner& b, const Corner& c, const Colour& tint);
  /// fills a rectangle, all of it at the depth of its upper left corner.
  void rectangle(const Screen_point& upper_left, const Screen_point& lower_right, const Colour& colour);
  /// draws a line with round ends.
  /// \param bias  by how many samples it stands in front of where it is
  void stroke(const Screen_point& a, const Screen_point& b, double radius, double bias, const Colour& colour);
  /// draws a disc with a white rim.
  void dot(const Screen_point& centre, double radius, double rim, double bias, const Colour& colour);

  /// averages the samples of each pixel.
  /// \param pixels  red, green, blue; the rows of the band
  void resolve(std::span<std::uint8_t> pixels) const;

private:
  struct Box {
    int left, right, top, bottom; ///< samples, the last ones included
  };
  Box clip(double left, double right, double top, double bottom) const;
  std::size_t index(int x, int y) const {
    return std::size_t(y - first_ * samples) * std::size_t(width_ * samples) + std::size_t(x);
  }

  int width_, first_, last_;
  std::vector<Colour> colour_;
  std::vector<float> depth_;
};

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_RENDER_CANVAS_H
