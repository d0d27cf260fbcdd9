// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_TOOL_RESULT_H
#define EXTREMAL_MESH_3_SRC_TOOL_RESULT_H

#include <CGAL/Extremal_mesh_3/check.h>
#include <CGAL/Extremal_mesh_3/extract_extremal_mesh.h>
#include <CGAL/Extremal_mesh_3/fit_vertex_shapes.h>
#include <CGAL/Extremal_mesh_3/read_mesh.h>

#include <optional>
#include <vector>

namespace CGAL::Extremal_mesh_3::tool {

/// All that `extract` can write and tell.
struct Result {
  Cell_complex surface;
  std::optional<Mesh_repairs> repairs; ///< of a mesh from a file
  std::optional<Fit_report> fit;       ///< of its vertices' shapes
  Extraction extraction;
  std::vector<Check> checks;
};

} // namespace CGAL::Extremal_mesh_3::tool

#endif // EXTREMAL_MESH_3_SRC_TOOL_RESULT_H
