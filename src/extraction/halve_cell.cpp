// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "halve_cell.h"

#include "../differential/vector.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

namespace {

/// A cell is halved where the shape changes by less than this part of itself along the line that divides it …
constexpr double one_way = 0.7;
/// … and each half is at most so wide, in parts of the cell.
constexpr double widest_half = 0.75;
/// Cells with more sides have too many pairs of them to look at.
constexpr std::size_t most_sides = 16;

/// How the derivatives of the shape vary within a cell: the second moments of their differences from their means.
struct Variation {
  double xx = 0, xy = 0, yy = 0;

  explicit Variation(const Flat_cell& flat) {
    for (Flat_value Flat_shape::*part : {&Flat_shape::Q, &Flat_shape::A1, &Flat_shape::A3}) {
      Complex mean_x = 0, mean_y = 0;
      double size = 0;
      for (const Flat_shape& s : flat.shapes) {
        mean_x += (s.*part).x / double(flat.shapes.size());
        mean_y += (s.*part).y / double(flat.shapes.size());
        size = std::max(size, std::norm((s.*part).f));
      }
      for (const Flat_shape& s : flat.shapes) {
        const Complex x = (s.*part).x - mean_x, y = (s.*part).y - mean_y;
        xx += std::norm(x) / size;
        xy += (std::conj(x) * y).real() / size;
        yy += std::norm(y) / size;
      }
    }
  }
};

/// The corners of a cell and the middles of its sides. Real parts tell how far they are in the direction across the line.
struct Outline {
  std::vector<Complex> corners, middles;

  Outline(const Refined_complex& complex, const Refined_cell& cell, const Sample& middle, Complex across) {
    const auto laid = [&](std::uint32_t sample) {
      const Vector d = complex.samples()[sample].p - middle.p;
      return Complex(dot(d, middle.shape.u), dot(d, middle.shape.v())) * std::conj(across);
    };
    for (const Half_edge h : cell.sides) {
      corners.push_back(laid(complex.source(h)));
      middles.push_back(complex.edges()[h / 2].divided() ? laid(complex.middle_sample(h))
                                                         : 0.5 * (corners.back() + laid(complex.target(h))));
    }
  }

  /// the width of the wider half; infinite if the line between the middles of sides i and j leaves the cell.
  double widest_half_between(std::size_t i, std::size_t j) const {
    const std::size_t n = corners.size();
    const Complex line = middles[j] - middles[i];
    double widest = 0, first_side = 0;
    for (const bool second : {false, true}) {
      double from = std::min(middles[i].real(), middles[j].real()), to = std::max(middles[i].real(), middles[j].real());
      // The corners from side i on to side j lie on one side of the line, the others on the other one.
      for (std::size_t k = second ? j : i; k != (second ? i : j); k = (k + 1) % n) {
        const Complex& corner = corners[(k + 1) % n];
        const double side = (std::conj(line) * (corner - middles[i])).imag();
        if (first_side == 0)
          first_side = side;
        if (!(second ? side * first_side < 0 : side * first_side > 0))
          return std::numeric_limits<double>::infinity();
        from = std::min(from, corner.real());
        to = std::max(to, corner.real());
      }
      widest = std::max(widest, to - from);
    }
    return widest;
  }
};

template <class Coordinate> double extent(const std::vector<Complex>& points, const Coordinate& of) {
  const auto [least, greatest] =
      std::minmax_element(points.begin(), points.end(), [&](Complex a, Complex b) { return of(a) < of(b); });
  return of(*greatest) - of(*least);
}

} // namespace

std::optional<Side_pair> halving_of(const Refined_complex& complex, const Refined_cell& cell, const Sample& middle,
                                    const Flat_cell& flat) {
  if (!flat.has_derivatives || !flat.flat || cell.sides.size() > most_sides)
    return std::nullopt;
  const Variation v(flat);
  const double mean = (v.xx + v.yy) / 2, difference = std::hypot((v.xx - v.yy) / 2, v.xy);
  const double across = std::sqrt(mean + difference), along = std::sqrt(std::max(0.0, mean - difference));
  const Outline outline(complex, cell, middle, std::polar(1.0, std::atan2(2 * v.xy, v.xx - v.yy) / 2));
  const double width = extent(outline.corners, [](Complex z) { return z.real(); }),
               length = extent(outline.corners, [](Complex z) { return z.imag(); });
  if (!(along * length < one_way * across * width)) // nor if one of them is not a number
    return std::nullopt;

  std::optional<Side_pair> best;
  double least_width = widest_half * width;
  for (std::size_t i = 0; i < outline.corners.size(); ++i)
    for (std::size_t j = i + 1; j < outline.corners.size(); ++j)
      if (const double w = outline.widest_half_between(i, j); w < least_width) {
        least_width = w;
        best = Side_pair{std::uint8_t(i), std::uint8_t(j)};
      }
  return best;
}

} // namespace CGAL::Extremal_mesh_3
