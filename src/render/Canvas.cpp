// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Canvas.h"

#include "../differential/vector.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL::Extremal_mesh_3 {

namespace {

constexpr Colour background_top{252, 252, 253}, background_bottom{228, 231, 236};
constexpr Colour white{255, 255, 255};

Colour mix(const Colour& a, const Colour& b, double t) {
  Colour result;
  for (std::size_t i = 0; i < 3; ++i)
    result[i] = std::uint8_t(std::lround(a[i] + t * (b[i] - a[i])));
  return result;
}

/// a matt surface under a soft light from the upper left and a weak one from the right, darker where it turns away from
/// the eye.
Colour shade(const Vector& normal, const Colour& tint) {
  static const Vector key = normalized({-0.45, 0.65, 0.9}), fill = normalized({0.9, -0.1, 0.5});
  const double length = norm(normal);
  // Seen from behind, as into a surface with a border, it is lit as from the front, and a little darker.
  const bool behind = normal[2] < 0;
  const Vector n = length > 0 ? ((behind ? -1 : 1) / length) * normal : Vector{0, 0, 1};
  const double turned = 1 - n[2];
  double light = 0.60 + 0.38 * std::max(0.0, dot(n, key)) + 0.12 * std::max(0.0, dot(n, fill));
  light *= (1 - 0.28 * turned * turned * turned) * (behind ? 0.82 : 1);
  Colour result;
  for (std::size_t i = 0; i < 3; ++i)
    result[i] = std::uint8_t(std::lround(std::min(255.0, light * tint[i])));
  return result;
}

} // namespace

Canvas::Canvas(int width, int height, int first, int last) : width_(width), first_(first), last_(last) {
  const std::size_t row = std::size_t(width * samples);
  const std::size_t size = row * std::size_t((last - first) * samples);
  colour_.reserve(size);
  for (int y = first; y < last; ++y)
    colour_.insert(colour_.end(), row * samples, mix(background_top, background_bottom, double(y) / height));
  depth_.assign(size, std::numeric_limits<float>::infinity());
}

Canvas::Box Canvas::clip(double left, double right, double top, double bottom) const {
  // In this order NaN gives an empty box.
  const auto low = [](double x, double least) { return int(std::ceil(std::max(least, x) - 0.5)); };
  const auto high = [](double x, double most) { return int(std::floor(std::min(most, x) - 0.5)); };
  return {low(left, 0), high(right, width_ * samples), low(top, first_sample_row()), high(bottom, last_sample_row())};
}

void Canvas::triangle(const Corner& a, const Corner& b, const Corner& c, const Colour& tint) {
  const double area = (b.at.x - a.at.x) * (c.at.y - a.at.y) - (b.at.y - a.at.y) * (c.at.x - a.at.x);
  if (area == 0)
    return;
  const Box box = clip(std::min({a.at.x, b.at.x, c.at.x}), std::max({a.at.x, b.at.x, c.at.x}),
                       std::min({a.at.y, b.at.y, c.at.y}), std::max({a.at.y, b.at.y, c.at.y}));
  for (int y = box.top; y <= box.bottom; ++y)
    for (int x = box.left; x <= box.right; ++x) {
      const double px = x + 0.5, py = y + 0.5;
      const double u = ((px - a.at.x) * (c.at.y - a.at.y) - (py - a.at.y) * (c.at.x - a.at.x)) / area;
      const double v = ((b.at.x - a.at.x) * (py - a.at.y) - (b.at.y - a.at.y) * (px - a.at.x)) / area;
      if (u < 0 || v < 0 || u + v > 1)
        continue;
      const auto z = float(a.at.z + u * (b.at.z - a.at.z) + v * (c.at.z - a.at.z));
      const std::size_t i = index(x, y);
      if (z >= depth_[i])
        continue;
      depth_[i] = z;
      colour_[i] = shade((1 - u - v) * a.normal + u * b.normal + v * c.normal, tint);
    }
}

void Canvas::rectangle(const Screen_point& upper_left, const Screen_point& lower_right, const Colour& colour) {
  const Box box = clip(upper_left.x, lower_right.x, upper_left.y, lower_right.y);
  const auto z = float(upper_left.z);
  for (int y = box.top; y <= box.bottom; ++y)
    for (int x = box.left; x <= box.right; ++x)
      if (const std::size_t i = index(x, y); z < depth_[i]) {
        depth_[i] = z;
        colour_[i] = colour;
      }
}

void Canvas::stroke(const Screen_point& a, const Screen_point& b, double radius, double bias, const Colour& colour) {
  const Box box = clip(std::min(a.x, b.x) - radius, std::max(a.x, b.x) + radius, std::min(a.y, b.y) - radius,
                       std::max(a.y, b.y) + radius);
  const double dx = b.x - a.x, dy = b.y - a.y, length2 = dx * dx + dy * dy;
  for (int y = box.top; y <= box.bottom; ++y)
    for (int x = box.left; x <= box.right; ++x) {
      const double px = x + 0.5 - a.x, py = y + 0.5 - a.y;
      const double t = length2 > 0 ? std::clamp((px * dx + py * dy) / length2, 0.0, 1.0) : 0;
      const double qx = px - t * dx, qy = py - t * dy;
      const auto z = float(a.z + t * (b.z - a.z) - bias);
      const std::size_t i = index(x, y);
      if (qx * qx + qy * qy > radius * radius || z >= depth_[i])
        continue;
      depth_[i] = z;
      colour_[i] = colour;
    }
}

void Canvas::dot(const Screen_point& centre, double radius, double rim, double bias, const Colour& colour) {
  const Box box = clip(centre.x - radius, centre.x + radius, centre.y - radius, centre.y + radius);
  const auto z = float(centre.z - bias);
  for (int y = box.top; y <= box.bottom; ++y)
    for (int x = box.left; x <= box.right; ++x) {
      const double distance = std::hypot(x + 0.5 - centre.x, y + 0.5 - centre.y);
      const std::size_t i = index(x, y);
      if (distance > radius || z >= depth_[i])
        continue;
      depth_[i] = z;
      colour_[i] = distance > radius - rim ? white : colour;
    }
}

void Canvas::resolve(std::span<std::uint8_t> pixels) const {
  constexpr int number = samples * samples;
  std::size_t out = 0;
  for (int y = first_; y < last_; ++y)
    for (int x = 0; x < width_; ++x) {
      std::array<int, 3> sum{};
      for (int j = 0; j < samples; ++j)
        for (int i = 0; i < samples; ++i)
          for (std::size_t k = 0; k < 3; ++k)
            sum[k] += colour_[index(x * samples + i, y * samples + j)][k];
      for (const int s : sum)
        pixels[out++] = std::uint8_t((s + number / 2) / number);
    }
}

} // namespace CGAL::Extremal_mesh_3
