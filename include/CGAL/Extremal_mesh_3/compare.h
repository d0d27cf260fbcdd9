// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_COMPARE_H
#define CGAL_EXTREMAL_MESH_3_COMPARE_H

#include <CGAL/Extremal_mesh_3/Extremal_mesh.h>
#include <CGAL/Extremal_mesh_3/Similarity.h>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

/// How to compare.
struct Comparison_options {
  Similarity transform; ///< takes points of the first mesh to the second
  /// how far apart, in the unit of the second mesh, two points may be that are taken for the same. 0: `default_tolerance()`
  double tolerance = 0;
  int threads = 0; ///< 0: as many as the machine has cores. The result does not depend on it.
};

/// One kind of line or vertex. Lines are counted in segments of their polylines, shares of them are shares of length.
struct Comparison_row {
  std::string type; ///< that of `Line_type`; extremal_point, umbilic, umbilic_1_ridge, umbilic_3_ridge, non_generic
  std::size_t number_a = 0; ///< of the first mesh
  std::size_t number_b = 0; ///< of the second mesh
  double matched = 0;       ///< the share of the first mesh's that have one of the same kind within the tolerance
  double matched_back = 0;  ///< the same for the second mesh's
  /// the share that would match by chance: after points of the first mesh were moved along the surface, in any direction, by three to
  /// six tolerances
  double chance = 0;
  double deviation = 0; ///< standard deviation of the matched distances, from the first mesh to the second
  double rms = 0;       ///< root of the mean square of these distances
};

/// How much of two extremal meshes is the same. [Thirion 1993, 5.3 and figure 9]
struct Comparison {
  double tolerance = 0;             ///< that was used
  std::vector<Comparison_row> rows; ///< types of lines, then kinds of vertices
  /// \name Topology
  /// Shares of the first mesh's edges, and of the second's. An edge corresponds to one of the same type that is within the tolerance
  /// on 90 % of its length, and the ends of which are within the tolerance of its ends and of the same kinds, in this or the
  /// other order. A cell corresponds to one with the sign that it must have, the same Euler characteristic and as many sides,
  /// each of which corresponds to one of its own.
  /// @{
  double edges = 0;         ///< of the first mesh's
  double edges_back = 0;    ///< of the second mesh's
  double cells = 0;         ///< of the first mesh's
  double cells_back = 0;    ///< of the second mesh's
  double area_of_cells = 0; ///< of the corresponding cells, as a share of the first mesh's area
  /// @}
};

/// compares two extremal meshes. O(n log n) for n points of polylines.
/// \param a,b  the first and the second mesh
/// \param options  the motion between them, and what is taken for the same
/// \return shares by kinds of lines and vertices, and of edges and cells
/// \throws std::invalid_argument if the tolerance is negative or not finite, or a coordinate is not finite
Comparison compare_extremal_meshes(const Extremal_mesh& a, const Extremal_mesh& b,
                                   const Comparison_options& options = {});

/// \name Tables
/// @{

/// \param comparison  what `compare_extremal_meshes()` found
/// \return a table for people
std::string to_text(const Comparison& comparison);
/// \param comparison  what `compare_extremal_meshes()` found
/// \return a line of titles and one per row
std::string to_csv(const Comparison& comparison);
/// \param comparison  what `compare_extremal_meshes()` found
/// \return all of it, as one JSON object
std::string to_json(const Comparison& comparison);
/// @}

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_COMPARE_H
