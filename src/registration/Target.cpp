// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Point to plane by both normals: [Rusinkiewicz, "A symmetric objective function for ICP", 2019].
#include "Target.h"

#include "../differential/vector.h"

#include <cmath>

namespace CGAL::Extremal_mesh_3 {

namespace {

/// How far directions of the same thing may differ: 45 degrees for normals and tangents.
constexpr double alike = 0.7071;
/// If the nearest does not agree in direction, one of the next ones may.
constexpr std::size_t candidates = 4;

} // namespace

template <class Things> Target::Group Target::group_of(const Things& things, int kind) {
  std::vector<Point> points;
  std::vector<std::uint32_t> members;
  for (std::uint32_t i = 0; i < things.size(); ++i)
    if (kind < 0 || things[i].kind == kind) {
      points.push_back(things[i].point);
      members.push_back(i);
    }
  return {Point_tree<3>(points), std::move(members)};
}

Target::Target(const Features& features) : features_(features), all_lines_(group_of(features.samples, -1)) {
  for (std::size_t kind = 0; kind < feature_kinds; ++kind)
    vertices_.push_back(group_of(features.vertices, int(kind)));
  for (std::size_t kind = 0; kind < line_kinds; ++kind)
    lines_.push_back(group_of(features.samples, int(kind)));
}

std::optional<std::uint32_t> Target::vertex_near(const Feature& f, const Similarity& motion, double within) const {
  const Group& group = vertices_[f.kind];
  const Vector n = motion.turned(f.normal), t1 = motion.turned(f.t1);
  for (const auto& near : group.tree.nearest(motion(f.point), candidates, within)) {
    const Feature& other = features_.vertices[group.members[near.index]];
    if (dot(n, other.normal) > alike && (f.is_umbilic() || std::abs(dot(t1, other.t1)) > alike))
      return group.members[near.index];
  }
  return std::nullopt;
}

std::optional<std::uint32_t> Target::surface_near(const Line_sample& s, const Similarity& motion, double within) const {
  const Vector n = motion.turned(s.normal);
  for (const auto& near : all_lines_.tree.nearest(motion(s.point), candidates, within))
    if (dot(n, features_.samples[near.index].normal) > alike)
      return near.index;
  return std::nullopt;
}

std::optional<std::uint32_t> Target::line_near(const Line_sample& s, const Similarity& motion, double within) const {
  const Group& group = lines_[s.kind];
  const Vector n = motion.turned(s.normal), t = motion.turned(s.tangent);
  for (const auto& near : group.tree.nearest(motion(s.point), candidates, within)) {
    const Line_sample& other = features_.samples[group.members[near.index]];
    if (dot(n, other.normal) > alike && std::abs(dot(t, other.tangent)) > alike)
      return group.members[near.index];
  }
  return std::nullopt;
}

double distance_from_surface(const Line_sample& a, const Similarity& motion, const Line_sample& b) {
  const Vector n = motion.turned(a.normal) + b.normal;
  // the mean of unit normals that differ by an angle is shorter than 1
  return dot(1 / norm(n) * n, motion(a.point) - b.point);
}

} // namespace CGAL::Extremal_mesh_3
