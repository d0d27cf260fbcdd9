// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../io/json_text.h"
#include "Outputs.h"
#include "Progress_bar.h"
#include "commands.h"
#include "query_json.h"
#include "summary_text.h"

#include <CGAL/Extremal_mesh_3/io.h>
#include <CGAL/Extremal_mesh_3/persistence_diagram.h>
#include <CGAL/Extremal_mesh_3/simplify.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace CGAL::Extremal_mesh_3::tool {

namespace {

constexpr const char* criteria = "--threshold, --cells, --vertices, --level or --gap";

/// \throws Usage_error if the options do not belong together or are out of their range
void validate(const Simplify_options& options, const Outputs& outputs) {
  const int given = int(options.threshold.has_value()) + int(options.number_of_cells.has_value()) +
                    int(options.number_of_vertices.has_value()) + int(options.level.has_value()) + int(options.gap);
  if (given > 1)
    throw Usage_error(fmt::format("there are {} ways to say how far to simplify; give one of {}", given, criteria));
  if (given == 0 && !outputs.empty())
    throw Usage_error(fmt::format("it is not said how far to simplify; give one of {}", criteria));
  if (outputs.empty() && options.persistence.empty() && options.hierarchy.empty())
    throw Usage_error("there is nothing to write; give -o FILE, --persistence FILE or --hierarchy FILE");
  if (options.measure != "persistence" && options.measure != "life-time")
    throw Usage_error(
        fmt::format("the measure '{}' is not known; give --measure persistence or life-time", options.measure));
  if (options.threshold && !(*options.threshold >= 0))
    throw Usage_error(
        fmt::format("the threshold is {}; give --threshold a persistence of at least 0", *options.threshold));
  if (options.keep_crest && !(*options.keep_crest >= 0))
    throw Usage_error(fmt::format("the strength is {}; give --keep-crest a number of at least 0", *options.keep_crest));
  const auto refuse_negative = [](const std::optional<std::int64_t>& n, const char* what) {
    if (n && *n < 0)
      throw Usage_error(fmt::format("{} is {}; give a number of at least 0", what, *n));
  };
  refuse_negative(options.number_of_cells, "the number of cells");
  refuse_negative(options.number_of_vertices, "the number of vertices");
  refuse_negative(options.level, "the level");
  if (!options.cells.empty() && options.patches.empty())
    throw Usage_error("the patches to be written must come from somewhere; give --surface the cells.ply that 'extract "
                      "--cells' wrote");
  if (!options.persistence.empty() && !is_persistence_diagram_file(options.persistence))
    throw Usage_error(fmt::format("the extension of '{}' is not known; give --persistence an .svg, a .png or a .csv",
                                  options.persistence));
}

/// without a criterion, as for a diagram only, the level at the gap.
std::size_t level_of(const Simplification& simplification, const Simplify_options& options) {
  if (options.threshold)
    return simplification.level_of_persistence(*options.threshold);
  if (options.number_of_cells)
    return simplification.level_of_cells(std::size_t(*options.number_of_cells));
  if (options.number_of_vertices)
    return simplification.level_of_vertices(std::size_t(*options.number_of_vertices));
  if (!options.level)
    return simplification.level_at_gap();
  if (std::size_t(*options.level) >= simplification.number_of_levels())
    throw Usage_error(fmt::format("there is no level {}; give --level a number up to {}", *options.level,
                                  simplification.number_of_levels() - 1));
  return std::size_t(*options.level);
}

std::string counts(std::size_t vertices, std::size_t edges, std::size_t cells) {
  return fmt::format("{} vertices, {} edges, {} cells", vertices, edges, cells);
}

std::string step_text(const std::string& name, const Simplification& simplification, std::size_t step,
                      const Simplify_options& options) {
  if (step >= simplification.steps().size())
    return fmt::format("{:<10} none\n", name);
  const Simplification_step& s = simplification.steps()[step];
  return fmt::format("{:<10} {} of {} {:.4g}\n", name, to_string(s.operation),
                     options.measure == "life-time" ? "life time" : "persistence", s.persistence);
}

/// null if there is no such step.
Json json_of_step(const Simplification& simplification, std::size_t step) {
  if (step >= simplification.steps().size())
    return nullptr;
  const Simplification_step& s = simplification.steps()[step];
  return {{"operation", to_string(s.operation)}, {"persistence", s.persistence}, {"point", s.point}};
}

/// what is printed with --json: as `info --json`, and the level.
std::string level_json(const Simplification& simplification, std::size_t level, const Result& result) {
  Json json = Json::parse(report_json(result));
  json.erase("report"); // of an extraction
  json["level"] = {{"number", level},
                   {"levels", simplification.number_of_levels()},
                   {"at_gap", simplification.level_at_gap()},
                   {"last_step", json_of_step(simplification, level - 1)},
                   {"next_step", json_of_step(simplification, level)}};
  return json_text(json, 2);
}

} // namespace

int simplify(const Simplify_options& options) {
  Outputs outputs(options);
  validate(options, outputs);
  outputs.reserve(options.persistence);
  outputs.reserve(options.hierarchy);
  Extremal_mesh mesh = read_graphml(options.file);
  const Cell_patches patches = read_patches_of(options.patches, mesh, options.file);
  catch_interrupts();

  const std::string before = counts(mesh.number_of_vertices(), mesh.number_of_edges(), mesh.number_of_cells());
  Simplification_options simplification_options;
  if (options.measure == "life-time")
    simplification_options.measure = Simplification_measure::life_time;
  if (options.keep_crest)
    simplification_options.keep_crest = *options.keep_crest;
  const Simplification simplification = [&] {
    try {
      return Simplification(std::move(mesh), simplification_options);
    } catch (const std::invalid_argument& error) {
      throw Io_error(fmt::format("'{}' cannot be simplified: {}", options.file, error.what()));
    }
  }();
  const std::size_t level = level_of(simplification, options);
  stop_if_interrupted();
  Result result;
  result.extraction.mesh = simplification.mesh_at(level);
  if (!patches.cell.empty())
    result.extraction.patches = simplification.patches_at(level, patches);
  result.checks = Extremal_mesh_3::check(result.extraction.mesh);
  outputs.write(result);
  if (!options.persistence.empty())
    write_persistence_diagram(options.persistence, simplification, level);
  if (!options.hierarchy.empty())
    write_hierarchy(options.hierarchy, simplification);
  if (options.json)
    fmt::print("{}\n", level_json(simplification, level, result));
  if (options.quiet || options.json)
    return success;

  const Extremal_mesh& simple = result.extraction.mesh;
  fmt::print("{:<10} {}\n", "before", before);
  fmt::print("{:<10} {}\n", "after",
             counts(simple.number_of_vertices(), simple.number_of_edges(), simple.number_of_cells()));
  const auto tell_if_unreached = [](std::size_t reached, const std::optional<std::int64_t>& wanted, const char* what) {
    if (wanted && reached > std::size_t(*wanted))
      fmt::print("{:<10} {} {} cannot be reached\n", "note", *wanted, what);
  };
  tell_if_unreached(simple.number_of_cells(), options.number_of_cells, "cells");
  tell_if_unreached(simple.number_of_vertices(), options.number_of_vertices, "vertices");
  fmt::print("{:<10} {} of {}, {} at the gap\n", "level", level, simplification.number_of_levels() - 1,
             simplification.level_at_gap());
  fmt::print("{}{}", step_text("last step", simplification, level - 1, options),
             step_text("next step", simplification, level, options));
  fmt::print("{}", summary_text(simple, result.checks, nullptr));
  return success;
}

} // namespace CGAL::Extremal_mesh_3::tool
