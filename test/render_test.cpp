// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Extremal_mesh_3/render.h>

#include "hand_made.h"
#include "temporary_folder.h"

#include <gtest/gtest.h>
#include <png.h>

#include <cstdlib>

using namespace CGAL::Extremal_mesh_3;

namespace {

using Pixel = std::array<int, 3>;

struct Png {
  int width = 0, height = 0;
  std::vector<std::uint8_t> bytes;

  explicit Png(const std::string& file) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    EXPECT_TRUE(png_image_begin_read_from_file(&image, file.c_str())) << image.message;
    image.format = PNG_FORMAT_RGB;
    width = int(image.width);
    height = int(image.height);
    bytes.resize(PNG_IMAGE_SIZE(image));
    EXPECT_TRUE(png_image_finish_read(&image, nullptr, bytes.data(), 0, nullptr)) << image.message;
  }
  Pixel at(int x, int y) const {
    const std::size_t i = 3 * std::size_t(y * width + x);
    return {bytes[i], bytes[i + 1], bytes[i + 2]};
  }
};

constexpr int width = 400, height = 300;
/// The unit sphere seen along y fills 0.9 of the height.
constexpr double scale = 0.9 * height / 2;

Render_options along_y() {
  Render_options options;
  options.width = width;
  options.height = height;
  options.view = {0, 1, 0};
  options.legend = false;
  return options;
}

Png rendered(const Extremal_mesh& mesh, const Cell_patches& patches, const Render_options& options) {
  const Temporary_folder folder;
  render_png(folder.file("out.png"), mesh, patches, options);
  return Png(folder.file("out.png"));
}

/// the pixel where a point of the sphere is seen along y.
Pixel seen_at(const Png& png, double x, double z) {
  return png.at(int(width / 2 + scale * x), int(height / 2 - scale * z));
}

bool is_background(const Pixel& p) {
  return p[0] > 220 && p[1] > 220 && p[2] >= p[0] && p[2] < p[0] + 12;
}
bool is_warm(const Pixel& p) {
  return p[0] > p[2] + 15 && p[0] < p[2] + 80;
}
bool is_cool(const Pixel& p) {
  return p[2] > p[0] + 15 && p[2] < p[0] + 80;
}

} // namespace

TEST(Render, has_the_size_asked_for_and_a_light_background) {
  const Png png = rendered(hand_made::ellipsoid(), hand_made::octants(), along_y());
  EXPECT_EQ(png.width, width);
  EXPECT_EQ(png.height, height);
  for (const int x : {0, width - 1})
    for (const int y : {0, height - 1})
      EXPECT_TRUE(is_background(png.at(x, y)));
}

TEST(Render, cells_are_tinted_by_their_sign) {
  const Png png = rendered(hand_made::ellipsoid(), hand_made::octants(), along_y());
  // of the front octants (y < 0), that with x z > 0 has E_g < 0
  EXPECT_TRUE(is_cool(seen_at(png, 0.4, 0.4)));
  EXPECT_TRUE(is_warm(seen_at(png, -0.4, 0.4)));
  EXPECT_TRUE(is_cool(seen_at(png, -0.4, -0.4)));
  EXPECT_TRUE(is_warm(seen_at(png, 0.4, -0.4)));
}

TEST(Render, the_picture_is_not_mirrored) {
  Render_options options = along_y();
  options.view = {0, 0, -1}; // from above
  options.up = {0, 1, 0};
  const Png png = rendered(hand_made::ellipsoid(), hand_made::octants(), options);
  EXPECT_TRUE(is_warm(seen_at(png, 0.4, 0.4))); // x to the right, y upwards: all positive
  EXPECT_TRUE(is_cool(seen_at(png, -0.4, 0.4)));
}

TEST(Render, lines_have_the_colours_of_their_types) {
  const Png png = rendered(hand_made::ellipsoid(), hand_made::octants(), along_y());
  EXPECT_EQ(seen_at(png, 0.4, 0), (Pixel{255, 140, 0})); // z = 0: max_largest
  EXPECT_EQ(seen_at(png, 0, 0.4), (Pixel{12, 60, 170})); // x = 0: min_second
}

TEST(Render, extremal_points_are_dark_dots_with_a_white_rim) {
  const Png png = rendered(hand_made::ellipsoid(), hand_made::octants(), along_y());
  EXPECT_EQ(seen_at(png, 0, 0), (Pixel{40, 40, 40}));
  EXPECT_EQ(png.at(width / 2 + 4, height / 2 + 2), (Pixel{255, 255, 255}));
}

TEST(Render, umbilics_are_coloured_by_type) {
  Render_options options = along_y();
  options.view = {-0.6, 0, -0.8}; // straight onto one
  const Png png = rendered(hand_made::ellipsoid(), hand_made::octants(), options);
  const Pixel p = png.at(width / 2, height / 2);
  EXPECT_GT(p[1], p[0] + 50); // a lemon is green
  EXPECT_GT(p[1], p[2] + 50);
}

