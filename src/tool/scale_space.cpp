// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../io/json_text.h"
#include "Input.h"
#include "Progress_bar.h"
#include "commands.h"
#include "query_json.h"
#include "registration_commands.h"

#include <CGAL/Extremal_mesh_3/extract_extremal_mesh.h>
#include <CGAL/Extremal_mesh_3/io.h>
#include <CGAL/Extremal_mesh_3/scale_space.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <utility>

namespace CGAL::Extremal_mesh_3::tool {

namespace {

/// the mesh of an image at one scale, as `extract` makes it.
Extremal_mesh mesh_at(const Scale_space_command_options& options, double sigma) {
  Extract_options what;
  what.input = options.file;
  what.iso = options.iso;
  what.sigma = sigma;
  what.threads = options.threads;
  what.quiet = options.quiet;
  const Input input = read_input(what, Memory_limit(what.memory_limit));
  Extraction_options how;
  how.threads = options.threads;
  how.max_level = input.max_level;
  how.max_line_level = input.max_line_level.value_or(input.max_level);
  Progress_bar bar("lines", options.quiet);
  how.progress = bar.progress();
  Extremal_mesh mesh = extract_extremal_mesh(*input.function, input.lattice, how).mesh;
  mesh.set_provenance(input.source, json_text(input.parameters), input.frame);
  return mesh;
}

/// how many events of each kind concern a level: what is created comes on the way to it, the others go on the way to the next.
std::array<std::size_t, 4> events_at(const Scale_space& space, std::size_t level) {
  std::array<std::size_t, 4> events{};
  for (const Scale_event& e : space.events)
    if ((e.kind == Scale_event_kind::create ? e.level + 1 : e.level) == level)
      ++events[std::size_t(e.kind)];
  return events;
}

void print_counts(const Scale_space& space, const std::vector<Extremal_mesh>& meshes) {
  fmt::print("{:>8} {:>9} {:>7} {:>8} {:>8} {:>8} {:>8}\n", "sigma", "vertices", "cells", "created", "cancel", "merge",
             "vanish");
  for (std::size_t level = 0; level < meshes.size(); ++level) {
    const std::array<std::size_t, 4> events = events_at(space, level);
    fmt::print("{:>8g} {:>9} {:>7} {:>8} {:>8} {:>8} {:>8}\n", space.sigmas[level], meshes[level].number_of_vertices(),
               meshes[level].number_of_cells(), events[0], events[1], events[2], events[3]);
  }
}

Json counts_json(const Scale_space& space, const std::vector<Extremal_mesh>& meshes) {
  Json levels = Json::array();
  for (std::size_t level = 0; level < meshes.size(); ++level) {
    const std::array<std::size_t, 4> events = events_at(space, level);
    levels.push_back({{"sigma", space.sigmas[level]},
                      {"vertices", meshes[level].number_of_vertices()},
                      {"cells", meshes[level].number_of_cells()},
                      {"created", events[0]},
                      {"cancelled", events[1]},
                      {"merged", events[2]},
                      {"vanished", events[3]}});
  }
  return {{"levels", std::move(levels)}};
}

} // namespace

int scale_space(const Scale_space_command_options& options) {
  std::vector<double> sigmas = options.sigmas;
  std::sort(sigmas.begin(), sigmas.end());
  sigmas.erase(std::unique(sigmas.begin(), sigmas.end()), sigmas.end());
  if (sigmas.size() < 2)
    throw Usage_error("a scale space needs several scales; give --sigma two or more numbers");
  if (is_mesh_file(options.file))
    throw Usage_error(fmt::format("'{}' is a mesh; a scale space is made of an image", options.file));
  if (options.output.empty() && options.plot.empty() && options.events.empty() && options.folder.empty() &&
      !options.json)
    throw Usage_error("there is nothing to write; give -o FILE.csv, --events FILE.csv, --plot FILE.svg or --graphs "
                      "FOLDER, or --json");
  if (!options.plot.empty() && !options.plot.ends_with(".svg") && !options.plot.ends_with(".png"))
    throw Usage_error(fmt::format("the extension of '{}' is not known; give --plot an .svg or a .png", options.plot));
  for (const std::string* file : {&options.output, &options.plot, &options.events})
    if (!file->empty())
      check_writable(*file);
  if (!options.folder.empty() && !std::filesystem::is_directory(options.folder))
    throw Usage_error(fmt::format("'{}' is no folder; give --graphs one that is there", options.folder));
  catch_interrupts();
  std::vector<Extremal_mesh> meshes;
  for (const double sigma : sigmas)
    meshes.push_back(mesh_at(options, sigma));
  Scale_space_options how;
  how.tolerance = options.tolerance.value_or(0);
  const Scale_space space = link_scales(meshes, sigmas, how);
  if (!options.folder.empty())
    for (std::size_t level = 0; level < meshes.size(); ++level)
      write_graphml((std::filesystem::path(options.folder) / fmt::format("sigma_{}.graphml", sigmas[level])).string(),
                    with_life_times(meshes, space, level));
  if (!options.output.empty())
    write_scale_counts(options.output, space, meshes);
  if (!options.events.empty())
    write_scale_events(options.events, space);
  if (!options.plot.empty())
    write_scale_plot(options.plot, space, meshes);
  if (options.json)
    fmt::print("{}\n", pretty(counts_json(space, meshes)));
  else if (!options.quiet)
    print_counts(space, meshes);
  return success;
}

} // namespace CGAL::Extremal_mesh_3::tool
