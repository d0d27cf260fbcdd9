// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Registration of CTs: the bundled skull against a copy of it that was moved, resampled on other axes with another spacing, and got
// noise of 2 % of the contrast; against a part, a mirror image, another head.
#include <CGAL/Extremal_mesh_3/Image_function.h>
#include <CGAL/Extremal_mesh_3/extract_extremal_mesh.h>
#include <CGAL/Extremal_mesh_3/register.h>

#include "ellipsoid_image.h"
#include "resampled_image.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <numbers>

using namespace CGAL::Extremal_mesh_3;

namespace {

constexpr double iso = 2.9, sigma = 6, voxel = 3.94;

Image skull() {
  return read_image(std::string(EXTREMAL_MESH_3_DATA_DIR) + "/skull_2.9.nrrd");
}

Extremal_mesh mesh_of(Image&& image, double at = iso, double smoothing = sigma, double side = voxel) {
  Image_function_options image_options;
  image_options.iso = at;
  image_options.sigma = smoothing;
  const Image_function f(std::move(image), image_options);
  Extraction_options options;
  options.max_level = 8; // as the program has them for images
  options.max_line_level = 2;
  Extremal_mesh mesh = extract_extremal_mesh(f, f.lattice(), options).mesh;
  mesh.set_provenance("", fmt::format("{{\"sigma\":{},\"voxel\":{}}}", smoothing, side), "LPS");
  return mesh;
}

Image head() {
  return read_image(std::string(EXTREMAL_MESH_3_DATA_DIR) + "/headsq.nii.gz");
}
constexpr double iso_of_head = 1150;

Extremal_mesh copy_of(const Image& image, const surfaces::Motion& motion, unsigned seed, double at = iso) {
  Image copy = resampled_image::moved(image, motion, *std::min_element(image.voxels.begin(), image.voxels.end()),
                                      resampled_image::other_steps(image.lattice));
  resampled_image::add_noise(copy, 0.02 * resampled_image::contrast(image, at), seed);
  return mesh_of(std::move(copy), at);
}

/// How wrong a motion is.
struct Errors {
  double degrees = 0, rms = 0, at_centre = 0;
};
Errors errors_of(const Registration& r, const surfaces::Motion& motion, const Extremal_mesh& mesh) {
  Similarity truth;
  truth.rotation = motion.R;
  Errors errors;
  errors.degrees = rotation_angle(truth.inverse() * r.transform) * 180 / std::numbers::pi;
  for (std::size_t v = 0; v < mesh.number_of_vertices(); ++v) {
    const double d = surfaces::distance(r.transform(mesh.vertex(v).point), motion(mesh.vertex(v).point));
    errors.rms += d * d / double(mesh.number_of_vertices());
  }
  errors.rms = std::sqrt(errors.rms);
  errors.at_centre = surfaces::distance(r.transform(motion.back(r.centre)), r.centre);
  return errors;
}

/// a random ellipsoid, and a copy that was moved; both with noise.
std::pair<Extremal_mesh, Extremal_mesh> two_noisy_ellipsoids(unsigned seed, const surfaces::Motion& motion,
                                                             double smoothing) {
  const Image image = image_of_ellipsoid(seed);
  const double noise = 0.02 * resampled_image::contrast(image, 0);
  Image first = image,
        second = resampled_image::moved(image, motion, -100, resampled_image::other_steps(image.lattice));
  resampled_image::add_noise(first, noise, seed + 1000);
  resampled_image::add_noise(second, noise, seed);
  return {mesh_of(std::move(first), 0, smoothing, 1), mesh_of(std::move(second), 0, smoothing, 1)};
}

const Extremal_mesh& skull_mesh() {
  static const Extremal_mesh mesh = mesh_of(skull());
  return mesh;
}

void expect_found(const Registration& r, const surfaces::Motion& motion, const Extremal_mesh& mesh, double part) {
  EXPECT_TRUE(r.found) << r.reason;
  const Errors errors = errors_of(r, motion, mesh);
  EXPECT_LT(errors.degrees, part);
  EXPECT_LT(errors.rms, part * voxel);
}

} // namespace

