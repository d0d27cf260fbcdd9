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
#include "Flat_cell.h"
#include "course_of_lines.h"
#include "cuts_between_branches.h"
#include "degenerate_vertex.h"
#include "linear_fit.h"
#include "locate.h"
#include "nudge.h"

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
constexpr double gradient_error = 12.0;

/// Cells that were divided so often are looked at for what never ends to ask for more.
constexpr int level_of_symmetry = 3;

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
    // A side of a line that hardly rises over the error may be the tip of something that goes on inside.
    const auto [least, greatest] = std::minmax_element(phase.begin(), phase.begin() + std::ptrdiff_t(border.size()));
    if (!levels.empty() &&
        (pi * levels.front() - *least < fit.residual || *greatest - pi * levels.back() < fit.residual))
      return false;
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
  bool known = false;          ///< P and Q have as many zeros as their windings say
  bool may_be_umbilic = false; ///< Q may vanish
  Content content = Content::undecided;
  Linear_field P, Q; ///< of an umbilic: the gradients of the models, in the basis of the middle
};

Judgement judge(const Refined_complex& complex, const std::vector<Half_edge>& border, const Border_crossings& met,
                const Flat_cell& flat, int wP, int wQ) {
  const Field_state P = examine(flat.points, flat.P), Q = examine(flat.points, flat.Q);
  Judgement j;
  j.may_be_umbilic = !Q.nonzero;
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
    j.P = {P.fit.x, P.fit.y};
    j.Q = {Q.fit.x, Q.fit.y};
  }
  return j;
}

/// tells whether the branches that reach the border are those that the umbilic must have. On a surface that
/// interpolates, the gradients of P and Q are only nearly what C says: there they decide themselves.
/// \param cuts  gets where edges are to be cut if branches leave between neighbouring samples of the border
bool has_generic_umbilic(const Refined_complex& complex, const std::vector<Half_edge>& border, const Sample& umbilic,
                         const Sample& middle, const Judgement& judged, const Border_crossings& met, int wP, int wQ,
                         int most_edge_level, std::vector<Edge_cut>& cuts) {
  Umbilic_star star{umbilic.p, middle.shape.u, middle.shape.v(), judged.P, judged.Q};
  int lines = 0;
  if (complex.surface().interpolates()) {
    lines = lines_through_umbilic(star.P, star.Q);
  } else {
    const Umbilic_class c = classify_umbilic(umbilic.shape.A1, umbilic.shape.A3);
    if (2 * c.index != wQ || c.field_index != -wP)
      return false;
    lines = c.ridges;
    const Umbilic_fields fields = fields_at_umbilic(umbilic.shape.A1, umbilic.shape.A3);
    star = {umbilic.p, umbilic.shape.u, umbilic.shape.v(), fields.P, fields.Q};
  }
  if (met.crossings.size() == std::size_t(2 * lines) && families_differ(met.crossings, met.crossings.size() / 2))
    return true;
  if (lines == 3)
    cuts = cuts_between_branches(complex, border, star, most_edge_level);
  return false;
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

Cell_analysis analyse_cell(const Refined_complex& complex, const Refined_cell& cell, bool may_divide,
                           bool may_divide_lines, int most_edge_level) {
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
  const bool no_vertex = judged.known && wP == 0 && wQ == 0;
  if (no_vertex) {
    const Line_course course = course_of_lines(complex, border, met, middle, flat, most_edge_level);
    result.cuts = course.cuts;
    result.joined = course.joined;
    if (course.certain)
      result.content = Content::lines;
    if (course.certain || !course.cuts.empty())
      return result;
  }
  if (cell.level >= level_of_symmetry && middle.exact && !complex.surface().interpolates()) {
    std::optional<Sample> at;
    if (no_vertex)
      at = find_crossing_of_lines(complex, border, met, middle, flat);
    else if (judged.may_be_umbilic)
      at = find_flat_umbilic(complex, border, met, middle, flat);
    if (at)
      return accept(Content::unresolved, *at);
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
      if (has_generic_umbilic(complex, border, *at, middle, judged, met, wP, wQ, most_edge_level, result.cuts))
        return accept(Content::umbilic, *at);
  if (!result.cuts.empty())
    return result;

  // Where the surface cannot be reached there is nothing to be found out by dividing.
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
