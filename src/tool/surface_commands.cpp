// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface_commands.h"

#include "add_command.h"

namespace CGAL::Extremal_mesh_3::tool {

namespace {

/// a command with the argument that all of these have.
template <class Options>
std::pair<CLI::App*, std::shared_ptr<Options>>
command_on_graph(CLI::App& app, const char* name, const char* description, int (*function)(const Options&),
                 std::function<int()>& run) {
  const auto added = command(app, name, description, function, run);
  option(added.first, "GRAPH", added.second->file, "", graph_argument)->required();
  return added;
}

void add_common(CLI::App* command, Surface_command_options& options, const char* outputs) {
  option(command, "--surface", options.patches, "FILE", "the cells of GRAPH as 'extract --cells' wrote them (.ply)");
  option(command, "-o,--output", options.outputs, "FILE", outputs)->allow_extra_args(false);
  command->add_flag("--json", options.json, "print one JSON object");
  add_look(*command, options);
}

void add_segment(CLI::App& app, std::function<int()>& run) {
  const auto [c, o] = command_on_graph(app, "segment", "tells the cell of each face of a surface", segment, run);
  option(
      c, "MESH", o->input, "",
      "a mesh of the same surface, not cut along the lines: .off .obj .ply .stl .om; without it the faces are those of "
      "--surface");
  option(c, "--tolerance", o->tolerance, "LENGTH",
         "how far MESH may be from the cells (a hundredth of the surface's diagonal)");
  add_common(
      c, *o,
      "write the faces with their cells (.ply .vtp), in the colours of these (.off .glb .gltf), a page (.html), a "
      "picture (.png); repeatable");
  c->footer(
      "Example:\n  extremal_mesh segment femur.graphml femur.off --surface cells.ply --colour cell -o labelled.ply");
}

void add_reduce(CLI::App& app, std::function<int()>& run) {
  const auto [c, o] =
      command_on_graph(app, "reduce", "makes a surface of fewer triangles, with its crest lines kept", reduce, run);
  option(c, "--faces", o->number_of_faces, "N", "until there are at most so many triangles (a tenth of the surface's)");
  option(c, "--keep-crest", o->keep_crest, "STRENGTH", "crest lines of at least this strength are kept (0: all)");
  option(c, "--line-tolerance", o->line_tolerance, "LENGTH",
         "how far they may be from what is left of them (a thousandth of the surface's diagonal)");
  add_common(
      c, *o,
      "write the triangles with their cells (.ply .vtp), in the colours of these (.off .glb .gltf), a page (.html), a "
      "picture (.png); repeatable");
  c->footer(
      "Example:\n  extremal_mesh reduce skull.graphml --surface cells.ply --keep-crest 2 --faces 20000 -o reduced.ply");
}

void add_flatten(CLI::App& app, std::function<int()>& run) {
  const auto [c, o] =
      command_on_graph(app, "flatten", "maps each cell to the plane: those of four corners to a square", flatten, run);
  option(c, "--surface", o->patches, "FILE", "the cells of GRAPH as 'extract --cells' wrote them (.ply)");
  option(c, "-o,--output", o->output, "FILE", "write the surface with texture coordinates, a group per cell (.obj)");
  c->add_flag("--json", o->json, "print one JSON object");
  option(c, "--threads", o->threads, "N", "0: as many as there are cores (0)");
  c->add_flag("--quiet", o->quiet, "print errors only");
  c->footer("Example:\n  extremal_mesh flatten skull.graphml --surface cells.ply -o flat.obj");
}

} // namespace

void add_look(CLI::App& command, Output_options& options) {
  option(&command, "--colour", options.colour, "sign|cell",
         "of cells: two tints by the sign of E_g, or one for each (sign)");
  option(&command, "--show", options.show, "all|crest|surface",
         "in pictures: all, the crest lines alone, or no line (all)");
  option(&command, "--view,--camera", options.view, "DX DY DZ", "the direction of sight of pages and pictures");
  option(&command, "--up", options.up, "DX DY DZ", "what points upwards in them (0 0 1)");
  option(&command, "--size", options.size, "WIDTHxHEIGHT", "of the picture in pixels (1600x1200)");
  option(&command, "--threads", options.threads, "N", "0: as many as there are cores (0)");
  command.add_flag("--quiet", options.quiet, "print errors only");
}

void add_surface_commands(CLI::App& app, std::function<int()>& run) {
  add_segment(app, run);
  add_reduce(app, run);
  add_flatten(app, run);
}

} // namespace CGAL::Extremal_mesh_3::tool
