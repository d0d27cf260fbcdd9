// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A rasteriser in software: the result does not depend on a driver, a display or the number of threads.
#include <CGAL/Extremal_mesh_3/render.h>

#include "../cells/parallel.h"
#include "../differential/vector.h"
#include "../io/cell_colours.h"
#include "Camera.h"
#include "Canvas.h"
#include "Picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace CGAL::Extremal_mesh_3 {

namespace {

/// Rows of pixels drawn at a time: enough bands for all cores, few enough that looking through all polygons for each
/// costs nothing.
constexpr int band_height = 64;
/// Lines lie on the surface and would be half hidden by it: they are drawn in front of it by this many of their radii.
constexpr double line_bias = 3;
constexpr double dot_bias = 3;
constexpr Colour faint{236, 232, 226};

/// a size in pixels: as asked for, or `most`, or so much less that `count` things of the size times `room` have room in
/// the picture.
double size_for(double asked, double most, double room, std::size_t count, const Render_options& options) {
  if (asked > 0)
    return asked;
  return std::min(most, std::sqrt(options.width * double(options.height) / double(count + 1)) / room);
}

/// A range of rows of samples.
struct Rows {
  double top = std::numeric_limits<double>::infinity(), bottom = -std::numeric_limits<double>::infinity();
  void include(const Screen_point& p, double margin = 0) {
    top = std::min(top, p.y - margin);
    bottom = std::max(bottom, p.y + margin);
  }
  bool meet(const Canvas& canvas) const {
    return bottom >= canvas.first_sample_row() && top <= canvas.last_sample_row();
  }
};

/// What is to be drawn, projected.
class Scene {
public:
  Scene(const Extremal_mesh& mesh, const Cell_patches& patches, const Render_options& options)
      : mesh_(mesh), patches_(patches), options_(options), camera_(mesh, patches, options, Canvas::samples),
        line_width_(Canvas::samples * size_for(options.line_width, 3, 12, mesh.number_of_edges(), options)),
        dot_radius_(Canvas::samples * size_for(options.dot_radius, 6, 8, mesh.number_of_vertices(), options)),
        cell_colours_(cell_colours(mesh, options.colouring)) {
    corners_.reserve(patches.points.size());
    for (std::size_t i = 0; i < patches.points.size(); ++i)
      corners_.push_back({camera_.project(patches.points[i]), camera_.turn(patches.normals[i])});
    polygon_rows_.resize(patches.cell.size());
    for (std::size_t i = 0; i < patches.cell.size(); ++i)
      for (std::size_t j = patches.begin[i]; j < patches.begin[i + 1]; ++j)
        polygon_rows_[i].include(corners_[patches.corners[j]].at);
    line_rows_.resize(mesh.number_of_edges());
    for (std::size_t e = 0; e < mesh.number_of_edges(); ++e)
      for (const Point& p : mesh.edge(e).polyline)
        line_rows_[e].include(camera_.project(p), line_width_);
  }

  void draw(Canvas& canvas) const {
    for (std::size_t i = 0; i < polygon_rows_.size(); ++i)
      if (polygon_rows_[i].meet(canvas))
        draw_polygon(canvas, i);
    if (options_.lines == Shown_lines::none)
      return;
    for (std::size_t e = 0; e < line_rows_.size(); ++e)
      if (line_rows_[e].meet(canvas))
        draw_line(canvas, mesh_.edge(e));
    if (options_.lines == Shown_lines::crest)
      return;
    for (std::size_t v = 0; v < mesh_.number_of_vertices(); ++v)
      draw_vertex(canvas, mesh_.vertex(v));
  }

private:
  /// A polygon is a fan of triangles around its centre: it need not be convex or flat.
  void draw_polygon(Canvas& canvas, std::size_t i) const {
    const std::span<const std::uint32_t> corners =
        std::span(patches_.corners).subspan(patches_.begin[i], patches_.begin[i + 1] - patches_.begin[i]);
    const Colour tint = cell_colours_[patches_.cell[i]];
    if (corners.size() == 3) {
      canvas.triangle(corners_[corners[0]], corners_[corners[1]], corners_[corners[2]], tint);
      return;
    }
    Corner centre;
    for (const std::uint32_t c : corners) {
      const double share = 1 / double(corners.size());
      centre.at.x += share * corners_[c].at.x;
      centre.at.y += share * corners_[c].at.y;
      centre.at.z += share * corners_[c].at.z;
      centre.normal = centre.normal + share * corners_[c].normal;
    }
    for (std::size_t j = 0; j < corners.size(); ++j)
      canvas.triangle(centre, corners_[corners[j]], corners_[corners[(j + 1) % corners.size()]], tint);
  }

