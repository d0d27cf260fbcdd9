// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_TEST_GENERIC_SURFACES_H
#define CGAL_EXTREMAL_MESH_3_TEST_GENERIC_SURFACES_H

#include "surfaces.h"

#include <ostream>
#include <string>
#include <vector>

/// Algebraic surfaces without symmetry, with umbilics of one and of three ridges, of genus 0, 1 and 5.
namespace generic_surfaces {

struct Surface {
  std::string name, formula;
  double half_size;              ///< of a cube around the origin that holds the surface, and nothing else where f = 0
  std::size_t search_resolution; ///< of the lattice that gives the starts of the dense search
  int euler_characteristic;
  surfaces::Counts counts;

  surfaces::Box box(const surfaces::Motion& motion = {}) const {
    const double h = half_size;
    return surfaces::moved({{-h, -h, -h}, {h, h, h}}, motion);
  }
  friend std::ostream& operator<<(std::ostream& out, const Surface& s) { return out << s.name; }
};

// Every count is that of the dense search; edges and cells follow by the identities of MATHEMATICS 4.
inline const std::vector<Surface> all_surfaces = {
    {"egg", "x^2+2*y^2+4*z^2-1+0.15*x^3+0.1*y^3-0.2*x*y*z+0.1*x^2*z", 1.4, 50, 2, {6, 4, 0, 16, 8, 0, 2}},
    {"potato",
     "x^2+1.3*y^2+1.7*z^2+0.2*x^3+0.15*y^3-0.4*x*y*z+0.2*x^2*z+0.1*x*y^2-1",
     1.4,
     50,
     2,
     {8, 4, 0, 20, 10, 0, 2}},
    {"cube",
     "x^2+1.05*y^2+0.96*z^2+x^4+y^4+z^4+0.05*x*y*z+0.03*x^3-0.02*y^3+0.025*y^2*z+0.02*x*y-1",
     1.1,
     50,
     2,
     {42, 20, 8, 120, 60, 0, 2}},
    {"torus",
     "(x^2+y^2+z^2+0.84)^2-4*(x^2+y^2)+0.1*x^2+0.15*x*y*z+0.06*x^3+0.08*y*z^2+0.05*x*z+0.04*y^3",
     1.8,
     50,
     0,
     {22, 0, 0, 44, 22, 0, 0}},
    {"tanglecube",
     "x^4+y^4+z^4-5.03*x^2-4.98*y^2-5*z^2+11.8+0.06*x*y*z+0.04*x^3-0.03*y^3+0.05*x*z^2+0.04*x*y",
     3.2,
     100,
     -8,
     {144, 40, 16, 360, 168, 0, -8}}};

} // namespace generic_surfaces

#endif // CGAL_EXTREMAL_MESH_3_TEST_GENERIC_SURFACES_H
