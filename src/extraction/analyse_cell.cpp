// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// P vanishes at extremal points and umbilics, Q at umbilics. A cell is accepted when, of both, it is known how often
// they vanish inside: a field whose values keep to one side of 0 by more than the error of its linear model has no
// zero; one whose linear model is one-to-one by more than its error has at most one zero, and the winding around the
// border says whether it has.
#include "analyse_cell.h"

#include "../differential/umbilic_lines.h"
#include "../differential/vector.h"
#include "linear_fit.h"
#include "locate.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace CGAL::Extremal_mesh_3 {

namespace {

constexpr double pi = std::numbers::pi;
/// A field is taken for one-to-one if its error, carried back to the plane by its linear model, is below this part of
/// the cell's radius: for a quadratic deviation that keeps the Jacobian from vanishing in the cell.
constexpr double one_to_one = 0.17;
/// Values must keep from 0 by so many times the error.
constexpr double clearance = 2.0;
/// A linear model with error r over a cell of radius ρ has a gradient that is wrong by up to this times r/ρ.
constexpr double gradient_error = 6.0;
/// Cells narrower than this get additional samples around their middle.
constexpr double least_aspect = 0.3;

/// What is known of a field in a cell.
struct Field_state {
  Linear_fit<Complex> fit;
  bool nonzero = false; ///< nowhere 0
  bool simple = false;  ///< at most one zero, which is simple
};

/// the least height of values above a line through 0.
double clearance_of(const std::vector<Complex>& values) {
  Complex direction = 0;
  for (const Complex& v : values)
    direction += v / std::abs(v);
  direction /= std::abs(direction);
  double nearest = std::numeric_limits<double>::infinity();
  for (const Complex& v : values)
    nearest = std::min(nearest, (v * std::conj(direction)).real());
  return nearest;
}

Field_state examine(const Planar_points& points, const std::vector<Complex>& values) {
  Field_state state{Linear_fit<Complex>(points, values)};
  // Often one part of a field varies far more than the other, and so does its error. Carried back to the plane by the
  // linear model, both are measured by what they do there.
  std::vector<Complex> carried_back;
  double error = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    carried_back.push_back(preimage(state.fit, values[i]));
    error = std::max(error, std::abs(preimage(state.fit, state.fit.differences[i])));
  }
  state.nonzero =
      clearance_of(values) > clearance * state.fit.residual || clearance_of(carried_back) > clearance * error;
  state.simple = error < one_to_one * points.radius;
  return state;
}

/// The cell in the tangent plane of its middle.
struct Flat_cell {
  Planar_points points; ///< border, then the middle, then what else was sampled
  std::vector<Complex> P, Q;
  std::size_t border = 0;
  bool flat = true; ///< all normals are near to the middle's

  void add(const Sample& middle, const Sample& s) {
    const Vector d = s.p - middle.p;
    points.add({dot(d, middle.shape.u), dot(d, middle.shape.v())});
    flat = flat && dot(s.shape.n, middle.shape.n) > 0.5;
    const Moved_fields f = moved_to(s, middle);
    P.push_back(f.P);
    Q.push_back(f.Q);
  }
};

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

/// tells whether the phase of Φ = P² Q has no critical point in the cell: ∇φ = 2 Im(∇P/P) + Im(∇Q/Q), taken with the
/// gradients of the linear models, keeps to one side of a line by more than the error of the models.
///
/// The phase itself may be far from linear: along a line that leaves an extremal point where one extremality varies
/// much faster than the other it turns within a narrow strip, while P is as linear as can be.
bool phase_is_regular(const Flat_cell& flat, const Field_state& P, const Field_state& Q) {
  std::vector<Complex> gradient(flat.P.size()); // |P|²|Q|² ∇φ, as x + iy
  std::vector<double> error(flat.P.size());
  for (std::size_t i = 0; i < gradient.size(); ++i) {
    const Complex p = std::conj(flat.P[i]), q = std::conj(flat.Q[i]);
    const double a = 2 * std::norm(q), b = std::norm(p);
    gradient[i] = {a * (p * P.fit.x).imag() + b * (q * Q.fit.x).imag(),
                   a * (p * P.fit.y).imag() + b * (q * Q.fit.y).imag()};
    error[i] =
        gradient_error / flat.points.radius * (a * std::abs(p) * P.fit.residual + b * std::abs(q) * Q.fit.residual);
  }
  double least = 0, greatest = 0; // directions, relative to the first
  for (const Complex& g : gradient) {
    const double angle = std::arg(g * std::conj(gradient[0]));
    least = std::min(least, angle);
    greatest = std::max(greatest, angle);
  }
  const Complex direction = std::polar(1.0, std::arg(gradient[0]) + (least + greatest) / 2);
  for (std::size_t i = 0; i < gradient.size(); ++i)
    if (!((gradient[i] * std::conj(direction)).real() > error[i]))
      return false;
  return true;
}

