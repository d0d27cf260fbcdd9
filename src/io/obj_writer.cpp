// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lines as Wavefront OBJ, which ParaView, Blender and MeshLab read.
#include "Line_points.h"
#include "Text_file.h"

#include <CGAL/Extremal_mesh_3/interchange.h>

namespace CGAL::Extremal_mesh_3 {

void write_obj(const std::string& file, const Extremal_mesh& mesh) {
  const Line_points lines(mesh);
  Text_file out(file);
  out << "# the lines of an extremal mesh\n";
  for (const Point& p : lines.points)
    out.print(FMT_COMPILE("v {} {} {}\n"), p[0], p[1], p[2]);
  for (const Line_type type :
       {Line_type::max_largest, Line_type::min_largest, Line_type::max_second, Line_type::min_second}) {
    out.print(FMT_COMPILE("g {}\n"), to_string(type));
    for (std::size_t e = 0; e < mesh.number_of_edges(); ++e)
      if (mesh.edge(e).type == type) {
        out << "l";
        for (const std::uint32_t i : lines.edges[e])
          out.print(FMT_COMPILE(" {}"), i + 1);
        out << "\n";
      }
  }
  out.commit();
}

} // namespace CGAL::Extremal_mesh_3
