// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../io/json_text.h"
#include "Progress_bar.h"
#include "surface_commands.h"

#include <CGAL/Extremal_mesh_3/reduce.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <utility>

namespace CGAL::Extremal_mesh_3::tool {

namespace {

using Json = nlohmann::ordered_json;

void validate(const Reduce_options& options) {
  if (options.number_of_faces && *options.number_of_faces < 0)
    throw Usage_error(
        fmt::format("the number of triangles is {}; give --faces a number of at least 0", *options.number_of_faces));
  if (options.keep_crest && !(*options.keep_crest >= 0))
    throw Usage_error(fmt::format("the strength is {}; give --keep-crest a number of at least 0", *options.keep_crest));
  if (options.line_tolerance && !(std::isfinite(*options.line_tolerance) && *options.line_tolerance >= 0))
    throw Usage_error(
        fmt::format("the line tolerance is {}; give --line-tolerance a length of 0 or more", *options.line_tolerance));
}

Reduction reduced(const Reduce_options& options, const Given_surface& given) {
  Progress_bar bar("reducing", options.quiet);
  Reduction_options how;
  if (options.number_of_faces)
    how.number_of_faces = std::size_t(*options.number_of_faces);
  how.keep_crest = options.keep_crest.value_or(how.keep_crest);
  how.line_tolerance = options.line_tolerance;
  how.threads = options.threads;
  how.progress = bar.progress();
  try {
    return reduce(given.mesh, given.patches, how);
  } catch (const std::invalid_argument& error) {
    throw Io_error(fmt::format("'{}' cannot be reduced: {}", options.patches, error.what()));
  }
}

Json to_json(const Reduction& result, std::size_t faces) {
  return {{"faces_before", result.faces_before},
          {"faces", faces},
          {"kept_edges", result.kept_edges},
          {"kept_length", result.kept_length},
          {"line_segments_before", result.segments_before},
          {"line_segments", result.segments},
          {"line_deviation", result.line_deviation},
          {"surface_deviation", result.surface_deviation},
          {"euler_characteristic_before", result.euler_characteristic_before},
          {"euler_characteristic", result.euler_characteristic}};
}

void print(const Reduction& result, std::size_t faces, const std::optional<std::int64_t>& wanted) {
  fmt::print("{:<10} {}  of {}\n", "faces", faces, result.faces_before);
  if (wanted && faces > std::size_t(*wanted))
    fmt::print("{:<10} {} faces cannot be reached; keep fewer lines, or give them a larger --line-tolerance\n", "note",
               *wanted);
  fmt::print("{:<10} {} edges of length {:.4g}, as {} segments of {}\n", "kept", result.kept_edges, result.kept_length,
             result.segments, result.segments_before);
  fmt::print("{:<10} {:.3g}  of the lines at most, {:.3g} of the surface\n", "deviation", result.line_deviation,
             result.surface_deviation);
  fmt::print("{:<10} {}  as before\n", "Euler", result.euler_characteristic);
}

} // namespace

int reduce(const Reduce_options& options) {
  const Outputs outputs(options, Content::surface);
  if (outputs.empty() && !options.json)
    throw Usage_error("there is nothing to write; give -o FILE.ply or --json");
  validate(options);
  Given_surface given = read_surface_of(options);
  catch_interrupts();
  Reduction reduction = reduced(options, given);
  const std::size_t faces = reduction.faces.cell.size();
  Result result;
  result.extraction.mesh = std::move(given.mesh);
  result.extraction.patches = std::move(reduction.faces);
  outputs.write(result);
  if (options.json)
    fmt::print("{}\n", json_text(to_json(reduction, faces), 2));
  else if (!options.quiet)
    print(reduction, faces, options.number_of_faces);
  return success;
}

} // namespace CGAL::Extremal_mesh_3::tool
