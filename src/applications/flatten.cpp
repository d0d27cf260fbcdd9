// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Extremal_mesh_3/cell_patches.h>
#include <CGAL/Extremal_mesh_3/cell_queries.h>
#include <CGAL/Extremal_mesh_3/flatten.h>
#include <CGAL/Extremal_mesh_3/internal/manifold_patches.h>
#include <CGAL/Extremal_mesh_3/segment.h>

#include "../cells/Union_find.h"
#include "../cells/parallel.h"
#include "../cgal/flatten_disc.h"
#include "../differential/vector.h"
#include "divide.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <set>

namespace CGAL::Extremal_mesh_3 {

namespace {

using Ends = std::array<std::uint32_t, 2>;

/// One cell, on the surface and in the plane.
struct Piece {
  Cell_patches faces;
  std::vector<Plane_point> places;
  Flat_cell result;
};

/// sides that no other triangle has, by their first points. Nothing if they do not form one closed line through each point once, or the
/// triangles no disk.
std::optional<std::vector<std::uint32_t>> border_of_disc(const Triangles& disc) {
  std::set<Ends> sides, edges;
  Union_find pieces(disc.points.size());
  for (const auto& t : disc.corners)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = t[i], b = t[(i + 1) % 3];
      sides.insert({a, b});
      edges.insert({std::min(a, b), std::max(a, b)});
      pieces.unite(a, b);
    }
  if (disc.points.size() + disc.corners.size() != edges.size() + 1)
    return std::nullopt;
  for (std::uint32_t p = 1; p < disc.points.size(); ++p)
    if (pieces.find(p) != pieces.find(0))
      return std::nullopt;
  std::map<std::uint32_t, std::uint32_t> next;
  for (const auto& [a, b] : sides)
    if (!sides.contains({b, a}) && !next.emplace(a, b).second)
      return std::nullopt;
  if (next.empty())
    return std::nullopt;
  std::vector<std::uint32_t> border;
  for (std::uint32_t here = next.begin()->first; border.empty() || here != border[0]; here = next.at(here))
    border.push_back(here);
  if (border.size() != next.size())
    return std::nullopt;
  return border;
}

/// A corner of a cell, and the line that leaves it with the cell on the left; none along the border of the surface.
struct Corner {
  std::uint32_t vertex = 0;
  std::optional<Half_edge> leaving;
};

/// the corners along the walk around a cell, but for anchors.
std::vector<Corner> corners_of(const Extremal_mesh& mesh, std::uint32_t c) {
  std::vector<Half_edge> walk = mesh.cell(c).boundary.front();
  if (const auto quad = quadrilateral(mesh, c))
    for (std::size_t i = 0; i < walk.size(); ++i)
      walk[i] = quad->sides[i].half_edge;
  std::vector<Corner> corners;
  for (std::size_t i = 0; i < walk.size(); ++i) {
    if (mesh.vertex(mesh.source(walk[i])).kind != Vertex_kind::anchor)
      corners.push_back({mesh.source(walk[i]), walk[i]});
    const std::uint32_t end = mesh.target(walk[i]);
    if (end != mesh.source(walk[(i + 1) % walk.size()]))
      corners.push_back({end, std::nullopt});
  }
  return corners;
}

/// the second point of a half-edge's polyline.
Point second_point(const Extremal_mesh& mesh, Half_edge h) {
  const std::vector<Point>& line = mesh.edge(h / 2).polyline;
  return h % 2 == 0 ? line[1] : line[line.size() - 2];
}

/// turns the border so that it begins at the first corner, and finds the others. Nothing if they are not there in this order.
std::optional<std::vector<std::size_t>> place_corners(const Extremal_mesh& mesh, const Cell_patches& faces,
                                                      const std::vector<Corner>& corners,
                                                      std::vector<std::uint32_t>& border) {
  if (corners.empty())
    return std::vector<std::size_t>{};
  std::map<Point, std::uint32_t> vertex_at;
  for (const Corner& corner : corners)
    vertex_at.emplace(mesh.vertex(corner.vertex).point, corner.vertex);
  std::vector<std::size_t> met; // places on the border
  std::vector<std::uint32_t> vertices;
  for (std::size_t i = 0; i < border.size(); ++i)
    if (const auto found = vertex_at.find(faces.points[border[i]]); found != vertex_at.end()) {
      met.push_back(i);
      vertices.push_back(found->second);
    }
  const std::size_t n = corners.size();
  if (met.size() != n)
    return std::nullopt;
  std::optional<std::size_t> turn;
  for (std::size_t t = 0; t < n; ++t) {
    bool fits = true;
    for (std::size_t i = 0; i < n && fits; ++i)
      fits = vertices[(t + i) % n] == corners[i].vertex;
    if (!fits)
      continue;
    if (!turn)
      turn = t;
    // where a vertex comes twice, the lines tell which time is meant
    if (corners[0].leaving &&
        faces.points[border[(met[t] + 1) % border.size()]] == second_point(mesh, *corners[0].leaving)) {
      turn = t;
      break;
    }
  }
  if (!turn)
    return std::nullopt;
  const std::size_t first = met[*turn];
  std::rotate(border.begin(), border.begin() + std::ptrdiff_t(first), border.end());
  std::vector<std::size_t> at;
  for (std::size_t i = 0; i < n; ++i)
    at.push_back((met[(*turn + i) % n] + border.size() - first) % border.size());
  return at;
}

/// the corner i of n of a regular polygon in the unit square; of 4 of the square itself.
Plane_point polygon_corner(double i, std::size_t n) {
  constexpr std::array<Plane_point, 4> square{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  if (n == 4)
    return square[std::size_t(i) % 4];
  const double angle = 2 * std::numbers::pi * i / double(n);
  return {0.5 + 0.5 * std::cos(angle), 0.5 + 0.5 * std::sin(angle)};
}

/// the places of the border: lengths along each side keep their proportions.
std::vector<Plane_point> places_of_border(const Cell_patches& faces, const std::vector<std::uint32_t>& border,
                                          const std::vector<std::size_t>& corners) {
  const std::size_t n = corners.size(), m = border.size();
  const auto length = [&](std::size_t i) {
    return distance(faces.points[border[i]], faces.points[border[(i + 1) % m]]);
  };
  std::vector<Plane_point> places(m);
  const bool round = n < 3;
  const std::size_t sides = round ? 1 : n;
  for (std::size_t s = 0; s < sides; ++s) {
    const std::size_t first = round ? 0 : corners[s], last = s + 1 < sides ? corners[s + 1] : m;
    double whole = 0;
    for (std::size_t i = first; i < last; ++i)
      whole += length(i);
    double done = 0;
    const Plane_point a = polygon_corner(double(s), n), b = polygon_corner(double(s + 1), n);
    for (std::size_t i = first; i < last; ++i) {
      const double t = whole > 0 ? done / whole : double(i - first) / double(last - first);
      places[i] = round ? polygon_corner(t, 1) : Plane_point{(1 - t) * a[0] + t * b[0], (1 - t) * a[1] + t * b[1]};
      done += length(i);
    }
  }
  return places;
}

double area_distortion(const Triangles& disc, const std::vector<Plane_point>& places) {
  std::vector<double> on_surface, in_plane;
  double sum_on_surface = 0, sum_in_plane = 0;
  for (const auto& [a, b, c] : disc.corners) {
    const Plane_point &p = places[a], &q = places[b], &r = places[c];
    on_surface.push_back(0.5 * norm(cross(disc.points[b] - disc.points[a], disc.points[c] - disc.points[a])));
    in_plane.push_back(0.5 * ((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])));
    sum_on_surface += on_surface.back();
    sum_in_plane += in_plane.back();
  }
  double sum = 0;
  for (std::size_t i = 0; i < on_surface.size(); ++i)
    if (on_surface[i] > 0 && in_plane[i] > 0)
      sum += on_surface[i] / sum_on_surface *
             std::abs(std::log(in_plane[i] / sum_in_plane * sum_on_surface / on_surface[i]));
  return std::exp(sum);
}

/// what to do with one cell.
Flattening_outcome flatten_cell(const Extremal_mesh& mesh, std::uint32_t c, Piece& piece) {
  const auto rough = border_of_disc(triangles_of(piece.faces));
  if (!rough || mesh.cell(c).boundary.size() != 1 || mesh.cell(c).boundary.front().empty())
    return Flattening_outcome::not_a_disk;
  const std::set<std::uint32_t> on_border(rough->begin(), rough->end());
  std::set<Ends> border_sides;
  for (std::size_t i = 0; i < rough->size(); ++i) {
    const auto [a, b] = std::minmax((*rough)[i], (*rough)[(i + 1) % rough->size()]);
    border_sides.insert({a, b});
  }
  piece.faces = divide_edges(piece.faces, [&](std::uint32_t a, std::uint32_t b) {
    return on_border.contains(a) && on_border.contains(b) && !border_sides.contains({std::min(a, b), std::max(a, b)});
  });
  std::vector<std::uint32_t> border = *rough;
  const std::vector<Corner> corners = corners_of(mesh, c);
  const auto at = place_corners(mesh, piece.faces, corners, border);
  if (!at)
    return Flattening_outcome::unclear_border;
  for (const Corner& corner : corners)
    piece.result.corners.push_back(corner.vertex);
  const std::vector<Plane_point> places = places_of_border(piece.faces, border, *at);
  const Triangles disc = triangles_of(piece.faces);
  for (const Flat_weights weights : {Flat_weights::mean_value, Flat_weights::uniform}) {
    piece.places = flatten_disc(disc, border, places, weights);
    if (!piece.places.empty() && number_of_flipped(disc, piece.places) == 0) {
      piece.result.area_distortion = area_distortion(disc, piece.places);
      return Flattening_outcome::flat;
    }
  }
  piece.places.clear();
  return Flattening_outcome::rounding;
}

/// the polygons of each cell, all cells in one walk over the surface.
std::vector<Cell_patches> by_cell(const Cell_patches& cells, std::size_t n) {
  std::vector<Cell_patches> parts(n);
  std::vector<std::map<std::uint32_t, std::uint32_t>> number(n);
  for (std::size_t i = 0; i < cells.cell.size(); ++i) {
    const std::uint32_t c = cells.cell[i];
    Cell_patches& part = parts[c];
    for (std::size_t j = cells.begin[i]; j < cells.begin[i + 1]; ++j) {
      const std::uint32_t p = cells.corners[j];
      const auto [found, is_new] = number[c].try_emplace(p, std::uint32_t(part.points.size()));
      if (is_new) {
        part.points.push_back(cells.points[p]);
        part.normals.push_back(cells.normals[p]);
      }
      part.corners.push_back(found->second);
    }
    part.begin.push_back(part.corners.size());
    part.cell.push_back(c);
  }
  return parts;
}

} // namespace

