// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How do I get from a CT to a graph that NetworkX, igraph and Gephi read?
//
//   ct_to_graphml [IMAGE ISO [SIGMA]]       writes ct.graphml and ct.png where it is run

#include <CGAL/Extremal_mesh_3/Image_function.h>
#include <CGAL/Extremal_mesh_3/extract_extremal_mesh.h>
#include <CGAL/Extremal_mesh_3/io.h>
#include <CGAL/Extremal_mesh_3/render.h>

#include <exception>
#include <iostream>
#include <string>

using namespace CGAL::Extremal_mesh_3;

int main(int argc, char** argv) try {
  const Image image = read_image(argc > 1 ? argv[1] : EXTREMAL_MESH_3_DATA_DIR "/headsq.nii.gz");

  Image_function_options smoothing;
  smoothing.iso = argc > 2 ? std::stod(argv[2]) : 500;   // skin
  smoothing.sigma = argc > 3 ? std::stod(argv[3]) : 6.0; // mm
  const Image_function function(image, smoothing);

  Extraction_options options;
  options.patches = true; // for the picture
  const Extraction extraction = extract_extremal_mesh(function, function.lattice(), options);

  write_graphml("ct.graphml", extraction.mesh);
  render_png("ct.png", extraction.mesh, extraction.patches);
  std::cout << extraction.mesh.number_of_vertices() << " vertices and " << extraction.mesh.number_of_edges()
            << " edges in ct.graphml\n";
  return 0;
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
