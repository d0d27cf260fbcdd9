// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "polygon_triangles.h"

#include "../differential/vector.h"

#include <algorithm>

namespace CGAL::Extremal_mesh_3 {

namespace {

/// twice the area of a triangle seen against `normal`, negative if it is seen clockwise.
double turn(const Point& a, const Point& b, const Point& c, const Vector& normal) {
  return dot(cross(b - a, c - a), normal);
}

/// cuts off ears, those of the best shape first. Empty if there is none at some time.
std::vector<std::array<std::uint32_t, 3>> ears_of(std::span<const Point* const> corners, const Vector& normal) {
  std::vector<std::uint32_t> left(corners.size());
  for (std::uint32_t i = 0; i < left.size(); ++i)
    left[i] = i;
  std::vector<std::array<std::uint32_t, 3>> ears;
  const auto at = [&](std::size_t i) -> const Point& { return *corners[left[i]]; };
  while (left.size() > 3) {
    const std::size_t n = left.size();
    std::size_t best = n;
    double best_shape = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const Point &a = at((i + n - 1) % n), &b = at(i), &c = at((i + 1) % n);
      const double area = turn(a, b, c, normal),
                   shape = area / (dot(a - b, a - b) + dot(b - c, b - c) + dot(c - a, c - a));
      if (!(shape > best_shape))
        continue;
      bool empty = true;
      for (std::size_t k = 2; k + 1 < n && empty; ++k) {
        const Point& p = at((i + k) % n);
        empty = !(turn(a, b, p, normal) >= 0 && turn(b, c, p, normal) >= 0 && turn(c, a, p, normal) >= 0);
      }
      if (!empty)
        continue;
      best = i;
      best_shape = shape;
    }
    if (best == n)
      return {};
    ears.push_back({left[(best + n - 1) % n], left[best], left[(best + 1) % n]});
    left.erase(left.begin() + std::ptrdiff_t(best));
  }
  ears.push_back({left[0], left[1], left[2]});
  return ears;
}

} // namespace

Polygon_triangles triangles_of_polygon(std::span<const Point* const> corners) {
  const std::size_t n = corners.size();
  Polygon_triangles result;
  for (const Point* p : corners)
    result.middle = result.middle + (1 / double(n)) * *p;
  Vector normal{}; // as long as twice the area, seen from where it is greatest
  for (std::size_t i = 0; i < n; ++i)
    normal = normal + cross(*corners[i] - result.middle, *corners[(i + 1) % n] - result.middle);
  bool seen = true;
  for (std::size_t i = 0; i < n; ++i) {
    const Vector side = cross(*corners[i] - result.middle, *corners[(i + 1) % n] - result.middle);
    seen = seen && dot(side, normal) >= 0;
    result.area += norm(side) / 2;
  }
  if (seen || n <= 3)
    return result;
  result.ears = ears_of(corners, normal);
  if (result.ears.empty())
    return result;
  result.area = 0;
  for (const auto& [a, b, c] : result.ears)
    result.area += norm(cross(*corners[b] - *corners[a], *corners[c] - *corners[a])) / 2;
  return result;
}

} // namespace CGAL::Extremal_mesh_3
