// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_SRC_JET_EVALUATION_H
#define CGAL_EXTREMAL_MESH_3_SRC_JET_EVALUATION_H

#include "Jet_program.h"

#include <cstddef>

namespace CGAL::Extremal_mesh_3::internal {

// Points are evaluated side by side, a "lane" each: one pass over the instructions serves them all, and the compiler
// makes vector instructions of the loops over lanes. Every lane sees the same operations, and so does every order as
// far as it goes: neither the number of lanes nor the order changes a bit of the result. (This relies on
// -ffp-contract=off.)

inline constexpr std::size_t derivative_lanes = 8; ///< the sums of a row stay in registers
inline constexpr std::size_t value_lanes = 64;     ///< makes the decoding of instructions cheap

/// evaluates a program.
/// \param points  coordinate a of lane l is at [a * lanes + l]
/// \param scratch  `program.scratch_size * lanes` doubles. Coefficient k of the result is left at
///                 [(program.result + k) * lanes + l], for the k in `program.result_support`.
/// \pre `lanes` is 1, or `derivative_lanes` for orders 1 to 4, or `value_lanes` for order 0
void evaluate_jets(const Jet_program& program, std::size_t lanes, const double* points, double* scratch);

} // namespace CGAL::Extremal_mesh_3::internal

#endif // CGAL_EXTREMAL_MESH_3_SRC_JET_EVALUATION_H
