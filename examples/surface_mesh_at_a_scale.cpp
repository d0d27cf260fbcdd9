// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How do I look for the features of a CGAL::Surface_mesh that have a given size?
//
//   surface_mesh_at_a_scale [MESH.off RADIUS]     writes femur.graphml, femur_cells.off and femur_lines.off where it is run

#include <CGAL/Extremal_mesh_3/face_graph.h>
#include <CGAL/Extremal_mesh_3/io.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <exception>
#include <fstream>
#include <iostream>
#include <string>

using namespace CGAL::Extremal_mesh_3;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

int main(int argc, char** argv) try {
  const std::string file = argc > 1 ? argv[1] : EXTREMAL_MESH_3_DATA_DIR "/femur.off";
  const double radius = argc > 2 ? std::stod(argv[2]) : 0.15; // of the neighbourhoods, in the mesh's unit of length
  Mesh mesh;
  if (!(std::ifstream(file) >> mesh))
    throw Io_error(file + " cannot be read");

  Extraction_options options;
  options.patches = true; // the surface cut along the lines
  const Extraction extraction = extract_extremal_mesh(mesh, parameters::radius(radius).extraction_options(options));

  write_graphml("femur.graphml", extraction.mesh);
  write_off("femur_cells.off", extraction.patches, extraction.mesh);
  write_lines_off("femur_lines.off", extraction.mesh);
  std::cout << extraction.mesh.number_of_edges() << " lines between " << extraction.mesh.number_of_vertices()
            << " vertices, around " << extraction.mesh.number_of_cells() << " cells\n";
  return 0;
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