TEST(Render, crest_lines_alone_leave_out_other_lines_and_vertices) {
  Render_options options = along_y();
  options.lines = Shown_lines::crest;
  const Png png = rendered(hand_made::ellipsoid(), hand_made::octants(), options);
  EXPECT_EQ(seen_at(png, 0.4, 0), (Pixel{255, 140, 0})); // z = 0: max_largest
  EXPECT_NE(seen_at(png, 0, 0.4), (Pixel{12, 60, 170})); // x = 0: min_second
  EXPECT_EQ(seen_at(png, 0, 0), (Pixel{255, 140, 0}));   // the line goes on where the extremal point is
}

TEST(Render, the_surface_alone_has_its_tints_only) {
  Render_options options = along_y();
  options.lines = Shown_lines::none;
  const Png png = rendered(hand_made::ellipsoid(), hand_made::octants(), options);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const Pixel p = png.at(x, y);
      EXPECT_LT(std::abs(p[0] - p[2]), 80) << x << ", " << y; // lines and dots of umbilics are more colourful
    }
  EXPECT_TRUE(is_cool(seen_at(png, 0.4, 0.05)) && is_warm(seen_at(png, 0.4, -0.05)));
}

TEST(Render, what_is_behind_the_surface_is_not_seen) {
  Render_options options = along_y();
  const Extremal_mesh mesh = hand_made::two_loops();
  Cell_patches patches = hand_made::octants();
  patches.cell.assign(patches.cell.size(), 0);
  options.view = {0, 0, 1}; // from below: of the two circles, that at z = -1/2 is in front
  Render_options without_lines = options;
  without_lines.line_width = 1e-6;
  const Png with_lines = rendered(mesh, patches, options), without = rendered(mesh, patches, without_lines);
  int different = 0;
  for (std::size_t i = 0; i < with_lines.bytes.size(); i += 3)
    different += with_lines.bytes[i] != without.bytes[i];
  // one circle of radius √¾, as wide as a crest line; the other circle would be seen at the same place, so look from
  // aslant, too
  EXPECT_NEAR(different, 2 * 3.14 * scale * 0.866 * 1.3 * 3, 0.35 * different);
  options.view = without_lines.view = {0, 1, -2};
  const Png aslant = rendered(mesh, patches, options), aslant_without = rendered(mesh, patches, without_lines);
  int below = 0; // from above, the lower circle is on the far side but for a part near the horizon
  for (int y = height / 2 - 10; y < height / 2 + 10; ++y)
    for (int x = width / 2 - 10; x < width / 2 + 10; ++x)
      below += aslant.at(x, y) != aslant_without.at(x, y);
  EXPECT_EQ(below, 0);
}

TEST(Render, lines_alone_can_be_drawn) {
  const Png png = rendered(hand_made::ellipsoid(), {}, along_y());
  EXPECT_TRUE(is_background(seen_at(png, 0.4, 0.4)));
  EXPECT_EQ(seen_at(png, 0.4, 0), (Pixel{255, 140, 0}));
}

TEST(Render, an_empty_mesh_gives_an_empty_picture) {
  const Png png = rendered({}, {}, along_y());
  EXPECT_TRUE(is_background(png.at(width / 2, height / 2)));
}

TEST(Render, does_not_depend_on_the_number_of_threads) {
  Render_options options = along_y();
  options.threads = 1;
  const Png one = rendered(hand_made::ellipsoid(), hand_made::octants(), options);
  options.threads = 3;
  EXPECT_EQ(rendered(hand_made::ellipsoid(), hand_made::octants(), options).bytes, one.bytes);
}

TEST(Render, the_legend_is_in_the_lower_left_corner) {
  Render_options options = along_y();
  options.width = 800;
  options.height = 600;
  const Png without = rendered(hand_made::ellipsoid(), hand_made::octants(), options);
  options.legend = true;
  const Png with = rendered(hand_made::ellipsoid(), hand_made::octants(), options);
  int in_corner = 0, elsewhere = 0;
  for (int y = 0; y < options.height; ++y)
    for (int x = 0; x < options.width; ++x)
      if (with.at(x, y) != without.at(x, y))
        ++(x < 200 && y > 400 ? in_corner : elsewhere);
  EXPECT_GT(in_corner, 300);
  EXPECT_EQ(elsewhere, 0);
}

TEST(Render, refuses_what_makes_no_sense) {
  const Temporary_folder folder;
  const std::string file = folder.file("out.png");
  const Extremal_mesh mesh = hand_made::ellipsoid();
  const auto refuses = [&](const std::function<void(Render_options&)>& spoil) {
    Render_options options = along_y();
    spoil(options);
    EXPECT_THROW(render_png(file, mesh, hand_made::octants(2), options), std::invalid_argument);
  };
  refuses([](Render_options& o) { o.width = 15; });
  refuses([](Render_options& o) { o.height = 16385; });
  refuses([](Render_options& o) { o.view = {0, 0, 0}; });
  refuses([](Render_options& o) { o.view = {0, std::nan(""), 0}; });
  refuses([](Render_options& o) { o.line_width = -1; });
  Cell_patches patches = hand_made::octants(2);
  patches.cell[0] = 8;
  EXPECT_THROW(render_png(file, mesh, patches, along_y()), std::invalid_argument);
  EXPECT_THROW(render_png(folder.file("none/out.png"), mesh, hand_made::octants(2), along_y()), Io_error);
  EXPECT_EQ(folder.number_of_files(), 0U);
}
