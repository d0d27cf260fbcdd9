// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_EXTRACTION_CELL_MODEL_H
#define EXTREMAL_MESH_3_SRC_EXTRACTION_CELL_MODEL_H

#include "Flat_cell.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

/// A real function of the place in the plane, with its derivatives there.
struct Plane_jet {
  double f = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;
};

/// How far a real function may be from its linear part within a distance of a place, and its gradient from that there.
struct Plane_range {
  double remainder = 0, turn = 0;
};

/// Which field: P vanishes at extremal points and umbilics, Q at umbilics.
enum class Field : std::uint8_t { P, Q };

/// The two parts of P or Q at a place.
struct Field_jets {
  Plane_jet re, im;
};
/// By how much the model may be wrong in each.
struct Field_errors {
  double re = 0, im = 0;
};
/// P or Q about a place.
struct Field_view {
  Field_jets here;
  Plane_range re, im; ///< within a distance
  Field_errors errors;
};

/// P and Q in a cell as functions of the place z = x + iy in its tangent plane: in coordinates along the long and the short axis
/// of the cell, in which it is about as long as wide and fills the unit circle. Φ = P² Q made of these is near to the
/// true one also where its phase turns within a narrow strip.
///
/// The components are those in the principal basis of the middle. There P = |Q| (e1 + i e2): at a crease one part varies
/// far more than the other, and so does its error, so each has an estimate of its own.
///
/// Where samples have derivatives L and C are cubic, or of degree 4 or 5 if there are many samples, fitted to values and
/// derivatives, and P follows: products vary twice as fast as their factors. Elsewhere P and Q themselves are quadratic.
class Cell_model {
public:
  /// \pre with derivatives, at least 4 samples; without, at least 7. They do not lie on one conic.
  /// \param Q  at the middle, in the basis of `flat`
  Cell_model(const Flat_cell& flat, Complex Q);

  /// between the coordinates of the model and those of `flat`, which are lengths.
  Complex from_plane(Complex z) const {
    const Complex turned = z * std::conj(axis_);
    return {turned.real() / length_, turned.imag() / width_};
  }
  Complex to_plane(Complex z) const { return Complex(length_ * z.real(), width_ * z.imag()) * axis_; }
  struct Fields {
    Complex P, Q;
    Complex phi() const { return P * P * Q; }
  };
  Fields operator()(Complex z) const;
  Field_jets jets(Field field, Complex z) const;
  /// \param r  how far it is looked from z
  Field_view view(Field field, Complex z, double r) const { return view_of(field, jets(z), r); }
  struct Views {
    Field_view P, Q;
  };
  Views views(Complex z, double r) const {
    const Jets j = jets(z);
    return {view_of(Field::P, j, r), view_of(Field::Q, j, r)};
  }
  /// estimates, to the safe side.
  Field_errors errors(Field field, Complex z) const;
  /// the same for the phase of Φ: farther from the nearest multiple of π than this, it is on the side on which it seems.
  double phase_error(Complex z) const;

  /// Derivatives of the phase: x and y, then xx, xy, yy.
  struct Slopes {
    double x, y, xx, xy, yy;
    double log_x, log_y; ///< of the logarithm of |P|² |Q|²
    double hessian() const { return xx * yy - xy * xy; }
  };
  Slopes slopes(Complex z) const;

private:
  /// Q = q1 + i q2. With derivatives, Re P = q1 e1 + q2 s1 and Im P = q1 e2 − q2 s2, where e1 = C111, e2 = C222,
  /// s1 = (3 C112 + C222)/2 and s2 = (C111 + 3 C122)/2; without, `e1` and `e2` are P's parts.
  enum Part : std::uint8_t { q1, q2, e1, e2, s1, s2 };
  static constexpr int parts = 6, most_monomials = 21;
  using Values = Eigen::Array<double, parts, 1>;
  using Jets = std::array<Plane_jet, parts>;

  Field_jets jets_of(Field field, const Jets& j) const;
  Field_view view_of(Field field, const Jets& j, double r) const;
  template <class Part_value> Field_errors errors_of(Field field, const Part_value& value) const;
  Values values(Complex z) const;
  Jets jets(Complex z) const;
  template <int Degree> Values values_of_degree(Complex z) const;
  template <int Degree> Jets jets_of_degree(Complex z) const;
  Plane_range range(Part part, const Plane_jet& here, double r) const;
  void choose_coordinates(const Planar_points& points);
  /// the number of samples that are left if one is taken of those that lie side by side.
  std::size_t samples_apart(const std::vector<Complex>& points) const;
  template <int Degree> void fit(const Flat_cell& flat, Complex w);

  bool by_parts_ = false;
  int degree_ = 0;
  /// the coefficients of 1, x, y, x², xy, y², x³, x²y, …, of all parts
  Eigen::Array<double, parts, most_monomials> c_;
  Values third_ = Values::Zero();    ///< more than |D³(t, t, t)| in the cell
  Values residual_ = Values::Zero(); ///< the greatest difference from what the part was fitted to
  Complex axis_ = 1;                 ///< the direction of the long axis
  double length_ = 1, width_ = 1;
};

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_EXTRACTION_CELL_MODEL_H
