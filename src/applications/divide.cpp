// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "divide.h"

#include "../algorithms/patches.h"
#include "../cells/polygon_triangles.h"
#include "../differential/vector.h"

#include <algorithm>
#include <map>
#include <optional>

namespace CGAL::Extremal_mesh_3 {

namespace {

using Ends = std::array<std::uint32_t, 2>;

Ends ends(std::uint32_t a, std::uint32_t b) {
  return {std::min(a, b), std::max(a, b)};
}

std::uint32_t add_middle(Cell_patches& patches, std::uint32_t a, std::uint32_t b) {
  patches.points.push_back(0.5 * (patches.points[a] + patches.points[b]));
  const Vector sum = patches.normals[a] + patches.normals[b];
  patches.normals.push_back(norm(sum) > 0 ? normalized(sum) : patches.normals[a]);
  return std::uint32_t(patches.points.size() - 1);
}

/// The middles of edges that are divided, one for each.
class Middles {
public:
  explicit Middles(Cell_patches& patches) : patches_(patches) {}
  std::uint32_t of(std::uint32_t a, std::uint32_t b) {
    const auto [found, is_new] = number_.try_emplace(ends(a, b), 0U);
    if (is_new)
      found->second = add_middle(patches_, a, b);
    return found->second;
  }

private:
  Cell_patches& patches_;
  std::map<Ends, std::uint32_t> number_;
};

void add_triangle(Cell_patches& patches, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t cell) {
  patches.corners.insert(patches.corners.end(), {a, b, c});
  patches.begin.push_back(patches.corners.size());
  patches.cell.push_back(cell);
}

/// adds a triangle whose sides may have middles: all of it seen from one of them, so that no part is without area.
template <class Middle>
void add_divided(Cell_patches& patches, const std::array<std::uint32_t, 3>& triangle, std::uint32_t cell,
                 Middle&& middle_of) {
  std::vector<std::uint32_t> around;
  std::size_t first = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    around.push_back(triangle[i]);
    if (const auto middle = middle_of(triangle[i], triangle[(i + 1) % 3])) {
      first = first == 0 ? around.size() : first;
      around.push_back(*middle);
    }
  }
  for (std::size_t i = 1; i + 1 < around.size(); ++i)
    add_triangle(patches, around[first], around[(first + i) % around.size()], around[(first + i + 1) % around.size()],
                 cell);
}

} // namespace

Cell_patches divide_into_triangles(const Cell_patches& manifold) {
  std::vector<Polygon_triangles> covers(manifold.cell.size());
  std::map<Ends, int> uses; // by sides of polygons, and by diagonals
  std::vector<const Point*> points;
  for (std::size_t i = 0; i < manifold.cell.size(); ++i) {
    const auto corners = polygon(manifold, i);
    const std::size_t n = corners.size();
    points.clear();
    for (std::size_t j = 0; j < n; ++j) {
      points.push_back(&manifold.points[corners[j]]);
      ++uses[ends(corners[j], corners[(j + 1) % n])];
    }
    covers[i] = triangles_of_polygon(points);
    for (const auto& ear : covers[i].ears)
      for (std::size_t k = 0; k < 3; ++k)
        if (const std::uint32_t a = ear[k], b = ear[(k + 1) % 3]; (a + 1) % n != b)
          ++uses[ends(corners[a], corners[b])];
  }

  Cell_patches result;
  result.points = manifold.points;
  result.normals = manifold.normals;
  for (std::size_t i = 0; i < manifold.cell.size(); ++i) {
    const auto corners = polygon(manifold, i);
    const std::size_t n = corners.size();
    const std::uint32_t cell = manifold.cell[i];
    if (n == 3) {
      add_triangle(result, corners[0], corners[1], corners[2], cell);
      continue;
    }
    if (covers[i].ears.empty()) {
      const auto middle = std::uint32_t(result.points.size());
      Vector normal{};
      for (const std::uint32_t corner : corners)
        normal = normal + manifold.normals[corner];
      result.points.push_back(covers[i].middle);
      result.normals.push_back(norm(normal) > 0 ? normalized(normal) : manifold.normals[corners[0]]);
      for (std::size_t j = 0; j < n; ++j)
        add_triangle(result, middle, corners[j], corners[(j + 1) % n], cell);
      continue;
    }
    Middles middles(result);
    for (const auto& ear : covers[i].ears)
      add_divided(result, {corners[ear[0]], corners[ear[1]], corners[ear[2]]}, cell,
                  [&, k = std::size_t(0)](std::uint32_t a, std::uint32_t b) mutable -> std::optional<std::uint32_t> {
                    const std::uint32_t from = ear[k % 3], to = ear[(k + 1) % 3];
                    ++k;
                    if ((from + 1) % n == to || uses[ends(a, b)] <= 2)
                      return std::nullopt;
                    return middles.of(a, b);
                  });
  }
  return result;
}

Cell_patches divide_edges(const Cell_patches& triangles,
                          const std::function<bool(std::uint32_t, std::uint32_t)>& choose) {
  Cell_patches result;
  result.points = triangles.points;
  result.normals = triangles.normals;
  Middles middles(result);
  for (std::size_t i = 0; i < triangles.cell.size(); ++i) {
    const auto corners = polygon(triangles, i);
    add_divided(result, {corners[0], corners[1], corners[2]}, triangles.cell[i],
                [&](std::uint32_t a, std::uint32_t b) -> std::optional<std::uint32_t> {
                  if (!choose(a, b))
                    return std::nullopt;
                  return middles.of(a, b);
                });
  }
  return result;
}

Triangles triangles_of(const Cell_patches& patches) {
  Triangles triangles;
  triangles.points = patches.points;
  for (std::size_t i = 0; i < patches.cell.size(); ++i) {
    const auto corners = polygon(patches, i);
    triangles.corners.push_back({corners[0], corners[1], corners[2]});
  }
  return triangles;
}

} // namespace CGAL::Extremal_mesh_3
