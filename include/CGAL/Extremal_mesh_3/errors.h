// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_ERRORS_H
#define CGAL_EXTREMAL_MESH_3_ERRORS_H

#include <stdexcept>

namespace CGAL::Extremal_mesh_3 {

/// A file that cannot be read or written, or whose content is not what it should be. The message is one
/// sentence that names the file, the place in it and what was expected.
class Io_error : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/// The input has no extremal mesh: no surface in the box, or `E_g = 0` over (almost) all of it.
class Extraction_error : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/// The surface has `E_g = 0` over an area (sphere, plane, cylinder, surface of revolution…), where
/// the extremal mesh is not defined.
class Degenerate_surface_error : public Extraction_error {
public:
  using Extraction_error::Extraction_error;
};

/// A `Progress` function returned `false`.
class Cancelled : public std::runtime_error {
public:
  Cancelled() : std::runtime_error("cancelled") {}
};

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_ERRORS_H
