// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_EXTRACTION_QUADRATIC_MODEL_H
#define EXTREMAL_MESH_3_SRC_EXTRACTION_QUADRATIC_MODEL_H

#include "Flat_cell.h"

#include <array>
#include <cmath>

namespace CGAL::Extremal_mesh_3 {

/// A complex function c0 + c1 x + c2 y + c3 x² + c4 xy + c5 y² of the place z = x + iy.
struct Quadratic_field {
  std::array<Complex, 6> c{};
  double residual = 0; ///< the greatest difference from the values that it was fitted to

  Complex operator()(Complex z) const {
    const double x = z.real(), y = z.imag();
    return c[0] + x * (c[1] + x * c[3] + y * c[4]) + y * (c[2] + y * c[5]);
  }
  Complex dx(Complex z) const { return c[1] + 2 * z.real() * c[3] + z.imag() * c[4]; }
  Complex dy(Complex z) const { return c[2] + z.real() * c[4] + 2 * z.imag() * c[5]; }
};

/// P and Q in a cell as quadratic functions of the place in its tangent plane, in units of the cell's radius. Φ = P² Q
/// made of these is near to the true one also where its phase turns within a narrow strip.
class Quadratic_model {
public:
  /// \pre at least 7 samples that do not lie on one conic
  explicit Quadratic_model(const Flat_cell& flat);

  double scale() const { return scale_; } ///< the radius of the cell
  Complex phi(Complex z) const {
    const Complex p = P_(z);
    return p * p * Q_(z);
  }
  /// an estimate, to the safe side, of the error of the phase of Φ.
  double phase_error(Complex z) const {
    constexpr double safety = 3; // residuals are those at samples
    return safety * (2 * P_.residual / std::abs(P_(z)) + Q_.residual / std::abs(Q_(z)));
  }
  /// Derivatives of the phase: x and y, then xx, xy, yy.
  struct Slopes {
    double x, y, xx, xy, yy;
    double hessian() const { return xx * yy - xy * xy; }
  };
  Slopes slopes(Complex z) const;

private:
  Quadratic_field P_, Q_;
  double scale_ = 1;
};

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_EXTRACTION_QUADRATIC_MODEL_H
