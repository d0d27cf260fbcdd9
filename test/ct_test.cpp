// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Iso-surfaces of images, from the voxels to the checked mesh.
#include <CGAL/Extremal_mesh_3/Formula.h>
#include <CGAL/Extremal_mesh_3/Image_function.h>
#include <CGAL/Extremal_mesh_3/io.h>

#include "graph_comparison.h"
#include "same_mesh.h"
#include "surfaces.h"
#include "temporary_folder.h"

using namespace CGAL::Extremal_mesh_3;

namespace {

struct Volume {
  std::string file;
  double iso;
  friend std::ostream& operator<<(std::ostream& out, const Volume& v) { return out << v.file << " at " << v.iso; }
};

class Ct : public testing::TestWithParam<Volume> {
protected:
  Image image() const { return read_image(std::string(EXTREMAL_MESH_3_DATA_DIR) + "/" + GetParam().file); }

  Extraction extract(const Image& image, int threads) const {
    Image_function_options image_options;
    image_options.iso = GetParam().iso;
    image_options.threads = threads;
    const Image_function f(image, image_options);
    Extraction_options options;
    options.threads = threads;
    // what the program takes: with more levels noise takes ten times as long
    options.max_level = 8;
    options.max_line_level = 2;
    return extract_extremal_mesh(f, f.lattice(), options);
  }
};

/// the middle of an image, of half its width.
Image middle_of(const Image& image) {
  Image part;
  const auto& n = image.lattice.size;
  part.lattice = image.lattice;
  part.lattice.origin = image.lattice.node(double(n[0] / 4), double(n[1] / 4), double(n[2] / 4));
  for (std::size_t a = 0; a < 3; ++a)
    part.lattice.size[a] = n[a] / 2;
  for (std::size_t k = 0; k < n[2] / 2; ++k)
    for (std::size_t j = 0; j < n[1] / 2; ++j)
      for (std::size_t i = 0; i < n[0] / 2; ++i)
        part.voxels.push_back(image.voxels[(n[0] / 4 + i) + n[0] * ((n[1] / 4 + j) + n[1] * (n[2] / 4 + k))]);
  return part;
}

/// −100·f on a lattice: bright inside.
Image sampled(const Function_3& f, const Lattice& lattice) {
  Image image{lattice, {}};
  std::vector<double> slice(lattice.size[0] * lattice.size[1]);
  for (std::size_t k = 0; k < lattice.size[2]; ++k) {
    f.lattice_values(lattice, k, slice.data());
    for (const double value : slice)
      image.voxels.push_back(float(-100 * value));
  }
  return image;
}

/// the same voxels in another order: the axes are exchanged cyclically and the first one is reversed, which makes the
/// lattice left-handed.
Image reordered(const Image& image) {
  const auto [nx, ny, nz] = image.lattice.size;
  Image copy;
  const Vector s = image.lattice.step[0];
  copy.lattice.origin = image.lattice.node(double(nx - 1), 0, 0);
  copy.lattice.step = {image.lattice.step[2], {-s[0], -s[1], -s[2]}, image.lattice.step[1]};
  copy.lattice.size = {nz, nx, ny};
  for (std::size_t j = 0; j < ny; ++j)
    for (std::size_t i = 0; i < nx; ++i)
      for (std::size_t k = 0; k < nz; ++k)
        copy.voxels.push_back(image.voxels[(nx - 1 - i) + nx * (j + ny * k)]);
  return copy;
}

Extraction extract(const Image& image) {
  const Image_function f(image, {});
  return extract_extremal_mesh(f, f.lattice());
}

} // namespace

TEST_P(Ct, has_a_mesh_on_which_all_checks_hold_before_and_after_graphml) {
  const Extraction extraction = extract(image(), 0);
  surfaces::expect_all_checks_hold(extraction.mesh);
  EXPECT_GT(extraction.mesh.number_of_edges(), 1000U);
  RecordProperty("uncertain_cells", int(extraction.report.uncertain_cells));

  const Temporary_folder folder;
  write_graphml(folder.file("ct.graphml"), extraction.mesh);
  const Extremal_mesh copy = read_graphml(folder.file("ct.graphml"));
  same_mesh::expect_same(extraction.mesh, copy);
  surfaces::expect_all_checks_hold(copy);
}

