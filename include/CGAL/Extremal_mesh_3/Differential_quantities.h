// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_DIFFERENTIAL_QUANTITIES_H
#define CGAL_EXTREMAL_MESH_3_DIFFERENTIAL_QUANTITIES_H

#include <CGAL/Extremal_mesh_3/Derivatives.h>
#include <CGAL/Extremal_mesh_3/Extremal_mesh.h>

#include <complex>

namespace CGAL::Extremal_mesh_3 {

/// The second fundamental form L of a surface at a point and its covariant derivative C, written as complex numbers in the direct
/// orthonormal tangent basis (u, v), v = n × u. Under a rotation of the basis by α, `Q`, `A1` and `A3` are multiplied by
/// e^{−2iα}, e^{−iα} and e^{−3iα}: each is smooth on the surface, at umbilics too, and needs no principal directions.
struct Local_shape {
  Vector n{0, 0, 1};       ///< unit normal
  Vector u{1, 0, 0};       ///< unit, orthogonal to n
  double H = 0;            ///< mean curvature (L11 + L22)/2, in 1/length
  std::complex<double> Q;  ///< (L11 − L22)/2 + i L12; |Q| = (k1 − k2)/2
  std::complex<double> A1; ///< 3[(C111 + C122) + i(C112 + C222)]/4, in 1/length²
  std::complex<double> A3; ///< [(C111 − 3C122) + i(3C112 − C222)]/4

  /// \return n × u, the second vector of the tangent basis
  Vector v() const { return {n[1] * u[2] - n[2] * u[1], n[2] * u[0] - n[0] * u[2], n[0] * u[1] - n[1] * u[0]}; }
  /// P = Ā3 Q + A1 Q̄; with the principal basis, |Q| (e1 + i e2). Zero exactly at extremal points and umbilics.
  /// \return P, in 1/length³
  std::complex<double> P() const { return std::conj(A3) * Q + A1 * std::conj(Q); }
  /// Φ = P² Q, the same in every basis: Im Φ = 2|Q|³ E_g, Re Φ = |Q|³ (e1² − e2²).
  /// \return Φ, in 1/length⁷
  std::complex<double> Phi() const {
    const std::complex<double> p = P();
    return p * p * Q;
  }
};

/// computes the local shape of the surface `f = 0`.
/// \param d  derivatives of `f` up to order 3 at a point of the surface
/// \return L and C in a tangent basis of its own choice
/// \pre the gradient is not zero and every entry is finite; otherwise the result is not finite either
Local_shape local_shape(const Derivatives& d);

/// Principal curvatures, directions and extremality coefficients.
struct Principal_quantities {
  double k1 = 0; ///< the larger principal curvature, in 1/length, with respect to n = ∇f/|∇f|
  double k2 = 0; ///< the smaller one
  Vector t1{};   ///< principal direction of k1, unit; at an umbilic any tangent
  Vector t2{};   ///< principal direction of k2; (t1, t2, n) is direct
  double e1 = 0; ///< ∇k1·t1, in 1/length²; its sign changes with that of t1
  double e2 = 0; ///< ∇k2·t2, in 1/length²; its sign changes with that of t2
  /// \return E_g = e1 e2, in 1/length⁴, independent of the orientation of t1, t2 and n
  double gaussian_extremality() const { return e1 * e2; }
};

/// turns the complex form into principal quantities. [Thirion 1993, 2.2–2.6]
/// \param s  the shape at a point
/// \return curvatures, directions, extremalities
Principal_quantities principal_quantities(const Local_shape& s);

/// computes ∇e_i·t_i, the derivative of an extremality along its own line of curvature: the second derivative of k_i there. It does not
/// depend on the orientation of t_i.
/// \param d  derivatives of `f` up to order 4
/// \param s  `local_shape(d)`
/// \param family  1 or 2
/// \return in 1/length³; not finite at an umbilic
double extremality_derivative(const Derivatives& d, const Local_shape& s, int family);

/// The derivative of C along the surface, made symmetric (what ∇C is not in by itself are products of curvatures), in
/// the basis of a `Local_shape`: for a unit tangent t at the angle θ, D(t,t,t,t) = D0 + Re(D̄2 e^{2iθ} + D̄4 e^{4iθ}) is the
/// second derivative of the normal curvature along the geodesic that leaves in the direction t.
struct Fourth_order_form {
  double D0 = 0;           ///< in 1/length³
  std::complex<double> D2; ///< multiplied by e^{−2iα} under a rotation of the basis by α
  std::complex<double> D4; ///< multiplied by e^{−4iα}
};

/// computes the fourth-order form of the surface `f = 0`.
/// \param d  derivatives of `f` up to order 4
/// \param s  `local_shape(d)`
/// \return the form, in the basis of `s`
Fourth_order_form fourth_order_form(const Derivatives& d, const Local_shape& s);

/// the same ∇e_i·t_i from the fourth-order form.
/// \param s  the shape at a point
/// \param D  the fourth-order form there, in the basis of `s`
/// \param family  1 or 2
/// \return in 1/length³; not finite at an umbilic
double extremality_derivative(const Local_shape& s, const Fourth_order_form& D, int family);

/// The generic umbilic with given third-order form.
struct Umbilic_class {
  double index = 0;                       ///< of the line field of curvature: +½, −½, or 0 if not generic
  int field_index = 0;                    ///< of the vector field V = |Q| (e1 t1 − e2 t2); 0 if not generic
  Umbilic_type type = Umbilic_type::none; ///< the pattern of lines of curvature
  int ridges = 0;                         ///< lines through the umbilic: 1 or 3 (0 if not generic)
};

/// classifies an umbilic from the third-order form there.
/// \param A1,A3  as in `Local_shape`, at the umbilic
/// \return its class
Umbilic_class classify_umbilic(std::complex<double> A1, std::complex<double> A3);

/// the type of a line of extremal points of family `i`.
/// \param k1,k2  the principal curvatures
/// \param family  1 or 2: which one is extremal
/// \param derivative  ∇e_i·t_i
/// \return the type
Line_type line_type(double k1, double k2, int family, double derivative);

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_DIFFERENTIAL_QUANTITIES_H
