// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_EXTRACTION_LINEAR_FIT_H
#define EXTREMAL_MESH_3_SRC_EXTRACTION_LINEAR_FIT_H

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

/// Positions in the tangent plane of a cell.
struct Planar_points {
  std::vector<std::complex<double>> z;
  double radius = 0; ///< of the farthest, from 0

  void add(std::complex<double> point) {
    z.push_back(point);
    radius = std::max(radius, std::abs(point));
  }
  /// the ratio of the smaller to the greater extent.
  double aspect() const {
    const Moments m = moments();
    const double mean = (m.xx + m.yy) / 2, difference = std::hypot((m.xx - m.yy) / 2, m.xy);
    return std::sqrt(std::max(0.0, mean - difference) / (mean + difference));
  }
  struct Moments {
    std::complex<double> center;
    double xx = 0, xy = 0, yy = 0;
  };
  Moments moments() const {
    Moments m;
    for (const auto& p : z)
      m.center += p / double(z.size());
    for (const auto& p : z) {
      const auto d = p - m.center;
      m.xx += d.real() * d.real();
      m.xy += d.real() * d.imag();
      m.yy += d.imag() * d.imag();
    }
    return m;
  }
};

/// The linear function nearest to values (real or complex) at points of the plane.
template <class Value> struct Linear_fit {
  Value constant{}, x{}, y{};
  std::vector<Value> differences; ///< of the values from the function, at each point
  double residual = 0;            ///< the greatest of them

  Linear_fit(const Planar_points& points, const std::vector<Value>& values) {
    const auto m = points.moments();
    Value mean{}, bx{}, by{};
    for (const Value& v : values)
      mean += v / double(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
      bx += (points.z[i] - m.center).real() * (values[i] - mean);
      by += (points.z[i] - m.center).imag() * (values[i] - mean);
    }
    const double det = m.xx * m.yy - m.xy * m.xy;
    x = (m.yy * bx - m.xy * by) / det;
    y = (m.xx * by - m.xy * bx) / det;
    constant = mean - m.center.real() * x - m.center.imag() * y;
    for (std::size_t i = 0; i < values.size(); ++i) {
      differences.push_back(values[i] - (*this)(points.z[i]));
      residual = std::max(residual, std::abs(differences.back()));
    }
  }
  Value operator()(std::complex<double> p) const { return constant + p.real() * x + p.imag() * y; }
};

/// the point z at which the linear part of `f` is `value`: values measured in the plane. Not finite if the linear part
/// is singular.
inline std::complex<double> preimage(const Linear_fit<std::complex<double>>& f, std::complex<double> value) {
  const double det = f.x.real() * f.y.imag() - f.x.imag() * f.y.real();
  return {(value.real() * f.y.imag() - value.imag() * f.y.real()) / det,
          (f.x.real() * value.imag() - f.x.imag() * value.real()) / det};
}

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_EXTRACTION_LINEAR_FIT_H
