// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Extremal_mesh_3/segment.h>

#include "../algorithms/patches.h"
#include "../cells/polygon_triangles.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

void require_cells_of(const Extremal_mesh& mesh, const Cell_patches& cells) {
  // Files that other programs wrote again have coordinates rounded to floats; another surface differs by more.
  constexpr double share = 1e-5;
  require_patches_of(mesh, cells);
  std::vector<double> area(mesh.number_of_cells(), 0);
  double whole = 0;
  std::vector<const Point*> corners;
  for (std::size_t i = 0; i < cells.cell.size(); ++i) {
    corners.clear();
    for (const std::uint32_t corner : polygon(cells, i))
      corners.push_back(&cells.points[corner]);
    if (corners.size() >= 3)
      area[cells.cell[i]] += triangles_of_polygon(corners).area;
  }
  for (const Extremal_mesh_cell& cell : mesh.cells())
    whole += cell.area;
  for (std::size_t c = 0; c < area.size(); ++c)
    if (!(std::abs(area[c] - mesh.cell(c).area) <= share * whole))
      throw std::invalid_argument(
          fmt::format("the surface is not that of the extremal mesh: cell {} has the area {:.6g} on "
                      "it, and {:.6g} in the mesh",
                      c, area[c], mesh.cell(c).area));
}

} // namespace CGAL::Extremal_mesh_3
