// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_MEASURES_H
#define CGAL_EXTREMAL_MESH_3_MEASURES_H

#include <CGAL/Extremal_mesh_3/Extremal_mesh.h>
#include <CGAL/Extremal_mesh_3/lines.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

/// \file
/// Measures of the parts of an extremal mesh. Rigid motions change none of them; what has no unit does not change with the
/// scale either.
namespace CGAL::Extremal_mesh_3 {

/// Measures of an edge or of a whole line.
struct Line_measures {
  double length = 0;   ///< in the input's unit
  double strength = 0; ///< ∫|k_family| ds, no unit
  /// area of the surface × ∫|∇e_family·t_family| ds, no unit. At umbilics |∇e| grows like one over the distance: for lines that
  /// reach one the integral has no limit, and tells how near the points of the polylines come, too.
  double sharpness = 0;
  double mean_curvature = 0;    ///< ∫ k_family ds / length, in 1/length: its sign is that of the curvature
  double extreme_curvature = 0; ///< the value of k_family that is greatest in absolute value, in 1/length
  /// of an edge: √(area of the surface) × ∫|e_other| ds, no unit. That is about how much the other principal curvature differs
  /// between the two ends, so how far it would have to change for them to meet and cancel each other: the `persistence` of
  /// that step of a `Simplification`, as long as nothing else has changed. Of a line: that of its least stable edge, at
  /// which it would be cut first.
  double stability = 0;
};

/// measures an edge. O(points of its polyline).
/// \param mesh  an extremal mesh
/// \param edge  its number
/// \return its measures
/// \throws std::invalid_argument if there is no such edge
Line_measures edge_measures(const Extremal_mesh& mesh, std::uint32_t edge);

/// measures a line, or any other chain of edges: lengths, strengths and sharpnesses add up. The family of each edge is
/// its own. O(points of the polylines).
/// \param mesh  an extremal mesh
/// \param line  half-edges of it
/// \return the measures of all together
/// \throws std::invalid_argument if there is no such half-edge
Line_measures line_measures(const Extremal_mesh& mesh, const Extremal_line& line);

/// Measures of a cell.
struct Cell_measures {
  double area = 0;             ///< in the square of the input's unit of length
  double weight = 0;           ///< ∫√|E_g| dA, no unit
  double mean_extremality = 0; ///< weight / area, in 1/length²
  double perimeter = 0;        ///< length of its sides; lines with the cell on both sides count twice
  std::size_t sides = 0;       ///< number of half-edges around it
  /// 4π·area / perimeter², no unit: 1 for a flat round disk, less for anything longer or more ragged in the plane.
  /// Nothing for cells without a line and for those that touch the border, the length of which is not known.
  std::optional<double> compactness;
};

/// measures a cell. O(sides).
/// \param mesh  an extremal mesh
/// \param cell  its number
/// \return its measures
/// \throws std::invalid_argument if there is no such cell
Cell_measures cell_measures(const Extremal_mesh& mesh, std::uint32_t cell);

/// Which extrema of the two principal curvatures meet in an extremal point: that of family 1, then that of family 2. An
/// extremum is one of the curvature's absolute value along its own line of curvature, as in `Line_type`.
enum class Extrema : std::uint8_t {
  max_max, ///< both maximal
  max_min, ///< |k1| maximal, |k2| minimal
  min_max, ///< |k1| minimal, |k2| maximal
  min_min  ///< both minimal
};
/// \param extrema  which ones meet
/// \return `max/max`, `max/min`, `min/max` or `min/min`
std::string_view to_string(Extrema extrema);

/// Measures of a vertex.
struct Vertex_measures {
  /// of the straight lines through the vertex, the weakest counts with the strengths of its two edges here; branches that
  /// no line continues count alone. No unit.
  double strength = 0;
  double stability = 0;           ///< of the least stable edge at the vertex, no unit
  std::optional<Extrema> extrema; ///< of extremal points
};

/// measures a vertex. O(points of the polylines of the edges at it).
/// \param mesh  an extremal mesh
/// \param vertex  its number
/// \return its measures
/// \throws std::invalid_argument if there is no such vertex
Vertex_measures vertex_measures(const Extremal_mesh& mesh, std::uint32_t vertex);

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_MEASURES_H
