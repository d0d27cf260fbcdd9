// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Extremal_mesh_3/Cell_complex.h>

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace CGAL::Extremal_mesh_3 {

namespace {

/// One side of one polygon.
struct Side {
  std::uint32_t low = 0, high = 0; // the two points, ordered
  std::uint32_t position = 0;      // in the list of corners
  bool reversed = false;           // the polygon runs from high to low
};

void check_polygons(std::size_t points, const std::vector<std::size_t>& begin,
                    const std::vector<std::uint32_t>& corners) {
  if (begin.empty() || begin.front() != 0 || begin.back() != corners.size())
    throw std::invalid_argument("polygon_begin must start with 0 and end with the number of corners");
  if (corners.size() > std::numeric_limits<std::uint32_t>::max() / 4)
    throw std::invalid_argument(fmt::format("{} corners are more than a cell complex can hold", corners.size()));
  std::vector<std::uint32_t> sorted;
  for (std::size_t i = 0; i + 1 < begin.size(); ++i) {
    if (begin[i + 1] < begin[i] + 3)
      throw std::invalid_argument(fmt::format("polygon {} has fewer than 3 sides", i));
    sorted.assign(corners.begin() + std::ptrdiff_t(begin[i]), corners.begin() + std::ptrdiff_t(begin[i + 1]));
    std::sort(sorted.begin(), sorted.end());
    if (sorted.back() >= points)
      throw std::invalid_argument(
          fmt::format("polygon {} names point {}, but there are {} points", i, sorted.back(), points));
    if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end())
      throw std::invalid_argument(
          fmt::format("polygon {} meets point {} twice", i, *std::adjacent_find(sorted.begin(), sorted.end())));
  }
}

/// the sides of all polygons, by their points and positions: counted by the lower point, of which each has few.
std::vector<Side> sorted_sides(std::size_t points, const std::vector<std::size_t>& polygon_begin,
                               const std::vector<std::uint32_t>& corners) {
  const auto for_each_side = [&](const auto& visit) {
    for (std::size_t c = 0; c + 1 < polygon_begin.size(); ++c)
      for (std::size_t p = polygon_begin[c]; p < polygon_begin[c + 1]; ++p) {
        const std::uint32_t a = corners[p], b = corners[p + 1 < polygon_begin[c + 1] ? p + 1 : polygon_begin[c]];
        visit(Side{std::min(a, b), std::max(a, b), std::uint32_t(p), a > b});
      }
  };
  std::vector<std::uint32_t> end(points + 1, 0); // of the sides at each point, when all are there
  for_each_side([&](const Side& s) { ++end[s.low + 1]; });
  for (std::size_t p = 0; p < points; ++p)
    end[p + 1] += end[p];
  std::vector<Side> sides(corners.size());
  for_each_side([&](const Side& s) { sides[end[s.low]++] = s; });
  for (std::size_t p = 0; p < points; ++p)
    std::sort(sides.begin() + std::ptrdiff_t(p == 0 ? 0 : end[p - 1]), sides.begin() + std::ptrdiff_t(end[p]),
              [](const Side& a, const Side& b) { return std::tie(a.high, a.position) < std::tie(b.high, b.position); });
  return sides;
}

/// checks that the cells around every point form one fan, open at the border or closed.
void check_fans(const Cell_complex& c) {
  constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> position(2 * c.edges.size(), none); // of each half-edge
  std::vector<std::uint32_t> corners(c.points.size(), 0), start(c.points.size(), none);
  for (std::size_t p = 0; p < c.half_edges.size(); ++p) {
    position[c.half_edges[p]] = std::uint32_t(p);
    const std::uint32_t v = c.source(c.half_edges[p]);
    ++corners[v];
    start[v] = std::uint32_t(p);
  }
  const auto cell_of = [&](std::size_t p) {
    const std::uint32_t h = c.half_edges[p];
    return std::size_t(c.edge_cells[h / 2][h % 2]);
  };
  const auto previous = [&](std::size_t p) {
    const std::size_t cell = cell_of(p);
    return p == c.cell_begin[cell] ? c.cell_begin[cell + 1] - 1 : p - 1;
  };
  for (std::size_t v = 0; v < c.points.size(); ++v) {
    if (start[v] == none)
      throw std::invalid_argument(fmt::format("point {} belongs to no polygon", v));
    std::size_t met = 1;
    // Counter-clockwise from cell to cell, then clockwise if a border was met.
    std::size_t p = start[v];
    for (;;) {
      p = position[c.half_edges[previous(p)] ^ 1U];
      if (p == none || p == start[v])
        break;
      ++met;
    }
    if (p == none)
      for (p = position[c.half_edges[start[v]] ^ 1U]; p != none;) {
        ++met;
        const std::size_t cell = cell_of(p);
        const std::size_t next = p + 1 == c.cell_begin[cell + 1] ? c.cell_begin[cell] : p + 1;
        p = position[c.half_edges[next] ^ 1U];
      }
    if (met != corners[v])
      throw std::invalid_argument(fmt::format("the cells around point {} do not form a single fan", v));
  }
}

} // namespace

Cell_complex make_cell_complex(std::vector<Point> points, const std::vector<std::size_t>& polygon_begin,
                               const std::vector<std::uint32_t>& corners) {
  check_polygons(points.size(), polygon_begin, corners);
  std::vector<Side> sides = sorted_sides(points.size(), polygon_begin, corners);
  // Sides of the same two points are neighbours now; the first of a group owns the edge.
  std::vector<std::uint32_t> partner(corners.size()); // position of the owner of the edge
  for (std::size_t i = 0; i < sides.size();) {
    std::size_t j = i + 1;
    while (j < sides.size() && sides[j].low == sides[i].low && sides[j].high == sides[i].high)
      ++j;
    if (j - i > 2 || (j - i == 2 && sides[i].reversed == sides[i + 1].reversed))
      throw std::invalid_argument(
          j - i > 2 ? fmt::format("the edge between points {} and {} has {} polygons, more than 2", sides[i].low,
                                  sides[i].high, j - i)
                    : fmt::format("the two polygons at the edge between points {} and {} are oriented differently",
                                  sides[i].low, sides[i].high));
    for (std::size_t k = i; k < j; ++k)
      partner[sides[k].position] = sides[i].position;
    i = j;
  }

  sides = {};

  Cell_complex complex;
  complex.points = std::move(points);
  complex.cell_begin = polygon_begin;
  complex.half_edges.resize(corners.size());
  std::size_t edges = 0;
  for (std::size_t p = 0; p < corners.size(); ++p)
    edges += partner[p] == p;
  complex.edges.reserve(edges);
  complex.edge_cells.reserve(edges);
  for (std::size_t p = 0, cell = 0; p < corners.size(); ++p) {
    while (p == polygon_begin[cell + 1])
      ++cell;
    if (partner[p] == p) {
      const std::uint32_t b = corners[p + 1 < polygon_begin[cell + 1] ? p + 1 : polygon_begin[cell]];
      complex.half_edges[p] = std::uint32_t(2 * complex.edges.size());
      complex.edges.push_back({corners[p], b});
      complex.edge_cells.push_back({std::int32_t(cell), Cell_complex::no_cell});
    } else {
      complex.half_edges[p] = complex.half_edges[partner[p]] ^ 1U;
      complex.edge_cells[complex.half_edges[p] / 2][1] = std::int32_t(cell);
    }
  }
  partner = {};
  check_fans(complex);
  return complex;
}

} // namespace CGAL::Extremal_mesh_3