TEST_P(Ct, gives_the_same_bits_with_one_thread_and_with_two) {
  // A part will do, and has a border, where the surface leaves it.
  const Image part = middle_of(image());
  const Extraction one = extract(part, 1), two = extract(part, 2);
  surfaces::expect_all_checks_hold(one.mesh);
  EXPECT_FALSE(one.mesh.surface().closed);
  EXPECT_GT(one.mesh.number_of_edges(), 100U);
  same_mesh::expect_same(one.mesh, two.mesh);
  EXPECT_EQ(one.report.refined_cells, two.report.refined_cells);
  EXPECT_EQ(one.report.uncertain_cells, two.report.uncertain_cells);
}

INSTANTIATE_TEST_SUITE_P(Volumes, Ct, testing::Values(Volume{"skull_2.9.nrrd", 2.9}, Volume{"headsq.nii.gz", 1150}),
                         [](const auto& info) { return info.param.file.substr(0, 5); });

TEST(Image_surface, of_a_quadric_and_cubic_terms_has_the_mesh_of_the_smoothed_polynomial) {
  // Convolving with a Gaussian of width σ adds σ² a for every term a x², and 3σ² b x to every b x³: the spline holds
  // these polynomials exactly, and the lattice is centred, so f is known in closed form.
  const double step = 0.09, sigma2 = step * step;
  const Formula f("x^2+2*y^2+4*z^2-1+0.1*x^3");
  const Formula smoothed("x^2+2*y^2+4*z^2-1+0.1*x^3+" + std::to_string(sigma2) + "*(7+0.3*x)");
  const Lattice lattice{{-1.8, -1.8, -1.8}, {Vector{step, 0, 0}, Vector{0, step, 0}, Vector{0, 0, step}}, {41, 41, 41}};
  Image_function_options options;
  options.sigma = step;
  const Image_function image(sampled(f, lattice), options);
  const Extremal_mesh a = extract_extremal_mesh(image, lattice).mesh;
  const Extremal_mesh b = extract_extremal_mesh(smoothed, lattice).mesh;
  EXPECT_TRUE(graph_comparison::isomorphic(a, b));
  for (const auto kind : {Vertex_kind::extremal_point, Vertex_kind::umbilic}) {
    const auto off =
        graph_comparison::largest_distance(graph_comparison::positions(a, kind), graph_comparison::positions(b, kind));
    ASSERT_TRUE(off);
    // Voxels and coefficients are floats (1e-7), third derivatives of a spline over voxels amplify that some 100 times
    // over the length 1 / step.
    EXPECT_LT(*off, 0.1 * step);
  }
}

TEST(Image_surface, does_not_depend_on_the_order_of_the_axes) {
  const Formula f("x^2+1.3*y^2+1.7*z^2+0.2*x^3+0.15*y^3-0.4*x*y*z+0.2*x^2*z+0.1*x*y^2-1");
  const Lattice lattice{
      {-1.5, -1.45, -1.55}, {Vector{0.075, 0, 0}, Vector{0, 0.075, 0}, Vector{0, 0, 0.08}}, {40, 40, 40}};
  const Image image = sampled(f, lattice);
  const Extraction a = extract(image), b = extract(reordered(image));
  EXPECT_TRUE(graph_comparison::isomorphic(a.mesh, b.mesh));
  EXPECT_EQ(surfaces::counts_of(a.mesh), (surfaces::Counts{8, 4, 0, 20, 10, 0, 2}));
  for (const auto kind : {Vertex_kind::extremal_point, Vertex_kind::umbilic}) {
    const auto off = graph_comparison::largest_distance(graph_comparison::positions(a.mesh, kind),
                                                        graph_comparison::positions(b.mesh, kind));
    ASSERT_TRUE(off);
    EXPECT_LT(*off, 0.01 * 0.08); // a hundredth of a voxel: the axes are smoothed in another order, in floats
  }
}
