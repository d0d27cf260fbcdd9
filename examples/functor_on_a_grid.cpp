// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How do I use my own function? As a lambda with auto parameters it is differentiated exactly, without more code.

#include <CGAL/Extremal_mesh_3/Functor_function.h>
#include <CGAL/Extremal_mesh_3/check.h>
#include <CGAL/Extremal_mesh_3/extract_extremal_mesh.h>

#include <cmath>
#include <iostream>

using namespace CGAL::Extremal_mesh_3;

int main() {
  // A torus bent out of its symmetry. The functions of <cmath> are called unqualified, so that those of jets are found.
  const auto torus = make_function([](auto x, auto y, auto z) {
    using std::sqrt;
    const auto from_circle = sqrt(x * x + 1.3 * y * y) - 1.0;
    return from_circle * from_circle + z * z * (1.0 + 0.2 * x) + 0.03 * y * z - 0.16;
  });
  const Lattice lattice = make_lattice({-1.6, -1.5, -0.7}, {1.6, 1.5, 0.7}, 64);

  Extraction_options options;
  options.progress = [](double) { return true; }; // false stops the work: Cancelled is thrown
  const Extraction extraction = extract_extremal_mesh(torus, lattice, options);

  const Surface_info& surface = extraction.mesh.surface();
  std::cout << "Euler characteristic " << surface.euler_characteristic << ", area " << surface.area << ", "
            << extraction.report.uncertain_cells << " uncertain cells of " << extraction.report.refined_cells << '\n';
  for (const Check& c : check(extraction.mesh))
    std::cout << (!c.applies ? "  -  " : c.holds ? " yes " : " NO  ") << c.claim << " (" << c.detail << ")\n";
  return all_hold(check(extraction.mesh)) ? 0 : 1;
}
