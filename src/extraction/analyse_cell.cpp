// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// P vanishes at extremal points and umbilics, Q at umbilics. A cell is accepted when, of both, it is known how often
// they vanish inside, and when the lines then have one way to go. Where samples have derivatives, a cubic model of the
// shape tells. Elsewhere a field whose values keep to one side of 0 by more than the error of its linear model has no
// zero; one whose linear model is one-to-one by more than its error has at most one zero, and the winding around the
// border says whether it has.
#include "analyse_cell.h"

#include "../differential/umbilic_lines.h"
#include "../differential/vector.h"
#include "Cell_model.h"
#include "Flat_cell.h"
#include "course_of_lines.h"
#include "cuts_between_branches.h"
#include "degenerate_vertex.h"
#include "halve_cell.h"
#include "linear_fit.h"
#include "locate.h"
#include "nudge.h"
#include "zeros_in_cell.h"

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

/// What is found out about a cell.
struct Judgement {
  bool known = false;          ///< P and Q have as many zeros as their windings say
  bool may_be_umbilic = false; ///< Q may vanish
  bool one_umbilic = false;    ///< there is one, and no other zero; `course` tells of its branches
  Content content = Content::undecided;
  Complex P_zero, Q_zero; ///< where the zeros should be, in the plane of the cell
  Linear_field P, Q;      ///< of an umbilic: the gradients of the models, in the basis of the middle
  Line_course course;
};

bool may_be_extremal_point(const Border_crossings& met, int wP, int wQ) {
  return std::abs(wP) == 1 && wQ == 0 && met.crossings.size() == 4 && families_differ(met.crossings, 1);
}

/// judges by linear models of P and Q.
Judgement judge_linearly(const Refined_complex& complex, const std::vector<Half_edge>& border,
                         const Border_crossings& met, const Flat_cell& flat, int wP, int wQ) {
  const Field_state P = examine(flat.points, flat.P), Q = examine(flat.points, flat.Q);
  Judgement j;
  j.may_be_umbilic = !Q.nonzero;
  j.known = flat.flat && (P.nonzero || P.simple) && (Q.nonzero || Q.simple);
  if (!j.known)
    return j;
  if (wP == 0 && wQ == 0 && lines_are_certain(complex, border, flat, P, Q, met))
    j.content = Content::lines;
  if (may_be_extremal_point(met, wP, wQ) && P.simple && Q.nonzero)
    j.content = Content::extremal_point;
  if (std::abs(wP) == 1 && std::abs(wQ) == 1 && P.simple && Q.simple) {
    j.content = Content::umbilic;
    j.one_umbilic = j.course.no_closed_line = true;
    j.P = {P.fit.x, P.fit.y};
    j.Q = {Q.fit.x, Q.fit.y};
  }
  return j;
}

/// the distance from the middle of a cell, which is narrower than its size where one side was divided more often, to its
/// border; 0 if the middle is not inside.
double room_around_middle(const Flat_cell& flat) {
  const Planar_polygon border(
      std::vector<Complex>(flat.points.z.begin(), flat.points.z.begin() + std::ptrdiff_t(flat.border)));
  return border.contains(0) ? border.distance_to_border(0) : 0;
}

/// the border in the coordinates of a model.
Planar_polygon polygon_of(const Flat_cell& flat, const Cell_model& model) {
  std::vector<Complex> corners;
  for (std::size_t i = 0; i < flat.border; ++i)
    corners.push_back(model.from_plane(flat.points.z[i]));
  return Planar_polygon(std::move(corners));
}

/// judges where samples have no derivatives; takes more of them if these leave doubt.
Judgement judge_by_values(const Refined_complex& complex, const std::vector<Half_edge>& border,
                          const Border_crossings& met, const Sample& middle, Flat_cell& flat, int wP, int wQ,
                          int most_edge_level) {
  Judgement j = judge_linearly(complex, border, met, flat, wP, wQ);
  if (j.content != Content::undecided && add_sides(complex, border, middle, flat))
    j = judge_linearly(complex, border, met, flat, wP, wQ);
  if (j.content == Content::lines || !j.known || wP != 0 || wQ != 0)
    return j;
  add_samples(complex, border, middle, flat);
  if (!flat.flat || lifted_phase(complex, border, flat).empty())
    return j;
  const Cell_model model(flat, middle.shape.Q);
  j.course = course_of_lines(complex, border, met, model, polygon_of(flat, model), most_edge_level);
  if (j.course.certain)
    j.content = Content::lines;
  return j;
}

