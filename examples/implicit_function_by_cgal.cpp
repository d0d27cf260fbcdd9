// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How do I use CGAL's mesher for a surface f = 0, and does the extremal mesh depend on the mesher?

#include <CGAL/Extremal_mesh_3/Formula.h>
#include <CGAL/Extremal_mesh_3/check.h>
#include <CGAL/Extremal_mesh_3/extract_extremal_mesh.h>
#include <CGAL/Extremal_mesh_3/make_cgal_cells.h>

#include <iostream>

using namespace CGAL::Extremal_mesh_3;

int main() {
  const Formula potato("x^2+1.3*y^2+1.7*z^2+0.2*x^3+0.15*y^3-0.4*x*y*z+0.2*x^2*z+0.1*x*y^2-1");
  const Lattice lattice = make_lattice({-1.4, -1.4, -1.4}, {1.4, 1.4, 1.4}, 32);

  Cgal_mesh_options options;
  options.radius = 0.1;     // triangles in circles of at most that radius,
  options.distance = 0.005; // and smaller where the surface bends more
  const Cell_complex triangles = make_cgal_cells(potato, lattice, options);
  const Cell_complex polygons = make_implicit_cells(potato, lattice);

  // The cells only tell where to look: every vertex and line is found on the function itself.
  for (const Cell_complex* cells : {&triangles, &polygons}) {
    const Extremal_mesh mesh = extract_extremal_mesh(potato, *cells).mesh;
    std::cout << cells->number_of_cells() << " initial cells: " << mesh.number_of_vertices() << " vertices, "
              << mesh.number_of_edges() << " edges, " << mesh.number_of_cells() << " cells\n";
    if (!all_hold(check(mesh)))
      return 1;
  }
  return 0;
}