std::string_view to_string(Flattening_outcome outcome) {
  switch (outcome) {
  case Flattening_outcome::flat:
    return "flat";
  case Flattening_outcome::not_a_disk:
    return "not_a_disk";
  case Flattening_outcome::unclear_border:
    return "unclear_border";
  case Flattening_outcome::rounding:
    break;
  }
  return "rounding";
}

Flattening flatten(const Extremal_mesh& mesh, const Cell_patches& cells, int threads, const Progress& progress) {
  require_cells_of(mesh, cells);
  const std::size_t n = mesh.number_of_cells();
  const std::vector<Cell_patches> parts = by_cell(cells, n);
  std::vector<Piece> pieces(n);
  Thread_pool pool(threads);
  constexpr std::size_t block = 256;
  for (std::size_t first = 0; first < n; first += block) {
    if (progress && !progress(double(first) / double(n)))
      throw Cancelled();
    pool.for_each(std::min(block, n - first), 1, [&](std::size_t i) {
      const std::size_t c = first + i;
      Piece& piece = pieces[c];
      piece.faces = divide_into_triangles(internal::manifold_patches(parts[c]));
      piece.result.outcome = flatten_cell(mesh, std::uint32_t(c), piece);
    });
  }
  Flattening result;
  for (Piece& piece : pieces) {
    const auto offset = std::uint32_t(result.faces.points.size());
    Cell_patches& all = result.faces;
    all.points.insert(all.points.end(), piece.faces.points.begin(), piece.faces.points.end());
    all.normals.insert(all.normals.end(), piece.faces.normals.begin(), piece.faces.normals.end());
    all.cell.insert(all.cell.end(), piece.faces.cell.begin(), piece.faces.cell.end());
    piece.result.first_triangle = result.places.size();
    piece.result.triangles = piece.faces.cell.size();
    for (std::size_t i = 0; i < piece.faces.corners.size(); ++i) {
      const std::uint32_t corner = piece.faces.corners[i];
      if (i % 3 == 0)
        result.places.emplace_back();
      all.corners.push_back(offset + corner);
      if (!piece.places.empty())
        result.places.back()[i % 3] = piece.places[corner];
      if (i % 3 == 2)
        all.begin.push_back(all.corners.size());
    }
    if (!piece.places.empty())
      result.flipped += number_of_flipped(triangles_of(piece.faces), piece.places);
    result.cells.push_back(std::move(piece.result));
  }
  return result;
}

} // namespace CGAL::Extremal_mesh_3
