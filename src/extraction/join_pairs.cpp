// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "join_pairs.h"

#include <algorithm>
#include <map>

namespace CGAL::Extremal_mesh_3 {

void join_pairs(const Border_crossings& met, int joined, std::vector<int>& partner) {
  const int n = int(met.crossings.size());
  partner.assign(std::size_t(n), -1);
  if (joined != 0) {
    std::map<std::int32_t, std::vector<std::size_t>> of_level;
    for (std::size_t i = 0; i < met.crossings.size(); ++i)
      of_level[met.crossings[i].level].push_back(i);
    // Two such levels could be joined so that their lines cross: then, in cells that are not certain, neither is.
    const auto fours =
        std::count_if(of_level.begin(), of_level.end(), [](const auto& x) { return x.second.size() == 4; });
    for (const auto& [level, c] : of_level) {
      if (c.size() != 4 || fours != 1)
        continue;
      // Between crossing c[i] and the next one E_g is positive if the phase rises from an even level.
      const bool positive = met.crossings[c[0]].rising == (level % 2 == 0);
      const std::size_t first = positive == (joined > 0) ? 1 : 0;
      for (const std::size_t i : {first, first + 2}) {
        partner[c[i]] = int(c[(i + 1) % 4]);
        partner[c[(i + 1) % 4]] = int(c[i]);
      }
    }
  }
  std::vector<int> open; // crossings still without a partner, in order
  for (int i = 0; i < n; ++i) {
    if (partner[std::size_t(i)] >= 0)
      continue;
    const Border_crossing& c = met.crossings[std::size_t(i)];
    if (!open.empty()) {
      const Border_crossing& last = met.crossings[std::size_t(open.back())];
      if (last.level == c.level && last.rising != c.rising) {
        partner[std::size_t(i)] = open.back();
        partner[std::size_t(open.back())] = i;
        open.pop_back();
        continue;
      }
    }
    open.push_back(i);
  }
  // The border is a circle: the last may pair with the first, whose level is 2·winding higher after a turn.
  std::size_t first = 0;
  while (open.size() - first >= 2) {
    const Border_crossing &a = met.crossings[std::size_t(open[first])], &b = met.crossings[std::size_t(open.back())];
    if (b.level != a.level + 2 * met.winding_phi || a.rising == b.rising)
      break;
    partner[std::size_t(open[first])] = open.back();
    partner[std::size_t(open.back())] = open[first];
    ++first;
    open.pop_back();
  }
}

} // namespace CGAL::Extremal_mesh_3
