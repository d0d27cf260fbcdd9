// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../io/json_text.h"
#include "Outputs.h"
#include "Progress_bar.h"
#include "commands.h"
#include "query_json.h"

#include <CGAL/Extremal_mesh_3/io.h>

#include <fmt/format.h>

namespace CGAL::Extremal_mesh_3::tool {

namespace {

int write_outputs(const View_command_options& options, const Outputs& outputs) {
  catch_interrupts();
  Result result;
  result.extraction.mesh = read_graphml(options.file);
  result.extraction.patches = read_patches_of(options.patches, result.extraction.mesh, options.file);
  outputs.write(result);
  if (options.json)
    fmt::print("{}\n", json_text(Json{{"files", options.outputs}}));
  else if (!options.quiet)
    for (const std::string& file : options.outputs)
      fmt::print("{}\n", file);
  return success;
}

} // namespace

int view(const View_command_options& options) {
  const Outputs outputs(options);
  if (outputs.empty())
    throw Usage_error("there is nothing to write; give -o view.html or -o picture.png");
  if (!outputs.only_pictures())
    throw Usage_error(
        "what is viewed is a page or a picture; give -o an .html or a .png, or use 'extremal_mesh convert'");
  return write_outputs(options, outputs);
}

int convert(const View_command_options& options) {
  const Outputs outputs(options);
  if (outputs.empty())
    throw Usage_error("there is nothing to write; give -o FILE, what it is follows from its extension");
  return write_outputs(options, outputs);
}

} // namespace CGAL::Extremal_mesh_3::tool