TEST(Register_images, finds_a_noisy_copy_within_a_tenth_of_a_voxel_and_of_a_degree) {
  const surfaces::Motion motion = surfaces::random_motion(21, 100);
  expect_found(register_extremal_meshes(skull_mesh(), copy_of(skull(), motion, 21)), motion, skull_mesh(), 0.1);
}

TEST(Register_images, finds_what_is_left_after_a_third_was_cut_away_from_each) {
  const surfaces::Motion motion = surfaces::random_motion(22, 100);
  const Image image = skull();
  const Extremal_mesh a = mesh_of(resampled_image::slab(image, 0, 0, 43)),
                      b = copy_of(resampled_image::slab(image, 1, 21, 64), motion, 22);
  expect_found(register_extremal_meshes(a, b), motion, a, 0.1);
}

TEST(Register_images, finds_a_mirror_image_only_if_it_is_asked_to) {
  // Of the head: the skull's image is symmetric, so its mirror image is the skull itself.
  const surfaces::Motion motion = surfaces::mirrored(surfaces::random_motion(23, 100));
  const Extremal_mesh a = mesh_of(head(), iso_of_head), b = copy_of(head(), motion, 23, iso_of_head);
  EXPECT_FALSE(register_extremal_meshes(a, b).found);
  Registration_options options;
  options.mirror = true;
  expect_found(register_extremal_meshes(a, b, options), motion, a, 0.1);
}

TEST(Register_images, claims_nothing_of_another_head) {
  const Extremal_mesh other = mesh_of(head(), iso_of_head);
  EXPECT_FALSE(register_extremal_meshes(skull_mesh(), other).found);
  EXPECT_FALSE(register_extremal_meshes(other, skull_mesh()).found);
}

TEST(Register_images, finds_twenty_random_ellipsoids_and_tells_how_exactly) {
  double turns = 0, shifts = 0;
  constexpr unsigned motions = 20;
  for (unsigned seed = 1; seed <= motions; ++seed) {
    SCOPED_TRACE(seed);
    surfaces::Motion motion = surfaces::random_motion(seed, 30);
    for (double& t : motion.translation) // more than ten voxels
      t += t < 0 ? -10 : 10;
    const auto [a, b] = two_noisy_ellipsoids(seed, motion, 3);
    const Registration r = register_extremal_meshes(a, b);
    ASSERT_TRUE(r.found) << r.reason;
    const Errors errors = errors_of(r, motion, a);
    EXPECT_LT(errors.degrees, 0.1);
    EXPECT_LT(errors.rms, 0.1);
    turns += std::pow(errors.degrees * std::numbers::pi / 180 / r.rotation_error, 2) / motions;
    shifts += std::pow(errors.at_centre / r.translation_error, 2) / motions;
  }
  // If the errors that are told are right, these means of squares are 1; of 20 of them, each hardly more than one squared normal number, they
  // are outside of these bounds less than once in a hundred times.
  for (const double mean : {turns, shifts}) {
    EXPECT_GT(mean, 0.37);
    EXPECT_LT(mean, 1.9);
  }
}

TEST(Register_images, does_not_take_a_surface_that_is_nearly_symmetric_for_itself_turned_over) {
  // Noise moves nearly all vertices of these far away, and half a turn leaves nine tenths of the surface within a quarter of a voxel of itself.
  for (const unsigned seed : {54U, 59U, 75U}) {
    SCOPED_TRACE(seed);
    const surfaces::Motion motion = surfaces::random_motion(seed, 30);
    const auto [a, b] = two_noisy_ellipsoids(seed, motion, 2);
    const Registration r = register_extremal_meshes(a, b);
    if (r.found) {
      EXPECT_LT(errors_of(r, motion, a).degrees, 0.5);
    }
  }
}
