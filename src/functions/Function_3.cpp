// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Extremal_mesh_3/Function_3.h>

namespace CGAL::Extremal_mesh_3 {

void Function_3::lattice_values(const Lattice& lattice, std::size_t k, double* out) const {
  for (std::size_t j = 0; j < lattice.size[1]; ++j)
    for (std::size_t i = 0; i < lattice.size[0]; ++i)
      *out++ = value(lattice.node(static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)));
}

void Function_3::lattice_values(const Lattice& lattice, std::size_t k, std::span<const Row_part> parts,
                                double* out) const {
  for (const Row_part& part : parts)
    for (std::size_t i = part.first; i < part.last; ++i)
      out[part.j * lattice.size[0] + i] =
          value(lattice.node(static_cast<double>(i), static_cast<double>(part.j), static_cast<double>(k)));
}

bool Function_3::half_step_values(const Lattice&, const std::array<std::size_t, 3>&, std::array<double, 27>&) const {
  return false;
}

std::optional<double> Function_3::root_on_edge(const Lattice&, const std::array<std::size_t, 3>&, std::size_t, double,
                                               double) const {
  return std::nullopt;
}

bool Function_3::bounds(const Box_3&, int, Derivative_bounds&) const {
  return false;
}

} // namespace CGAL::Extremal_mesh_3
