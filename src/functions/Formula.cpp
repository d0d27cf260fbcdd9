// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Text → expression DAG → one program per order of derivatives → Taylor coefficients, for one point or several at once.

#include <CGAL/Extremal_mesh_3/Formula.h>

#include "Bounds_evaluation.h"
#include "Formula_parser.h"
#include "Jet_evaluation.h"

#include <CGAL/Extremal_mesh_3/internal/Taylor_indices.h>
#include <CGAL/Extremal_mesh_3/internal/interval_arithmetic.h>

#include <algorithm>
#include <array>
#include <vector>

#include <fmt/format.h>

namespace CGAL::Extremal_mesh_3 {
namespace {

using internal::derivative_lanes;
using internal::Jet_program;
using internal::value_lanes;

/// memory for one evaluation, kept by each thread so that evaluations do not allocate.
double* scratch(std::size_t size) {
  thread_local std::vector<double> memory;
  if (memory.size() < size)
    memory.resize(size);
  return memory.data();
}

/// copies the derivatives of one lane out of the result.
void store(const Jet_program& program, const double* scratch, std::size_t lanes, std::size_t lane, Derivatives& d) {
  const double* const jet = scratch + program.result * lanes + lane;
  const auto coefficient = [&](std::size_t k) {
    return (program.result_support >> k & 1u) != 0 ? jet[k * lanes] : 0.0;
  };
  internal::taylor_to_derivatives(coefficient, program.order, d);
}

void check_order(int order) {
  if (order < 1 || order > 4)
    throw std::invalid_argument(fmt::format("Formula: the order of derivatives is {}, not 1 to 4", order));
}

} // namespace

struct Formula::Implementation {
  std::array<Jet_program, 5> programs; ///< by order of derivatives
};

Formula::Formula(std::string_view text) : implementation_(std::make_unique<Implementation>()) {
  internal::Expression expression;
  const internal::Expression::Id root = internal::parse_formula(text, expression);
  for (int order = 0; order <= 4; ++order)
    implementation_->programs[static_cast<std::size_t>(order)] = make_jet_program(expression, root, order);
}

Formula::~Formula() = default;
Formula::Formula(Formula&&) noexcept = default;

double Formula::value(const Point& p) const {
  const Jet_program& program = implementation_->programs[0];
  double* const memory = scratch(program.scratch_size);
  evaluate_jets(program, 1, p.data(), memory);
  return memory[program.result];
}

void Formula::derivatives(const Point& p, int order, Derivatives& d) const {
  check_order(order);
  const Jet_program& program = implementation_->programs[static_cast<std::size_t>(order)];
  double* const memory = scratch(program.scratch_size);
  evaluate_jets(program, 1, p.data(), memory);
  store(program, memory, 1, 0, d);
}

void Formula::derivatives(std::span<const Point> points, int order, std::span<Derivatives> d) const {
  check_order(order);
  if (points.size() != d.size())
    throw std::invalid_argument(
        fmt::format("Formula: {} points, but room for the derivatives at {}", points.size(), d.size()));
  constexpr std::size_t lanes = derivative_lanes;
  const Jet_program& program = implementation_->programs[static_cast<std::size_t>(order)];
  double* const memory = scratch(program.scratch_size * lanes);
  std::array<double, 3 * lanes> coordinates;
  for (std::size_t first = 0; first < points.size(); first += lanes) {
    const std::size_t count = std::min(lanes, points.size() - first);
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (std::size_t l = 0; l < lanes; ++l) // the lanes left over repeat the last point
        coordinates[axis * lanes + l] = points[first + std::min(l, count - 1)][axis];
    evaluate_jets(program, lanes, coordinates.data(), memory);
    for (std::size_t l = 0; l < count; ++l)
      store(program, memory, lanes, l, d[first + l]);
  }
}

void Formula::lattice_values(const Lattice& lattice, std::size_t k, double* out) const {
  std::vector<Row_part> rows;
  rows.reserve(lattice.size[1]);
  for (std::size_t j = 0; j < lattice.size[1]; ++j)
    rows.push_back({j, 0, lattice.size[0]});
  lattice_values(lattice, k, rows, out);
}

void Formula::lattice_values(const Lattice& lattice, std::size_t k, std::span<const Row_part> parts,
                             double* out) const {
  constexpr std::size_t lanes = value_lanes;
  const Jet_program& program = implementation_->programs[0];
  double* const memory = scratch(program.scratch_size * lanes);
  std::array<double, 3 * lanes> coordinates{};
  std::array<std::size_t, lanes> place{};
  const auto flush = [&](std::size_t count) {
    evaluate_jets(program, lanes, coordinates.data(), memory);
    for (std::size_t l = 0; l < count; ++l)
      out[place[l]] = memory[program.result * lanes + l];
  };
  std::size_t lane = 0; // rows follow each other without gaps in the lanes, so that short rows are no slower
  for (const Row_part& part : parts)
    for (std::size_t i = part.first; i < part.last; ++i) {
      const Point p = lattice.node(static_cast<double>(i), static_cast<double>(part.j), static_cast<double>(k));
      for (std::size_t axis = 0; axis < 3; ++axis)
        coordinates[axis * lanes + lane] = p[axis];
      place[lane] = part.j * lattice.size[0] + i;
      if (++lane == lanes) {
        flush(lanes);
        lane = 0;
      }
    }
  if (lane > 0)
    flush(lane);
}

bool Formula::bounds(const Box_3& box, int order, Derivative_bounds& d) const {
  if (order < 0 || order > 4)
    throw std::invalid_argument(fmt::format("Formula: the order of bounds is {}, not 0 to 4", order));
  const Jet_program& program = implementation_->programs[static_cast<std::size_t>(order)];
  thread_local std::vector<Interval> memory;
  if (memory.size() < program.scratch_size)
    memory.resize(program.scratch_size);
  const int known_order = evaluate_bounds(program, box, memory.data());
  const auto coefficient = [&](std::size_t k) {
    if (internal::taylor_tables.degree[k] > known_order)
      return internal::all_numbers;
    return (program.result_support >> k & 1u) != 0 ? memory[program.result + k] : Interval{};
  };
  internal::taylor_to_derivatives(coefficient, program.order, d);
  return true;
}

} // namespace CGAL::Extremal_mesh_3
