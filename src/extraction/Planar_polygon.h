// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_EXTRACTION_PLANAR_POLYGON_H
#define EXTREMAL_MESH_3_SRC_EXTRACTION_PLANAR_POLYGON_H

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

/// The border of a cell in its tangent plane.
class Planar_polygon {
public:
  using Complex = std::complex<double>;

  Planar_polygon() = default;
  explicit Planar_polygon(std::vector<Complex> corners) : corner_(std::move(corners)) {}

  const std::vector<Complex>& corners() const { return corner_; }

  bool contains(Complex z) const {
    bool inside = false;
    for (std::size_t i = 0, j = corner_.size() - 1; i < corner_.size(); j = i++) {
      const Complex a = corner_[i] - z, b = corner_[j] - z;
      if ((a.imag() > 0) != (b.imag() > 0) && (a.real() - a.imag() * (b.real() - a.real()) / (b.imag() - a.imag())) > 0)
        inside = !inside;
    }
    return inside;
  }

  /// the distance from the nearest side.
  double distance_to_border(Complex z) const {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0, j = corner_.size() - 1; i < corner_.size(); j = i++) {
      const Complex side = corner_[i] - corner_[j], from = z - corner_[j];
      const double length2 = std::norm(side);
      const double t = length2 > 0 ? std::clamp((std::conj(side) * from).real() / length2, 0.0, 1.0) : 0;
      least = std::min(least, std::norm(from - t * side));
    }
    return std::sqrt(least);
  }

private:
  std::vector<Complex> corner_;
};

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_EXTRACTION_PLANAR_POLYGON_H
