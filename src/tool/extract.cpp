// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Outputs.h"
#include "Progress_bar.h"
#include "commands.h"
#include "summary_text.h"

#include <CGAL/Extremal_mesh_3/Formula.h>
#include <CGAL/Extremal_mesh_3/Image_function.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <memory>

namespace CGAL::Extremal_mesh_3::tool {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::int64_t default_resolution = 64;
/// More cubes on a side than this are a slip of the finger: the values alone would take days.
constexpr std::int64_t highest_resolution = 20000;

/// What to extract from, and how it is recorded.
struct Input {
  std::unique_ptr<Function_3> function;
  Lattice lattice;
  std::string source, frame;
  Json parameters;
};

Lattice lattice_of(const Extract_options& options, std::int64_t resolution) {
  const std::array<double, 6>& box = *options.box;
  for (std::size_t a = 0; a < 3; ++a) {
    const double low = box[a], high = box[a + 3];
    if (!std::isfinite(low) || !std::isfinite(high))
      throw Usage_error("the numbers of the box must be finite; give --box x0 y0 z0 x1 y1 z1");
    if (!(low < high))
      throw Usage_error(fmt::format("the box is empty: {0}0 = {1} is not less than {0}1 = {2}; give --box x0 y0 z0 x1 "
                                    "y1 z1 with the lower corner first",
                                    "xyz"[a], low, high));
  }
  if (resolution < 1 || resolution > highest_resolution)
    throw Usage_error(
        fmt::format("the resolution is {}; give --resolution a number from 1 to {}", resolution, highest_resolution));
  return make_lattice({box[0], box[1], box[2]}, {box[3], box[4], box[5]}, std::size_t(resolution));
}

Input formula_input(const Extract_options& options) {
  if (!options.box)
    throw Usage_error("a formula needs a box in which to look for its surface; give --box x0 y0 z0 x1 y1 z1");
  if (options.iso || options.sigma)
    throw Usage_error("--iso and --sigma are for images; subtract the value in the formula instead");
  const std::int64_t resolution = options.resolution.value_or(default_resolution);
  Input input;
  input.lattice = lattice_of(options, resolution);
  try {
    input.function = std::make_unique<Formula>(*options.formula);
  } catch (const Formula_error& error) {
    throw Usage_error(fmt::format("the formula cannot be understood: {}", error.what()));
  }
  input.source = *options.formula;
  input.parameters = {{"formula", *options.formula}, {"box", *options.box}, {"resolution", resolution}};
  return input;
}

Input image_input(const Extract_options& options) {
  if (options.box || options.resolution)
    throw Usage_error("--box and --resolution are for formulas; an image is taken whole, at its own resolution");
  if (!options.iso)
    throw Usage_error("an image needs the value that its surface has; give --iso VALUE");
  Image image = read_image(options.input);
  Progress_bar bar("smoothing", options.quiet);
  Image_function_options image_options;
  image_options.iso = *options.iso;
  image_options.sigma = options.sigma.value_or(0);
  image_options.threads = options.threads;
  image_options.progress = bar.progress();
  auto function = std::make_unique<Image_function>(std::move(image), image_options);
  Input input;
  input.lattice = function->lattice();
  input.source = options.input;
  input.frame = "LPS";
  input.parameters = {{"image", options.input}, {"iso", *options.iso}, {"sigma", function->sigma()}};
  input.function = std::move(function);
  return input;
}

Input input_of(const Extract_options& options) {
  if (options.formula && !options.input.empty())
    throw Usage_error("there is an input file and a formula; give one of them");
  if (!options.formula && options.input.empty())
    throw Usage_error("there is nothing to extract from; give an image, or --formula \"…\" and --box");
  return options.formula ? formula_input(options) : image_input(options);
}

} // namespace

int extract(const Extract_options& options) {
  if (options.threads < 0)
    throw Usage_error(fmt::format("the number of threads is {}; give --threads 0 for all cores", options.threads));
  const Outputs outputs(options);
  Input input = input_of(options);
  catch_interrupts();

  Extraction_options extraction_options;
  extraction_options.threads = options.threads;
  extraction_options.max_level = options.max_level.value_or(options.formula ? 14 : 8);
  // The noise of an image makes lines that nearly touch everywhere; to settle them all would take most of the time.
  extraction_options.max_line_level =
      options.max_line_level.value_or(options.formula ? extraction_options.max_level : 2);
  extraction_options.patches = outputs.need_patches();
  Result result;
  {
    Progress_bar bar("surface", options.quiet);
    extraction_options.progress = bar.progress();
    result.surface = make_implicit_cells(*input.function, input.lattice, extraction_options);
  }
  {
    Progress_bar bar("lines", options.quiet);
    extraction_options.progress = bar.progress();
    result.extraction = extract_extremal_mesh(*input.function, result.surface, extraction_options);
  }
  input.parameters["max_level"] = extraction_options.max_level;
  input.parameters["max_line_level"] = extraction_options.max_line_level;
  result.extraction.mesh.set_provenance(
      input.source, input.parameters.dump(-1, ' ', false, Json::error_handler_t::replace), input.frame);
  result.checks = Extremal_mesh_3::check(result.extraction.mesh);
  outputs.write(result);
  if (!options.quiet)
    fmt::print("{}", summary_text(result.extraction.mesh, result.checks, &result.extraction.report));
  return success;
}

} // namespace CGAL::Extremal_mesh_3::tool
