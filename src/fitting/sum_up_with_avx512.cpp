// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sum_up_jets.h"

namespace CGAL::Extremal_mesh_3 {

void sum_up_with_avx512(const Wide_point* points, std::size_t count, Jet_sums& sums) {
  sum_up(points, count, sums);
}

} // namespace CGAL::Extremal_mesh_3
