// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Regions.h"

#include "../cells/Union_find.h"
#include "../cells/polygon_triangles.h"
#include "../differential/vector.h"

#include <cmath>
#include <unordered_map>

namespace CGAL::Extremal_mesh_3 {

namespace {

/// √|E_g|; 0 at an umbilic, where E_g has no limit.
double root_extremality(const Sample& s) {
  const double R = std::abs(s.shape.Q);
  return R > 0 ? std::sqrt(std::abs(s.shape.Phi().imag()) / (2 * R * R * R)) : 0;
}

/// adds a piece of a region to it.
/// \param root  √|E_g|, the mean over the corners
void add(Extremal_mesh_cell& cell, const std::vector<const Point*>& corners, double root) {
  const double area = triangles_of_polygon(corners).area;
  ++cell.euler_characteristic;
  cell.area += area;
  cell.weight += area * root;
}

} // namespace

Regions::Regions(const Arrangement& arrangement, Cell_patches* patches)
    : arrangement_(arrangement), region_(arrangement.number_of_intervals(), no_id) {
  unite_pieces();
  count();
  if (patches)
    add_patches(*patches);
}

void Regions::unite_pieces() {
  const Refined_complex& complex = arrangement_.complex();
  const auto& edges = complex.edges();
  Union_find sets(region_.size());
  for (std::uint32_t e = 0; e < edges.size(); ++e)
    if (!edges[e].divided() && arrangement_.crossings_of(e) == 0)
      sets.unite(edges[e].a, edges[e].b);
  std::vector<Piece> pieces;
  for (std::uint32_t c = 0; c < complex.cells().size(); ++c) {
    if (!arrangement_.is_crossed(c)) // one piece, and one interval
      continue;
    arrangement_.pieces(c, pieces);
    for (const Piece& piece : pieces)
      for (const std::uint32_t interval : piece.intervals)
        sets.unite(piece.intervals[0], interval);
  }

  // Regions are numbered in the order of their first interval; intervals of divided edges and samples that are no
  // corners are in none.
  const auto mark = [&](std::uint32_t interval, bool positive) {
    const std::uint32_t set = sets.find(interval);
    if (region_[set] == no_id) {
      region_[set] = std::uint32_t(cells_.size());
      cells_.emplace_back();
      cells_.back().sign = positive ? 1 : -1;
      cells_.back().euler_characteristic = 0;
    }
    region_[interval] = region_[set];
  };
  for (std::uint32_t e = 0; e < edges.size(); ++e) {
    if (edges[e].divided())
      continue;
    const std::uint32_t m = arrangement_.crossings_of(e);
    bool positive = complex.samples()[edges[e].a].positive;
    if (m == 0)
      mark(edges[e].b, positive);
    for (std::uint32_t i = 0; i <= m; ++i, positive = !positive)
      mark(arrangement_.interval(e, i), positive);
  }
}

void Regions::count() {
  const Refined_complex& complex = arrangement_.complex();
  const auto& edges = complex.edges();

  // Euler characteristic of the open region: inner points − inner parts of edges + pieces.
  std::vector<char> corner(complex.samples().size(), 0); // 1: inner, 2: on the border
  for (std::uint32_t e = 0; e < edges.size(); ++e) {
    if (edges[e].divided())
      continue;
    const bool on_border = edges[e].cell[0] == no_id || edges[e].cell[1] == no_id;
    for (const std::uint32_t v : {edges[e].a, edges[e].b})
      if (on_border || corner[v] == 0)
        corner[v] = on_border ? 2 : 1;
    for (std::uint32_t i = 0; i <= arrangement_.crossings_of(e); ++i) {
      Extremal_mesh_cell& cell = cells_[region(e, i)];
      if (on_border)
        cell.touches_border = true;
      else
        --cell.euler_characteristic;
    }
  }
  for (std::uint32_t v = 0; v < corner.size(); ++v)
    if (corner[v] == 1)
      ++cells_[region_[v]].euler_characteristic;

  std::vector<double> extremality(corner.size(), 0);
  for (std::uint32_t v = 0; v < corner.size(); ++v)
    if (corner[v] != 0)
      extremality[v] = root_extremality(complex.samples()[v]);
  std::vector<Piece> pieces;
  std::vector<const Point*> corners;
  for (std::uint32_t c = 0; c < complex.cells().size(); ++c) {
    if (complex.cells()[c].divided)
      continue;
    if (!arrangement_.is_crossed(c)) {
      corners.clear();
      double weight = 0;
      std::uint32_t v = 0;
      complex.visit_border(complex.cells()[c], [&](Half_edge h) {
        v = complex.source(h);
        corners.push_back(&complex.samples()[v].p);
        weight += extremality[v];
        return true;
      });
      add(cells_[region_[v]], corners, weight / double(corners.size()));
      continue;
    }
    arrangement_.pieces(c, pieces);
    for (const Piece& piece : pieces) {
      corners.clear();
      double weight = 0;
      std::size_t weighted = 0;
      for (const Piece::Corner& corner_of_piece : piece.corners) {
        corners.push_back(&arrangement_.position(corner_of_piece));
        if (corner_of_piece.kind == Piece::Corner::Kind::sample) // elsewhere E_g is 0
          weight += extremality[corner_of_piece.id];
        weighted += corner_of_piece.kind != Piece::Corner::Kind::line_point; // however many there are
      }
      add(cells_[region_[piece.intervals[0]]], corners, weight / double(weighted));
    }
  }
}

void Regions::add_patches(Cell_patches& patches) const {
  const Refined_complex& complex = arrangement_.complex();
  using Kind = Piece::Corner::Kind;
  // Corners are shared between pieces: samples, crossings, nodes and points of lines have ranges of keys of their own.
  const std::size_t crossings = complex.samples().size(), nodes = crossings + arrangement_.crossings().size(),
                    line_points = nodes + arrangement_.nodes().size();
  std::vector<std::uint32_t> point(line_points + arrangement_.line_points().size(), no_id);
  std::vector<Piece> pieces;
  for (std::uint32_t c = 0; c < complex.cells().size(); ++c) {
    if (complex.cells()[c].divided)
      continue;
    arrangement_.pieces(c, pieces);
    for (const Piece& piece : pieces) {
      for (const Piece::Corner& corner : piece.corners) {
        const std::size_t key = corner.id + (corner.kind == Kind::sample     ? 0
                                             : corner.kind == Kind::crossing ? crossings
                                             : corner.kind == Kind::node     ? nodes
                                                                             : line_points);
        if (point[key] == no_id) {
          point[key] = std::uint32_t(patches.points.size());
          patches.points.push_back(arrangement_.position(corner));
          patches.normals.push_back(arrangement_.normal(corner));
        }
        patches.corners.push_back(point[key]);
      }
      patches.begin.push_back(patches.corners.size());
      patches.cell.push_back(region_[piece.intervals[0]]);
    }
  }
}

} // namespace CGAL::Extremal_mesh_3
