// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Camera.h"

#include "../differential/vector.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace CGAL::Extremal_mesh_3 {

namespace {

/// The part of the picture that the scene fills, along the tighter axis.
constexpr double filled = 0.9;

} // namespace

Camera::Camera(const Extremal_mesh& mesh, const Cell_patches& patches, const Render_options& options, int samples) {
  const double length = norm(options.view);
  if (!(length > 0) || !std::isfinite(length))
    throw std::invalid_argument("the direction of sight must be finite and not zero");
  forward_ = normalized(options.view);
  const Vector sideways = cross(forward_, options.up);
  right_ = norm(sideways) > 1e-9 * norm(options.up) ? normalized(sideways) : any_orthogonal(forward_);
  up_ = cross(right_, forward_);

  constexpr double infinity = std::numeric_limits<double>::infinity();
  double left = infinity, top = infinity, right = -infinity, bottom = -infinity;
  const auto include = [&](const Point& p) {
    const Screen_point s = project(p);
    left = std::min(left, s.x);
    right = std::max(right, s.x);
    top = std::min(top, s.y);
    bottom = std::max(bottom, s.y);
  };
  for (const Point& p : patches.points)
    include(p);
  for (std::size_t e = 0; e < mesh.number_of_edges(); ++e)
    for (const Point& p : mesh.edge(e).polyline)
      include(p);
  const double width = options.width * samples, height = options.height * samples;
  if (!(left <= right)) // nothing to show
    left = right = top = bottom = 0;
  const double scale = filled * std::min(width / (right - left), height / (bottom - top));
  scale_ = std::isfinite(scale) ? scale : 1;
  x_ = width / 2 - scale_ * (left + right) / 2;
  y_ = height / 2 - scale_ * (top + bottom) / 2;
}

Screen_point Camera::project(const Point& p) const {
  return {scale_ * dot(p, right_) + x_, -scale_ * dot(p, up_) + y_, scale_ * dot(p, forward_)};
}

Vector Camera::turn(const Vector& v) const {
  return {dot(v, right_), dot(v, up_), -dot(v, forward_)};
}

} // namespace CGAL::Extremal_mesh_3
