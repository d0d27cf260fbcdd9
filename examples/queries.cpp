// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which crest lines matter most, what is around a point, and which way leads from one vertex to another?

#include <CGAL/Extremal_mesh_3/Formula.h>
#include <CGAL/Extremal_mesh_3/Line_locator.h>
#include <CGAL/Extremal_mesh_3/cell_queries.h>
#include <CGAL/Extremal_mesh_3/extract_extremal_mesh.h>
#include <CGAL/Extremal_mesh_3/measures.h>
#include <CGAL/Extremal_mesh_3/paths.h>
#include <CGAL/Extremal_mesh_3/select.h>

#include <iostream>

using namespace CGAL::Extremal_mesh_3;

int main() {
  const Formula potato("x^2+1.3*y^2+1.7*z^2+0.2*x^3+0.15*y^3-0.4*x*y*z+0.2*x^2*z+0.1*x*y^2-1");
  const Lattice lattice = make_lattice({-1.4, -1.4, -1.4}, {1.4, 1.4, 1.4}, 32);
  const Extremal_mesh mesh = extract_extremal_mesh(potato, lattice).mesh;

  for (const Extremal_line& line : strongest_crest_lines(mesh, 3)) {
    const Line_measures m = line_measures(mesh, line);
    std::cout << "a crest line of " << line.half_edges.size() << " edges, strength " << m.strength << ", stability "
              << m.stability << '\n';
  }

  const Line_locator locator(mesh);
  const Point p = {0.5, 0.4, 0.5};
  if (const auto cell = locator.cell_at(p))
    for (const auto& walk : cell_sides(mesh, *cell))
      for (const Cell_side& side : walk)
        std::cout << "beside a " << to_string(side.type) << " line lies cell " << side.neighbour << '\n';

  const auto umbilics = vertices_of_kind(mesh, Vertex_kind::umbilic);
  const auto path = shortest_path(mesh, umbilics.front(), umbilics.back());
  if (!path)
    return 1;
  std::cout << path->half_edges.size() << " edges, " << path->length << " long, lead from one umbilic to another\n";
  return 0;
}
