// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "weld.h"

#include "../cells/Union_find.h"
#include "../differential/vector.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <tuple>

namespace CGAL::Extremal_mesh_3 {

namespace {

struct Box {
  Point low, high;
};

Box bounding_box(const std::vector<Point>& points) {
  Box box{points.front(), points.front()};
  for (const Point& p : points)
    for (std::size_t a = 0; a < 3; ++a) {
      box.low[a] = std::min(box.low[a], p[a]);
      box.high[a] = std::max(box.high[a], p[a]);
    }
  return box;
}

/// keeps the points for which `keep` holds; others are at `replacement`, which is kept.
template <typename Keep, typename Replacement>
std::size_t compact(Polygon_soup& soup, const Keep& keep, const Replacement& replacement) {
  std::vector<std::uint32_t> index(soup.points.size());
  std::uint32_t kept = 0;
  for (std::uint32_t i = 0; i < soup.points.size(); ++i)
    if (keep(i)) {
      soup.points[kept] = soup.points[i];
      index[i] = kept++;
    }
  for (Polygon& polygon : soup.polygons)
    for (std::uint32_t& corner : polygon)
      corner = index[replacement(corner)];
  const std::size_t dropped = soup.points.size() - kept;
  soup.points.resize(kept);
  return dropped;
}

void unite_equal(const std::vector<Point>& points, Union_find& sets) {
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](auto a, auto b) { return points[a] < points[b]; });
  for (std::size_t i = 1; i < order.size(); ++i)
    if (points[order[i - 1]] == points[order[i]])
      sets.unite(order[i - 1], order[i]);
}

/// Points sorted by the cubes of a grid in which they are.
class Grid {
public:
  Grid(const std::vector<Point>& points, const Point& low, double size)
      : points_(points), low_(low), size_(size), entries_(points.size()) {
    for (std::uint32_t i = 0; i < points.size(); ++i)
      entries_[i] = {cube(points[i]), i};
    std::sort(entries_.begin(), entries_.end());
  }

  /// calls visit(j) for each point j in the cubes that the box around p meets.
  template <typename Visit> void for_each_near(const Point& p, double radius, const Visit& visit) const {
    const Cube low = cube(p - Vector{radius, radius, radius}), high = cube(p + Vector{radius, radius, radius});
    for (std::int64_t x = low[0]; x <= high[0]; ++x)
      for (std::int64_t y = low[1]; y <= high[1]; ++y) { // cubes along z are neighbours in the order
        auto entry = std::lower_bound(entries_.begin(), entries_.end(), Entry{{x, y, low[2]}, 0});
        for (; entry != entries_.end() && entry->first <= Cube{x, y, high[2]}; ++entry)
          visit(entry->second);
      }
  }

private:
  using Cube = std::array<std::int64_t, 3>;
  using Entry = std::pair<Cube, std::uint32_t>;

  Cube cube(const Point& p) const {
    Cube c;
    for (std::size_t a = 0; a < 3; ++a)
      c[a] = std::int64_t(std::floor((p[a] - low_[a]) / size_));
    return c;
  }

  const std::vector<Point>& points_;
  Point low_;
  double size_;
  std::vector<Entry> entries_;
};

void unite_near(const std::vector<Point>& points, double tolerance, Union_find& sets) {
  // In cubes of a few times the tolerance the box around a point rarely meets another one.
  constexpr double cubes_per_tolerance = 4;
  const Grid grid(points, bounding_box(points).low, cubes_per_tolerance * tolerance);
  for (std::uint32_t i = 0; i < points.size(); ++i)
    grid.for_each_near(points[i], tolerance, [&](std::uint32_t j) {
      if (j < i && distance(points[i], points[j]) <= tolerance)
        sets.unite(i, j);
    });
}

} // namespace

double diagonal(const std::vector<Point>& points) {
  if (points.empty())
    return 0;
  const Box box = bounding_box(points);
  return distance(box.low, box.high);
}

std::size_t weld(Polygon_soup& soup, double tolerance) {
  for (Point& p : soup.points)
    for (double& coordinate : p)
      coordinate += 0.0; // no −0
  Union_find sets(soup.points.size());
  // Below, cubes of the grid would have numbers that are no integers any more, and no double is that near to another.
  constexpr double finest = 1e-18;
  if (tolerance > finest * diagonal(soup.points))
    unite_near(soup.points, tolerance, sets);
  else
    unite_equal(soup.points, sets);
  return compact(
      soup, [&](std::uint32_t i) { return sets.find(i) == i; }, [&](std::uint32_t i) { return sets.find(i); });
}

std::size_t drop_isolated_points(Polygon_soup& soup) {
  std::vector<bool> used(soup.points.size());
  for (const Polygon& polygon : soup.polygons)
    for (const std::uint32_t corner : polygon)
      used[corner] = true;
  return compact(
      soup, [&](std::uint32_t i) { return used[i]; }, [](std::uint32_t i) { return i; });
}

} // namespace CGAL::Extremal_mesh_3
