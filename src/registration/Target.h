// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_REGISTRATION_TARGET_H
#define EXTREMAL_MESH_3_SRC_REGISTRATION_TARGET_H

#include "../cgal/Point_tree.h"
#include "Features.h"

#include <CGAL/Extremal_mesh_3/Similarity.h>

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

/// The features of the second mesh, ready to be searched.
class Target {
public:
  /// \param features  outlives it
  explicit Target(const Features& features);

  const Features& features() const { return features_; }

  /// the nearest vertex of the same kind with about the same frame, not farther than `within`.
  std::optional<std::uint32_t> vertex_near(const Feature& f, const Similarity& motion, double within) const;
  /// the nearest sample of any line on about the same side of the surface.
  std::optional<std::uint32_t> surface_near(const Line_sample& s, const Similarity& motion, double within) const;
  /// the nearest sample of a line of the same kind with about the same tangent.
  std::optional<std::uint32_t> line_near(const Line_sample& s, const Similarity& motion, double within) const;

private:
  /// Points of one kind, and where they are in the features.
  struct Group {
    Point_tree<3> tree;
    std::vector<std::uint32_t> members;
  };
  template <class Things> static Group group_of(const Things& things, int kind);

  const Features& features_;
  std::vector<Group> vertices_, lines_; ///< by kind
  Group all_lines_;
};

/// the distance of a moved sample from the surface at another one. Along the mean of both normals: that is right up to third order,
/// however far beside each other they are.
double distance_from_surface(const Line_sample& a, const Similarity& motion, const Line_sample& b);

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_REGISTRATION_TARGET_H
