// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_SCALE_SPACE_H
#define CGAL_EXTREMAL_MESH_3_SCALE_SPACE_H

#include <CGAL/Extremal_mesh_3/Extremal_mesh.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

/// What becomes of a vertex from a scale to the next coarser one.
enum class Scale_event_kind : std::uint8_t {
  create, ///< it is there at the coarser scale only
  cancel, ///< it is there at the finer scale only, and so is another one of opposite index beside it
  merge,  ///< it is there at the finer scale only, beside one that stays
  vanish  ///< it is there at the finer scale only, and nothing is near that would tell why
};
/// \param kind  an event
/// \return its name, as in files
std::string_view to_string(Scale_event_kind kind);

/// The track of what has none.
inline constexpr std::uint32_t no_track = std::numeric_limits<std::uint32_t>::max();

/// Something that happens between the scales `level` and `level + 1`.
struct Scale_event {
  Scale_event_kind kind = Scale_event_kind::create; ///< what happens
  std::size_t level = 0;                            ///< of the finer one of the two scales
  std::uint32_t track = 0;                          ///< to which it happens
  std::uint32_t other = no_track;                   ///< the track that it cancels or merges with
  Point point{};                                    ///< where the vertex is at the scale at which it is found
};

/// An extremal point or umbilic through the scales at which it is found.
struct Scale_track {
  Vertex_kind kind = Vertex_kind::extremal_point; ///< the same at all scales
  std::size_t first_level = 0;                    ///< at which it is found
  std::vector<std::uint32_t> vertices;            ///< one per level from the first one on
  /// \return the last level at which it is found
  std::size_t last_level() const { return first_level + vertices.size() - 1; }
};

/// How to link scales.
struct Scale_space_options {
  /// how far a vertex may move from a scale to the next, plus half of the difference of the two σ, which is what a feature moves when
  /// its surroundings change by that. 0: `default_tolerance()`
  double tolerance = 0;
};

/// The extremal meshes of one surface at several scales, with what belongs together.
struct Scale_space {
  std::vector<double> sigmas;      ///< ascending
  std::vector<Scale_track> tracks; ///< each vertex of each level is in one, if it is an extremal point or an umbilic
  std::vector<Scale_event> events; ///< by level
  /// of each vertex of each level; `no_track` for other kinds of vertices
  std::vector<std::vector<std::uint32_t>> track;
  std::vector<double> reach; ///< how far what is the same may be apart at level i and level i + 1

  /// ln(σ of the last level at which a vertex is found / σ of the first one): 0 if it is found at one only. No unit.
  /// \param level  a level
  /// \return one per vertex of the level
  std::vector<double> vertex_life_times(std::size_t level) const;
  /// the same for each edge of a level: over the levels before and after at which edges of its family join the same two tracks; of an edge that does
  /// not join two, such as a closed line: over those at which half of its points are within reach of lines of its family.
  /// \param meshes  those that were linked
  /// \param level  a level
  /// \return one per edge of the level
  std::vector<double> edge_life_times(const std::vector<Extremal_mesh>& meshes, std::size_t level) const;
};

/// links the vertices of each mesh with those of the next one: each the other's nearest of the same kind and index, not farther apart
/// than the tolerance. O(n log n).
/// \param sigmas  of the meshes, strictly ascending
/// \param meshes  one per σ
/// \param options  how far the same vertex may move
/// \return tracks and events
/// \throws std::invalid_argument if there are not as many σ as meshes, or they do not ascend
Scale_space link_scales(const std::vector<Extremal_mesh>& meshes, std::vector<double> sigmas,
                        const Scale_space_options& options = {});

/// the mesh of a level, with the life times of its vertices and edges: they are written to GraphML, and can be the measure of a `Simplification`.
/// \param meshes  those that were linked
/// \param space  by `link_scales()`
/// \param level  a level
/// \return a copy of `meshes[level]`
/// \throws std::invalid_argument if there is no such level
Extremal_mesh with_life_times(const std::vector<Extremal_mesh>& meshes, const Scale_space& space, std::size_t level);

/// \name Files
/// @{

/// writes one row per level: σ, how many extremal points, umbilics, edges and cells, and how many of the vertices are new, stay, and end.
/// \throws Io_error
/// \param file  the name of the file to write
/// \param space  by `link_scales()`
/// \param meshes  those that were linked
void write_scale_counts(const std::string& file, const Scale_space& space, const std::vector<Extremal_mesh>& meshes);
/// writes one row per event.
/// \param file  the name of the file to write
/// \param space  by `link_scales()`
/// \throws Io_error
void write_scale_events(const std::string& file, const Scale_space& space);
/// draws the numbers of extremal points, umbilics and cells against σ, as `.svg` or `.png`.
/// \param file  the name of the file to write
/// \param space  by `link_scales()`
/// \param meshes  those that were linked
/// \throws Io_error
/// \throws std::invalid_argument for another extension
void write_scale_plot(const std::string& file, const Scale_space& space, const std::vector<Extremal_mesh>& meshes);
/// @}

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_SCALE_SPACE_H
