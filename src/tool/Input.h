// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_TOOL_INPUT_H
#define EXTREMAL_MESH_3_SRC_TOOL_INPUT_H

#include "commands.h"
#include "memory_limit.h"

#include <CGAL/Extremal_mesh_3/Function_3.h>
#include <CGAL/Extremal_mesh_3/Lattice.h>
#include <CGAL/Extremal_mesh_3/read_mesh.h>

#include <nlohmann/json.hpp>

#include <memory>
#include <optional>
#include <string>

namespace CGAL::Extremal_mesh_3::tool {

/// What to extract from, and how that is recorded.
struct Input {
  std::unique_ptr<Function_3> function; ///< with the lattice to look for its surface on; null: there is a mesh
  Lattice lattice;
  bool use_cgal_mesher = false; ///< for cells of that surface
  Mesh mesh;
  int max_level = 0;                 ///< unless told otherwise
  std::optional<int> max_line_level; ///< unless told otherwise; none: the same
  std::string source, frame;
  nlohmann::ordered_json parameters;
};

/// understands a formula, or reads an image or a mesh.
/// \throws Usage_error if options do not belong together or are out of their range; std::runtime_error if it takes too much memory;
///         what the library throws
Input read_input(const Extract_options& options, const Memory_limit& limit);

} // namespace CGAL::Extremal_mesh_3::tool

#endif // EXTREMAL_MESH_3_SRC_TOOL_INPUT_H
