// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_SELECT_H
#define CGAL_EXTREMAL_MESH_3_SELECT_H

#include <CGAL/Extremal_mesh_3/measures.h>

#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

/// gathers the vertices of a kind, by their numbers. O(V).
/// \param mesh  an extremal mesh
/// \param kind  which vertices
/// \return their numbers
std::vector<std::uint32_t> vertices_of_kind(const Extremal_mesh& mesh, Vertex_kind kind);

/// The measures by which edges can be selected: the members of `Line_measures`.
enum class Line_measure : std::uint8_t {
  length,            ///< `Line_measures::length`
  strength,          ///< `Line_measures::strength`
  sharpness,         ///< `Line_measures::sharpness`
  mean_curvature,    ///< `Line_measures::mean_curvature`
  extreme_curvature, ///< `Line_measures::extreme_curvature`
  stability          ///< `Line_measures::stability`
};
/// \param measure  one of them
/// \return its name
std::string_view to_string(Line_measure measure);

/// picks one of the measures.
/// \param measures  of an edge or a line
/// \param measure  which one
/// \return its value
double value_of(const Line_measures& measures, Line_measure measure);

/// The values of a measure that are wanted, bounds included.
struct Measure_range {
  Line_measure measure = Line_measure::length;           ///< which one
  double min = -std::numeric_limits<double>::infinity(); ///< the least value
  double max = std::numeric_limits<double>::infinity();  ///< the greatest value
};

/// Which edges are wanted: those that agree with all that is given.
struct Edge_selection {
  std::optional<Line_type> type;     ///< the type of the greatest part of the length
  std::optional<int> family;         ///< 1 or 2
  std::vector<Measure_range> ranges; ///< of measures
};

/// gathers the edges that are wanted, by their ids. O(E), and O(points of the polylines) with ranges.
/// \param mesh  an extremal mesh
/// \param selection  what edges must satisfy
/// \return their numbers
/// \throws std::invalid_argument if the family is neither 1 nor 2, or a bound is not a number
std::vector<std::uint32_t> select_edges(const Extremal_mesh& mesh, const Edge_selection& selection);

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_SELECT_H
