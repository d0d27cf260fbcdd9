// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Segment_finder.h"

#include "../differential/vector.h"
#include "../queries/require.h"

#include <algorithm>

namespace CGAL::Extremal_mesh_3 {

Segment_finder::Segment_finder(const Extremal_mesh& mesh, std::optional<Line_type> type) : mesh_(mesh) {
  std::vector<Bounding_box> boxes;
  for (std::uint32_t i = 0; i < mesh.number_of_edges(); ++i) {
    const Extremal_mesh_edge& e = mesh.edge(i);
    for (std::uint32_t s = 0; s + 1 < e.polyline.size(); ++s) {
      if (type && e.segment_types[s] != *type)
        continue;
      const Point &p = e.polyline[s], &q = e.polyline[s + 1];
      require_finite(p);
      require_finite(q);
      Bounding_box& box = boxes.emplace_back();
      for (std::size_t a = 0; a < 3; ++a) {
        box.low[a] = std::min(p[a], q[a]);
        box.high[a] = std::max(p[a], q[a]);
      }
      segments_.push_back({i, s});
    }
  }
  require_number(segments_.size());
  if (!boxes.empty())
    tree_.emplace(boxes);
}

double Segment_finder::distance_to(std::uint32_t i, const Point& p) const {
  const auto& line = mesh_.edge(segments_[i].edge).polyline;
  const Point &a = line[segments_[i].segment], &b = line[segments_[i].segment + 1];
  const Vector ab = b - a;
  const double squared = dot(ab, ab), t = squared > 0 ? std::clamp(dot(p - a, ab) / squared, 0.0, 1.0) : 0;
  return distance(p, a + t * ab);
}

auto Segment_finder::nearest(const Point& p, double within) const -> std::optional<Near> {
  std::optional<Near> found;
  std::uint32_t first = 0;
  double bound = within;
  if (tree_)
    tree_->visit_near(p, [&](std::uint32_t i) {
      const double d = distance_to(i, p);
      // of several at the same distance the first one, in whichever order they come
      if (d < bound || (d == bound && (!found || i < first))) {
        bound = d;
        first = i;
        found = Near{segments_[i].edge, segments_[i].segment, d};
      }
      return bound * bound;
    });
  return found;
}

void Segment_finder::for_each(const Point& p, double within, const std::function<void(const Near&)>& visit) const {
  if (tree_)
    tree_->visit_near(p, [&](std::uint32_t i) {
      if (const double d = distance_to(i, p); d <= within)
        visit({segments_[i].edge, segments_[i].segment, d});
      return within * within;
    });
}

} // namespace CGAL::Extremal_mesh_3
