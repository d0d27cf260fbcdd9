// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Folds.h"

#include "../differential/vector.h"
#include "Refined_complex.h"

#include <cmath>
#include <numbers>

namespace CGAL::Extremal_mesh_3 {

namespace {

constexpr double pi = std::numbers::pi;
/// Where the surface is resolved, normals at the ends of an edge differ by less than this (cos 72°).
constexpr double least_cosine = 0.3;

const Vector& normal(const Refined_complex& complex, std::uint32_t v) {
  return complex.samples()[v].shape.n;
}

/// the signed area on the unit sphere of the polygon of normals along the border of a cell.
double spherical_area(const Refined_complex& complex, const std::vector<Half_edge>& border) {
  const Vector& a = normal(complex, complex.source(border[0]));
  double area = 0;
  for (std::size_t i = 1; i + 1 < border.size(); ++i) {
    const Vector &b = normal(complex, complex.source(border[i])), &c = normal(complex, complex.source(border[i + 1]));
    area += 2 * std::atan2(dot(a, cross(b, c)), 1 + dot(a, b) + dot(b, c) + dot(c, a));
  }
  return area;
}

} // namespace

double Folds::direction(const Refined_complex& complex, Half_edge h) const {
  if (const auto it = given_.find(h); it != given_.end())
    return it->second;
  const Sample& a = complex.samples()[complex.source(h)];
  const Vector d = complex.samples()[complex.target(h)].p - a.p;
  return std::atan2(dot(d, a.shape.v()), dot(d, a.shape.u));
}

/// in [−½π, 3⁄2π): a corner of a small cell may be turned over a little, and then those beside it make up for that.
double Folds::inner_angle(const Refined_complex& complex, Half_edge in, Half_edge out) const {
  const double angle = direction(complex, in ^ 1U) - direction(complex, out);
  return angle - 2 * pi * std::floor((angle + pi / 2) / (2 * pi));
}

bool Folds::folded(const Refined_complex& complex, Half_edge h) const {
  return !folded_.empty() && (folded_[complex.source(h)] || folded_[complex.target(h)]);
}

Complex Folds::transport(const Refined_complex& complex, Half_edge h) const {
  if (folded(complex, h))
    return std::polar(1.0, direction(complex, h ^ 1U) + pi - direction(complex, h));
  return frame_turn(complex.samples()[complex.source(h)], complex.samples()[complex.target(h)]);
}

double Folds::holonomy(const Refined_complex& complex, const std::vector<Half_edge>& border) const {
  bool any = false;
  for (const Half_edge h : border)
    any = any || folded(complex, h);
  if (!any)
    return spherical_area(complex, border);
  double angle = 2 * pi;
  for (std::size_t i = 0; i < border.size(); ++i) {
    const Half_edge h = border[i];
    angle -= pi - inner_angle(complex, border[(i + border.size() - 1) % border.size()], h);
    // An edge between sound points is transported along by the normals, for its other cell too.
    if (!folded(complex, h))
      angle +=
          std::arg(transport(complex, h) * std::polar(1.0, direction(complex, h) - direction(complex, h ^ 1U) - pi));
  }
  return angle;
}

const std::vector<char>& Folds::find(const Refined_complex& complex) {
  folded_.assign(complex.samples().size(), 0);
  std::vector<Half_edge> before(2 * complex.edges().size(),
                                no_id); // of each half-edge: the one before it around its cell
  std::vector<Half_edge> leaving(complex.samples().size(), no_id), border;
  for (const Refined_cell& cell : complex.cells()) {
    if (cell.divided)
      continue;
    complex.border(cell, border);
    for (std::size_t i = 0; i < border.size(); ++i) {
      const std::uint32_t v = complex.source(border[i]), w = complex.target(border[i]);
      before[border[i]] = border[(i + border.size() - 1) % border.size()];
      leaving[v] = border[i];
      if (!complex.samples()[v].exact || dot(normal(complex, v), normal(complex, w)) < least_cosine)
        folded_[v] = folded_[w] = 1;
    }
  }
  std::vector<Half_edge> star;
  for (std::uint32_t v = 0; v < folded_.size(); ++v) {
    if (!folded_[v] || leaving[v] == no_id)
      continue;
    star.clear();
    double turn = 0;
    Half_edge h = leaving[v];
    do { // counter-clockwise
      star.push_back(h);
      turn += inner_angle(complex, before[h], h);
      h = before[h] ^ 1U;
    } while (h != leaving[v]);
    if (std::abs(turn - 2 * pi) > 1)
      spread(complex, star);
  }
  return folded_;
}

/// gives the edges around a point directions that make one full turn, in proportion to the angles between them in
/// space.
void Folds::spread(const Refined_complex& complex, const std::vector<Half_edge>& star) {
  const Point& p = complex.samples()[complex.source(star[0])].p;
  std::vector<double> angle;
  double sum = 0;
  for (std::size_t i = 0; i < star.size(); ++i) {
    const Vector a = complex.samples()[complex.target(star[i])].p - p;
    const Vector b = complex.samples()[complex.target(star[(i + 1) % star.size()])].p - p;
    angle.push_back(std::atan2(norm(cross(a, b)), dot(a, b)) + 0.1); // none may vanish
    sum += angle.back();
  }
  double direction_here = direction(complex, star[0]);
  for (std::size_t i = 0; i < star.size(); ++i) {
    given_[star[i]] = direction_here;
    direction_here += 2 * pi * angle[i] / sum;
  }
}

} // namespace CGAL::Extremal_mesh_3
