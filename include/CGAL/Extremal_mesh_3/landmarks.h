// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_LANDMARKS_H
#define CGAL_EXTREMAL_MESH_3_LANDMARKS_H

#include <CGAL/Extremal_mesh_3/Extremal_mesh.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

/// A vertex as a landmark.
struct Landmark {
  std::string id;           ///< EP1, EP2, … and U1, U2, …: the strongest first
  std::uint32_t vertex = 0; ///< its number in the mesh
  double persistence = 0;   ///< see `Simplification`; infinite for those that are left in the simplest mesh
  double strength = 0;      ///< see `Vertex_measures`
};

/// Which vertices become landmarks.
struct Landmark_options {
  std::size_t most = static_cast<std::size_t>(-1); ///< so many of each kind
  bool extremal_points = true;                     ///< list these
  bool umbilics = false;                           ///< list these
};

/// lists extremal points, then umbilics, the most persistent first; of those with the same persistence the strongest, then the one
/// with the smaller number. The order does not change with a motion of the surface, but for such ties.
/// \param mesh  an extremal mesh
/// \param options  which kinds, and how many
/// \return the landmarks, with their names
std::vector<Landmark> strongest_landmarks(const Extremal_mesh& mesh, const Landmark_options& options = {});

/// writes landmarks for 3D Slicer (`.mrk.json`): each with its frame (t1, t2, normal) as orientation.
/// \param file  the name of the file to write
/// \param mesh  an extremal mesh
/// \param landmarks  vertices of it
/// \throws Io_error
void write_markups(const std::string& file, const Extremal_mesh& mesh, const std::vector<Landmark>& landmarks);

/// writes landmarks as a table (`.csv`): id, kind, position, frame, curvatures, persistence, strength, number of the vertex.
/// \param file  the name of the file to write
/// \param mesh  an extremal mesh
/// \param landmarks  vertices of it
/// \throws Io_error
void write_landmarks_csv(const std::string& file, const Extremal_mesh& mesh, const std::vector<Landmark>& landmarks);

/// A point that somebody has marked.
struct Given_landmark {
  std::string label; ///< its name in the file, or its number
  Point point{};     ///< in LPS, as meshes of images have it
};

/// reads the points of markups of 3D Slicer (`.json`; RAS is turned to LPS), or of a table (`.csv`) with columns x, y and z, or the first
/// three numbers of each row.
/// \param file  the name of the file to read
/// \return the points, in the order of the file
/// \throws Io_error naming the file, the place in it and what was expected
std::vector<Given_landmark> read_landmarks(const std::string& file);

/// What is near to a given landmark. Distances are infinite if there is none.
struct Landmark_match {
  std::uint32_t extremal_point = 0; ///< the vertex
  std::uint32_t umbilic = 0;        ///< the vertex
  std::uint32_t line = 0;           ///< the edge
  std::uint32_t crest_line = 0;     ///< the edge
  double to_extremal_point = 0;     ///< distance
  double to_umbilic = 0;            ///< distance
  double to_line = 0;               ///< distance
  double to_crest_line = 0;         ///< distance
  /// \name By chance
  /// the means of the same distances from points of the surface around, one to three `reach` away
  /// @{
  double chance_extremal_point = 0; ///< to the nearest extremal point
  double chance_umbilic = 0;        ///< to the nearest umbilic
  double chance_line = 0;           ///< to the nearest line
  double chance_crest_line = 0;     ///< to the nearest crest line
  /// @}
};

/// finds the nearest extremal point, umbilic, line and crest line of each landmark.
/// \param among  extremal points and umbilics are sought among these; empty: among all
/// \param reach  how far away the points are by which chance is judged; 0: √(area / number of cells)
/// \param mesh  an extremal mesh
/// \param landmarks  the points
/// \return one match per landmark
std::vector<Landmark_match> match_landmarks(const Extremal_mesh& mesh, const std::vector<Given_landmark>& landmarks,
                                            const std::vector<Landmark>& among = {}, double reach = 0);

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_LANDMARKS_H
