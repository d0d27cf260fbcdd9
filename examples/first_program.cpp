// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What does a first program of one's own look like, from a mesh to its ridges and cells? (doc/tutorial_program.md)
//
//   first_program [MESH.off]       writes ridges.graphml and cells.ply where it is run

#include <CGAL/Extremal_mesh_3/face_graph.h>
#include <CGAL/Extremal_mesh_3/io.h>
#include <CGAL/Extremal_mesh_3/lines.h>
#include <CGAL/Extremal_mesh_3/measures.h>
#include <CGAL/Extremal_mesh_3/simplify.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <exception>
#include <fstream>
#include <iostream>
#include <string>

using namespace CGAL::Extremal_mesh_3;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

int main(int argc, char** argv) try {
  Mesh mesh;
  const std::string file = argc > 1 ? argv[1] : EXTREMAL_MESH_3_DATA_DIR "/ellipe0.003.off";
  if (!(std::ifstream(file) >> mesh))
    throw Io_error(file + " cannot be read");

  // the surface cut along its lines, and a bar of progress
  Extraction_options options;
  options.patches = true;
  options.progress = [](double share) {
    std::cerr << '\r' << int(100 * share) << " %";
    return true; // false would stop the work
  };
  const Extraction extraction = extract_extremal_mesh(mesh, parameters::radius(0.25).extraction_options(options));
  std::cerr << '\n' << extraction.report.uncertain_cells << " uncertain cells\n";

  // what noise has made goes, what is left are lines of the shape
  const Simplification simplification(extraction.mesh);
  const std::size_t level = simplification.level_at_gap();
  const Extremal_mesh simple = simplification.mesh_at(level);

  for (const Extremal_line& crest : strongest_crest_lines(simple, 2)) {
    const Line_measures measures = line_measures(simple, crest);
    std::cout << "a crest line " << measures.length << " long, of strength " << measures.strength << ", with "
              << polyline(simple, crest.half_edges).size() << " points\n";
  }

  for (std::size_t c = 0; c < simple.number_of_cells(); ++c) {
    const Extremal_mesh_cell& cell = simple.cell(c);
    std::cout << "a cell with E_g " << (cell.sign > 0 ? "> 0" : "< 0") << ", area " << cell.area << ", between";
    for (const auto& walk : cell.boundary)
      for (const Half_edge h : walk)
        std::cout << ' ' << to_string(simple.edge(h / 2).type);
    std::cout << '\n';
  }

  write_graphml("ridges.graphml", simple);
  write_ply("cells.ply", simplification.patches_at(level, extraction.patches), simple);
  return 0;
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
