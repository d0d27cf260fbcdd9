// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How do I get the extremal mesh of a surface given by a formula, and can I trust it?

#include <CGAL/Extremal_mesh_3/Formula.h>
#include <CGAL/Extremal_mesh_3/check.h>
#include <CGAL/Extremal_mesh_3/extract_extremal_mesh.h>

#include <iostream>

using namespace CGAL::Extremal_mesh_3;

int main() {
  const Formula ellipsoid("x^2/9 + y^2/4 + z^2 = 1");
  const Lattice lattice = make_lattice({-4, -3, -2}, {4, 3, 2}, 64);
  const Extremal_mesh mesh = extract_extremal_mesh(ellipsoid, lattice).mesh;
  std::cout << mesh.number_of_vertices() << " vertices, " << mesh.number_of_edges() << " edges, "
            << mesh.number_of_cells() << " cells\n";
  return all_hold(check(mesh)) ? 0 : 1;
}
