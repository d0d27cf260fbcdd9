// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../io/json_text.h"
#include "Progress_bar.h"
#include "surface_commands.h"

#include <CGAL/Extremal_mesh_3/io.h>
#include <CGAL/Extremal_mesh_3/segment.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <utility>

namespace CGAL::Extremal_mesh_3::tool {

namespace {

using Json = nlohmann::ordered_json;

Segmentation segmented(const Segment_options& options, const Given_surface& given) {
  if (options.input.empty())
    return segment(given.mesh, given.patches);
  const Mesh mesh = read_mesh(options.input);
  Progress_bar bar("segmenting", options.quiet);
  Segmentation_options how;
  how.tolerance = options.tolerance.value_or(0);
  how.threads = options.threads;
  how.progress = bar.progress();
  try {
    return segment(mesh.cells, given.mesh, given.patches, how);
  } catch (const std::invalid_argument& error) {
    throw Io_error(fmt::format("'{}' is not of the surface in '{}': {}", options.input, options.patches, error.what()));
  }
}

std::size_t cells_with_faces(const Segmentation& result) {
  std::size_t n = 0;
  for (const Cell_share& share : result.cells)
    n += share.faces > 0 ? 1 : 0;
  return n;
}

Json to_json(const Segmentation& result, const Extremal_mesh& mesh) {
  Json json = {{"faces", result.faces.cell.size()},
               {"cells", result.cells.size()},
               {"cells_with_faces", cells_with_faces(result)},
               {"area", result.area},
               {"cut_faces", result.cut_faces},
               {"cut_area", result.cut_area},
               {"away_faces", result.away_faces},
               {"away_area", result.away_area},
               {"largest_distance", result.largest_distance},
               {"shares", Json::array()}};
  for (std::size_t c = 0; c < result.cells.size(); ++c)
    json["shares"].push_back({{"cell", c},
                              {"sign", mesh.cell(c).sign},
                              {"faces", result.cells[c].faces},
                              {"pieces", result.cells[c].pieces},
                              {"area", result.cells[c].area},
                              {"area_of_cell", mesh.cell(c).area}});
  return json;
}

void print(const Segmentation& result) {
  fmt::print("{:<10} {}  in {} of {} cells\n", "faces", result.faces.cell.size(), cells_with_faces(result),
             result.cells.size());
  fmt::print("{:<10} {}  with a line through them, {:.2g} % of the area\n", "cut", result.cut_faces,
             result.area > 0 ? 100 * result.cut_area / result.area : 0);
  if (result.away_faces > 0)
    fmt::print("{:<10} {}  farther from the cells than the tolerance, in the nearest one, {:.2g} % of the area\n",
               "away", result.away_faces, 100 * result.away_area / result.area);
  fmt::print("{:<10} {:.6g}\n", "area", result.area);
  fmt::print("{:<10} {:.4g}  at most, from the cells\n", "distance", result.largest_distance);
}

} // namespace

Given_surface read_surface_of(const Surface_command_options& options) {
  if (options.patches.empty())
    throw Usage_error(
        "the surface must come from somewhere; give --surface the cells.ply that 'extract --cells' wrote");
  Given_surface given;
  given.mesh = read_graphml(options.file);
  given.patches = read_patches_of(options.patches, given.mesh, options.file);
  try {
    require_cells_of(given.mesh, given.patches);
  } catch (const std::invalid_argument& error) {
    throw Io_error(fmt::format("'{}' is not of the mesh in '{}': {}", options.patches, options.file, error.what()));
  }
  return given;
}

int segment(const Segment_options& options) {
  const Outputs outputs(options, Content::surface);
  if (outputs.empty() && !options.json)
    throw Usage_error("there is nothing to write; give -o FILE.ply or --json");
  if (options.tolerance && !(std::isfinite(*options.tolerance) && *options.tolerance > 0))
    throw Usage_error(fmt::format("the tolerance is {}; give --tolerance a positive length", *options.tolerance));
  if (options.tolerance && options.input.empty())
    throw Usage_error("--tolerance is for a MESH; the cells are where they are");
  Given_surface given = read_surface_of(options);
  catch_interrupts();
  Segmentation segmentation = segmented(options, given);
  Result result;
  result.extraction.mesh = std::move(given.mesh);
  result.extraction.patches = std::move(segmentation.faces);
  outputs.write(result);
  segmentation.faces = std::move(result.extraction.patches);
  if (options.json)
    fmt::print("{}\n", json_text(to_json(segmentation, result.extraction.mesh), 2));
  else if (!options.quiet)
    print(segmentation);
  return success;
}

} // namespace CGAL::Extremal_mesh_3::tool
