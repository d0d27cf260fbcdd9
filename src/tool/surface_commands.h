// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_TOOL_SURFACE_COMMANDS_H
#define EXTREMAL_MESH_3_SRC_TOOL_SURFACE_COMMANDS_H

#include "Outputs.h"

#include <CGAL/Extremal_mesh_3/segment.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace CGAL::Extremal_mesh_3::tool {

/// What the commands on surfaces have in common: a graph, and the surface cut along its lines.
struct Surface_command_options : Output_options {
  std::string file;
  std::string patches; ///< the cells of the graph, as `extract --cells` writes them
  bool json = false;
};

struct Segment_options : Surface_command_options {
  std::string input; ///< a mesh of the same surface; empty: the cells themselves
  std::optional<double> tolerance;
};
int segment(const Segment_options& options);

struct Reduce_options : Surface_command_options {
  std::optional<std::int64_t> number_of_faces;
  std::optional<double> keep_crest, line_tolerance;
};
int reduce(const Reduce_options& options);

struct Flatten_options {
  std::string file, patches, output;
  int threads = 0;
  bool json = false, quiet = false;
};
int flatten(const Flatten_options& options);

/// A graph and its surface.
struct Given_surface {
  Extremal_mesh mesh;
  Cell_patches patches;
};
/// reads them.
/// \throws Usage_error if there is no --surface; Io_error if they do not belong together
Given_surface read_surface_of(const Surface_command_options& options);

/// how pages and pictures look.
void add_look(CLI::App& command, Output_options& options);

/// adds the commands above to the program. The one that is called for is put into `run`.
void add_surface_commands(CLI::App& app, std::function<int()>& run);

} // namespace CGAL::Extremal_mesh_3::tool

#endif // EXTREMAL_MESH_3_SRC_TOOL_SURFACE_COMMANDS_H
