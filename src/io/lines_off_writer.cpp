// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lines as tubes: OFF has no lines, and readers drop faces of two corners. A tube's cross-section is carried along its
// line without turning more than the line does.
#include "../differential/vector.h"
#include "Off_file.h"

#include <CGAL/Extremal_mesh_3/io.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

namespace {

constexpr std::uint32_t sides = 6;
/// Of the diagonal of the box around all lines: thin beside most cells, and still seen.
constexpr double default_radius = 1.0 / 700;

/// A line without repeated points.
struct Line {
  std::vector<Point> points;
  std::vector<Line_type> types; ///< of the segments
};

Line without_repetitions(const Extremal_mesh_edge& edge) {
  Line line{{edge.polyline.front()}, {}};
  for (std::size_t i = 1; i < edge.polyline.size(); ++i)
    if (norm(edge.polyline[i] - line.points.back()) > 0) {
      line.points.push_back(edge.polyline[i]);
      line.types.push_back(edge.segment_types[i - 1]);
    }
  return line;
}

/// writes `sides` points around each point of a line.
void add_rings(Off_file& out, const Line& line, double radius) {
  const std::vector<Point>& p = line.points;
  const std::size_t n = p.size();
  Vector u = any_orthogonal(normalized(p[1] - p[0]));
  for (std::size_t i = 0; i < n; ++i) {
    // the mean direction of the two segments, or that of the second where the line turns straight back
    const Vector out_direction = normalized(i + 1 < n ? p[i + 1] - p[i] : p[i] - p[i - 1]);
    const Vector in_direction = i > 0 ? normalized(p[i] - p[i - 1]) : out_direction;
    const Vector sum = in_direction + out_direction;
    const Vector t = norm(sum) > 1e-6 ? normalized(sum) : out_direction;
    const Vector across = u - dot(u, t) * t;
    u = norm(across) > 1e-6 ? normalized(across) : any_orthogonal(t);
    const Vector v = cross(t, u);
    for (std::uint32_t side = 0; side < sides; ++side) {
      const double angle = 2 * std::numbers::pi * side / sides;
      out.add_point(p[i] + radius * (std::cos(angle) * u + std::sin(angle) * v));
    }
  }
}

void add_faces(Off_file& out, const Line& line, std::uint32_t first) {
  const auto segments = std::uint32_t(line.types.size());
  std::array<std::uint32_t, sides> start{}, end{};
  for (std::uint32_t side = 0; side < sides; ++side) {
    start[side] = first + sides - 1 - side;
    end[side] = first + segments * sides + side;
  }
  out.add_polygon(start, line_colour(line.types.front()));
  for (std::uint32_t i = 0; i < segments; ++i)
    for (std::uint32_t side = 0; side < sides; ++side) {
      const std::uint32_t a = first + i * sides + side, b = first + i * sides + (side + 1) % sides;
      out.add_polygon(std::array{a, b, b + sides, a + sides}, line_colour(line.types[i]));
    }
  out.add_polygon(end, line_colour(line.types.back()));
}

double diagonal(const Extremal_mesh& mesh) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Point low{infinity, infinity, infinity}, high{-infinity, -infinity, -infinity};
  for (std::size_t e = 0; e < mesh.number_of_edges(); ++e)
    for (const Point& p : mesh.edge(e).polyline)
      for (std::size_t a = 0; a < 3; ++a) {
        low[a] = std::min(low[a], p[a]);
        high[a] = std::max(high[a], p[a]);
      }
  return mesh.number_of_edges() == 0 ? 0 : norm(high - low);
}

} // namespace

void write_lines_off(const std::string& file, const Extremal_mesh& mesh, double radius) {
  if (!(radius >= 0) || !std::isfinite(radius))
    throw std::invalid_argument(fmt::format("the radius of tubes is {}; it must be 0 or more", radius));
  if (radius == 0)
    radius = default_radius * diagonal(mesh);
  std::vector<Line> lines;
  std::size_t number_of_points = 0, number_of_faces = 0;
  for (std::size_t e = 0; e < mesh.number_of_edges(); ++e) {
    Line line = without_repetitions(mesh.edge(e));
    if (line.types.empty())
      continue;
    number_of_points += sides * line.points.size();
    number_of_faces += sides * line.types.size() + 2;
    lines.push_back(std::move(line));
  }
  Off_file out(file, number_of_points, number_of_faces);
  for (const Line& line : lines)
    add_rings(out, line, radius);
  std::uint32_t first = 0;
  for (const Line& line : lines) {
    add_faces(out, line, first);
    first += sides * std::uint32_t(line.points.size());
  }
  out.commit();
}

} // namespace CGAL::Extremal_mesh_3
