// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_FITTING_MEDIAN_H
#define EXTREMAL_MESH_3_SRC_FITTING_MEDIAN_H

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

/// the middle one of the values, which does not depend on their order; 0 if there are none.
inline double median(std::vector<double> values) {
  if (values.empty())
    return 0;
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_FITTING_MEDIAN_H
