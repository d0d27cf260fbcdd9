// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Text_file.h"

#include <CGAL/Extremal_mesh_3/interchange.h>
#include <CGAL/Extremal_mesh_3/measures.h>

namespace CGAL::Extremal_mesh_3 {

void write_vertices_csv(const std::string& file, const Extremal_mesh& mesh) {
  Text_file out(file);
  out << "vertex,kind,x,y,z,nx,ny,nz,t1x,t1y,t1z,t2x,t2y,t2z,k_max,k_min,index,field_index,umbilic_type,ridges,degree,"
         "strength\n";
  for (std::uint32_t v = 0; v < mesh.number_of_vertices(); ++v) {
    const Extremal_mesh_vertex& vertex = mesh.vertex(v);
    out.print(FMT_COMPILE("{},{}"), v, to_string(vertex.kind));
    for (const Vector* vector : {&vertex.point, &vertex.normal, &vertex.t1, &vertex.t2})
      out.print(FMT_COMPILE(",{},{},{}"), (*vector)[0], (*vector)[1], (*vector)[2]);
    out.print(FMT_COMPILE(",{},{},{},{},{},{},{},{}\n"), vertex.k1, vertex.k2, vertex.umbilic_index, vertex.field_index,
              to_string(vertex.umbilic_type), vertex.ridges, vertex.star.size(), vertex_measures(mesh, v).strength);
  }
  out.commit();
}

void write_edges_csv(const std::string& file, const Extremal_mesh& mesh) {
  Text_file out(file);
  out << "edge,source,target,family,type,length,strength,sharpness,mean_curvature,extreme_curvature,stability,left_"
         "cell,"
         "right_cell,points\n";
  for (std::uint32_t e = 0; e < mesh.number_of_edges(); ++e) {
    const Extremal_mesh_edge& edge = mesh.edge(e);
    const Line_measures measures = edge_measures(mesh, e);
    out.print(FMT_COMPILE("{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n"), e, edge.source, edge.target, edge.family,
              to_string(edge.type), edge.length, edge.strength, edge.sharpness, measures.mean_curvature,
              measures.extreme_curvature, measures.stability, edge.left_cell, edge.right_cell, edge.polyline.size());
  }
  out.commit();
}

void write_cells_csv(const std::string& file, const Extremal_mesh& mesh) {
  Text_file out(file);
  out << "cell,sign,area,weight,perimeter,sides,euler_characteristic,touches_border\n";
  for (std::uint32_t c = 0; c < mesh.number_of_cells(); ++c) {
    const Extremal_mesh_cell& cell = mesh.cell(c);
    const Cell_measures measures = cell_measures(mesh, c);
    out.print(FMT_COMPILE("{},{},{},{},{},{},{},{}\n"), c, cell.sign, cell.area, cell.weight, measures.perimeter,
              measures.sides, cell.euler_characteristic, int(cell.touches_border));
  }
  out.commit();
}

} // namespace CGAL::Extremal_mesh_3
