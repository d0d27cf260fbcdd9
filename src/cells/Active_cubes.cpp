// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Active_cubes.h"

#include "cube.h"

#include <algorithm>
#include <cstdint>

namespace CGAL::Extremal_mesh_3 {

Active_cubes::Active_cubes(const Lattice& lattice) : lattice_(lattice), all_(true) {
  for (std::size_t a = 0; a < 3; ++a)
    blocks_[a] = (lattice.size[a] - 1 + side - 1) / side;
  ranges_.assign(blocks_[1] * blocks_[2], {{0, lattice.size[0] - 1}});
}

Active_cubes::Active_cubes(const Function_3& f, const Lattice& lattice, Thread_pool& pool) : Active_cubes(lattice) {
  using Block = std::array<std::size_t, 3>; // in units of its own side
  std::size_t size = 1;                     // of the blocks looked at, in units of `side`
  while (size < *std::max_element(blocks_.begin(), blocks_.end()))
    size *= 2;
  std::vector<Block> open{{0, 0, 0}};
  for (;;) {
    std::vector<char> may_have_zero(open.size());
    pool.for_each(open.size(), 16, [&](std::size_t i) {
      std::array<double, 3> low, high;
      for (std::size_t a = 0; a < 3; ++a) {
        low[a] = double(open[i][a] * size * side);
        high[a] = double(std::min((open[i][a] + 1) * size * side, lattice.size[a] - 1));
      }
      Derivative_bounds d;
      may_have_zero[i] = !f.bounds(box_around(lattice, low, high), 0, d) || d.value.contains(0);
    });
    std::size_t n = 0;
    for (std::size_t i = 0; i < open.size(); ++i)
      if (may_have_zero[i])
        open[n++] = open[i];
    open.resize(n);
    if (size == 1)
      break;
    size /= 2;
    std::vector<Block> parts;
    for (const Block& b : open)
      for (std::size_t corner = 0; corner < 8; ++corner) {
        const Block part{2 * b[0] + (corner & 1), 2 * b[1] + (corner >> 1 & 1), 2 * b[2] + (corner >> 2 & 1)};
        if (part[0] * size < blocks_[0] && part[1] * size < blocks_[1] && part[2] * size < blocks_[2])
          parts.push_back(part);
      }
    open = std::move(parts);
  }

  all_ = false;
  std::sort(open.begin(), open.end());
  for (auto& row : ranges_)
    row.clear();
  for (const Block& b : open) {
    std::vector<Range>& row = ranges_[b[1] + blocks_[1] * b[2]];
    const Range range{b[0] * side, std::min((b[0] + 1) * side, lattice.size[0] - 1)};
    if (!row.empty() && row.back().last == range.first)
      row.back().last = range.last;
    else
      row.push_back(range);
  }
}

std::vector<Row_part> Active_cubes::nodes(std::size_t k) const {
  // A node is a corner of the cubes with its own number and of those before.
  const auto around = [](std::size_t node, std::size_t cubes) {
    return std::array{(node == 0 ? 0 : node - 1) / side, std::min(node, cubes - 1) / side};
  };
  std::vector<Row_part> parts;
  std::vector<Range> ranges;
  const auto layers = around(k, lattice_.size[2] - 1);
  for (std::size_t j = 0; j < lattice_.size[1]; ++j) {
    const auto rows = around(j, lattice_.size[1] - 1);
    ranges.clear();
    for (std::size_t z = layers[0]; z <= layers[1]; ++z)
      for (std::size_t y = rows[0]; y <= rows[1]; ++y)
        ranges.insert(ranges.end(), row_of_block(y, z).begin(), row_of_block(y, z).end());
    std::sort(ranges.begin(), ranges.end(), [](const Range& a, const Range& b) { return a.first < b.first; });
    for (const Range& range : ranges) {
      if (!parts.empty() && parts.back().j == j && parts.back().last >= range.first)
        parts.back().last = std::max(parts.back().last, range.last + 1);
      else
        parts.push_back({j, range.first, range.last + 1});
    }
  }
  return parts;
}

} // namespace CGAL::Extremal_mesh_3