  void draw_line(Canvas& canvas, const Extremal_mesh_edge& edge) const {
    const bool weak = edge.strength < options_.min_strength;
    Screen_point from = camera_.project(edge.polyline.front());
    for (std::size_t i = 0; i + 1 < edge.polyline.size(); ++i) {
      const Screen_point to = camera_.project(edge.polyline[i + 1]);
      const Line_type type = edge.segment_types[i];
      const bool largest = type == Line_type::max_largest || type == Line_type::min_largest;
      const double width = (type == Line_type::max_largest ? 1.3 : largest ? 1.0 : 0.85) * (weak ? 0.6 : 1);
      const double radius = 0.5 * width * line_width_;
      Colour colour = line_colour(type);
      if (weak)
        for (std::size_t k = 0; k < 3; ++k)
          colour[k] = std::uint8_t((colour[k] + faint[k]) / 2);
      if (options_.lines == Shown_lines::all || type == Line_type::max_largest)
        canvas.stroke(from, to, radius, line_bias * radius, colour);
      from = to;
    }
  }

  void draw_vertex(Canvas& canvas, const Extremal_mesh_vertex& vertex) const {
    if (vertex.kind == Vertex_kind::anchor) // no place of its own on its line
      return;
    if (mesh_.surface().closed && camera_.turn(vertex.normal)[2] < 0) // on the far side
      return;
    const bool small = vertex.kind == Vertex_kind::boundary;
    const double radius = (small ? 0.6 : 1) * dot_radius_;
    const Screen_point centre = camera_.project(vertex.point);
    Rows rows;
    rows.include(centre, radius);
    if (rows.meet(canvas))
      canvas.dot(centre, radius, 0.25 * radius, dot_bias * radius, vertex_colour(vertex));
  }

  const Extremal_mesh& mesh_;
  const Cell_patches& patches_;
  const Render_options& options_;
  Camera camera_;
  double line_width_, dot_radius_; ///< samples
  std::vector<Colour> cell_colours_;
  std::vector<Corner> corners_;
  std::vector<Rows> polygon_rows_, line_rows_;
};

void validate(const Extremal_mesh& mesh, const Cell_patches& patches, const Render_options& options) {
  for (const int size : {options.width, options.height})
    if (size < 16 || size > 16384)
      throw std::invalid_argument(
          fmt::format("a picture of {} × {} pixels is not in 16 … 16384", options.width, options.height));
  if (!(options.line_width >= 0) || !(options.dot_radius >= 0))
    throw std::invalid_argument("the width of lines and the radius of dots must be 0 or more");
  if (patches.normals.size() != patches.points.size() || patches.begin.size() != patches.cell.size() + 1)
    throw std::invalid_argument("the arrays of the patches do not fit together");
  for (const std::uint32_t c : patches.cell)
    if (c >= mesh.number_of_cells())
      throw std::invalid_argument(
          fmt::format("a patch names cell {}, but there are only {}", c, mesh.number_of_cells()));
}

} // namespace

void render_png(const std::string& file, const Extremal_mesh& mesh, const Cell_patches& patches,
                const Render_options& options) {
  validate(mesh, patches, options);
  const Scene scene(mesh, patches, options);
  Picture picture(options.width, options.height);
  const int bands = (options.height + band_height - 1) / band_height;
  Thread_pool(options.threads).for_each(std::size_t(bands), 1, [&](std::size_t band) {
    const int first = int(band) * band_height, last = std::min(first + band_height, options.height);
    Canvas canvas(options.width, options.height, first, last);
    scene.draw(canvas);
    canvas.resolve(picture.rows(first, last));
  });
  if (options.legend)
    draw_legend(picture, mesh, options.lines);
  picture.write_png(file);
}

} // namespace CGAL::Extremal_mesh_3
