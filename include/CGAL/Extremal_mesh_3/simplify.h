// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_SIMPLIFY_H
#define CGAL_EXTREMAL_MESH_3_SIMPLIFY_H

#include <CGAL/Extremal_mesh_3/Extremal_mesh.h>
#include <CGAL/Extremal_mesh_3/extract_extremal_mesh.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <string_view>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

/// What one step of a simplification does. Each changes the mesh as a small change of the surface could: degrees stay
/// even, the signs of the cells alternate, χ and both sums of indices are kept.
enum class Simplification_operation : std::uint8_t {
  cancel_extremal_points, ///< two extremal points of opposite index, joined by an edge, vanish
  cancel_umbilics,        ///< two umbilics of opposite index, joined by an edge, vanish
  merge_vertices, ///< three vertices (or two, one of them not generic) become the generic one with the sum of their indices
  /// a bump, such as two lemons with an extremal point between them, and a saddle vanish: two parts of the graph with the
  /// indices (1, 1) and (−1, −1), each within a disk, with all that they enclose. Nothing else changes
  cancel_islands,
  drop_loop,        ///< a loop at a 3-ridge umbilic vanishes, which becomes a 1-ridge one
  drop_closed_line, ///< a closed line around a disk in which there is nothing vanishes
  drop_border_line  ///< so does a line that cuts a disk off at the border of the surface
};
/// \param operation  what a step does
/// \return its name, as in files
std::string_view to_string(Simplification_operation operation);

/// What it costs that something vanishes.
enum class Simplification_measure : std::uint8_t {
  persistence, ///< by how much a principal curvature must change for it
  /// how long it lives over σ: the longest life time of what vanishes; of steps that are equal in that, the least persistent comes first
  life_time
};
/// \param measure  what steps cost
/// \return its name
std::string_view to_string(Simplification_measure measure);

/// One step of a simplification.
struct Simplification_step {
  Simplification_operation operation = Simplification_operation::cancel_extremal_points; ///< what it does
  /// by how much a principal curvature must change for it, times the square root of the surface's area (no unit); it
  /// never falls from a step to the next. If life times are the measure, the longest of what has vanished so far
  double persistence = 0;
  Point point{};                       ///< where it happens
  std::vector<std::uint32_t> vanished; ///< vertices of the unsimplified mesh that are no more
  std::size_t vertices = 0;            ///< how many the mesh has after the step
  std::size_t edges = 0;               ///< the same
  std::size_t cells = 0;               ///< the same
};

/// How to simplify.
struct Simplification_options {
  Simplification_measure measure = Simplification_measure::persistence; ///< what goes first
  /// crest lines, as `strongest_crest_lines()` gathers them, of at least this strength keep their course
  double keep_crest = std::numeric_limits<double>::infinity();
};

/// The hierarchy of ever simpler extremal meshes, from a given one (level 0) to the simplest that can be reached. Level
/// i is the mesh after i steps, least persistent first.
///
/// Every line of a level runs along lines of the given mesh and every cell is a union of its cells. Where vertices were
/// cancelled, up to three lines run along the same piece of a line, beside each other; none crosses another.
/// The steps depend on measures that rigid motions do not change, only.
class Simplification {
public:
  /// finds all steps. O(n log n) for n edges.
  /// \throws std::invalid_argument if the mesh's stars, walks, degrees, signs or numbers fail in `check()`, or it has no life times and
  ///         these are the measure
  /// \param mesh  the mesh of level 0
  /// \param options  what goes first, what stays
  explicit Simplification(Extremal_mesh mesh, const Simplification_options& options = {});
  ~Simplification();
  Simplification(Simplification&&) noexcept; ///< takes over what another one holds
  /// takes over what another one holds.
  /// \return this one
  Simplification& operator=(Simplification&&) noexcept;

  /// \return all steps, in their order
  const std::vector<Simplification_step>& steps() const;
  /// \return the number of steps and 1
  std::size_t number_of_levels() const { return steps().size() + 1; }

  /// \name Levels
  /// @{

  /// the level at which every step of at most this persistence is done.
  /// \param threshold  a persistence
  /// \return the level
  std::size_t level_of_persistence(double threshold) const;
  /// the first level with at most so many cells; the last level if there is none.
  /// \param cells  how many
  /// \return the level
  std::size_t level_of_cells(std::size_t cells) const;
  /// the first level with at most so many vertices; the last level if there is none.
  /// \param vertices  how many
  /// \return the level
  std::size_t level_of_vertices(std::size_t vertices) const;
  /// the level before the greatest rise of the persistence from a step to the next, counted from 0: where noise ends and
  /// shape begins, if there is such an end.
  /// \return the level
  std::size_t level_at_gap() const;
  /// @}

  /// makes the mesh of a level. Its `parameters` tell the level and its persistence. O(size of the given mesh).
  /// \param level  0 to `number_of_levels() - 1`
  /// \return the mesh
  /// \throws std::out_of_range if there is no such level
  Extremal_mesh mesh_at(std::size_t level) const;
  /// tells for each cell of the given mesh in which cell of `mesh_at(level)` it is.
  /// \param level  0 to `number_of_levels() - 1`
  /// \return one per cell of the given mesh
  std::vector<std::uint32_t> cells_at(std::size_t level) const;
  /// the patches of the given mesh with the cells of `mesh_at(level)`.
  /// \param level  0 to `number_of_levels() - 1`
  /// \param patches  those of the given mesh
  /// \return the same polygons
  Cell_patches patches_at(std::size_t level, const Cell_patches& patches) const;

  /// the persistence of each vertex of the given mesh: that of the step in which it vanishes, or infinity.
  /// \return one per vertex of the given mesh
  std::vector<double> vertex_persistence() const;

private:
  struct Data;
  std::unique_ptr<Data> data_;
};

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_SIMPLIFY_H
