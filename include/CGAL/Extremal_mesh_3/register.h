// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_REGISTER_H
#define CGAL_EXTREMAL_MESH_3_REGISTER_H

#include <CGAL/Extremal_mesh_3/Extremal_mesh.h>
#include <CGAL/Extremal_mesh_3/Similarity.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

/// How to look for a motion.
struct Registration_options {
  bool scale = false;  ///< look for a uniform scale as well
  bool mirror = false; ///< where there is no rigid motion, look for one of the mirror image
  /// how far apart, in the unit of the second mesh, two points may be that are taken for the same. 0: `default_tolerance()` of the two
  double tolerance = 0;
  std::size_t most_vertices = 1500; ///< so many of each mesh are used, the most persistent ones
  unsigned seed = 1;                ///< which of the pairs are tried, where there are too many
  int threads = 0;                  ///< 0: as many as the machine has cores. The result does not depend on it.
};

/// A vertex of the first mesh and the one of the second that is the same.
struct Matched_vertices {
  std::uint32_t a = 0; ///< of the first mesh
  std::uint32_t b = 0; ///< of the second mesh
  double distance = 0; ///< after the first was moved
};

/// How well a motion takes one mesh to the other, where they overlap.
struct Registration_evidence {
  /// of the first mesh, how many were looked for: the most persistent ones, where the second one is
  std::size_t vertices = 0;
  std::size_t matched = 0;         ///< of these, how many are at the place of one of the same kind
  double chance = 0;               ///< the share that matches when the motion is slightly wrong
  double overlap = 0;              ///< the share of the first mesh's lines that lies at the second one's surface
  double on_surface = 0;           ///< of these, the share that is within a quarter of the tolerance of the surface
  double on_surface_by_chance = 0; ///< the same when the motion is slightly wrong
  /// log10 of the probability that so many vertices match by chance, times the number of motions tried
  double log10_significance = 0;
};

/// A motion that takes one extremal mesh to another.
struct Registration {
  /// the meshes are of the same surface, moved, as far as they overlap. If not, no motion is claimed
  bool found = false;
  std::string reason;   ///< why none was found
  Similarity transform; ///< takes points of the first mesh to the second; if none was found, the best that was met
  bool normals_reversed = false;         ///< the second surface has its normals on the other side
  double tolerance = 0;                  ///< that was used
  Registration_evidence evidence;        ///< for the motion
  std::vector<Matched_vertices> matched; ///< all extremal points and umbilics, each at most once
  double rms = 0;                        ///< of their distances
  double surface_rms = 0;                ///< of the distances between the surfaces, on the lines, outliers apart
  /// \name Standard errors
  /// root mean squares of the errors that the noise of the surfaces makes, by how much they differ and over which distances these differences depend
  /// on each other
  /// @{
  double rotation_error = 0;    ///< of the angle, in radians
  Point centre{};               ///< of the overlap, in the second mesh
  double translation_error = 0; ///< of the distance between where the centre is and where it should be
  double scale_error = 0;       ///< of the scale, no unit
  /// @}
  /// other motions that fit nearly as well, as on symmetric surfaces
  std::vector<Similarity> alternatives;
};

/// tells how far apart points of two extremal meshes may be that are the same: the side of a voxel or the σ that their
/// `parameters` tell, or 1 % of the root of their areas; but never more than a quarter of the distance of vertices.
/// \param a,b  the first and the second mesh
/// \return a length in the unit of the second mesh
double default_tolerance(const Extremal_mesh& a, const Extremal_mesh& b);

/// finds the motion that takes one extremal mesh to another, without an initial guess.
///
/// Two pairs of extremal points whose distance, frames and curvatures agree propose a motion; those that many pairs propose are
/// refined on vertices and lines and tested: a motion is found only if much more is at its place than when it is
/// slightly changed. The meshes may overlap in part, each may have what the other has not, and the normals of one may be reversed.
/// O(n log n) for n points of polylines.
/// \param a,b  the mesh to move, and the one to move it to
/// \param options  scale, mirror image, tolerance
/// \return the motion, or why there is none
/// \throws std::invalid_argument if an option is out of its range, or a coordinate is not finite
Registration register_extremal_meshes(const Extremal_mesh& a, const Extremal_mesh& b,
                                      const Registration_options& options = {});

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_REGISTER_H
