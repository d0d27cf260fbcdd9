// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../io/json_text.h"
#include "Input.h"
#include "Outputs.h"
#include "Progress_bar.h"
#include "commands.h"
#include "summary_text.h"

#include <CGAL/Extremal_mesh_3/keep_components.h>
#include <CGAL/Extremal_mesh_3/make_cgal_cells.h>

#include <fmt/format.h>

#include <utility>

namespace CGAL::Extremal_mesh_3::tool {

namespace {

/// cells of the surface f = 0.
/// \param report  is filled with what is known about the surface
Cell_complex cells_of(const Input& input, const Extraction_options& options, Surface_report& report) {
  if (!input.use_cgal_mesher)
    return make_implicit_cells(*input.function, input.lattice, options, &report);
  Cgal_mesh_options mesh_options;
  mesh_options.threads = options.threads;
  mesh_options.progress = options.progress;
  return make_cgal_cells(*input.function, input.lattice, mesh_options);
}

/// leaves out the components of the surface that are not asked for, and tells so in the parameters.
void choose_components(const Extract_options& told, Input& input, Cell_complex& surface) {
  surface = keep_components(std::move(surface), {told.largest, told.min_area.value_or(0)});
  if (told.largest)
    input.parameters["largest"] = true;
  if (told.min_area)
    input.parameters["min_area"] = *told.min_area;
}

/// the cells of the surface f = 0, then its extremal mesh.
void extract_from_function(Input& input, const Extract_options& told, Extraction_options options, Result& result) {
  Surface_report report;
  {
    Progress_bar bar("surface", told.quiet);
    options.progress = bar.progress();
    result.surface = cells_of(input, options, report);
  }
  choose_components(told, input, result.surface);
  Progress_bar bar("lines", told.quiet);
  options.progress = bar.progress();
  result.extraction = extract_extremal_mesh(*input.function, result.surface, options);
  result.extraction.report.surface = report;
}

/// the shapes at the vertices of a mesh, then its extremal mesh.
void extract_from_mesh(Input& input, const Extract_options& told, Extraction_options options, Result& result) {
  result.surface = std::move(input.mesh.cells);
  result.repairs = input.mesh.repairs;
  choose_components(told, input, result.surface);
  Fit fit;
  {
    Progress_bar bar("fitting", told.quiet);
    Fit_options fit_options;
    fit_options.radius = told.radius.value_or(0);
    fit_options.rings = told.rings.value_or(0);
    fit_options.threads = told.threads;
    fit_options.progress = bar.progress();
    fit = fit_vertex_shapes(result.surface, fit_options);
  }
  result.fit = fit.report;
  if (told.radius)
    input.parameters["radius"] = *told.radius;
  if (told.rings)
    input.parameters["rings"] = *told.rings;
  input.parameters["radii_used"] = {fit.report.radius_min, fit.report.radius_median, fit.report.radius_max};
  Progress_bar bar("lines", told.quiet);
  options.progress = bar.progress();
  result.extraction = extract_extremal_mesh(result.surface, fit.shapes, options);
}

} // namespace

int extract(const Extract_options& options) {
  const Memory_limit limit(options.memory_limit);
  const Outputs outputs(options);
  Input input = read_input(options, limit);
  catch_interrupts();

  Extraction_options extraction_options;
  extraction_options.threads = options.threads;
  extraction_options.max_level = options.max_level.value_or(input.max_level);
  extraction_options.max_line_level =
      options.max_line_level.value_or(input.max_line_level.value_or(extraction_options.max_level));
  extraction_options.line_tolerance = options.line_tolerance.value_or(0);
  extraction_options.certify = extraction_options.prove_surface = options.certify;
  extraction_options.patches = outputs.need_patches();
  Result result;
  if (input.function)
    extract_from_function(input, options, extraction_options, result);
  else
    extract_from_mesh(input, options, extraction_options, result);

  input.parameters["max_level"] = extraction_options.max_level;
  input.parameters["max_line_level"] = extraction_options.max_line_level;
  if (options.line_tolerance)
    input.parameters["line_tolerance"] = *options.line_tolerance;
  result.extraction.mesh.set_provenance(input.source, json_text(input.parameters), input.frame);
  result.checks = Extremal_mesh_3::check(result.extraction.mesh);
  outputs.write(result);
  if (options.json)
    fmt::print("{}\n", report_json(result));
  else if (!options.quiet)
    fmt::print("{}", result_text(result));
  return success;
}

} // namespace CGAL::Extremal_mesh_3::tool