/// the phase, lifted to a real function: along the border by the edges' turns, to the inner samples by the least turn
/// from each sample of the border. Empty if these do not agree.
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

/// tells whether the lines through a cell without zeros of P and Q run in one way only.
bool lines_are_certain(const Refined_complex& complex, const std::vector<Half_edge>& border, const Flat_cell& flat,
                       const Field_state& P, const Field_state& Q, const Border_crossings& met) {
  const std::vector<double> phase = lifted_phase(complex, border, flat);
  if (phase.empty())
    return false;
  const Linear_fit<double> fit(flat.points, phase);
  const bool straight = std::hypot(fit.x, fit.y) * flat.points.radius > gradient_error * fit.residual;
  if (straight || phase_is_regular(flat, P, Q)) {
    std::vector<std::int32_t> levels; // no closed line; a line that meets the border twice has one way to go
    for (const Border_crossing& c : met.crossings)
      levels.push_back(c.level);
    std::sort(levels.begin(), levels.end());
    for (std::size_t i = 0; i + 2 < levels.size(); ++i)
      if (levels[i] == levels[i + 2])
        return false;
    return true;
  }
  if (!met.crossings.empty())
    return false;
  // The phase must keep from its levels inside, too.
  double gap = pi;
  for (const double p : phase)
    gap = std::min(gap, std::abs(p - pi * std::round(p / pi)));
  return gap > clearance * fit.residual;
}

/// tells whether each crossing has another family than the one that stands `offset` places on.
bool families_differ(const std::vector<Border_crossing>& c, std::size_t offset) {
  for (std::size_t i = 0; i < c.size(); ++i)
    if (c[i].family() == c[(i + offset) % c.size()].family())
      return false;
  return true;
}

/// What the samples of a cell say of it.
struct Judgement {
  bool known = false; ///< P and Q have as many zeros as their windings say
  Content content = Content::undecided;
  int lines = 0; ///< through the zero of Q, if P and Q were linear
};

Judgement judge(const Refined_complex& complex, const std::vector<Half_edge>& border, const Border_crossings& met,
                const Flat_cell& flat, int wP, int wQ) {
  const Field_state P = examine(flat.points, flat.P), Q = examine(flat.points, flat.Q);
  Judgement j;
  j.known = flat.flat && (P.nonzero || P.simple) && (Q.nonzero || Q.simple);
  if (!j.known)
    return j;
  if (wP == 0 && wQ == 0 && lines_are_certain(complex, border, flat, P, Q, met))
    j.content = Content::lines;
  if (std::abs(wP) == 1 && wQ == 0 && P.simple && Q.nonzero && met.crossings.size() == 4 &&
      families_differ(met.crossings, 1))
    j.content = Content::extremal_point;
  if (std::abs(wP) == 1 && std::abs(wQ) == 1 && P.simple && Q.simple) {
    j.content = Content::umbilic;
    j.lines = lines_through_umbilic({P.fit.x, P.fit.y}, {Q.fit.x, Q.fit.y});
  }
  return j;
}

/// tells whether the branches that reach the border are those that the umbilic must have. On a surface that
/// interpolates, the gradients of P and Q are only nearly what C says: there they decide themselves.
bool has_generic_umbilic(const Surface& surface, const Sample& umbilic, const Judgement& judged,
                         const Border_crossings& met, int wP, int wQ) {
  int lines = judged.lines;
  if (!surface.interpolates()) {
    const Umbilic_class c = classify_umbilic(umbilic.shape.A1, umbilic.shape.A3);
    if (2 * c.index != wQ || c.field_index != -wP)
      return false;
    lines = c.ridges;
  }
  return met.crossings.size() == std::size_t(2 * lines) && families_differ(met.crossings, met.crossings.size() / 2);
}

