// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A user's program: it calls each part of the library that links to another one (TBB, fmt, libpng, ITK, GMP).

#include <CGAL/Extremal_mesh_3/Formula.h>
#include <CGAL/Extremal_mesh_3/Image.h>
#include <CGAL/Extremal_mesh_3/check.h>
#include <CGAL/Extremal_mesh_3/extract_extremal_mesh.h>
#include <CGAL/Extremal_mesh_3/io.h>
#include <CGAL/Extremal_mesh_3/read_mesh.h>
#include <CGAL/Extremal_mesh_3/render.h>

#include <iostream>

using namespace CGAL::Extremal_mesh_3;

int main() {
  Extraction_options options;
  options.patches = true;
  const Formula ellipsoid("x^2/9 + y^2/4 + z^2 = 1");
  const Extraction extraction = extract_extremal_mesh(ellipsoid, make_lattice({-4, -3, -2}, {4, 3, 2}, 24), options);
  render_png("consumer.png", extraction.mesh, extraction.patches);
  write_graphml("consumer.graphml", extraction.mesh);
  const Extremal_mesh mesh = read_graphml("consumer.graphml");
  write_off("consumer.off", extraction.mesh);
  const bool is_sphere = read_mesh("consumer.off").cells.euler_characteristic() == 2;
  bool image_was_refused = false;
  try {
    read_image("consumer.graphml");
  } catch (const Io_error&) {
    image_was_refused = true;
  }
  std::cout << mesh.number_of_vertices() << " vertices, " << mesh.number_of_edges() << " edges, "
            << mesh.number_of_cells() << " cells\n";
  const bool right = mesh.number_of_vertices() == 10 && mesh.number_of_edges() == 16 && mesh.number_of_cells() == 8;
  return right && all_hold(check(mesh)) && is_sphere && image_was_refused ? 0 : 1;
}
