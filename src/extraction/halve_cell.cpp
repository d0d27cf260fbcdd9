// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "halve_cell.h"

#include "../differential/vector.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

namespace {

/// A cell is halved where the shape then bends within each half by less than this part of what it does within the cell: two
/// halvings do at least as much as a division into quarters.
constexpr double least_gain = 0.6;
/// Cells with more sides have too many pairs of them to look at.
constexpr std::size_t most_sides = 16;

/// The corners of a cell and the middles of its sides, in the coordinates in which it is as wide as long.
struct Outline {
  std::vector<Complex> corners, middles;
  Complex axis; ///< along which the cell is longest
  double length = 0, width = 0;

  Outline(const Refined_complex& complex, const Refined_cell& cell, const Sample& middle) {
    const auto laid = [&](std::uint32_t sample) {
      const Vector d = complex.samples()[sample].p - middle.p;
      return Complex(dot(d, middle.shape.u), dot(d, middle.shape.v()));
    };
    for (const Half_edge h : cell.sides) {
      corners.push_back(laid(complex.source(h)));
      middles.push_back(complex.edges()[h / 2].divided() ? laid(complex.middle_sample(h))
                                                         : 0.5 * (corners.back() + laid(complex.target(h))));
    }
    Complex mean = 0, spread = 0; // Σ (z − mean)² points to twice the angle of the axis
    for (const Complex z : corners)
      mean += z / double(corners.size());
    for (const Complex z : corners)
      spread += (z - mean) * (z - mean);
    axis = std::polar(1.0, std::arg(spread) / 2);
    for (const Complex z : corners) {
      const Complex d = (z - mean) * std::conj(axis);
      length = std::max(length, std::abs(d.real()));
      width = std::max(width, std::abs(d.imag()));
    }
    for (auto* const points : {&corners, &middles})
      for (Complex& z : *points)
        z = scaled(z);
  }
  Complex scaled(Complex z) const {
    z *= std::conj(axis);
    return {z.real() / length, z.imag() / width};
  }

  /// the corners of the part between the middles of sides i and j; nothing if they are not all on one side of the line.
  std::vector<Complex> part(std::size_t i, std::size_t j) const {
    std::vector<Complex> result{middles[i], middles[j]};
    const std::size_t n = corners.size();
    for (std::size_t k = i; k != j; k = (k + 1) % n) {
      const Complex corner = corners[(k + 1) % n];
      if (!((std::conj(middles[j] - middles[i]) * (corner - middles[i])).imag() < 0)) // it is on the right
        return {};
      result.push_back(corner);
    }
    return result;
  }
};

/// The second derivatives of the parts of the shape within a cell, from how their first ones differ; each divided by the greatest
/// value.
class Bend {
public:
  Bend(const Flat_cell& flat, const Outline& outline) {
    std::vector<Complex> z;
    Complex mean = 0;
    for (const Complex at : flat.points.z)
      mean += outline.scaled(at) / double(flat.points.z.size());
    double uu = 0, uv = 0, vv = 0;
    for (const Complex at : flat.points.z) {
      z.push_back(outline.scaled(at) - mean);
      uu += z.back().real() * z.back().real();
      uv += z.back().real() * z.back().imag();
      vv += z.back().imag() * z.back().imag();
    }
    // f_u = a + f_uu u + f_uv v and f_v = b + f_uv u + f_vv v, by least squares.
    const double det = (uu + vv) * (uu * vv - uv * uv);
    std::size_t p = 0;
    for (Flat_value Flat_shape::*part : {&Flat_shape::Q, &Flat_shape::A1, &Flat_shape::A3}) {
      Complex r0 = 0, r1 = 0, r2 = 0;
      double size = 0;
      for (std::size_t i = 0; i < z.size(); ++i) {
        const Flat_value& s = flat.shapes[i].*part;
        const Complex u = outline.length * (outline.axis.real() * s.x + outline.axis.imag() * s.y);
        const Complex v = outline.width * (outline.axis.real() * s.y - outline.axis.imag() * s.x);
        r0 += u * z[i].real();
        r1 += u * z[i].imag() + v * z[i].real();
        r2 += v * z[i].imag();
        size = std::max(size, std::abs(s.f));
      }
      const double scale = 1 / (det * size);
      const double minor = uu * vv - uv * uv;
      second_[p++] = {scale * ((minor + vv * vv) * r0 - uv * vv * r1 + uv * uv * r2),
                      scale * (-uv * vv * r0 + uu * vv * r1 - uu * uv * r2),
                      scale * (uv * uv * r0 - uu * uv * r1 + (minor + uu * uu) * r2)};
    }
  }

  /// how far the parts are from linear within a polygon.
  double within(const std::vector<Complex>& polygon) const {
    Complex mean = 0;
    for (const Complex z : polygon)
      mean += z / double(polygon.size());
    double sum = 0;
    for (const Second& s : second_) {
      double greatest = 0;
      for (const Complex z : polygon) {
        const double u = z.real() - mean.real(), v = z.imag() - mean.imag();
        greatest = std::max(greatest, std::norm(s.uu * u * u + 2.0 * s.uv * u * v + s.vv * v * v));
      }
      sum += greatest;
    }
    return std::sqrt(sum);
  }

private:
  struct Second {
    Complex uu, uv, vv;
  };
  std::array<Second, 3> second_;
};

} // namespace

std::optional<Side_pair> halving_of(const Refined_complex& complex, const Refined_cell& cell, const Sample& middle,
                                    const Flat_cell& flat) {
  if (!flat.has_derivatives || !flat.flat || cell.sides.size() > most_sides)
    return std::nullopt;
  const Outline outline(complex, cell, middle);
  const Bend bend(flat, outline);
  std::optional<Side_pair> best;
  double least = least_gain * bend.within(outline.corners); // which may not be a number
  for (std::size_t i = 0; i < outline.corners.size(); ++i)
    for (std::size_t j = i + 1; j < outline.corners.size(); ++j) {
      const std::vector<Complex> one = outline.part(i, j), other = outline.part(j, i);
      if (one.empty() || other.empty())
        continue;
      if (const double most = std::max(bend.within(one), bend.within(other)); most < least) {
        least = most;
        best = Side_pair{std::uint8_t(i), std::uint8_t(j)};
      }
    }
  return best;
}

} // namespace CGAL::Extremal_mesh_3
