// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Surface_walk.h"

#include "../differential/vector.h"

#include <algorithm>

namespace CGAL::Extremal_mesh_3 {

void Surface_walk::start(std::uint32_t v) {
  if (++walk_ == 0) { // after 2³² walks
    std::fill(visited_.begin(), visited_.end(), 0U);
    walk_ = 1;
  }
  found_.assign(1, v);
  visited_[v] = walk_;
  can_grow_ = false;
}

std::span<const std::uint32_t> Surface_walk::within_distance(std::uint32_t v, const Vector& normal, double radius) {
  start(v);
  const Point p = vertices_[v].p;
  const Vector n = normal;
  const double limit = radius * radius;
  for (std::size_t i = 0; i < found_.size(); ++i)
    for (const std::uint32_t w : adjacency_[found_[i]]) {
      if (!visit(w))
        continue;
      const Mesh_vertex& x = vertices_[w];
      const Vector d = x.p - p;
      if (!(dot(x.n, n) > least_cosine))
        continue;
      if (dot(d, d) < limit)
        found_.push_back(w);
      else
        can_grow_ = true;
    }
  return found_;
}

std::span<const std::uint32_t> Surface_walk::within_rings(std::uint32_t v, const Vector& normal, int rings) {
  start(v);
  const Vector n = normal;
  std::size_t first = 0;
  for (int ring = 0; ring <= rings; ++ring) {
    const std::size_t last = found_.size();
    for (; first < last; ++first)
      for (const std::uint32_t w : adjacency_[found_[first]]) {
        if (!visit(w) || !(dot(vertices_[w].n, n) > least_cosine))
          continue;
        if (ring < rings)
          found_.push_back(w);
        else
          can_grow_ = true;
      }
  }
  return found_;
}

} // namespace CGAL::Extremal_mesh_3
