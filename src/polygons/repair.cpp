// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "repair.h"

#include "../cells/Union_find.h"
#include "../cgal/mesh_orientation.h"
#include "../differential/vector.h"
#include "flat_faces.h"
#include "weld.h"

#include <algorithm>
#include <optional>
#include <set>
#include <stdexcept>
#include <unordered_map>
#include <utility>

namespace CGAL::Extremal_mesh_3 {

namespace {

/// \param scratch  is overwritten; to be used again saves a lot of time
bool has_repetition(const Polygon& polygon, Polygon& scratch) {
  scratch = polygon;
  std::sort(scratch.begin(), scratch.end());
  return std::adjacent_find(scratch.begin(), scratch.end()) != scratch.end();
}

/// divides a closed walk into loops that meet no point twice. Those of one or two points are left out.
void append_loops(const Polygon& walk, std::vector<Polygon>& loops) {
  Polygon path;
  std::unordered_map<std::uint32_t, std::size_t> position; // in the path
  const auto close_loop = [&](std::size_t begin) {
    const Polygon loop(path.begin() + std::ptrdiff_t(begin), path.end());
    for (const std::uint32_t corner : loop)
      position.erase(corner);
    path.resize(begin);
    if (loop.size() >= 3)
      loops.push_back(loop);
  };
  for (const std::uint32_t corner : walk) {
    if (const auto found = position.find(corner); found != position.end())
      close_loop(found->second);
    position[corner] = path.size();
    path.push_back(corner);
  }
  close_loop(0);
}

/// \return how many polygons were left out or divided
std::size_t make_simple(std::vector<Polygon>& polygons) {
  std::vector<Polygon> simple;
  simple.reserve(polygons.size());
  Polygon scratch;
  std::size_t count = 0;
  for (Polygon& polygon : polygons)
    if (polygon.size() >= 3 && !has_repetition(polygon, scratch))
      simple.push_back(std::move(polygon));
    else {
      append_loops(polygon, simple);
      ++count;
    }
  polygons = std::move(simple);
  return count;
}

/// the same for polygons that differ by where they begin and which way they go round only.
Polygon canonical(Polygon polygon) {
  std::rotate(polygon.begin(), std::min_element(polygon.begin(), polygon.end()), polygon.end());
  if (polygon[1] > polygon.back())
    std::reverse(polygon.begin() + 1, polygon.end());
  return polygon;
}

/// a number that is the same for polygons with the same corners in any order.
std::uint64_t hash(const Polygon& polygon) {
  std::uint64_t sum = 0;
  for (const std::uint32_t corner : polygon) {
    std::uint64_t x = (corner + 1) * 0x9e3779b97f4a7c15U; // Steele et al. 2014, SplitMix
    x = (x ^ (x >> 30U)) * 0xbf58476d1ce4e5b9U;
    sum += x ^ (x >> 27U);
  }
  return sum;
}

/// \return how many polygons were left out
std::size_t drop_duplicates(std::vector<Polygon>& polygons) {
  std::vector<std::pair<std::uint64_t, std::size_t>> order;
  for (std::size_t i = 0; i < polygons.size(); ++i)
    order.emplace_back(hash(polygons[i]), i);
  std::sort(order.begin(), order.end());
  for (auto begin = order.begin(), end = begin; begin != order.end(); begin = end) {
    end = std::find_if(begin, order.end(), [&](const auto& entry) { return entry.first != begin->first; });
    if (end - begin == 1) // almost always
      continue;
    std::set<Polygon> met;
    for (auto entry = begin; entry != end; ++entry)
      if (Polygon& polygon = polygons[entry->second]; !met.insert(canonical(polygon)).second)
        polygon.clear();
  }
  return std::erase_if(polygons, [](const Polygon& polygon) { return polygon.empty(); });
}

Cell_complex cells_of(const Polygon_soup& soup) {
  std::vector<std::size_t> begin{0};
  std::vector<std::uint32_t> corners;
  for (const Polygon& polygon : soup.polygons) {
    corners.insert(corners.end(), polygon.begin(), polygon.end());
    begin.push_back(corners.size());
  }
  return make_cell_complex(soup.points, begin, corners);
}

/// the cells, if the polygons are an oriented manifold already, as they mostly are.
std::optional<Cell_complex> cells_if_manifold(const Polygon_soup& soup) {
  try {
    return cells_of(soup);
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

/// What tells how a component of the surface should be oriented.
struct Component {
  std::int64_t faces = 0, turned = 0;
  bool is_closed = true;
  double volume = 0; ///< positive if the normals point outwards

  bool should_turn() const { return is_closed && volume != 0 ? volume < 0 : 2 * turned > faces; }
};

/// the volume between a polygon and a point, times 6.
double volume(const std::vector<Point>& points, const Polygon& polygon, const Point& from) {
  double sum = 0;
  const Vector a = points[polygon[0]] - from;
  for (std::size_t i = 2; i < polygon.size(); ++i)
    sum += dot(a, cross(points[polygon[i - 1]] - from, points[polygon[i]] - from));
  return sum;
}

/// turns components of the surface over.
/// \return whether there were any
bool turn_components(Polygon_soup& soup, const Cell_complex& cells, std::vector<bool>& turned) {
  Union_find sets(cells.number_of_cells());
  for (const auto& [left, right] : cells.edge_cells)
    if (right != Cell_complex::no_cell)
      sets.unite(std::uint32_t(left), std::uint32_t(right));
  std::vector<Component> components(cells.number_of_cells()); // at the first face of each
  for (std::uint32_t f = 0; f < soup.polygons.size(); ++f) {
    const std::uint32_t first = sets.find(f);
    Component& component = components[first];
    ++component.faces;
    component.turned += turned[f];
    // From a point nearby, not the origin: less is lost to rounding.
    component.volume += volume(soup.points, soup.polygons[f], soup.points[soup.polygons[first][0]]);
  }
  for (const auto& [left, right] : cells.edge_cells)
    if (right == Cell_complex::no_cell)
      components[sets.find(std::uint32_t(left))].is_closed = false;

  bool any = false;
  for (std::uint32_t f = 0; f < soup.polygons.size(); ++f)
    if (components[sets.find(f)].should_turn()) {
      std::reverse(soup.polygons[f].begin(), soup.polygons[f].end());
      turned[f] = !turned[f];
      any = true;
    }
  return any;
}

} // namespace

Mesh repair(Polygon_soup soup, double weld_tolerance) {
  Mesh mesh;
  Mesh_repairs& repairs = mesh.repairs;
  if (soup.polygons.empty())
    throw std::runtime_error("expected at least one face, found none");
  const std::size_t faces = soup.polygons.size();
  repairs.isolated_vertices = drop_isolated_points(soup);
  repairs.welded_vertices = weld(soup, weld_tolerance);
  repairs.degenerate_faces = make_simple(soup.polygons);
  if (soup.polygons.empty())
    throw std::runtime_error("expected a face with three different vertices, found none among " +
                             std::to_string(faces) + " faces");
  repairs.duplicate_faces = drop_duplicates(soup.polygons);
  repairs.isolated_vertices += drop_isolated_points(soup);

  std::optional<Cell_complex> cells = cells_if_manifold(soup);
  Orientation_counts orientation;
  orientation.turned.resize(soup.polygons.size());
  if (!cells)
    orientation = orient(soup);
  repairs.non_manifold_edges = orientation.non_manifold_edges;
  repairs.non_manifold_vertices = orientation.non_manifold_vertices;
  repairs.flat_faces = merge_flat_faces(soup, orientation.turned);
  mesh.cells = cells && repairs.flat_faces == 0 ? std::move(*cells) : cells_of(soup);
  if (turn_components(soup, mesh.cells, orientation.turned))
    mesh.cells = cells_of(soup);
  repairs.turned_faces = std::size_t(std::count(orientation.turned.begin(), orientation.turned.end(), true));
  return mesh;
}

} // namespace CGAL::Extremal_mesh_3
