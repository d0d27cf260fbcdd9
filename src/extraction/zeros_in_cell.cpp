// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "zeros_in_cell.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

namespace {

/// Squares are divided so often; there are at most so many.
constexpr int deepest = 6;
constexpr int most_squares = 400;
/// The error of a field may change by this times itself over the cell's radius.
constexpr double slope_of_error = 4;
/// The Jacobian must not change by more than this part of itself where a field is to be one-to-one.
constexpr double one_to_one = 0.7;
/// A zero counts as one beside the border nearer than this: sides are not quite straight.
constexpr double least_distance = 0.02;
/// Zeros nearer to each other than this are one.
constexpr double apart = 1e-5;

class Zero_search {
public:
  Zero_search(const Cell_model& model, Field field, const Planar_polygon& cell)
      : model_(model), field_(field), cell_(cell) {}

  Zeros_in_cell find() {
    result_.certain = true;
    search(0, 1, 0);
    return result_;
  }

private:
  /// The inverse of the Jacobian: a change of the first part takes the zero by `re`, one of the second part by `im`.
  struct Inverse {
    Complex re, im;
    explicit Inverse(const Field_jets& j) {
      const double det = j.re.x * j.im.y - j.re.y * j.im.x;
      re = Complex(j.im.y, -j.im.x) / det;
      im = Complex(-j.re.y, j.re.x) / det;
    }
    Complex step(double a, double b) const { return a * re + b * im; }
    double length(double a, double b) const { return a * std::sqrt(std::norm(re)) + b * std::sqrt(std::norm(im)); }
  };

  static bool keeps_off_zero(const Plane_jet& j, const Plane_range& within, double wrong, double r) {
    return std::abs(j.f) > std::sqrt(j.x * j.x + j.y * j.y) * r + within.remainder + wrong;
  }

  /// looks into the square about z with sides of 2 h.
  void search(Complex z, double h, int depth) {
    if (!result_.certain)
      return;
    if (++squares_ > most_squares) {
      result_.certain = false;
      return;
    }
    const double r = depth == 0 ? 1 : std::numbers::sqrt2 * h; // the cell lies in the unit circle
    if (depth > 0 && !cell_.contains(z) && cell_.distance_to_border(z) > r + least_distance)
      return;
    const Field_view view = model_.view(field_, z, r);
    const Field_jets& here = view.here;
    const Field_errors& wrong = view.errors;
    // One part keeps away from 0 by more than it changes …
    if (keeps_off_zero(here.re, view.re, wrong.re, r) || keeps_off_zero(here.im, view.im, wrong.im, r))
      return;
    // … or the zero that the linear parts would have lies outside.
    const Inverse inverse(here);
    const double moved_by_error = inverse.length(wrong.re, wrong.im);
    const double near = r + inverse.length(view.re.remainder, view.im.remainder) + moved_by_error;
    if (std::norm(inverse.step(here.re.f, here.im.f)) > near * near)
      return;
    if (inverse.length(view.re.turn, view.im.turn) + slope_of_error * moved_by_error < one_to_one) {
      if (const auto zero = newton(z, r))
        note(*zero);
      return;
    }
    // What the error leaves open at this very place smaller squares leave open, too.
    const bool never = std::abs(here.re.f) < wrong.re && std::abs(here.im.f) < wrong.im &&
                       slope_of_error * moved_by_error > one_to_one && cell_.contains(z);
    if (never || depth == deepest) {
      result_.certain = false;
      return;
    }
    const double q = h / 2;
    for (const Complex d : {Complex(-q, -q), Complex(q, -q), Complex(-q, q), Complex(q, q)})
      search(z + d, q, depth + 1);
  }

  /// the zero in or beside a square in which the field is one-to-one.
  std::optional<Complex> newton(Complex center, double r) const {
    Complex z = center;
    for (int i = 0; i < 20; ++i) {
      const Field_jets j = model_.jets(field_, z);
      const Complex step = Inverse(j).step(-j.re.f, -j.im.f);
      z += step;
      if (!(std::abs(z - center) < 3 * r))
        return std::nullopt;
      if (std::abs(step) < 1e-3 * apart)
        return z;
    }
    return std::nullopt;
  }

  void note(Complex zero) {
    if (std::any_of(found_.begin(), found_.end(), [&](Complex other) { return std::abs(other - zero) < apart; }))
      return;
    found_.push_back(zero);
    const Field_errors wrong = model_.errors(field_, zero);
    const double near = least_distance + Inverse(model_.jets(field_, zero)).length(wrong.re, wrong.im),
                 distance = cell_.distance_to_border(zero);
    if (distance < near)
      ++result_.beside_border;
    else if (cell_.contains(zero))
      ++result_.inside;
    else
      return;
    result_.place = zero;
  }

  const Cell_model& model_;
  Field field_;
  const Planar_polygon& cell_;
  std::vector<Complex> found_;
  int squares_ = 0;
  Zeros_in_cell result_;
};

} // namespace

Zeros_in_cell zeros_in_cell(const Cell_model& model, Field field, const Planar_polygon& cell) {
  return Zero_search(model, field, cell).find();
}

} // namespace CGAL::Extremal_mesh_3
