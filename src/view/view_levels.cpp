// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "view_levels.h"

#include "../io/cell_colours.h"

#include <algorithm>
#include <array>
#include <utility>

namespace CGAL::Extremal_mesh_3 {

namespace {

/// levels at even distances; of steps with the same persistence all are done, as a threshold would have it.
std::vector<std::size_t> some_levels(const Simplification& simplification, std::size_t most) {
  const std::size_t steps = simplification.steps().size();
  std::vector<std::size_t> levels{0};
  for (std::size_t i = 1; i < most && steps > 0; ++i) {
    const std::size_t step = std::max<std::size_t>(1, steps * i / (most - 1)) - 1;
    levels.push_back(simplification.level_of_persistence(simplification.steps()[step].persistence));
  }
  std::sort(levels.begin(), levels.end());
  levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
  return levels;
}

/// The segments of a mesh's lines by their ends. Lines of simpler meshes run along lines of the given one, through the same points.
class Segments {
public:
  explicit Segments(const Extremal_mesh& mesh) {
    std::uint32_t number = 0;
    for (std::size_t e = 0; e < mesh.number_of_edges(); ++e) {
      const std::vector<Point>& points = mesh.edge(e).polyline;
      for (std::size_t i = 0; i + 1 < points.size(); ++i)
        all_.emplace_back(key(points[i], points[i + 1]), number++);
    }
    std::sort(all_.begin(), all_.end());
  }
  std::size_t size() const { return all_.size(); }

  /// calls a function with the number of each segment that has these ends.
  template <typename Function> void find(const Point& a, const Point& b, const Function& function) const {
    const Key wanted = key(a, b);
    auto i = std::lower_bound(all_.begin(), all_.end(), std::pair<Key, std::uint32_t>{wanted, 0});
    for (; i != all_.end() && i->first == wanted; ++i)
      function(i->second);
  }

private:
  using Key = std::array<Point, 2>;
  static Key key(const Point& a, const Point& b) { return a < b ? Key{a, b} : Key{b, a}; }

  std::vector<std::pair<Key, std::uint32_t>> all_;
};

} // namespace

View_levels view_levels(const Extremal_mesh& mesh, const Simplification& simplification, Cell_colouring colouring,
                        std::size_t most) {
  View_levels result;
  result.levels = some_levels(simplification, most);
  const Segments segments(mesh);
  result.of_segment.assign(segments.size(), 0);
  result.of_vertex.assign(mesh.number_of_vertices(), 0);
  const std::vector<double> vertex_persistence = simplification.vertex_persistence();
  for (std::size_t i = 0; i < result.levels.size(); ++i) {
    const std::size_t level = result.levels[i];
    const Extremal_mesh simple = simplification.mesh_at(level);
    const double persistence = level == 0 ? 0 : simplification.steps()[level - 1].persistence;
    result.persistence.push_back(persistence);
    result.vertices.push_back(simple.number_of_vertices());
    result.edges.push_back(simple.number_of_edges());
    result.cells.push_back(simple.number_of_cells());
    for (std::size_t v = 0; v < vertex_persistence.size(); ++v)
      if (level == 0 || vertex_persistence[v] > persistence)
        result.of_vertex[v] = std::uint8_t(i);
    for (std::size_t e = 0; e < simple.number_of_edges(); ++e) {
      const std::vector<Point>& points = simple.edge(e).polyline;
      for (std::size_t j = 0; j + 1 < points.size(); ++j)
        segments.find(points[j], points[j + 1], [&](std::uint32_t s) { result.of_segment[s] = std::uint8_t(i); });
    }
    const std::vector<Colour> colours = cell_colours(simple, colouring);
    for (const std::uint32_t cell : simplification.cells_at(level))
      result.colours.push_back(colours[cell]);
  }
  return result;
}

} // namespace CGAL::Extremal_mesh_3
