// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_CGAL_FLATTEN_DISC_H
#define EXTREMAL_MESH_3_SRC_CGAL_FLATTEN_DISC_H

#include "Triangles.h"

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

using Plane_point = std::array<double, 2>;

enum class Flat_weights { mean_value, uniform };

/// maps a disc to the plane, with CGAL's Surface_mesh_parameterization: inner points are weighted means of their neighbours (Floater, Mean value
/// coordinates, 2003; Tutte, How to draw a graph, 1963).
/// \param border  its points in the order in which the disc is on their left
/// \param places  of these
/// \return a place for each point; empty if the system could not be solved
std::vector<Plane_point> flatten_disc(const Triangles& disc, const std::vector<std::uint32_t>& border,
                                      const std::vector<Plane_point>& places, Flat_weights weights);

/// counts the triangles that are clockwise, or have no area: decided exactly.
std::size_t number_of_flipped(const Triangles& disc, const std::vector<Plane_point>& places);

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_CGAL_FLATTEN_DISC_H
