// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../io/json_text.h"
#include "Progress_bar.h"
#include "surface_commands.h"

#include <CGAL/Extremal_mesh_3/flatten.h>
#include <CGAL/Extremal_mesh_3/io.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>
#include <vector>

namespace CGAL::Extremal_mesh_3::tool {

namespace {

using Json = nlohmann::ordered_json;

struct Counts {
  std::size_t flat = 0;
  std::map<std::size_t, std::size_t> by_corners;           ///< of flat cells
  std::map<std::string, std::size_t, std::less<>> refused; ///< by the outcome
  double area_distortion = 1;                              ///< the median of the flat cells
};

Counts count(const Flattening& flattening) {
  Counts counts;
  std::vector<double> distortions;
  for (const Flat_cell& cell : flattening.cells)
    if (cell.outcome == Flattening_outcome::flat) {
      ++counts.flat;
      ++counts.by_corners[cell.corners.size()];
      distortions.push_back(cell.area_distortion);
    } else {
      ++counts.refused[std::string(to_string(cell.outcome))];
    }
  std::sort(distortions.begin(), distortions.end());
  if (counts.flat > 0)
    counts.area_distortion = distortions[counts.flat / 2];
  return counts;
}

Json to_json(const Flattening& flattening, const Counts& counts) {
  Json json = {{"cells", flattening.cells.size()},
               {"flat", counts.flat},
               {"by_corners", Json::object()},
               {"refused", counts.refused},
               {"triangles", flattening.places.size()},
               {"flipped", flattening.flipped},
               {"area_distortion", counts.area_distortion},
               {"list", Json::array()}};
  for (const auto& [corners, number] : counts.by_corners)
    json["by_corners"][std::to_string(corners)] = number;
  for (std::size_t c = 0; c < flattening.cells.size(); ++c) {
    const Flat_cell& cell = flattening.cells[c];
    json["list"].push_back({{"cell", c},
                            {"outcome", to_string(cell.outcome)},
                            {"corners", cell.corners},
                            {"triangles", cell.triangles},
                            {"area_distortion", cell.area_distortion}});
  }
  return json;
}

void print(const Flattening& flattening, const Counts& counts) {
  std::string text;
  for (const auto& [corners, number] : counts.by_corners)
    text += fmt::format("{}{} with {} corner{}", text.empty() ? "" : ", ", number, corners, corners == 1 ? "" : "s");
  fmt::print("{:<10} {:<7}  of {} cells: {}\n", "flat", counts.flat, flattening.cells.size(), text);
  for (const auto& [outcome, number] : counts.refused)
    fmt::print("{:<10} {:<7}  {}\n", "refused", number, outcome);
  fmt::print("{:<10} {:<7}  of {} triangles\n", "flipped", flattening.flipped, flattening.places.size());
  fmt::print("{:<10} {:<7.4g}  of areas, in the median of the flat cells\n", "distortion", counts.area_distortion);
}

} // namespace

int flatten(const Flatten_options& options) {
  if (options.output.empty() && !options.json)
    throw Usage_error("there is nothing to write; give -o FILE.obj or --json");
  if (!options.output.empty()) {
    if (!options.output.ends_with(".obj"))
      throw Usage_error(fmt::format("the extension of '{}' is not known; give -o an .obj", options.output));
    check_writable(options.output);
  }
  Surface_command_options common;
  common.file = options.file;
  common.patches = options.patches;
  const Given_surface given = read_surface_of(common);
  catch_interrupts();
  const Flattening flattening = [&] {
    Progress_bar bar("flattening", options.quiet);
    return Extremal_mesh_3::flatten(given.mesh, given.patches, options.threads, bar.progress());
  }();
  if (!options.output.empty())
    write_flat_obj(options.output, flattening);
  const Counts counts = count(flattening);
  if (options.json)
    fmt::print("{}\n", json_text(to_json(flattening, counts), 2));
  else if (!options.quiet)
    print(flattening, counts);
  return success;
}

} // namespace CGAL::Extremal_mesh_3::tool