/// adds the middles of up to three sides to cells with few samples. The corners and the middle of a quadrilateral see nothing of
/// a saddle x² − y² along its sides, and so would miss two lines that pass each other there.
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

/// Phases this near to 0 or π, and values of P and Q that are less than this part of those around, are trouble.
constexpr double on_line = 1e-4, small = 0.03;

/// less than 1 if the sample lies on a line, or if |P| or |Q| is small against the values around.
double distance_from_trouble(const Sample& s, double P_around, double Q_around) {
  const double off_line = std::abs(std::sin(s.phase)) / on_line;
  return std::min({off_line, std::abs(s.P) / (small * P_around), std::abs(s.shape.Q) / (small * Q_around)});
}

} // namespace

bool is_plainly_empty(const Refined_complex& complex, const Refined_cell& cell) {
  constexpr double little = 1.5, far = 0.3;
  constexpr double nearly_flat = 0.9; // with normals that near, transport around the cell turns by less than ½
  const Vector& normal = complex.samples()[complex.source(cell.sides[0])].shape.n;
  double turn = 0, gap = pi;
  const bool quiet = complex.visit_border(cell, [&](Half_edge h) {
    const Refined_edge& e = complex.edges()[h / 2];
    const Sample& s = complex.samples()[complex.source(h)];
    turn += 2 * std::abs(e.turn_P) + std::abs(e.turn_Q);
    gap = std::min(gap, std::abs(s.phase - pi * std::round(s.phase / pi)));
    const bool crossed = e.winding != 0 || complex.samples()[e.a].positive != complex.samples()[e.b].positive;
    return !crossed && turn < little && dot(s.shape.n, normal) > nearly_flat;
  });
  return quiet && (gap > far || (complex.surface().interpolates() && gap > turn));
}

Border_crossings border_crossings(const Refined_complex& complex, const std::vector<Half_edge>& border) {
  Border_crossings met;
  // The half-turn [π·m, π·(m + 1)) in which the lifted phase lies.
  std::int32_t m = complex.samples()[complex.source(border[0])].positive ? 0 : -1;
  const std::int32_t start = m;
  for (const Half_edge h : border) {
    const Refined_edge& e = complex.edges()[h / 2];
    const std::int32_t winding = h % 2 == 0 ? e.winding : -e.winding;
    const std::int32_t step = (complex.samples()[complex.target(h)].positive ? 0 : -1) -
                              (complex.samples()[complex.source(h)].positive ? 0 : -1) + 2 * winding;
    for (std::int32_t i = 0; i < step; ++i)
      met.crossings.push_back({h, ++m, true});
    for (std::int32_t i = 0; i > step; --i)
      met.crossings.push_back({h, m--, false});
  }
  met.winding_phi = (m - start) / 2;
  return met;
}

bool should_be_nudged(const Sample& s, double P2_around, double Q2_around) {
  const double off_line = std::min(std::abs(s.phase), pi - std::abs(s.phase));
  return off_line < on_line || std::norm(s.P) < small * small * P2_around ||
         std::norm(s.shape.Q) < small * small * Q2_around;
}

Sample nudged(const Surface& surface, const Sample& s, double size, double P_around, double Q_around,
              const std::vector<const Sample*>& around) {
  constexpr double part = 0.14, golden_angle = 2.399963229728653;
  double best = distance_from_trouble(s, P_around, Q_around);
  if (!(best < 1) || !s.exact)
    return s;
  Sample chosen = s;
  const auto try_one = [&](const std::optional<Sample>& other) {
    const double distance = other ? distance_from_trouble(*other, P_around, Q_around) : 0;
    if (distance > best) {
      best = distance;
      chosen = *other;
    }
  };
  if (surface.interpolates()) {
    // Not straight towards another sample: what lies here would then lie on the edge from the opposite one.
    const std::size_t n = around.size();
    for (std::size_t i = 0; i < n && best < 1; ++i)
      try_one(interpolate(surface, {&s, around[i], around[(i + 1) % n], around[(i + 2) % n]},
                          {1 - part, 0.6 * part, 0.3 * part, 0.1 * part}));
    return chosen;
  }
  for (int i = 0; i < 5 && best < 1; ++i) {
    const double angle = golden_angle * (i + 1);
    const Vector d = std::cos(angle) * s.shape.u + std::sin(angle) * s.shape.v();
    try_one(surface.sample(s.p + part * size * d, s.shape.n, size));
  }
  return chosen;
}

