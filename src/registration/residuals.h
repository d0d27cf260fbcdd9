// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_REGISTRATION_RESIDUALS_H
#define EXTREMAL_MESH_3_SRC_REGISTRATION_RESIDUALS_H

#include "../cells/parallel.h"
#include "Target.h"
#include "least_squares.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

/// What is measured: the height over the other surface, the distance from a line across it, that from a vertex along the surface.
enum class Residual_sort : std::uint8_t { surface, across_line, vertex_tangent };
inline constexpr std::size_t residual_sorts = 3;

/// How far a point of the first mesh, moved, is from where it should be, in one direction.
struct Residual {
  Point point{};
  Vector direction{};
  double value = 0;
  Residual_sort sort = Residual_sort::surface;
  double weight = 0;
};

/// the height of a moved sample over the other surface at a sample of that, with curvatures at both: exact up to the fourth order in their
/// distance. Nothing if they are farther apart than the surface is flat.
std::optional<Residual> height_over(const Line_sample& a, const Similarity& motion, const Line_sample& b);

/// all residuals of vertices and samples that have something of their sort within the gate.
/// \param threads  null: on the caller's thread alone
std::vector<Residual> find_residuals(const Features& a, const Target& b, const Similarity& motion, double gate,
                                     Thread_pool* threads);

/// the distances between the surfaces at the samples of the second mesh, from points of the first one.
/// \param backwards  takes the second mesh to the first
std::vector<Residual> find_residuals_back(const Features& b, const Target& a, const Similarity& backwards, double gate,
                                          Thread_pool& threads);

/// weighs residuals by how small those of their sort are, with Tukey's biweight. What is far out has the weight 0.
/// \param least  deviation, that of rounding
/// \param share  by which those of each sort count
/// \return the root mean square of the distances between the surfaces that count
double weigh(std::vector<Residual>& residuals, double least, const std::array<double, residual_sorts>& share);

/// The coordinates in which a motion is changed: about the centre of the residuals, lengths in units of their size. Without these turns and
/// translations could not be compared.
struct Change_frame {
  Point centre{};
  double size = 0;

  explicit Change_frame(const std::vector<Residual>& residuals);
  Unknowns derivative(const Residual& r) const;
  /// turns, moves and scales after a motion.
  Similarity changed(const Similarity& motion, const Unknowns& by) const;
};

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_REGISTRATION_RESIDUALS_H