/// judges by a model of values and derivatives.
Judgement judge_by_model(const Refined_complex& complex, const std::vector<Half_edge>& border,
                         const Border_crossings& met, const Sample& middle, const Flat_cell& flat, int wP, int wQ,
                         int most_edge_level) {
  Judgement j;
  const Cell_model model(flat, middle.shape.Q);
  const Planar_polygon polygon = polygon_of(flat, model);
  const Zeros_in_cell Q = zeros_in_cell(model, Field::Q, polygon);
  j.may_be_umbilic = !(Q.certain && Q.inside + Q.beside_border == 0);
  if (!Q.agree_with(wQ))
    return j;
  const Zeros_in_cell P = zeros_in_cell(model, Field::P, polygon);
  j.known = P.agree_with(wP);
  if (!j.known)
    return j;
  j.P_zero = model.to_plane(P.place);
  j.Q_zero = model.to_plane(Q.place);
  Content content = Content::undecided;
  if (wP == 0 && wQ == 0) {
    j.course = course_of_lines(complex, border, met, model, polygon, most_edge_level);
    content = Content::lines;
  } else if (may_be_extremal_point(met, wP, wQ)) {
    j.course = lines_around_vertex(complex, border, met, model, polygon, most_edge_level);
    content = Content::extremal_point;
  } else if (std::abs(wP) == 1 && std::abs(wQ) == 1) {
    j.course = lines_around_vertex(complex, border, met, model, polygon, most_edge_level);
    j.one_umbilic = true;
    content = Content::umbilic;
  }
  if (j.course.certain)
    j.content = content;
  return j;
}

/// judges where samples have derivatives; takes more of them if these leave doubt about the lines. About zeros a model of more samples
/// rarely tells more, and parts of the cell do.
Judgement judge_by_derivatives(const Refined_complex& complex, const std::vector<Half_edge>& border,
                               const Border_crossings& met, const Sample& middle, Flat_cell& flat, int wP, int wQ,
                               int most_edge_level) {
  Judgement j;
  j.may_be_umbilic = true;
  if (!flat.flat)
    return j;
  j = judge_by_model(complex, border, met, middle, flat, wP, wQ, most_edge_level);
  const bool simple = std::abs(wP) <= 1 && std::abs(wQ) <= 1 && met.crossings.size() <= 4;
  if (j.content != Content::undecided || !j.course.cuts.empty() || !simple || !j.known)
    return j;
  add_samples(complex, border, middle, flat);
  if (!flat.flat || !flat.has_derivatives)
    return j;
  return judge_by_model(complex, border, met, middle, flat, wP, wQ, most_edge_level);
}

/// tells whether the branches that reach the border are those that the umbilic must have. On a surface that
/// interpolates, the gradients of P and Q are only nearly what C says: there they decide themselves.
/// \param cuts  gets where edges are to be cut if branches leave between neighbouring samples of the border; stays as
///              it is if none do
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
  // Its directions tell better where to cut than what the model says of the border.
  if (lines == 3)
    if (auto between = cuts_between_branches(complex, border, star, most_edge_level); !between.empty())
      cuts = std::move(between);
  return false;
}

} // namespace

