// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_TYPES_H
#define CGAL_EXTREMAL_MESH_3_TYPES_H

#include <array>
#include <cstdint>
#include <functional>

namespace CGAL::Extremal_mesh_3 {

/// A point of R³, in the input's unit of length.
using Point = std::array<double, 3>;
/// A vector of R³.
using Vector = std::array<double, 3>;

/// Called with the share of the work that is done, in [0, 1], from one thread at a time.
/// Returning `false` asks the algorithm to stop as soon as it can (`Cancelled` is then thrown).
using Progress = std::function<bool(double)>;

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_TYPES_H
