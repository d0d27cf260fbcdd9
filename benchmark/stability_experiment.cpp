// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which part of the extremal mesh is found again in a second image of the same thing? The image is moved, resampled and
// gets noise; both extremal meshes are simplified to the same levels, and what has a partner in the other one is counted.

#include <CGAL/Extremal_mesh_3/Image_function.h>
#include <CGAL/Extremal_mesh_3/io.h>
#include <CGAL/Extremal_mesh_3/simplify.h>

#include "../test/correspondence.h"
#include "../test/resampled_image.h"

#include <fmt/format.h>

#include <charconv>
#include <cstdio>
#include <exception>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

using namespace CGAL::Extremal_mesh_3;
using correspondence::Shares;

namespace {

constexpr std::string_view usage =
    "usage: stability_experiment IMAGE --iso V --sigma MM [--degrees 20] [--translation VOXELS] [--noise 0.02]\n"
    "                            [--seed N] [--tolerance VOXELS] -o curve.csv\n"
    "example: stability_experiment data/skull_2.9.nrrd --iso 2.9 --sigma 4 -o curve.csv\n";

struct Usage_error : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct Options {
  std::string image, output;
  std::optional<double> iso, sigma;
  double degrees = 20;
  double translation = 10; ///< in largest sides of a voxel
  double noise = 0.02;     ///< deviation, in contrasts between above and below the iso value
  double tolerance = 1;    ///< in largest sides of a voxel
  unsigned seed = 1;
};

template <typename Number> Number number(const std::string& option, const std::string& text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size())
    throw Usage_error(fmt::format("{}: expected a number, not \"{}\"", option, text));
  return value;
}

Options read_options(int argc, char** argv) {
  Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string name = argv[i];
    if (!name.starts_with("-")) {
      if (!options.image.empty())
        throw Usage_error(fmt::format("expected one image, not \"{}\" as well", name));
      options.image = name;
      continue;
    }
    if (++i == argc)
      throw Usage_error(fmt::format("{}: expected a value", name));
    const std::string value = argv[i];
    if (name == "-o")
      options.output = value;
    else if (name == "--iso")
      options.iso = number<double>(name, value);
    else if (name == "--sigma")
      options.sigma = number<double>(name, value);
    else if (name == "--degrees")
      options.degrees = number<double>(name, value);
    else if (name == "--translation")
      options.translation = number<double>(name, value);
    else if (name == "--noise")
      options.noise = number<double>(name, value);
    else if (name == "--tolerance")
      options.tolerance = number<double>(name, value);
    else if (name == "--seed")
      options.seed = number<unsigned>(name, value);
    else
      throw Usage_error(fmt::format("unknown option {}", name));
  }
  if (options.image.empty() || options.output.empty() || !options.iso || !options.sigma)
    throw Usage_error("expected an image, --iso, --sigma and -o");
  return options;
}

/// a turn about the first, then about the second axis through the image's centre, then a translation along the
/// diagonal.
surfaces::Motion motion_of(const Lattice& lattice, double degrees, double translation) {
  const double angle = degrees * std::numbers::pi / 180, c = std::cos(angle), s = std::sin(angle);
  surfaces::Motion motion;
  motion.R = {Vector{c, s * s, c * s}, Vector{0, c, -s}, Vector{-s, c * s, c * c}}; // R_y R_x
  const auto& n = lattice.size;
  const Point centre = lattice.node(0.5 * double(n[0] - 1), 0.5 * double(n[1] - 1), 0.5 * double(n[2] - 1));
  const Vector turned = motion.turned(centre);
  for (std::size_t a = 0; a < 3; ++a)
    motion.translation[a] = centre[a] - turned[a] + translation / std::sqrt(3.0);
  return motion;
}

/// An image's extremal mesh, all its simplifications, and points all over its surface.
struct Result {
  Simplification simplification;
  double root_area; ///< of the surface: persistence / root_area is a change of curvature
  std::vector<Point> surface;

  static Result of(Image&& image, const Options& options) {
    Image_function_options image_options;
    image_options.iso = *options.iso;
    image_options.sigma = *options.sigma;
    const Image_function f(std::move(image), image_options);
    Extraction_options extraction_options;
    extraction_options.max_level = 8; // as the tool has them for images
    extraction_options.max_line_level = 2;
    Cell_complex cells = make_implicit_cells(f, f.lattice(), extraction_options);
    Extremal_mesh mesh = extract_extremal_mesh(f, cells, extraction_options).mesh;
    const double area = mesh.surface().area;
    return {Simplification(std::move(mesh)), std::sqrt(area), std::move(cells.points)};
  }
};

struct Level {
  std::string_view series;
  std::size_t level_a = 0, level_b = 0;
  std::size_t among_a = level_a, among_b = level_b; ///< of what partners are sought among
};

