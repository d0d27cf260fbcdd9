// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_TOOL_OUTPUTS_H
#define EXTREMAL_MESH_3_SRC_TOOL_OUTPUTS_H

#include "Result.h"
#include "commands.h"

#include <CGAL/Extremal_mesh_3/render.h>
#include <CGAL/Extremal_mesh_3/view.h>

#include <string>
#include <vector>

namespace CGAL::Extremal_mesh_3::tool {

/// What a command writes in the first place: other endings have other meanings.
enum class Content { graph, surface };

/// The files that a command was asked for.
class Outputs {
public:
  /// \throws Usage_error for an unknown extension or two outputs in one file; Io_error if one cannot be written
  explicit Outputs(const Output_options& options, Content content = Content::graph);

  /// takes note of a file that the command itself writes.
  /// \throws the same
  void reserve(const std::string& file);
  bool empty() const { return outputs_.empty(); }
  /// whether all is for looking at: pages and pictures.
  bool only_pictures() const;
  /// whether the surface is needed: pictures are drawn without it if there is none, its cells cannot be written.
  bool need_patches() const;
  /// \throws Io_error; Cancelled, between two files, if there was a Ctrl-C
  void write(const Result& result) const;

private:
  enum class Kind {
    graphml,
    cell_polygons,
    picture,
    page,
    obj,
    lines_ply,
    vtp,
    gltf,
    vertices_csv,
    edges_csv,
    cells_csv,
    json,
    markups,
    lines,
    patches_off,
    patches_ply,
    surface,
    report,
    other
  };
  struct Output {
    Kind kind;
    std::string file;
  };

  /// what a file is, by its ending.
  /// \throws Usage_error if that is not known
  static Kind kind_of(const std::string& file, Content content);
  void add(Kind kind, const std::string& file);
  void write(const Output& output, const Result& result) const;

  std::vector<Output> outputs_;
  Render_options render_;
  View_options view_;
  Cell_colouring colouring_ = Cell_colouring::sign;
};

/// reads the surface that belongs to a graph, as `extract --cells` wrote it; none if there is no file of it.
/// \param graph  the file of the mesh, for the message
/// \throws Io_error
Cell_patches read_patches_of(const std::string& file, const Extremal_mesh& mesh, const std::string& graph);

} // namespace CGAL::Extremal_mesh_3::tool

#endif // EXTREMAL_MESH_3_SRC_TOOL_OUTPUTS_H
