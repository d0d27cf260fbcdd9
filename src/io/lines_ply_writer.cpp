// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lines as PLY with edges. As text: it is for programs that know edges, and for eyes.
#include "Line_points.h"
#include "Text_file.h"
#include "colours.h"

#include <CGAL/Extremal_mesh_3/interchange.h>

namespace CGAL::Extremal_mesh_3 {

void write_lines_ply(const std::string& file, const Extremal_mesh& mesh) {
  const Line_points lines(mesh);
  std::size_t segments = 0;
  for (const auto& edge : lines.edges)
    segments += edge.size() - 1;
  Text_file out(file);
  out << "ply\nformat ascii 1.0\ncomment the lines of an extremal mesh\n";
  out << "comment types: 0 max_largest, 1 min_largest, 2 max_second, 3 min_second\n";
  out.print(FMT_COMPILE("element vertex {}\n"), lines.points.size());
  for (const std::string_view name : {"x", "y", "z", "nx", "ny", "nz", "k_max", "k_min"})
    out << "property double " << name << "\n";
  out.print(FMT_COMPILE("element edge {}\nproperty int vertex1\nproperty int vertex2\n"), segments);
  for (const std::string_view name : {"red", "green", "blue", "type", "family"})
    out << "property uchar " << name << "\n";
  out << "property int edge\nend_header\n";
  for (std::size_t i = 0; i < lines.points.size(); ++i) {
    const Point& p = lines.points[i];
    const Vector& n = lines.normals[i];
    out.print(FMT_COMPILE("{} {} {} {} {} {} {} {}\n"), p[0], p[1], p[2], n[0], n[1], n[2], lines.k1[i], lines.k2[i]);
  }
  for (std::size_t e = 0; e < mesh.number_of_edges(); ++e)
    for (std::size_t i = 0; i + 1 < lines.edges[e].size(); ++i) {
      const Line_type type = mesh.edge(e).segment_types[i];
      const Colour c = line_colour(type);
      out.print(FMT_COMPILE("{} {} {} {} {} {} {} {}\n"), lines.edges[e][i], lines.edges[e][i + 1], c[0], c[1], c[2],
                static_cast<int>(type), mesh.edge(e).family, e);
    }
  out.commit();
}

} // namespace CGAL::Extremal_mesh_3
