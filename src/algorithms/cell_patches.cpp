// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Extremal_mesh_3/cell_patches.h>

#include "../cells/polygon_triangles.h"
#include "../differential/vector.h"
#include "patches.h"

#include <fmt/format.h>

#include <array>
#include <limits>
#include <stdexcept>

namespace CGAL::Extremal_mesh_3 {

void require_consistent(const Cell_patches& patches) {
  const std::size_t n = patches.cell.size();
  bool good = patches.normals.size() == patches.points.size() && patches.begin.size() == n + 1 &&
              patches.begin.front() == 0 && patches.begin.back() == patches.corners.size();
  for (std::size_t i = 0; good && i < n; ++i)
    good = patches.begin[i] <= patches.begin[i + 1];
  if (!good)
    throw std::invalid_argument("the arrays of the patches do not fit together");
  for (const std::uint32_t c : patches.corners)
    if (c >= patches.points.size())
      throw std::invalid_argument(
          fmt::format("a patch has the corner {}, but there are only {} points", c, patches.points.size()));
}

void require_patches_of(const Extremal_mesh& mesh, const Cell_patches& patches) {
  require_consistent(patches);
  for (const std::uint32_t c : patches.cell)
    if (c >= mesh.number_of_cells())
      throw std::invalid_argument(
          fmt::format("a patch is in cell {}, but the extremal mesh has only {}; are they of the same one?", c,
                      mesh.number_of_cells()));
}

Cell_patches patches_of_cell(const Cell_patches& patches, std::uint32_t cell) {
  require_consistent(patches);
  constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> index(patches.points.size(), none);
  Cell_patches result;
  for (std::size_t i = 0; i < patches.cell.size(); ++i) {
    if (patches.cell[i] != cell)
      continue;
    for (const std::uint32_t corner : polygon(patches, i)) {
      if (index[corner] == none) {
        index[corner] = std::uint32_t(result.points.size());
        result.points.push_back(patches.points[corner]);
        result.normals.push_back(patches.normals[corner]);
      }
      result.corners.push_back(index[corner]);
    }
    result.begin.push_back(result.corners.size());
    result.cell.push_back(cell);
  }
  if (result.cell.empty())
    throw std::invalid_argument(fmt::format("there is no patch of cell {}", cell));
  return result;
}

Cell_patches triangulate(const Cell_patches& patches) {
  require_consistent(patches);
  Cell_patches result;
  result.points = patches.points;
  result.normals = patches.normals;
  const auto add = [&](std::span<const std::uint32_t> corners, std::uint32_t cell) {
    result.corners.insert(result.corners.end(), corners.begin(), corners.end());
    result.begin.push_back(result.corners.size());
    result.cell.push_back(cell);
  };
  std::vector<const Point*> points;
  for (std::size_t i = 0; i < patches.cell.size(); ++i) {
    const auto corners = polygon(patches, i);
    if (corners.size() <= 3) {
      add(corners, patches.cell[i]);
      continue;
    }
    points.clear();
    Vector normal{};
    for (const std::uint32_t corner : corners) {
      points.push_back(&patches.points[corner]);
      normal = normal + patches.normals[corner];
    }
    const Polygon_triangles triangles = triangles_of_polygon(points);
    for (const auto& [a, b, c] : triangles.ears)
      add(std::array{corners[a], corners[b], corners[c]}, patches.cell[i]);
    if (!triangles.ears.empty())
      continue;
    const auto centre = std::uint32_t(result.points.size());
    result.points.push_back(triangles.middle);
    // opposite normals, as on a sheet thinner than its cells, have no mean
    result.normals.push_back(norm(normal) > 0 ? normalized(normal) : patches.normals[corners[0]]);
    for (std::size_t j = 0; j < corners.size(); ++j)
      add(std::array{centre, corners[j], corners[(j + 1) % corners.size()]}, patches.cell[i]);
  }
  return result;
}

} // namespace CGAL::Extremal_mesh_3
