// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Slices.h"

#include <algorithm>

namespace CGAL::Extremal_mesh_3 {

Slices::Slices(const Function_3& f, const Lattice& lattice, const Active_cubes& active)
    : f_(f), lattice_(lattice), active_(active), nodes_(lattice.size[0] * lattice.size[1]),
      block_(std::clamp<std::size_t>((std::size_t(1) << 21) / nodes_, 2, 16)), values_((block_ + kept) * nodes_),
      signs_((block_ + kept) * nodes_) {}

void Slices::compute_more(Thread_pool& pool) {
  const std::size_t first = end_ - std::min(end_, kept), moved = (first - first_) * nodes_;
  std::copy(values_.begin() + std::ptrdiff_t(moved), values_.begin() + std::ptrdiff_t((end_ - first_) * nodes_),
            values_.begin());
  std::copy(signs_.begin() + std::ptrdiff_t(moved), signs_.begin() + std::ptrdiff_t((end_ - first_) * nodes_),
            signs_.begin());
  first_ = first;
  const std::size_t count = std::min(block_, lattice_.size[2] - end_);
  pool.for_each(count, 1, [&](std::size_t s) {
    const std::size_t at = (end_ + s - first_) * nodes_;
    compute(end_ + s, values_.data() + at, signs_.data() + at);
  });
  end_ += count;
}

void Slices::compute(std::size_t k, double* values, std::uint8_t* signs) const {
  if (active_.are_all()) {
    f_.lattice_values(lattice_, k, values);
    for (std::size_t n = 0; n < nodes_; ++n)
      signs[n] = values[n] >= 0;
    return;
  }
  const std::vector<Row_part> parts = active_.nodes(k);
  f_.lattice_values(lattice_, k, parts, values);
  for (const Row_part& part : parts)
    for (std::size_t n = part.j * lattice_.size[0] + part.first; n < part.j * lattice_.size[0] + part.last; ++n)
      signs[n] = values[n] >= 0;
}

} // namespace CGAL::Extremal_mesh_3
