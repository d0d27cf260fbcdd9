// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Extremal_mesh_3/scale_space.h>

#include "../io/Text_file.h"
#include "Diagram.h"

#include <fmt/compile.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace CGAL::Extremal_mesh_3 {

namespace {

struct Counts {
  std::size_t extremal_points = 0, umbilics = 0, edges = 0, cells = 0;
};

Counts counts_of(const Extremal_mesh& mesh) {
  Counts counts{0, 0, mesh.number_of_edges(), mesh.number_of_cells()};
  for (std::size_t v = 0; v < mesh.number_of_vertices(); ++v) {
    counts.extremal_points += mesh.vertex(v).kind == Vertex_kind::extremal_point;
    counts.umbilics += mesh.vertex(v).kind == Vertex_kind::umbilic;
  }
  return counts;
}

constexpr double left = 90, right = 870, top = 60, bottom = 540;
constexpr Colour grid{228, 230, 234}, frame{120, 124, 132};

/// Both axes are logarithmic: numbers fall about as a power of σ.
struct Axes {
  double low_sigma = 1, high_sigma = 2;
  int low = 0, high = 1; ///< powers of 10

  double x(double sigma) const {
    const double width = std::log(high_sigma / low_sigma);
    return left + (right - left) * (width > 0 ? std::log(sigma / low_sigma) / width : 0.5);
  }
  double y(double number) const {
    return bottom - (bottom - top) * (std::log10(std::max(number, std::pow(10, low))) - low) / (high - low);
  }
};

void draw_axes(Diagram& diagram, const Axes& axes, const std::vector<double>& sigmas) {
  using Align = Diagram::Align;
  for (int decade = axes.low; decade <= axes.high; ++decade)
    for (const int factor : {1, 2, 5}) {
      const double number = factor * std::pow(10, decade), y = axes.y(number);
      if (decade == axes.high && factor > 1)
        break;
      diagram.lines.push_back({left, y, right, y, 1, grid, false});
      diagram.texts.push_back({left - 8, y, Align::right, fmt::format("{:g}", number)});
    }
  for (const double sigma : sigmas) {
    const double x = axes.x(sigma);
    diagram.lines.push_back({x, top, x, bottom, 1, grid, false});
    diagram.texts.push_back({x, bottom + 14, Align::middle, fmt::format("{:g}", sigma)});
  }
  diagram.lines.push_back({left, top, left, bottom, 1, frame, false});
  diagram.lines.push_back({left, bottom, right, bottom, 1, frame, false});
  diagram.texts.push_back({(left + right) / 2, bottom + 38, Align::middle, "sigma"});
}

} // namespace

void write_scale_plot(const std::string& file, const Scale_space& space, const std::vector<Extremal_mesh>& meshes) {
  if (!file.ends_with(".svg") && !file.ends_with(".png"))
    throw std::invalid_argument(fmt::format("the extension of '{}' is not one of a plot: .svg or .png", file));
  if (meshes.size() != space.sigmas.size() || meshes.empty())
    throw std::invalid_argument(fmt::format("there are {} meshes for {} scales", meshes.size(), space.sigmas.size()));
  std::vector<Counts> counts;
  std::size_t most = 1, least = static_cast<std::size_t>(-1);
  for (const Extremal_mesh& mesh : meshes) {
    counts.push_back(counts_of(mesh));
    for (const std::size_t n : {counts.back().extremal_points, counts.back().umbilics, counts.back().cells})
      if (n > 0) {
        most = std::max(most, n);
        least = std::min(least, n);
      }
  }
  Axes axes;
  axes.low_sigma = space.sigmas.front();
  axes.high_sigma = space.sigmas.back();
  axes.low = int(std::floor(std::log10(double(std::min(least, most)))));
  axes.high = std::max(axes.low + 1, int(std::ceil(std::log10(double(most)))));
  Diagram diagram;
  draw_axes(diagram, axes, space.sigmas);
  struct Curve {
    const char* name;
    Colour colour;
    std::size_t Counts::*count;
  };
  double x = left;
  for (const Curve& curve :
       {Curve{"extremal points", {31, 119, 180}, &Counts::extremal_points},
        Curve{"umbilics", {214, 39, 160}, &Counts::umbilics}, Curve{"cells", {44, 160, 44}, &Counts::cells}}) {
    Diagram::Dots dots{curve.name, curve.colour, {}};
    for (std::size_t i = 0; i < counts.size(); ++i) {
      dots.centres.push_back({axes.x(space.sigmas[i]), axes.y(double(counts[i].*curve.count))});
      if (i > 0)
        diagram.lines.push_back({dots.centres[i - 1][0], dots.centres[i - 1][1], dots.centres[i][0], dots.centres[i][1],
                                 1.5, curve.colour, false});
    }
    diagram.rectangles.push_back({x, 26, 8, 8, curve.colour});
    diagram.texts.push_back({x + 13, 30, Diagram::Align::left, curve.name});
    x += 160;
    diagram.dots.push_back(std::move(dots));
  }
  file.ends_with(".svg") ? diagram.write_svg(file) : diagram.write_png(file);
}

void write_scale_counts(const std::string& file, const Scale_space& space, const std::vector<Extremal_mesh>& meshes) {
  Text_file out(file);
  out << "level,sigma,extremal_points,umbilics,edges,cells,created,cancelled,merged,vanished,median_life\n";
  for (std::size_t level = 0; level < meshes.size(); ++level) {
    const Counts counts = counts_of(meshes[level]);
    std::array<std::size_t, 4> events{}; // those that lead to this level, for `create`; from it for the others
    for (const Scale_event& e : space.events)
      if ((e.kind == Scale_event_kind::create ? e.level + 1 : e.level) == level)
        ++events[std::size_t(e.kind)];
    std::vector<double> lives = space.vertex_life_times(level);
    const auto middle = lives.begin() + std::ptrdiff_t(lives.size() / 2);
    std::nth_element(lives.begin(), middle, lives.end());
    out.print(FMT_COMPILE("{},{},{},{},{},{},{},{},{},{},{}\n"), level, space.sigmas[level], counts.extremal_points,
              counts.umbilics, counts.edges, counts.cells, events[0], events[1], events[2], events[3],
              lives.empty() ? 0 : *middle);
  }
  out.commit();
}

void write_scale_events(const std::string& file, const Scale_space& space) {
  Text_file out(file);
  out << "level,sigma,next_sigma,event,kind,track,other,x,y,z\n";
  for (const Scale_event& e : space.events) {
    out.print(FMT_COMPILE("{},{},{},{},{},{},"), e.level, space.sigmas[e.level], space.sigmas[e.level + 1],
              to_string(e.kind), to_string(space.tracks[e.track].kind), e.track);
    if (e.other != no_track)
      out.print(FMT_COMPILE("{}"), e.other);
    out.print(FMT_COMPILE(",{},{},{}\n"), e.point[0], e.point[1], e.point[2]);
  }
  out.commit();
}

} // namespace CGAL::Extremal_mesh_3
