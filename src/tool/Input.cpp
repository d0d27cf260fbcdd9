// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Input.h"

#include "Progress_bar.h"

#include <CGAL/Extremal_mesh_3/Formula.h>
#include <CGAL/Extremal_mesh_3/Image_function.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace CGAL::Extremal_mesh_3::tool {

namespace {

constexpr std::int64_t default_resolution = 64;
/// More cubes on a side than this are a slip of the finger: the values alone would take days.
constexpr std::int64_t highest_resolution = 20000;

/// With more the neighbourhood is the whole mesh.
constexpr int most_rings = 1000;

/// How often a cell may be divided.
constexpr int function_level = 20;
constexpr int image_level = 8;
/// The noise of an image makes lines that nearly touch everywhere; to settle them all would take most of the time.
constexpr int image_line_level = 2;
constexpr int mesh_level = 8;

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

void refuse_mesh_options(const Extract_options& options) {
  if (options.radius || options.rings || options.weld)
    throw Usage_error("--radius, --rings and --weld are for meshes");
}

Input formula_input(const Extract_options& options, const Memory_limit& limit) {
  if (!options.box)
    throw Usage_error("a formula needs a box in which to look for its surface; give --box x0 y0 z0 x1 y1 z1");
  if (options.iso || options.sigma)
    throw Usage_error("--iso and --sigma are for images; subtract the value in the formula instead");
  refuse_mesh_options(options);
  if (options.mesher && *options.mesher != "grid" && *options.mesher != "cgal")
    throw Usage_error(fmt::format("'{}' is not a mesher; give --mesher grid or cgal", *options.mesher));
  const std::int64_t resolution = options.resolution.value_or(default_resolution);
  Input input;
  input.max_level = function_level;
  input.lattice = lattice_of(options, resolution);
  const std::array<std::size_t, 3>& size = input.lattice.size;
  constexpr double slices = 2; // of values, at least, are known at a time
  limit.require(slices * sizeof(double) * double(size[0]) * double(size[1]),
                fmt::format("a lattice of {} x {} x {} nodes", size[0], size[1], size[2]));
  try {
    input.function = std::make_unique<Formula>(*options.formula);
  } catch (const Formula_error& error) {
    throw Usage_error(fmt::format("the formula cannot be understood: {}", error.what()));
  }
  input.source = *options.formula;
  input.parameters = {{"formula", *options.formula}, {"box", *options.box}, {"resolution", resolution}};
  if (options.mesher)
    input.parameters["mesher"] = *options.mesher;
  input.use_cgal_mesher = options.mesher == "cgal";
  return input;
}

Input image_input(const Extract_options& options, const Memory_limit& limit) {
  if (options.box || options.resolution || options.mesher)
    throw Usage_error(
        "--box, --resolution and --mesher are for formulas; an image is taken whole, at its own resolution");
  refuse_mesh_options(options);
  if (!options.iso)
    throw Usage_error(
        fmt::format("'{}' is taken for an image, as its name does not end like that of a mesh (.off .obj .ply "
                    ".stl .om); an image needs the value that its surface has; give --iso VALUE",
                    options.input));
  Image image = read_image(options.input, {.memory_limit = limit.bytes(), .scratch_folder = {}});
  double voxel = 0; // its largest side: what registration takes for the same place
  for (const Vector& step : image.lattice.step)
    voxel = std::max(voxel, std::hypot(step[0], step[1], step[2]));
  Progress_bar bar("smoothing", options.quiet);
  Image_function_options image_options;
  image_options.iso = *options.iso;
  image_options.sigma = options.sigma.value_or(0);
  image_options.threads = options.threads;
  image_options.progress = bar.progress();
  auto function = std::make_unique<Image_function>(std::move(image), image_options);
  Input input;
  input.max_level = image_level;
  input.max_line_level = image_line_level;
  input.lattice = function->lattice();
  input.source = options.input;
  input.frame = "LPS";
  input.parameters = {{"image", options.input}, {"iso", *options.iso}, {"sigma", function->sigma()}, {"voxel", voxel}};
  input.function = std::move(function);
  return input;
}

Input mesh_input(const Extract_options& options, const Memory_limit& limit) {
  if (options.box || options.resolution || options.mesher || options.iso || options.sigma)
    throw Usage_error(
        "--box, --resolution, --mesher, --iso and --sigma are for formulas and images; a mesh is taken as "
        "it is");
  if (options.certify)
    throw Usage_error("--certify is for formulas and images; what lies between the vertices of a mesh is not known");
  if (options.line_tolerance)
    throw Usage_error(
        "--line-tolerance is for formulas and images; the lines on a mesh are straight between its edges");
  if (options.radius && options.rings)
    throw Usage_error("there are a radius and a number of rings; give one of --radius and --rings");
  if (options.radius && !(std::isfinite(*options.radius) && *options.radius > 0))
    throw Usage_error(fmt::format("the radius is {}; give --radius a positive length", *options.radius));
  if (options.rings && (*options.rings < 1 || *options.rings > most_rings))
    throw Usage_error(
        fmt::format("the number of rings is {}; give --rings a number from 1 to {}", *options.rings, most_rings));
  std::error_code error;
  if (const std::uintmax_t size = std::filesystem::file_size(options.input, error); !error) {
    constexpr double content_and_polygons = 3; // bytes per byte of the most compact file, at least
    limit.require(content_and_polygons * double(size), fmt::format("to read '{}'", options.input));
  }
  Input input;
  input.mesh = read_mesh(options.input, {.weld_tolerance = options.weld});
  input.max_level = mesh_level;
  input.source = options.input;
  input.parameters = {{"mesh", options.input}};
  if (options.weld)
    input.parameters["weld"] = *options.weld;
  return input;
}

} // namespace

Input read_input(const Extract_options& options, const Memory_limit& limit) {
  if (options.formula && !options.input.empty())
    throw Usage_error("there is an input file and a formula; give one of them");
  if (!options.formula && options.input.empty())
    throw Usage_error("there is nothing to extract from; give an image, a mesh, or --formula \"…\" and --box");
  if (options.line_tolerance && !(std::isfinite(*options.line_tolerance) && *options.line_tolerance >= 0))
    throw Usage_error(
        fmt::format("the line tolerance is {}; give --line-tolerance a length of 0 or more", *options.line_tolerance));
  if (options.min_area && !(std::isfinite(*options.min_area) && *options.min_area >= 0))
    throw Usage_error(fmt::format("the least area is {}; give --min-area an area of 0 or more", *options.min_area));
  if (options.min_area && options.largest)
    throw Usage_error("the largest component is one; give one of --largest and --min-area");
  return options.formula               ? formula_input(options, limit)
         : is_mesh_file(options.input) ? mesh_input(options, limit)
                                       : image_input(options, limit);
}

} // namespace CGAL::Extremal_mesh_3::tool
