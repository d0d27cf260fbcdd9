// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How do I get the cells of an extremal mesh as surfaces?
//
// Writes cells.ply, where it is run, with a colour for each cell.

#include <CGAL/Extremal_mesh_3/Formula.h>
#include <CGAL/Extremal_mesh_3/cell_surface.h>
#include <CGAL/Extremal_mesh_3/io.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <iostream>

using namespace CGAL::Extremal_mesh_3;
using Surface = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

int main() {
  const Formula ellipsoid("x^2/9 + y^2/4 + z^2 = 1");
  Extraction_options options;
  options.patches = true; // the surface cut along the lines
  const Extraction extraction = extract_extremal_mesh(ellipsoid, make_lattice({-4, -3, -2}, {4, 3, 2}, 48), options);
  write_ply("cells.ply", extraction.patches, extraction.mesh, Cell_colouring::cell);

  // All cells in one mesh of polygons: an edge between faces of different cells is a piece of a line.
  Surface surface;
  make_cell_surface(extraction.patches, surface);
  const auto cell = surface.property_map<Surface::Face_index, std::uint32_t>("f:cell").first;
  std::size_t on_lines = 0;
  for (const auto e : surface.edges())
    on_lines += cell[surface.face(surface.halfedge(e))] != cell[surface.face(surface.opposite(surface.halfedge(e)))];
  std::cout << surface.number_of_faces() << " faces, " << on_lines << " edges on lines, "
            << (CGAL::is_closed(surface) ? "closed" : "not closed") << '\n';

  // One cell as triangles.
  for (std::uint32_t c = 0; c < extraction.mesh.number_of_cells(); ++c) {
    Surface octant;
    make_cell_surface(triangulate(patches_of_cell(extraction.patches, c)), octant);
    std::cout << "cell " << c << ": area " << CGAL::Polygon_mesh_processing::area(octant) << '\n';
  }
}
