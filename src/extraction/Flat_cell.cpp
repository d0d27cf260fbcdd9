// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Flat_cell.h"

#include "../differential/vector.h"

#include <cmath>

namespace CGAL::Extremal_mesh_3 {

namespace {

/// Cells narrower than this get additional samples around their middle. Where samples have derivatives, models stretch cells to be as
/// wide as long, and samples beside a narrow cell would only tell of what it was divided to keep away from.
constexpr double least_aspect = 0.3, least_aspect_with_derivatives = 0.02;

} // namespace

Flat_shape laid_flat(const Sample& s, const Sample& middle) {
  const Local_shape &a = s.shape, &b = middle.shape;
  const Complex turn = frame_turn(s, middle);
  const Vector av = a.v(), bv = b.v();
  const auto in_basis = [&](const Vector& t) { return Complex(dot(t, b.u), dot(t, bv)); };
  const Complex n = in_basis(a.n), u = in_basis(a.u), v = in_basis(av);
  // The basis of the middle, carried to each point by the shortest turn between the normals, is a frame that turns
  // itself, by (1 − cos θ) dφ where the normal has the polar coordinates θ, φ about that of the middle.
  const auto turn_of_frame = [&](double along_u, double along_v) { // of the normal's change
    const Complex dn = along_u * u + along_v * v;
    return (std::conj(n) * dn).imag() / (1 + dot(a.n, b.n));
  };
  const double turn_u = turn_of_frame(-(a.H + a.Q.real()), -a.Q.imag());
  const double turn_v = turn_of_frame(-a.Q.imag(), -(a.H - a.Q.real()));
  const double det = (std::conj(u) * v).imag();
  const Shape_derivatives d = shape_derivatives(a, s.fourth);
  const auto laid = [&](Complex f, const Shape_derivatives::Pair& along, double spin, Complex factor) {
    const Complex i(0, 1), moved = factor * f;
    // Along u and v of the sample …
    const Complex along_u = factor * (along.z + along.z_bar) + i * spin * turn_u * moved;
    const Complex along_v = factor * i * (along.z - along.z_bar) + i * spin * turn_v * moved;
    // … and along the axes of the plane, in which these are `u` and `v`.
    return Flat_value{moved, (v.imag() * along_u - u.imag() * along_v) / det,
                      (u.real() * along_v - v.real() * along_u) / det};
  };
  const Complex turn2 = turn * turn;
  return {laid(a.Q, d.Q, 2, turn2), laid(a.A1, d.A1, 1, turn), laid(a.A3, d.A3, 3, turn2 * turn)};
}

void Flat_cell::add(const Sample& middle, const Sample& s) {
  const Vector d = s.p - middle.p;
  points.add({dot(d, middle.shape.u), dot(d, middle.shape.v())});
  flat = flat && dot(s.shape.n, middle.shape.n) > 0.5;
  const Moved_fields f = moved_to(s, middle);
  P.push_back(f.P);
  Q.push_back(f.Q);
  has_derivatives = has_derivatives && s.has_fourth;
  if (has_derivatives)
    shapes.push_back(laid_flat(s, middle));
}

Flat_cell flatten(const Refined_complex& complex, const std::vector<Half_edge>& border, const Sample& middle) {
  Flat_cell flat;
  for (const Half_edge h : border)
    flat.add(middle, complex.samples()[complex.source(h)]);
  flat.border = border.size();
  flat.add(middle, middle);
  if (flat.points.aspect() < (flat.has_derivatives ? least_aspect_with_derivatives : least_aspect)) {
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

void add_samples(const Refined_complex& complex, const std::vector<Half_edge>& border, const Sample& middle,
                 Flat_cell& flat) {
  constexpr std::size_t most_sides = 8;
  const std::size_t step = (border.size() + most_sides - 1) / most_sides;
  for (std::size_t i = 0; i < border.size(); i += step) {
    const Sample &a = complex.samples()[complex.source(border[i])], &b = complex.samples()[complex.target(border[i])];
    flat.add(middle, sample_between(complex.surface(), a, b, 0.5));
    flat.add(middle, sample_between(complex.surface(), middle, a, 0.5));
  }
}

std::vector<double> border_phase(const Refined_complex& complex, const std::vector<Half_edge>& border) {
  std::vector<double> phase{complex.samples()[complex.source(border[0])].phase};
  for (const Half_edge h : border) {
    const Refined_edge& e = complex.edges()[h / 2];
    const double turn = 2 * e.turn_P + e.turn_Q;
    phase.push_back(phase.back() + (h % 2 == 0 ? turn : -turn));
  }
  return phase;
}

std::vector<double> lifted_phase(const Refined_complex& complex, const std::vector<Half_edge>& border,
                                 const Flat_cell& flat) {
  std::vector<double> phase = border_phase(complex, border);
  phase.resize(flat.points.z.size()); // the last one of the border is that of an inner sample from here on
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
