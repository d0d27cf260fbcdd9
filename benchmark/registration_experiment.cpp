// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Are two images of the same thing registered by their extremal meshes, and how exactly? Each image is moved by random
// motions, resampled with another spacing and other axes, and gets noise; what `register_extremal_meshes()` finds is compared
// with what was done.

#include <CGAL/Extremal_mesh_3/Image_function.h>
#include <CGAL/Extremal_mesh_3/extract_extremal_mesh.h>
#include <CGAL/Extremal_mesh_3/io.h>
#include <CGAL/Extremal_mesh_3/register.h>

#include "../test/ellipsoid_image.h"
#include "../test/resampled_image.h"

#include <fmt/format.h>

#include <charconv>
#include <chrono>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

using namespace CGAL::Extremal_mesh_3;

namespace {

constexpr std::string_view usage =
    "usage: registration_experiment (IMAGE --iso V | --surfaces) --sigma MM [--motions 20] [--first SEED] [--noise "
    "0.02]\n"
    "                               [--cut | --cut-one] [--keep FOLDER | --graphs FOLDER] -o results.csv\n"
    "--surfaces: random ellipsoids instead of an image; --cut: a third of each image is cut away, on different sides;\n"
    "--cut-one: of the second one only;\n"
    "--keep: the graphs are written there; --graphs: they are read from there, where --keep wrote them\n"
    "example: registration_experiment data/skull_2.9.nrrd --iso 2.9 --sigma 4 -o results.csv\n";

struct Usage_error : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct Options {
  std::string image, output, keep, graphs;
  std::optional<double> iso, sigma;
  bool surfaces = false, cut = false, cut_one = false;
  unsigned motions = 20, first = 1;
  double noise = 0.02; ///< deviation, in contrasts between above and below the iso value
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
    if (name == "--surfaces" || name == "--cut" || name == "--cut-one") {
      (name == "--cut" ? options.cut : name == "--cut-one" ? options.cut_one : options.surfaces) = true;
      continue;
    }
    if (!name.starts_with("-")) {
      options.image = name;
      continue;
    }
    if (++i == argc)
      throw Usage_error(fmt::format("{}: expected a value", name));
    const std::string value = argv[i];
    if (name == "-o")
      options.output = value;
    else if (name == "--keep")
      options.keep = value;
    else if (name == "--graphs")
      options.graphs = value;
    else if (name == "--iso")
      options.iso = number<double>(name, value);
    else if (name == "--sigma")
      options.sigma = number<double>(name, value);
    else if (name == "--noise")
      options.noise = number<double>(name, value);
    else if (name == "--motions")
      options.motions = number<unsigned>(name, value);
    else if (name == "--first")
      options.first = number<unsigned>(name, value);
    else
      throw Usage_error(fmt::format("unknown option {}", name));
  }
  if (options.surfaces)
    options.iso = 0;
  if (options.image.empty() != options.surfaces || options.output.empty() || !options.iso || !options.sigma)
    throw Usage_error("expected an image with --iso, or --surfaces; --sigma and -o");
  if (!options.keep.empty() && !options.graphs.empty())
    throw Usage_error("graphs are either written or read; give one of --keep and --graphs");
  return options;
}

Extremal_mesh mesh_of(Image&& image, const Options& options, double voxel) {
  Image_function_options image_options;
  image_options.iso = *options.iso;
  image_options.sigma = *options.sigma;
  const Image_function f(std::move(image), image_options);
  Extraction_options extraction_options;
  extraction_options.max_level = 8; // as the tool has them for images
  extraction_options.max_line_level = 2;
  Extremal_mesh mesh = extract_extremal_mesh(f, f.lattice(), extraction_options).mesh;
  mesh.set_provenance(options.image, fmt::format("{{\"sigma\":{},\"voxel\":{}}}", *options.sigma, voxel), "LPS");
  return mesh;
}

/// How exactly a motion was found.
struct Errors {
  double degrees = 0, translation = 0, rms = 0; ///< at the centre of the overlap; of all vertices
};

Errors errors_of(const Registration& r, const surfaces::Motion& truth, const Extremal_mesh& mesh) {
  const Similarity& found = r.transform;
  Similarity true_motion;
  true_motion.rotation = truth.R;
  true_motion.translation = truth.translation;
  Errors errors;
  errors.degrees = rotation_angle(true_motion.inverse() * found) * 180 / std::numbers::pi;
  for (std::size_t v = 0; v < mesh.number_of_vertices(); ++v) {
    const Point& p = mesh.vertex(v).point;
    const double d = surfaces::distance(found(p), truth(p));
    errors.rms += d * d / double(mesh.number_of_vertices());
  }
  errors.rms = std::sqrt(errors.rms);
  errors.translation = surfaces::distance(found(truth.back(r.centre)), r.centre);
  return errors;
}

Image cut(const Image& image, std::size_t axis, bool low) {
  const std::size_t n = image.lattice.size[axis], third = n / 3;
  return low ? resampled_image::slab(image, axis, 0, n - third) : resampled_image::slab(image, axis, third, n);
}

std::string graph_of_first(const std::string& folder, unsigned seed, const Options& options) {
  return fmt::format("{}/{}a.graphml", folder, options.surfaces ? std::to_string(seed) : "");
}
std::string graph_of_second(const std::string& folder, unsigned seed) {
  return fmt::format("{}/{}b.graphml", folder, seed);
}

