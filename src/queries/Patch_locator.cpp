// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The nearest point of a triangle: Ericson, Real-Time Collision Detection, 2005, section 5.1.5.
#include <CGAL/Extremal_mesh_3/Patch_locator.h>

#include "../cells/polygon_triangles.h"
#include "../cgal/Box_tree.h"
#include "../differential/vector.h"
#include "require.h"

#include <algorithm>
#include <array>
#include <tuple>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

namespace {

/// A triangle of a polygon.
struct Triangle {
  std::array<Point, 3> corners;
  std::uint32_t polygon = 0;
};

/// the point a + s·ab for s from 0 to 1 that is nearest where `along` of `length2` is its share.
Point on_segment(const Point& a, const Vector& ab, double along, double length2) {
  return length2 > 0 ? a + std::clamp(along / length2, 0.0, 1.0) * ab : a;
}

Point nearest_point(const Triangle& triangle, const Point& p) {
  const auto& [a, b, c] = triangle.corners;
  const Vector ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
  const double d1 = dot(ab, ap), d2 = dot(ac, ap), d3 = dot(ab, bp), d4 = dot(ac, bp), d5 = dot(ab, cp),
               d6 = dot(ac, cp);
  if (d1 <= 0 && d2 <= 0)
    return a;
  if (d3 >= 0 && d4 <= d3)
    return b;
  if (d6 >= 0 && d5 <= d6)
    return c;
  const double of_c = d1 * d4 - d3 * d2, of_b = d5 * d2 - d1 * d6, of_a = d3 * d6 - d5 * d4;
  if (of_c <= 0 && d1 >= 0 && d3 <= 0)
    return on_segment(a, ab, d1, d1 - d3);
  if (of_b <= 0 && d2 >= 0 && d6 <= 0)
    return on_segment(a, ac, d2, d2 - d6);
  if (of_a <= 0 && d4 >= d3 && d5 >= d6)
    return on_segment(b, c - b, d4 - d3, (d4 - d3) + (d5 - d6));
  const double sum = of_a + of_b + of_c;
  return sum > 0 ? a + (of_b / sum) * ab + (of_c / sum) * ac : a;
}

void validate(const Cell_patches& patches) {
  const std::size_t polygons = patches.cell.size();
  if (patches.begin.size() != polygons + 1 || patches.begin.front() != 0 ||
      patches.begin.back() != patches.corners.size())
    throw std::invalid_argument(fmt::format("the patches have {} cells, {} starts of polygons and {} corners", polygons,
                                            patches.begin.size(), patches.corners.size()));
  for (std::size_t i = 0; i < polygons; ++i)
    if (patches.begin[i + 1] < patches.begin[i] + 3 || patches.begin[i + 1] > patches.corners.size())
      throw std::invalid_argument(fmt::format("polygon {} of the patches has less than 3 corners", i));
  for (const std::uint32_t corner : patches.corners)
    if (corner >= patches.points.size())
      throw std::invalid_argument(
          fmt::format("a polygon of the patches has corner {} of {} points", corner, patches.points.size()));
  for (const Point& p : patches.points)
    require_finite(p);
}

std::vector<Triangle> triangles_of(const Cell_patches& patches) {
  std::vector<Triangle> triangles;
  std::vector<const Point*> corners;
  for (std::uint32_t i = 0; i < patches.cell.size(); ++i) {
    const std::size_t first = patches.begin[i], n = patches.begin[i + 1] - first;
    const auto corner = [&](std::size_t k) -> const Point& { return patches.points[patches.corners[first + k % n]]; };
    if (n == 3) {
      triangles.push_back({{corner(0), corner(1), corner(2)}, i});
      continue;
    }
    corners.clear();
    for (std::size_t k = 0; k < n; ++k)
      corners.push_back(&corner(k));
    const Polygon_triangles cover = triangles_of_polygon(corners);
    for (const auto& [a, b, c] : cover.ears)
      triangles.push_back({{corner(a), corner(b), corner(c)}, i});
    if (cover.ears.empty())
      for (std::size_t k = 0; k < n; ++k)
        triangles.push_back({{cover.middle, corner(k), corner(k + 1)}, i});
  }
  require_number(triangles.size());
  return triangles;
}

std::vector<Bounding_box> boxes_of(const std::vector<Triangle>& triangles) {
  std::vector<Bounding_box> boxes;
  for (const Triangle& triangle : triangles) {
    const auto& [a, b, c] = triangle.corners;
    Bounding_box& box = boxes.emplace_back();
    for (std::size_t i = 0; i < 3; ++i)
      std::tie(box.low[i], box.high[i]) = std::minmax({a[i], b[i], c[i]});
  }
  return boxes;
}

} // namespace

struct Patch_locator::Data {
  explicit Data(const Cell_patches& patches)
      : triangles(triangles_of(patches)), cell(patches.cell), tree(boxes_of(triangles)) {}

  std::vector<Triangle> triangles;
  std::vector<std::uint32_t> cell;
  Box_tree tree;
};

Patch_locator::Patch_locator(const Cell_patches& patches) {
  validate(patches);
  data_ = std::make_unique<Data>(patches);
}
Patch_locator::~Patch_locator() = default;
Patch_locator::Patch_locator(Patch_locator&&) noexcept = default;
Patch_locator& Patch_locator::operator=(Patch_locator&&) noexcept = default;

std::optional<Patch_point> Patch_locator::nearest(const Point& p) const {
  require_finite(p);
  std::optional<Patch_point> nearest;
  data_->tree.visit_near(p, [&](std::uint32_t t) {
    const Triangle& triangle = data_->triangles[t];
    const Point q = nearest_point(triangle, p);
    const double here = distance(p, q);
    if (!nearest || std::tuple(here, triangle.polygon) < std::tuple(nearest->distance, nearest->polygon))
      nearest = Patch_point{data_->cell[triangle.polygon], triangle.polygon, q, here};
    return nearest->distance * nearest->distance * (1 + 1e-12); // as the tree's own distances are rounded, too
  });
  return nearest;
}

} // namespace CGAL::Extremal_mesh_3
