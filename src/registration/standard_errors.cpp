// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "standard_errors.h"

#include "../differential/vector.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace CGAL::Extremal_mesh_3 {

void estimate_errors(Alignment& result, const std::vector<Contribution>& contributions, const Change_frame& frame,
                     const Alignment_options& options, const Square_matrix& inverse) {
  std::map<std::array<std::int64_t, 3>, Unknowns> blocks;
  for (const Contribution& c : contributions) {
    std::array<std::int64_t, 3> block{};
    for (std::size_t i = 0; i < 3; ++i)
      block[i] = std::int64_t(std::floor((c.point[i] - frame.centre[i]) / options.block));
    Unknowns& sum = blocks[block];
    for (std::size_t i = 0; i < unknowns; ++i)
      sum[i] += c.sum[i];
  }
  Unknowns scatter{};
  for (auto& [block, sum] : blocks) {
    if (!options.scale)
      sum[6] = 0;
    const Unknowns change = inverse * sum;
    for (std::size_t i = 0; i < unknowns; ++i)
      scatter[i] += change[i] * change[i];
  }
  // as for a variance from few numbers
  const double n = double(blocks.size()), factor = n > unknowns ? n / (n - double(unknowns)) : n;
  const auto error = [&](std::size_t first, std::size_t end) {
    double by_weights = 0, by_blocks = 0;
    for (std::size_t i = first; i < end; ++i) {
      by_weights += inverse[i][i];
      by_blocks += factor * scatter[i];
    }
    return std::sqrt(std::max(by_weights, by_blocks));
  };
  result.centre = frame.centre;
  result.rotation_error = error(0, 3) / frame.size;
  result.translation_error = error(3, 6);
  result.scale_error = options.scale ? error(6, 7) / frame.size : 0;
}

} // namespace CGAL::Extremal_mesh_3