/// levels of `a` with a half, a quarter, … of its cells, and of `b` with the same threshold, or as many cells. In the series
/// "half" partners are sought among what is above half the threshold: what changes by less than a quarter of it cannot
/// have fallen below that.
std::vector<Level> levels_of(const Result& a, const Result& b) {
  std::vector<Level> by_threshold{{"threshold"}}, by_cells{{"cells"}}, by_half{{"half"}};
  const auto& steps = a.simplification.steps();
  // The second result is first brought to as many cells as the first one has.
  by_cells[0].level_b = b.simplification.level_of_cells(a.simplification.mesh_at(0).number_of_cells());
  by_cells[0].among_b = by_cells[0].level_b;
  for (double cells = double(a.simplification.mesh_at(0).number_of_cells()) / 2; cells >= 8; cells /= 2) {
    const std::size_t level = a.simplification.level_of_cells(std::size_t(cells));
    if (level == by_cells.back().level_a || steps[level - 1].cells > std::size_t(cells))
      break;
    by_cells.push_back({"cells", level, b.simplification.level_of_cells(std::size_t(cells))});
    const double threshold = steps[level - 1].persistence;
    const auto level_a = [&](double t) { return a.simplification.level_of_persistence(t); };
    const auto level_b = [&](double t) { return b.simplification.level_of_persistence(t / a.root_area * b.root_area); };
    by_threshold.push_back({"threshold", level_a(threshold), level_b(threshold)});
    by_half.push_back({"half", level_a(threshold), level_b(threshold), level_a(threshold / 2), level_b(threshold / 2)});
  }
  by_threshold.insert(by_threshold.end(), by_half.begin(), by_half.end());
  by_threshold.insert(by_threshold.end(), by_cells.begin(), by_cells.end());
  return by_threshold;
}

/// persistence / √area of the last step before a level, 1 / mm.
double threshold_at(const Result& r, std::size_t level) {
  return level == 0 ? 0 : r.simplification.steps()[level - 1].persistence / r.root_area;
}

/// Is a point inside both volumes?
class Inside {
public:
  Inside(const Lattice& lattice, double margin) : index_(lattice), size_(lattice.size) {
    for (std::size_t a = 0; a < 3; ++a)
      margin_[a] = margin / surfaces::length(lattice.step[a]);
  }
  /// \param p  in the place of the first image; the second volume holds all of the first
  bool operator()(const Point& p) const {
    const Point x = index_(p);
    for (std::size_t a = 0; a < 3; ++a)
      if (x[a] < margin_[a] || x[a] > double(size_[a] - 1) - margin_[a])
        return false;
    return true;
  }

private:
  resampled_image::Lattice_index index_;
  std::array<std::size_t, 3> size_;
  std::array<double, 3> margin_;
};

