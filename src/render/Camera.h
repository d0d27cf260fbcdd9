// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_RENDER_CAMERA_H
#define EXTREMAL_MESH_3_SRC_RENDER_CAMERA_H

#include <CGAL/Extremal_mesh_3/Extremal_mesh.h>
#include <CGAL/Extremal_mesh_3/extract_extremal_mesh.h>
#include <CGAL/Extremal_mesh_3/render.h>

namespace CGAL::Extremal_mesh_3 {

/// A point in a picture: x to the right and y downwards from the upper left corner, z away from the eye, all in samples
/// (several to a pixel).
struct Screen_point {
  double x = 0, y = 0, z = 0;
};

/// An orthographic camera that shows all of a scene.
class Camera {
public:
  /// \param samples  to a pixel, along each axis
  /// \throws std::invalid_argument if the direction of sight is zero or not finite
  Camera(const Extremal_mesh& mesh, const Cell_patches& patches, const Render_options& options, int samples);

  Screen_point project(const Point& p) const;
  /// turns a vector into (right, up, towards the eye).
  Vector turn(const Vector& v) const;

private:
  Vector right_{}, up_{}, forward_{};
  double scale_ = 1, x_ = 0, y_ = 0;
};

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_RENDER_CAMERA_H
