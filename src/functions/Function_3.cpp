// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Extremal_mesh_3/Function_3.h>

namespace CGAL::Extremal_mesh_3 {

void Function_3::lattice_values(const Lattice& lattice, std::size_t k, double* out) const {
  for (std::size_t j = 0; j < lattice.size[1]; ++j)
    for (std::size_t i = 0; i < lattice.size[0]; ++i)
      *out++ = value(lattice.node(static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)));
}

bool Function_3::bounds(const Box_3&, int, Derivative_bounds&) const {
  return false;
}

} // namespace CGAL::Extremal_mesh_3
