// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How do I tell what noise has done to an extremal mesh from what there is?
//
// Writes persistence.svg where it is run.

#include <CGAL/Extremal_mesh_3/Formula.h>
#include <CGAL/Extremal_mesh_3/check.h>
#include <CGAL/Extremal_mesh_3/extract_extremal_mesh.h>
#include <CGAL/Extremal_mesh_3/persistence_diagram.h>
#include <CGAL/Extremal_mesh_3/simplify.h>

#include <iostream>

using namespace CGAL::Extremal_mesh_3;

int main() {
  // An ellipsoid, which has 10 vertices, under small waves.
  const Formula surface("x^2/9 + y^2/4 + z^2 + 0.001*sin(9*x)*cos(8*y + 1) = 1");
  const Extremal_mesh mesh = extract_extremal_mesh(surface, make_lattice({-4, -3, -2}, {4, 3, 2}, 40)).mesh;

  const Simplification simplification(mesh);
  const std::size_t level = simplification.level_at_gap();
  const Extremal_mesh simple = simplification.mesh_at(level);
  write_persistence_diagram("persistence.svg", simplification, level);

  std::cout << mesh.number_of_vertices() << " vertices, " << simple.number_of_vertices() << " of them persistent\n";
  std::cout << "the last step has persistence " << simplification.steps()[level - 1].persistence
            << ", the next one would have " << simplification.steps()[level].persistence << '\n';
  return all_hold(check(simple)) && simple.number_of_vertices() == 10 ? 0 : 1;
}
