// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Flat_cell.h"

#include "../differential/vector.h"

#include <cmath>

namespace CGAL::Extremal_mesh_3 {

namespace {

/// Cells narrower than this get additional samples around their middle.
constexpr double least_aspect = 0.3;

} // namespace

void Flat_cell::add(const Sample& middle, const Sample& s) {
  const Vector d = s.p - middle.p;
  points.add({dot(d, middle.shape.u), dot(d, middle.shape.v())});
  flat = flat && dot(s.shape.n, middle.shape.n) > 0.5;
  const Moved_fields f = moved_to(s, middle);
  P.push_back(f.P);
  Q.push_back(f.Q);
}

Flat_cell flatten(const Refined_complex& complex, const std::vector<Half_edge>& border, const Sample& middle) {
  Flat_cell flat;
  for (const Half_edge h : border)
    flat.add(middle, complex.samples()[complex.source(h)]);
  flat.border = border.size();
  flat.add(middle, middle);
  if (flat.points.aspect() < least_aspect) {
    const double r = 0.5 * flat.points.radius;
    for (const Vector& d : {r * middle.shape.u, r * middle.shape.v(), -r * middle.shape.u, -r * middle.shape.v()})
      if (const auto s = complex.surface().sample(middle.p + d, middle.shape.n, r))
        flat.add(middle, *s);
  }
  return flat;
}

bool add_sides(const Refined_complex& complex, const std::vector<Half_edge>& border, const Sample& middle,
               Flat_cell& flat) {
  constexpr std::size_t enough = 7; // a quadratic function has 6 coefficients
  bool added = false;
  for (std::size_t i = 0; i < border.size() && flat.points.z.size() < enough; ++i) {
    const Half_edge h = border[i];
    flat.add(middle, sample_between(complex.surface(), complex.samples()[complex.source(h)],
                                    complex.samples()[complex.target(h)], 0.5));
    added = true;
  }
  return added;
}

std::vector<double> lifted_phase(const Refined_complex& complex, const std::vector<Half_edge>& border,
                                 const Flat_cell& flat) {
  std::vector<double> phase(flat.points.z.size());
  phase[0] = complex.samples()[complex.source(border[0])].phase;
  for (std::size_t i = 1; i < border.size(); ++i) {
    const Refined_edge& e = complex.edges()[border[i - 1] / 2];
    const double turn = 2 * e.turn_P + e.turn_Q;
    phase[i] = phase[i - 1] + (border[i - 1] % 2 == 0 ? turn : -turn);
  }
  for (std::size_t j = flat.border; j < phase.size(); ++j)
    for (std::size_t i = 0; i < flat.border; ++i) {
      const double lifted =
          phase[i] + 2 * std::arg(flat.P[j] * std::conj(flat.P[i])) + std::arg(flat.Q[j] * std::conj(flat.Q[i]));
      if (i == 0)
        phase[j] = lifted;
      else if (std::abs(lifted - phase[j]) > 1)
        return {};
    }
  return phase;
}

} // namespace CGAL::Extremal_mesh_3
