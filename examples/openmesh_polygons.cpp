// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How do I extract the extremal mesh of an OpenMesh, and how well is its shape known?
//
//   openmesh_polygons [MESH]

#include <CGAL/Extremal_mesh_3/check.h>
#include <CGAL/Extremal_mesh_3/face_graph.h>

#include <CGAL/boost/graph/graph_traits_PolyMesh_ArrayKernelT.h>

#include <algorithm>
#include <exception>
#include <iostream>
#include <iterator>
#include <vector>

using namespace CGAL::Extremal_mesh_3;
using Mesh = OpenMesh::PolyMesh_ArrayKernelT<OpenMesh::DefaultTraitsDouble>; // floats would be noise

int main(int argc, char** argv) try {
  const char* file = argc > 1 ? argv[1] : EXTREMAL_MESH_3_DATA_DIR "/ellipsoid_exact_poly.off";
  Mesh mesh;
  if (!OpenMesh::IO::read_mesh(mesh, file))
    throw Io_error(std::string(file) + " cannot be read");

  Fit fit;                                // the shape at each vertex, and how good it is
  std::vector<Mesh::VertexHandle> vertex; // of each of them
  const Extraction extraction =
      extract_extremal_mesh(mesh, parameters::fit_output(fit).vertex_output_iterator(std::back_inserter(vertex)));

  std::cout << mesh.n_faces() << " faces: " << extraction.mesh.number_of_vertices() << " vertices, "
            << extraction.mesh.number_of_edges() << " edges, " << extraction.mesh.number_of_cells() << " cells\n"
            << "jets fitted within " << fit.report.radius_median << ", in the mesh's unit of length\n";
  const auto& quality = fit.shapes.quality;
  const auto worst = std::max_element(quality.begin(), quality.end(),
                                      [](const auto& a, const auto& b) { return a.residual < b.residual; });
  const auto v = vertex[std::size_t(worst - quality.begin())];
  std::cout << "worst fit: " << worst->residual << " off the vertices around (" << mesh.point(v) << ")\n";
  return all_hold(check(extraction.mesh)) ? 0 : 1;
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
