// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_REGISTRATION_FEATURES_H
#define EXTREMAL_MESH_3_SRC_REGISTRATION_FEATURES_H

#include <CGAL/Extremal_mesh_3/Extremal_mesh.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

/// A vertex with its frame, up to the sign that t1 and t2 have in common.
struct Feature {
  Point point{};
  Vector normal{}, t1{}, t2{};
  double k1 = 0, k2 = 0;
  /// extremal points: bit 0, is k1 maximal along its line of curvature (not |k1|); bit 1, is k2; bit 2, is the index 1.
  /// Umbilics: 8 or 9, by the sign of the index
  std::uint8_t kind = 0;
  double persistence = 0; ///< times 1 / √area: a curvature
  std::uint32_t vertex = 0;

  bool is_umbilic() const { return kind >= 8; }
};
inline constexpr std::size_t feature_kinds = 10;

/// A point of a line.
struct Line_sample {
  Point point{};
  Vector normal{}, tangent{}; ///< unit
  std::uint8_t kind = 0;      ///< bit 0: family 2; bit 1: is k_family maximal along its line of curvature
  /// how the normal bends: n' along the tangent t, times t and times n × t, and along n × t, times n × t. In 1/length
  std::array<double, 3> bend{};

  /// how much the normal turns along w, a tangent vector, times w: minus the second derivative of the surface's height.
  double bent(const Vector& w) const;
};
inline constexpr std::size_t line_kinds = 4;

/// What registration looks at in an extremal mesh.
struct Features {
  std::vector<Feature> vertices; ///< the most persistent first
  std::vector<Line_sample> samples;
  double spacing = 0; ///< between neighbours among the samples of a line

  /// the same with the normals on the other side.
  Features turned_over() const;
  /// the same after the mirror x → −x.
  Features mirrored() const;
};

/// the vertices of all kinds that are matched: extremal points and generic umbilics.
/// \throws std::invalid_argument if a coordinate is not finite
std::vector<Feature> vertex_features(const Extremal_mesh& mesh);

/// points of the surface along all lines.
/// \param spacing  between neighbours, at most
/// \param most     about so many points at most: the spacing is made larger for that
Features line_features(const Extremal_mesh& mesh, double spacing, std::size_t most);

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_REGISTRATION_FEATURES_H
