// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// P, Q and Φ are polynomials in the derivatives of f, |∇f| and a tangent basis. The basis of the middle of a cell is taken
// along by the shortest rotation from its normal to that of each place, which is a rational function of the normals. So
// bounds of the derivatives over a box bound P, Q and Φ at every point of the surface in the box.
#include "certify.h"

#include "../cells/parallel.h"
#include "../differential/vector.h"
#include "../functions/sharp_bounds.h"

#include <CGAL/Extremal_mesh_3/internal/interval_arithmetic.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

namespace {

using Interval_vector = std::array<Interval, 3>;

/// How often the box of a cell is halved along all axes.
constexpr int most_levels = 3;
/// The box around the points of a cell is widened by this part of their extent: the surface bulges out of its polygons.
constexpr double widening = 0.1;

Interval dot(const Interval_vector& a, const Interval_vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Interval_vector scaled(const Interval& s, const Interval_vector& a) {
  return {s * a[0], s * a[1], s * a[2]};
}
Interval_vector difference(const Interval_vector& a, const Interval_vector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Interval_vector exactly(const Vector& a) {
  return {Interval{a[0], a[0]}, Interval{a[1], a[1]}, Interval{a[2], a[2]}};
}
Interval root(const Interval& a) {
  return {internal::below(std::sqrt(std::max(0.0, a.low))), internal::above(std::sqrt(a.high))};
}
bool excludes_zero(const Interval& a) {
  return a.low > 0 || a.high < 0;
}

/// the symmetric form H(a, ·).
Interval_vector contract(const std::array<Interval, 6>& h, const Interval_vector& a) {
  return {h[0] * a[0] + h[1] * a[1] + h[2] * a[2], h[1] * a[0] + h[3] * a[1] + h[4] * a[2],
          h[2] * a[0] + h[4] * a[1] + h[5] * a[2]};
}

/// the symmetric form T(a, ·, ·), in the order of a Hessian.
std::array<Interval, 6> contract(const std::array<Interval, 10>& t, const Interval_vector& a) {
  return {t[0] * a[0] + t[1] * a[1] + t[2] * a[2], t[1] * a[0] + t[3] * a[1] + t[4] * a[2],
          t[2] * a[0] + t[4] * a[1] + t[5] * a[2], t[3] * a[0] + t[6] * a[1] + t[7] * a[2],
          t[4] * a[0] + t[7] * a[1] + t[8] * a[2], t[5] * a[0] + t[8] * a[1] + t[9] * a[2]};
}

struct Interval_complex {
  Interval re, im;
  friend Interval_complex operator*(const Interval_complex& a, const Interval_complex& b) {
    return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
  }
  friend Interval_complex operator+(const Interval_complex& a, const Interval_complex& b) {
    return {a.re + b.re, a.im + b.im};
  }
};
Interval_complex conjugate(const Interval_complex& a) {
  return {a.re, -a.im};
}

/// |∇f| Q and |∇f|² A1, |∇f|² A3 over a box, in the basis that is carried along from the middle.
struct Shape_bounds {
  bool known = false;
  Interval_complex Q, A1, A3;
};

Shape_bounds shape_bounds(const Derivative_bounds& d, const Sample& middle) {
  Shape_bounds s;
  const Interval length = root(square(d.gradient[0]) + square(d.gradient[1]) + square(d.gradient[2]));
  if (!(length.low > 0))
    return s;
  Interval_vector n;
  for (std::size_t i = 0; i < 3; ++i)
    n[i] = intersection(d.gradient[i] / length, Interval{-1, 1});
  const Interval_vector n0 = exactly(middle.shape.n);
  const Interval cosine = 1.0 + dot(n0, n);
  if (!(cosine.low > 0.5))
    return s;
  const auto carried = [&](const Vector& t) {
    const Interval_vector t0 = exactly(t);
    return difference(t0, scaled(dot(t0, n) / cosine, {n0[0] + n[0], n0[1] + n[1], n0[2] + n[2]}));
  };
  const Interval_vector u = carried(middle.shape.u), v = carried(middle.shape.v());
  const Interval_vector Hu = contract(d.hessian, u), Hv = contract(d.hessian, v);
  const Interval L11 = -dot(Hu, u), L12 = -dot(Hu, v), L22 = -dot(Hv, v); // times the length
  const Interval nHu = dot(Hu, n), nHv = dot(Hv, n);
  const auto Tu = contract(d.third, u), Tv = contract(d.third, v);
  const auto form = [&](const std::array<Interval, 6>& T, const Interval_vector& a, const Interval_vector& b) {
    return length * dot(contract(T, a), b);
  };
  const Interval C111 = -(form(Tu, u, u) + 3.0 * (L11 * nHu)); // times the square of the length
  const Interval C112 = -(form(Tu, u, v) + L11 * nHv + 2.0 * (L12 * nHu));
  const Interval C122 = -(form(Tv, u, v) + L22 * nHu + 2.0 * (L12 * nHv));
  const Interval C222 = -(form(Tv, v, v) + 3.0 * (L22 * nHv));
  s.known = true;
  s.Q = {0.5 * (L11 - L22), L12};
  s.A1 = {0.75 * (C111 + C122), 0.75 * (C112 + C222)};
  s.A3 = {0.25 * (C111 - 3.0 * C122), 0.25 * (3.0 * C112 - C222)};
  return s;
}

enum class Proof : std::uint8_t { none, no_vertex, no_line };

/// what holds at all points of the surface in a box. The surface may not pass: then both.
class Prover {
public:
  Prover(const Function_3& f, const Sample& middle)
      : f_(f), middle_(middle), P_(unit(std::conj(middle.P))), Q_(unit(std::conj(middle.shape.Q))) {}

  Proof prove(const Box_3& box, int level) const {
    Derivative_bounds d;
    if (!f_.bounds(box, 1, d))
      return Proof::none;
    if (excludes_zero(d.value) || d.value.is_empty())
      return Proof::no_line;
    internal::sharp_bounds(f_, box, 3, d);
    const Shape_bounds s = shape_bounds(d, middle_);
    Proof here = Proof::none;
    if (s.known) {
      const Interval_complex P = conjugate(s.A3) * s.Q + s.A1 * conjugate(s.Q);
      if (excludes_zero((P * P * s.Q).im))
        return Proof::no_line;
      if (excludes_zero((P * P_).re) && excludes_zero((s.Q * Q_).re))
        here = Proof::no_vertex;
    }
    if (level == most_levels)
      return here;
    Proof least = Proof::no_line;
    for (unsigned k = 0; k < 8 && (least > here || least > Proof::none); ++k) {
      Box_3 part = box;
      for (std::size_t a = 0; a < 3; ++a)
        (k >> a & 1U ? part.low : part.high)[a] = box.low[a] + (box.high[a] - box.low[a]) / 2;
      least = std::min(least, prove(part, level + 1));
      if (least <= here)
        return here;
    }
    return std::max(least, here);
  }

private:
  static Interval_complex unit(Complex z) {
    const double r = std::abs(z);
    const Complex w = r > 0 ? z / r : Complex(1);
    return {{w.real(), w.real()}, {w.imag(), w.imag()}};
  }

  const Function_3& f_;
  const Sample& middle_;
  Interval_complex P_, Q_; ///< turn the values at the middle to the real axis
};

Proof prove_cell(const Function_3& f, const Refined_complex& complex, const Refined_cell& cell) {
  std::vector<const Sample*> corners;
  complex.visit_border(cell, [&](Half_edge h) {
    corners.push_back(&complex.samples()[complex.source(h)]);
    return true;
  });
  Box_3 box{corners[0]->p, corners[0]->p};
  double extent = 0;
  for (const Sample* s : corners)
    for (std::size_t a = 0; a < 3; ++a) {
      box.low[a] = std::min(box.low[a], s->p[a]);
      box.high[a] = std::max(box.high[a], s->p[a]);
    }
  for (std::size_t a = 0; a < 3; ++a)
    extent = std::max(extent, box.high[a] - box.low[a]);
  for (std::size_t a = 0; a < 3; ++a) {
    box.low[a] -= widening * extent;
    box.high[a] += widening * extent;
  }
  return Prover(f, sample_amid(complex.surface(), corners)).prove(box, 0);
}

} // namespace

Certificate certify(const Function_3& f, const Refined_complex& complex, int threads) {
  // Only what was found can be confirmed: cells without vertices, and among them those without crossings.
  const auto& cells = complex.cells();
  std::vector<Proof> proofs(cells.size(), Proof::none);
  std::vector<char> crossed(cells.size(), 0);
  for (const Refined_edge& e : complex.edges()) {
    if (e.divided())
      continue;
    const bool met = e.winding != 0 || complex.samples()[e.a].positive != complex.samples()[e.b].positive;
    for (const std::uint32_t c : e.cell)
      if (met && c != no_id)
        crossed[c] = 1;
  }
  Thread_pool pool(threads);
  pool.for_each(cells.size(), 32, [&](std::size_t c) {
    if (!cells[c].divided && cells[c].content == Content::lines && !cells[c].degenerate)
      proofs[c] = prove_cell(f, complex, cells[c]);
  });
  Certificate certificate;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    certificate.without_lines += proofs[c] == Proof::no_line && !crossed[c];
    certificate.without_vertices += proofs[c] == Proof::no_vertex;
  }
  return certificate;
}

} // namespace CGAL::Extremal_mesh_3
