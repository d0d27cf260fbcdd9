// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_SRC_JET_PROGRAM_H
#define CGAL_EXTREMAL_MESH_3_SRC_JET_PROGRAM_H

#include "Expression.h"

#include <CGAL/Extremal_mesh_3/Derivatives.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Extremal_mesh_3::internal {

/// The Taylor coefficients that are not zero whatever the point, one bit each. The value always counts as one of them.
using Support = std::uint64_t;

/// How to compute the coefficients of one jet from those of others, zeros left out. The rows are done in their order.
struct Jet_plan {
  struct Term {
    std::uint8_t a, b;
  };
  struct Row {
    std::uint8_t out;
    bool from_a, from_b; ///< of a sum: which operands have this coefficient; of a quotient: whether the dividend has it
    std::uint16_t terms; ///< of a product, a quotient or a composition: how many products are added up
  };
  std::vector<Row> rows;
  std::vector<Term> terms;              ///< of all rows, one after the other
  std::array<std::uint32_t, 5> stage{}; ///< of a composition: rows [stage[k-1], stage[k]) make Horner's k-th step
};

struct Jet_instruction {
  Operation operation;
  std::uint32_t a, b, out;           ///< where the jets start in the scratch memory, in coefficients
  std::array<std::uint32_t, 3> plan; ///< numbers of plans; which, depends on the operation
};

/// A formula made ready for the computation of its Taylor coefficients up to one order: instructions on jets in a
/// scratch memory that is reused as jets are no longer needed. Constants take one coefficient and come first.
struct Jet_program {
  int order = 0;
  std::vector<double> constants;
  std::array<bool, 3> uses_variable{};
  std::array<std::uint32_t, 3> variable{}; ///< where the jet of a variable is
  std::vector<Jet_instruction> instructions;
  std::vector<Jet_plan> plans;
  std::uint32_t temporary = 0; ///< where there is room for two jets that only one instruction uses
  std::uint32_t result = 0;
  Support result_support = 0;
  std::size_t scratch_size = 0; ///< in coefficients; times the number of lanes in doubles
};

/// \param root  the node to compute
/// \param order  0 to 4
Jet_program make_jet_program(const Expression& expression, Expression::Id root, int order);

} // namespace CGAL::Extremal_mesh_3::internal

#endif // CGAL_EXTREMAL_MESH_3_SRC_JET_PROGRAM_H