Cell_analysis analyse_cell(const Refined_complex& complex, const Refined_cell& cell, bool may_divide,
                           bool may_divide_lines) {
  Cell_analysis result;
  std::vector<Half_edge> border;
  complex.border(cell, border);
  const Border_crossings met = border_crossings(complex, border);

  double turn_Q = 0;
  for (const Half_edge h : border)
    turn_Q += h % 2 == 0 ? complex.edges()[h / 2].turn_Q : -complex.edges()[h / 2].turn_Q;
  result.winding_Q = int(std::lround((turn_Q + 2 * complex.holonomy(border)) / (2 * pi)));
  result.winding_P = (met.winding_phi - result.winding_Q) / 2;
  const int wP = result.winding_P, wQ = result.winding_Q;
  // Φ = P² Q. Where P or Q is 0 up to rounding, its turns are noise and need not fit.
  const bool consistent = 2 * wP + wQ == met.winding_phi;

  std::vector<const Sample*> corners;
  for (const Half_edge h : cell.sides)
    corners.push_back(&complex.samples()[complex.source(h)]);
  Sample middle = sample_amid(complex.surface(), corners);
  Flat_cell flat = flatten(complex, border, middle);
  Judgement judged;
  if (consistent)
    judged = judge(complex, border, met, flat, wP, wQ);
  if (judged.content != Content::undecided && add_sides(complex, border, middle, flat))
    judged = judge(complex, border, met, flat, wP, wQ);
  const double size = flat.points.radius;
  const auto accept = [&](Content content, const Sample& where) {
    result.content = content;
    result.sample = where;
    return result;
  };

  if (judged.content == Content::lines) {
    result.content = Content::lines;
    return result;
  }
  const auto zero_of = [&](Field field) {
    if (!complex.surface().interpolates())
      return locate_zero(complex.surface(), field, middle, size, 2 * size);
    std::vector<const Sample*> around;
    for (const Half_edge h : border)
      around.push_back(&complex.samples()[complex.source(h)]);
    return locate_zero_between(complex.surface(), field, around, middle);
  };
  if (judged.content == Content::extremal_point)
    if (const auto at = zero_of(Field::P))
      return accept(Content::extremal_point, *at);
  if (judged.content == Content::umbilic)
    if (const auto at = zero_of(Field::Q))
      if (has_generic_umbilic(complex.surface(), *at, judged, met, wP, wQ))
        return accept(Content::umbilic, *at);

  // Where the surface cannot be reached there is nothing to be found out by dividing.
  const bool no_vertex = judged.known && wP == 0 && wQ == 0;
  if (middle.exact && (no_vertex ? may_divide_lines : may_divide)) {
    double P_around = 0, Q_around = 0;
    for (std::size_t i = 0; i < flat.border; ++i) {
      P_around = std::max(P_around, std::abs(flat.P[i]));
      Q_around = std::max(Q_around, std::abs(flat.Q[i]));
    }
    result.sample = nudged(complex.surface(), middle, size, P_around, Q_around, corners);
    return result;
  }

  // The finest level: the simplest content with these windings. Crossings beyond what it needs are joined in pairs.
  result.certain = false;
  if (!consistent)
    return accept(Content::unresolved, middle);
  if (wP == 0 && wQ == 0) {
    result.content = Content::lines;
    return result;
  }
  if (std::abs(wP) == 1 && wQ == 0)
    return accept(Content::extremal_point, zero_of(Field::P).value_or(middle));
  if (std::abs(wP) == 1 && std::abs(wQ) == 1)
    return accept(Content::umbilic, zero_of(Field::Q).value_or(middle));
  return accept(Content::unresolved, middle);
}

} // namespace CGAL::Extremal_mesh_3