void run(const Options& options) {
  check_writable(options.output);
  Image image = read_image(options.image);
  const Lattice lattice = image.lattice;
  const double voxel = resampled_image::largest_spacing(lattice);
  const surfaces::Motion motion = motion_of(lattice, options.degrees, options.translation * voxel);
  const float lowest = *std::min_element(image.voxels.begin(), image.voxels.end());
  const double contrast = resampled_image::contrast(image, *options.iso);
  Image second = resampled_image::moved(image, motion, lowest);
  resampled_image::add_noise(second, options.noise * contrast, options.seed);
  const Result a = Result::of(std::move(image), options), b = Result::of(std::move(second), options);

  // Where the image ends the surface does, or is closed by a face: the Gaussian carries that to a distance of about 3σ.
  const double margin = std::max(3 * voxel, 3 * *options.sigma), tolerance = options.tolerance * voxel;
  const Inside inside(lattice, margin);
  const auto back = [&](const Point& p) { return motion.back(p); };
  const Vector off{10 / std::sqrt(3.0), 10 / std::sqrt(3.0), -10 / std::sqrt(3.0)};
  const correspondence::Way there{motion, inside}, home{back, [&](const Point&p) { return inside(motion.back(p)); }},
      wrong{[&](const Point&p) { return surfaces::along(motion(p), 1, off); }, inside};
  // 20000 points give shares to 1 %; taken from all of the surface, in the order of the lattice.
  const auto thinned = [](const std::vector<Point>& all, const auto& counts) {
    std::vector<Point> some;
    for (std::size_t i = 0; i < all.size(); i += 1 + all.size() / 20000)
      if (counts(all[i]))
        some.push_back(all[i]);
    return some;
  };
  const std::vector<Point> surface_a = thinned(a.surface, inside), surface_b = thinned(b.surface, home.counts);

  std::string csv =
      fmt::format("# {}: iso {}, sigma {} mm, largest side of a voxel {} mm\n"
                  "# second image: turned by {} degrees about the first and about the second axis, moved by {} voxels "
                  "along the diagonal; cubic "
                  "spline through the voxels, {} outside; noise of {} times the contrast {:.5g} (mean above iso minus "
                  "mean below), seed {}\n"
                  "# counted: what is more than {} mm inside the image; within {} mm; *_chance: by a motion wrong by "
                  "10 mm; *_anywhere: for points "
                  "anywhere on the surface\n"
                  "series,threshold_per_mm,level_a,level_b,vertices_a,edges_a,cells_a,vertices_b,edges_b,cells_b",
                  options.image, *options.iso, *options.sigma, voxel, options.degrees, options.translation, lowest,
                  options.noise, contrast, options.seed, margin, tolerance);
  for (const auto name : correspondence::names)
    csv += fmt::format(",{0}_ab,{0}_ba,{0}_mean,{0}_chance,{0}_above_chance", name);
  csv += ",extremal_points_anywhere,umbilics_1_anywhere,umbilics_3_anywhere,vertices_anywhere,length_anywhere\n";

  fmt::print("{:9} {:>9} {:>13} {:>13} | {:>5} {:>5} {:>5} {:>8} {:>8} | {:>5} {:>5} {:>6} | {:>6} {:>8}\n", "series",
             "1/mm", "cells", "vertices", "EP", "U1", "U3", "all", "(chance)", "edges", "ends", "(ch.)", "length",
             "(chance)");
  for (const Level& level : levels_of(a, b)) {
    const Extremal_mesh mesh_a = a.simplification.mesh_at(level.level_a),
                        mesh_b = b.simplification.mesh_at(level.level_b);
    const Extremal_mesh among_a = a.simplification.mesh_at(level.among_a),
                        among_b = b.simplification.mesh_at(level.among_b);
    const correspondence::Neighbourhoods near_a(among_a, tolerance), near_b(among_b, tolerance);
    const Shares ab = shares(mesh_a, near_b, there), ba = shares(mesh_b, near_a, home),
                 by_chance = shares(mesh_a, near_b, wrong), anywhere_b = chance(mesh_a, near_b, there, surface_b),
                 anywhere_a = chance(mesh_b, near_a, home, surface_a);
    csv += fmt::format("{},{},{},{},{},{},{},{},{},{}", level.series, threshold_at(a, level.level_a), level.level_a,
                       level.level_b, mesh_a.number_of_vertices(), mesh_a.number_of_edges(), mesh_a.number_of_cells(),
                       mesh_b.number_of_vertices(), mesh_b.number_of_edges(), mesh_b.number_of_cells());
    const auto mean = [](const Shares& x, const Shares& y, std::size_t m) { return (x[m].value() + y[m].value()) / 2; };
    for (std::size_t m = 0; m < ab.size(); ++m)
      csv += fmt::format(",{:.4f},{:.4f},{:.4f},{:.4f},{:.4f}", ab[m].value(), ba[m].value(), mean(ab, ba, m),
                         by_chance[m].value(), mean(ab, ba, m) - by_chance[m].value());
    for (const std::size_t m : {correspondence::extremal_points, correspondence::umbilics_1, correspondence::umbilics_3,
                                correspondence::vertices, correspondence::length})
      csv += fmt::format(",{:.4f}", mean(anywhere_a, anywhere_b, m));
    csv += '\n';
    const auto percent = [&](std::size_t m) { return 100 * mean(ab, ba, m); };
    fmt::print("{:9} {:9.3g} {:6}/{:6} {:6}/{:6} | {:5.1f} {:5.1f} {:5.1f} {:8.1f} {:8.1f} | {:5.1f} {:5.1f} {:6.1f} | "
               "{:6.1f} {:8.1f}\n",
               level.series, threshold_at(a, level.level_a), mesh_a.number_of_cells(), mesh_b.number_of_cells(),
               mesh_a.number_of_vertices(), mesh_b.number_of_vertices(), percent(0), percent(1), percent(2),
               percent(correspondence::vertices), 100 * mean(anywhere_a, anywhere_b, correspondence::vertices),
               percent(correspondence::edges), percent(correspondence::edges_with_ends),
               100 * by_chance[correspondence::edges].value(), percent(correspondence::length),
               100 * mean(anywhere_a, anywhere_b, correspondence::length));
    std::fflush(stdout);
  }
  write_text_file(options.output, csv);
}

} // namespace

int main(int argc, char** argv) {
  try {
    run(read_options(argc, argv));
    return 0;
  } catch (const Usage_error& error) {
    fmt::print(stderr, "stability_experiment: {}\n{}", error.what(), usage);
    return 2;
  } catch (const std::exception& error) {
    fmt::print(stderr, "stability_experiment: {}\n", error.what());
    return 1;
  }
}
