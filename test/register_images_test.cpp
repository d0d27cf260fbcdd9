// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Registration of CTs: the bundled skull against a copy of it that was moved, resampled on other axes with another spacing, and got
// noise of 2 % of the contrast; against a part, a mirror image, another head.
#include <CGAL/Extremal_mesh_3/Image_function.h>
#include <CGAL/Extremal_mesh_3/extract_extremal_mesh.h>
#include <CGAL/Extremal_mesh_3/register.h>

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

Extremal_mesh mesh_of(Image&& image, double at = iso) {
  Image_function_options image_options;
  image_options.iso = at;
  image_options.sigma = sigma;
  const Image_function f(std::move(image), image_options);
  Extraction_options options;
  options.max_level = 8; // as the program has them for images
  options.max_line_level = 2;
  Extremal_mesh mesh = extract_extremal_mesh(f, f.lattice(), options).mesh;
  mesh.set_provenance("", fmt::format("{{\"sigma\":{},\"voxel\":{}}}", sigma, voxel), "LPS");
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

const Extremal_mesh& skull_mesh() {
  static const Extremal_mesh mesh = mesh_of(skull());
  return mesh;
}

void expect_found(const Registration& r, const surfaces::Motion& motion, const Extremal_mesh& mesh, double part) {
  EXPECT_TRUE(r.found) << r.reason;
  Similarity truth;
  truth.rotation = motion.R;
  truth.translation = motion.translation;
  EXPECT_LT(rotation_angle(truth.inverse() * r.transform) * 180 / std::numbers::pi, part); // degrees
  double sum = 0;
  for (std::size_t v = 0; v < mesh.number_of_vertices(); ++v) {
    const double d = surfaces::distance(r.transform(mesh.vertex(v).point), motion(mesh.vertex(v).point));
    sum += d * d / double(mesh.number_of_vertices());
  }
  EXPECT_LT(std::sqrt(sum), part * voxel);
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
