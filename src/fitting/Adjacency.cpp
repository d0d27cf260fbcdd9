// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Adjacency.h"

#include <algorithm>

namespace CGAL::Extremal_mesh_3 {

namespace {

/// turns the pairs that for_each_pair(add) adds into lists without duplicates. It is called twice, to count and to
/// fill.
template <class For_each_pair> Adjacency collect(std::size_t vertices, const For_each_pair& for_each_pair) {
  Adjacency a;
  a.begin.assign(vertices + 1, 0);
  for_each_pair([&](std::uint32_t from, std::uint32_t) { ++a.begin[from + 1]; });
  for (std::size_t v = 0; v < vertices; ++v)
    a.begin[v + 1] += a.begin[v];
  a.vertices.resize(a.begin.back());
  std::vector<std::size_t> end(a.begin.begin(), a.begin.end() - 1);
  for_each_pair([&](std::uint32_t from, std::uint32_t to) {
    const auto first = a.vertices.begin() + std::ptrdiff_t(a.begin[from]);
    const auto last = a.vertices.begin() + std::ptrdiff_t(end[from]);
    if (std::find(first, last, to) == last)
      a.vertices[end[from]++] = to;
  });
  std::size_t position = 0;
  for (std::size_t v = 0; v < vertices; ++v) {
    const std::size_t first = a.begin[v];
    a.begin[v] = position;
    position =
        std::size_t(std::copy(a.vertices.begin() + std::ptrdiff_t(first), a.vertices.begin() + std::ptrdiff_t(end[v]),
                              a.vertices.begin() + std::ptrdiff_t(position)) -
                    a.vertices.begin());
  }
  a.begin.back() = position;
  a.vertices.resize(position);
  return a;
}

} // namespace

Adjacency neighbours_along_edges(const Cell_complex& cells) {
  return collect(cells.points.size(), [&](const auto& add) {
    for (const auto& [a, b] : cells.edges) {
      add(a, b);
      add(b, a);
    }
  });
}

Adjacency neighbours_across_cells(const Cell_complex& cells) {
  constexpr std::size_t most_sides = 16;
  return collect(cells.points.size(), [&](const auto& add) {
    for (const auto& [a, b] : cells.edges) {
      add(a, b);
      add(b, a);
    }
    for (std::size_t c = 0; c < cells.number_of_cells(); ++c) {
      const std::size_t first = cells.cell_begin[c], last = cells.cell_begin[c + 1];
      if (last - first == 3 || last - first > most_sides)
        continue;
      for (std::size_t i = first; i < last; ++i)
        for (std::size_t j = first; j < last; ++j)
          if (i != j)
            add(cells.source(cells.half_edges[i]), cells.source(cells.half_edges[j]));
    }
  });
}

} // namespace CGAL::Extremal_mesh_3