/// the mesh that is to be found again.
Extremal_mesh first_mesh(const Image& image, unsigned seed, double voxel, const Options& options) {
  if (!options.graphs.empty())
    return read_graphml(graph_of_first(options.graphs, seed, options));
  Image first = options.cut ? cut(image, 0, true) : image;
  if (options.surfaces) // the other ones are images with noise of their own
    resampled_image::add_noise(first, options.noise * resampled_image::contrast(image, *options.iso), seed + 1000);
  Extremal_mesh mesh = mesh_of(std::move(first), options, voxel);
  if (!options.keep.empty())
    write_graphml(graph_of_first(options.keep, seed, options), mesh);
  return mesh;
}

/// the mesh of the image that was moved, resampled, and got noise.
Extremal_mesh second_mesh(const Image& image, const surfaces::Motion& motion, unsigned seed, double voxel,
                          const Options& options) {
  if (!options.graphs.empty())
    return read_graphml(graph_of_second(options.graphs, seed));
  const float lowest = *std::min_element(image.voxels.begin(), image.voxels.end());
  Image second = resampled_image::moved(options.cut || options.cut_one ? cut(image, 1, false) : image, motion, lowest,
                                        resampled_image::other_steps(image.lattice));
  resampled_image::add_noise(second, options.noise * resampled_image::contrast(image, *options.iso), seed);
  Extremal_mesh mesh = mesh_of(std::move(second), options, voxel);
  if (!options.keep.empty())
    write_graphml(graph_of_second(options.keep, seed), mesh);
  return mesh;
}

void run(const Options& options) {
  check_writable(options.output);
  if (!options.keep.empty())
    std::filesystem::create_directories(options.keep);
  std::string csv =
      "motion,degrees,translation_voxels,vertices_a,vertices_b,found,degrees_error,translation_error_voxels,"
      "rms_voxels,degrees_estimated,translation_estimated_voxels,matched_share,chance,on_surface,overlap,"
      "seconds\n";
  unsigned found = 0;
  Errors worst, ratios; // squares of errors in standard errors
  Image image;
  Extremal_mesh a;
  double voxel = 1;
  for (unsigned seed = options.first; seed < options.first + options.motions; ++seed) {
    if (options.surfaces || image.voxels.empty()) {
      image = options.surfaces ? image_of_ellipsoid(seed) : read_image(options.image);
      voxel = resampled_image::largest_spacing(image.lattice);
      a = first_mesh(image, seed, voxel, options);
    }
    surfaces::Motion motion = surfaces::random_motion(seed, 30 * voxel);
    for (double& t : motion.translation) // more than ten voxels
      t += t < 0 ? -10 * voxel : 10 * voxel;
    const Extremal_mesh b = second_mesh(image, motion, seed, voxel, options);

    const auto start = std::chrono::steady_clock::now();
    const Registration r = register_extremal_meshes(a, b);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const Errors errors = errors_of(r, motion, a);
    found += r.found;
    const double degrees_estimated = r.rotation_error * 180 / std::numbers::pi;
    if (r.found) {
      worst = {std::max(worst.degrees, errors.degrees), std::max(worst.translation, errors.translation),
               std::max(worst.rms, errors.rms)};
      ratios.degrees += std::pow(errors.degrees / degrees_estimated, 2);
      ratios.translation += std::pow(errors.translation / r.translation_error, 2);
    }
    Similarity turn;
    turn.rotation = motion.R;
    const Registration_evidence& e = r.evidence;
    const std::string row = fmt::format(
        "{},{:.1f},{:.1f},{},{},{},{:.5f},{:.5f},{:.5f},{:.5f},{:.5f},{:.3f},{:.3f},{:.3f},{:.3f},{:.2f}\n", seed,
        rotation_angle(turn) * 180 / std::numbers::pi, surfaces::length(motion.translation) / voxel,
        a.number_of_vertices(), b.number_of_vertices(), int(r.found), errors.degrees, errors.translation / voxel,
        errors.rms / voxel, degrees_estimated, r.translation_error / voxel,
        e.vertices > 0 ? double(e.matched) / double(e.vertices) : 0, e.chance, e.on_surface, e.overlap, seconds);
    fmt::print("{}", row);
    std::fflush(stdout);
    csv += row;
    write_text_file(options.output, csv);
  }
  fmt::print("{} of {} found; errors at most {:.4f} degrees, {:.4f} voxels at the centre, rms {:.4f} voxels\n", found,
             options.motions, worst.degrees, worst.translation / voxel, worst.rms / voxel);
  if (found > 0)
    fmt::print("errors are {:.2f} and {:.2f} of the standard ones (rms)\n", std::sqrt(ratios.degrees / found),
               std::sqrt(ratios.translation / found));
}

} // namespace

int main(int argc, char** argv) {
  try {
    run(read_options(argc, argv));
    return 0;
  } catch (const Usage_error& error) {
    fmt::print(stderr, "registration_experiment: {}\n{}", error.what(), usage);
    return 2;
  } catch (const std::exception& error) {
    fmt::print(stderr, "registration_experiment: {}\n", error.what());
    return 1;
  }
}