namespace {

int winding_of_Q(const Refined_complex& complex, const std::vector<Half_edge>& border) {
  double turn = 0;
  for (const Half_edge h : border)
    turn += h % 2 == 0 ? complex.edges()[h / 2].turn_Q : -complex.edges()[h / 2].turn_Q;
  return int(std::lround((turn + 2 * complex.holonomy(border)) / (2 * pi)));
}

/// tells whether the phase at the samples within each side lies between those at its ends, as it would nearly always where the model
/// that the cell was accepted by was right about it.
bool sides_keep_between_corners(const Refined_complex& complex, const Refined_cell& cell,
                                const std::vector<Half_edge>& border) {
  if (border.size() == cell.sides.size())
    return true;
  const std::vector<double> phase = border_phase(complex, border);
  std::size_t begin = 0;
  for (std::size_t side = 0; side < cell.sides.size(); ++side) {
    const std::uint32_t last = complex.target(cell.sides[side]);
    std::size_t end = begin + 1;
    while (complex.target(border[end - 1]) != last)
      ++end;
    const auto [low, high] = std::minmax(phase[begin], phase[end]);
    for (std::size_t i = begin + 1; i < end; ++i)
      if (phase[i] < low || phase[i] > high)
        return false;
    begin = end;
  }
  return true;
}

} // namespace

bool still_holds(const Refined_complex& complex, const Refined_cell& cell) {
  if (cell.content == Content::undecided || cell.content == Content::unresolved || !cell.certain || cell.waits)
    return false;
  std::vector<Half_edge> border;
  complex.border(cell, border);
  const Border_crossings met = border_crossings(complex, border);
  return met.crossings.size() == cell.crossings && met.winding_phi == 2 * cell.winding_P + cell.winding_Q &&
         winding_of_Q(complex, border) == cell.winding_Q && sides_keep_between_corners(complex, cell, border);
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

  result.crossings = met.crossings.size();
  result.winding_Q = winding_of_Q(complex, border);
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
    judged = flat.has_derivatives ? judge_by_derivatives(complex, border, met, middle, flat, wP, wQ, most_edge_level)
                                  : judge_by_values(complex, border, met, middle, flat, wP, wQ, most_edge_level);
  const double size = flat.points.radius;
  const auto accept = [&](Content content, const Sample& where) {
    result.content = content;
    result.sample = where;
    return result;
  };

  result.cuts = judged.course.cuts;
  result.joined = judged.course.joined;
  if (judged.content == Content::lines)
    result.content = Content::lines;
  if (result.content == Content::lines || (!result.cuts.empty() && !judged.one_umbilic))
    return result;
  const bool no_vertex = judged.known && wP == 0 && wQ == 0;
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
      return locate_zero(complex.surface(), field, middle, field == Field::P ? judged.P_zero : judged.Q_zero, size,
                         2 * size);
    std::vector<const Sample*> around;
    around.reserve(border.size());
    for (const Half_edge h : border)
      around.push_back(&complex.samples()[complex.source(h)]);
    return locate_zero_between(complex.surface(), field, around, middle);
  };
  if (judged.content == Content::extremal_point)
    if (const auto at = zero_of(Field::P))
      return accept(Content::extremal_point, *at);
  if (judged.one_umbilic)
    if (const auto at = zero_of(Field::Q))
      // Where branches leave side by side the model cannot tell how often they cross an edge, at whatever size: that the
      // umbilic has just these branches does.
      if (has_generic_umbilic(complex, border, *at, middle, judged, met, wP, wQ, most_edge_level, result.cuts) &&
          judged.course.no_closed_line)
        return accept(Content::umbilic, *at);
  if (!result.cuts.empty())
    return result;

  // Where the surface cannot be reached there is nothing to be found out by dividing.
  if (middle.exact && (no_vertex ? may_divide_lines : may_divide)) {
    // Beside a vertex the middle, which keeps off zeros, serves better than a line that may run through one.
    if (wP == 0 && wQ == 0 && !complex.surface().interpolates())
      if (const auto between = halving_of(complex, cell, middle, flat)) {
        result.halved_between = *between;
        return result;
      }
    double P_around = 0, Q_around = 0;
    for (std::size_t i = 0; i < flat.border; ++i) {
      P_around = std::max(P_around, std::abs(flat.P[i]));
      Q_around = std::max(Q_around, std::abs(flat.Q[i]));
    }
    result.sample = nudged(complex.surface(), middle, size, room_around_middle(flat), P_around, Q_around, corners);
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
