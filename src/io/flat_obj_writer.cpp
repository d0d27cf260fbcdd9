// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Text_file.h"

#include <CGAL/Extremal_mesh_3/flatten.h>

#include <map>

namespace CGAL::Extremal_mesh_3 {

void write_flat_obj(const std::string& file, const Flattening& flattening) {
  const Cell_patches& faces = flattening.faces;
  Text_file out(file);
  out << "# the cells of an extremal mesh, each in the plane of its texture coordinates\n";
  // points that cells share come once
  std::map<Point, std::size_t> number;
  std::vector<std::size_t> of_point;
  for (const Point& p : faces.points) {
    const auto [found, is_new] = number.try_emplace(p, number.size() + 1);
    of_point.push_back(found->second);
    if (is_new)
      out.print(FMT_COMPILE("v {} {} {}\n"), p[0], p[1], p[2]);
  }
  std::size_t places = 0;
  for (std::size_t c = 0; c < flattening.cells.size(); ++c) {
    const Flat_cell& cell = flattening.cells[c];
    out.print(FMT_COMPILE("g cell_{}\n"), c);
    std::map<std::array<double, 2>, std::size_t> place;
    for (std::size_t t = cell.first_triangle; t < cell.first_triangle + cell.triangles; ++t) {
      std::array<std::size_t, 3> vt{};
      for (std::size_t i = 0; i < 3 && cell.outcome == Flattening_outcome::flat; ++i) {
        const auto& uv = flattening.places[t][i];
        const auto [found, is_new] = place.try_emplace(uv, places + 1);
        if (is_new) {
          ++places;
          out.print(FMT_COMPILE("vt {} {}\n"), uv[0], uv[1]);
        }
        vt[i] = found->second;
      }
      const auto v = [&](std::size_t i) { return of_point[faces.corners[3 * t + i]]; };
      if (cell.outcome == Flattening_outcome::flat)
        out.print(FMT_COMPILE("f {}/{} {}/{} {}/{}\n"), v(0), vt[0], v(1), vt[1], v(2), vt[2]);
      else
        out.print(FMT_COMPILE("f {} {} {}\n"), v(0), v(1), v(2));
    }
  }
  out.commit();
}

} // namespace CGAL::Extremal_mesh_3
