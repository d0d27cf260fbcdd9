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
  std::string id; ///< EP1, EP2, … and U1, U2, …: the strongest first
  std::uint32_t vertex = 0;
  double persistence = 0; ///< see `Simplification`; infinite for those that are left in the simplest mesh
  double strength = 0;    ///< see `Vertex_measures`
};

struct Landmark_options {
  std::size_t most = static_cast<std::size_t>(-1); ///< so many of each kind
  bool extremal_points = true;
  bool umbilics = false;
};

/// lists extremal points, then umbilics, the most persistent first; of those with the same persistence the strongest, then the one
/// with the smaller number. The order does not change with a motion of the surface, but for such ties.
std::vector<Landmark> strongest_landmarks(const Extremal_mesh& mesh, const Landmark_options& options = {});

/// writes landmarks for 3D Slicer (`.mrk.json`): each with its frame (t1, t2, normal) as orientation.
/// \throws Io_error
void write_markups(const std::string& file, const Extremal_mesh& mesh, const std::vector<Landmark>& landmarks);

/// writes landmarks as a table (`.csv`): id, kind, position, frame, curvatures, persistence, strength, number of the vertex.
/// \throws Io_error
void write_landmarks_csv(const std::string& file, const Extremal_mesh& mesh, const std::vector<Landmark>& landmarks);

/// A point that somebody has marked.
struct Given_landmark {
  std::string label;
  Point point{};
};

/// reads the points of markups of 3D Slicer (`.json`; RAS is turned to LPS), or of a table (`.csv`) with columns x, y and z, or the first
/// three numbers of each row.
/// \throws Io_error naming the file, the place in it and what was expected
std::vector<Given_landmark> read_landmarks(const std::string& file);

/// What is near to a given landmark. Distances are infinite if there is none.
struct Landmark_match {
  std::uint32_t extremal_point = 0, umbilic = 0, line = 0, crest_line = 0; ///< vertices and edges
  double to_extremal_point = 0, to_umbilic = 0, to_line = 0, to_crest_line = 0;
  /// the means of the same distances from points of the surface around, one to three `reach` away: what is near by chance
  double chance_extremal_point = 0, chance_umbilic = 0, chance_line = 0, chance_crest_line = 0;
};

/// finds the nearest extremal point, umbilic, line and crest line of each landmark.
/// \param among  extremal points and umbilics are sought among these; empty: among all
/// \param reach  how far away the points are by which chance is judged; 0: √(area / number of cells)
std::vector<Landmark_match> match_landmarks(const Extremal_mesh& mesh, const std::vector<Given_landmark>& landmarks,
                                            const std::vector<Landmark>& among = {}, double reach = 0);

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_LANDMARKS_H
