// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The second fundamental form of an implicit surface and its derivatives along the surface, after Thirion, RR-2149, with the
// complex notation in which nothing is singular at umbilics.
#include <CGAL/Extremal_mesh_3/Differential_quantities.h>

#include "umbilic_lines.h"
#include "vector.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace CGAL::Extremal_mesh_3 {

namespace {

using Complex = std::complex<double>;

double quadratic(const std::array<double, 6>& h, const Vector& a, const Vector& b) {
  return h[0] * a[0] * b[0] + h[3] * a[1] * b[1] + h[5] * a[2] * b[2] + h[1] * (a[0] * b[1] + a[1] * b[0]) +
         h[2] * (a[0] * b[2] + a[2] * b[0]) + h[4] * (a[1] * b[2] + a[2] * b[1]);
}

/// the symmetric form T(a, ·, ·), in the order of a Hessian.
std::array<double, 6> contract(const std::array<double, 10>& t, const Vector& a) {
  return {t[0] * a[0] + t[1] * a[1] + t[2] * a[2], t[1] * a[0] + t[3] * a[1] + t[4] * a[2],
          t[2] * a[0] + t[4] * a[1] + t[5] * a[2], t[3] * a[0] + t[6] * a[1] + t[7] * a[2],
          t[4] * a[0] + t[7] * a[1] + t[8] * a[2], t[5] * a[0] + t[8] * a[1] + t[9] * a[2]};
}

/// F(a, a, a, a).
double quartic(const std::array<double, 15>& f, const Vector& a) {
  const double x = a[0], y = a[1], z = a[2];
  const double x2 = x * x, y2 = y * y, z2 = z * z;
  return f[0] * x2 * x2 + f[10] * y2 * y2 + f[14] * z2 * z2 + 4 * (f[1] * x2 * x * y + f[2] * x2 * x * z) +
         4 * (f[6] * x * y2 * y + f[11] * y2 * y * z) + 4 * (f[9] * x * z2 * z + f[13] * y * z2 * z) +
         6 * (f[3] * x2 * y2 + f[5] * x2 * z2 + f[12] * y2 * z2) +
         12 * (f[4] * x2 * y * z + f[7] * x * y2 * z + f[8] * x * y * z2);
}

} // namespace

Local_shape local_shape(const Derivatives& d) {
  Local_shape s;
  const double length = norm(d.gradient);
  const double scale = 1 / length;
  s.n = scale * d.gradient;
  s.u = any_orthogonal(s.n);
  const Vector u = s.u, v = s.v();

  const double L11 = -scale * quadratic(d.hessian, u, u);
  const double L12 = -scale * quadratic(d.hessian, u, v);
  const double L22 = -scale * quadratic(d.hessian, v, v);
  const double nHu = quadratic(d.hessian, s.n, u), nHv = quadratic(d.hessian, s.n, v);

  const auto Tu = contract(d.third, u), Tv = contract(d.third, v);
  const double C111 = -scale * (quadratic(Tu, u, u) + 3 * L11 * nHu);
  const double C112 = -scale * (quadratic(Tu, u, v) + L11 * nHv + 2 * L12 * nHu);
  const double C122 = -scale * (quadratic(Tv, u, v) + L22 * nHu + 2 * L12 * nHv);
  const double C222 = -scale * (quadratic(Tv, v, v) + 3 * L22 * nHv);

  s.H = (L11 + L22) / 2;
  s.Q = Complex((L11 - L22) / 2, L12);
  s.A1 = 0.75 * Complex(C111 + C122, C112 + C222);
  s.A3 = 0.25 * Complex(C111 - 3 * C122, 3 * C112 - C222);
  return s;
}

Principal_quantities principal_quantities(const Local_shape& s) {
  Principal_quantities r;
  const double R = std::abs(s.Q);
  r.k1 = s.H + R;
  r.k2 = s.H - R;
  const double theta = std::arg(s.Q) / 2; // arg(0) is 0: any frame will do at an umbilic
  const double c = std::cos(theta), sn = std::sin(theta);
  const Vector v = s.v();
  r.t1 = c * s.u + sn * v;
  r.t2 = c * v - sn * s.u;
  const Complex w(c, sn);                                                 // e^{iθ}
  const Complex p = std::conj(s.A3) * w * w * w, q = std::conj(s.A1) * w; // e(θ) = Re(p + q)
  r.e1 = (p + q).real();
  r.e2 = (Complex(0, -1) * p + Complex(0, 1) * q).real(); // θ + π/2 turns p by −i and q by i
  return r;
}

namespace {

/// the second derivative of the normal curvature along the geodesic γ that leaves in the direction t, at the angle θ
/// from u: from f(γ(s)) = 0 differentiated four times; γ'' = k n, n' = −L(t) there.
/// \param w  e^{iθ}
double along_geodesic(const Derivatives& d, const Local_shape& s, const Complex& w) {
  const Vector v = s.v(), t = w.real() * s.u + w.imag() * v;
  const Complex Qw = s.Q * std::conj(w); // L(t, ·) = H t + Q w̄ as a complex number
  const Vector Lt = s.H * t + Qw.real() * s.u + Qw.imag() * v;
  const double k = dot(Lt, t);
  const double e = (std::conj(s.A3) * w * w * w + std::conj(s.A1) * w).real();
  const double length = norm(d.gradient);
  const Vector gamma3 = e * s.n - k * Lt; // γ'''
  return -(quartic(d.fourth, t) + 6 * k * quadratic(contract(d.third, s.n), t, t) +
           3 * k * k * quadratic(d.hessian, s.n, s.n) + 4 * quadratic(d.hessian, t, gamma3)) /
             length +
         k * dot(Lt, Lt);
}

/// ∇e_i·t_i from D(t_i,t_i,t_i,t_i). The line of curvature leaves the geodesic: ∇_t1 t1 = C(t1,t1,t2)/(k1 − k2) t2, and
/// likewise for t2.
double along_line_of_curvature(const Local_shape& s, double D, int family) {
  const Complex w = std::polar(1.0, std::arg(s.Q) / 2);
  const Complex a3 = s.A3 * std::conj(w * w * w), a1 = s.A1 * std::conj(w); // in the principal basis
  const double C112 = a1.imag() / 3 + a3.imag(), C122 = a1.real() / 3 - a3.real();
  const double difference = 2 * std::abs(s.Q);
  return family == 1 ? D + 3 * C112 * C112 / difference : D - 3 * C122 * C122 / difference;
}

double principal_angle(const Local_shape& s, int family) {
  return std::arg(s.Q) / 2 + (family == 1 ? 0 : std::numbers::pi / 2);
}

} // namespace

double extremality_derivative(const Derivatives& d, const Local_shape& s, int family) {
  return along_line_of_curvature(s, along_geodesic(d, s, std::polar(1.0, principal_angle(s, family))), family);
}

Fourth_order_form fourth_order_form(const Derivatives& d, const Local_shape& s) {
  // A trigonometric polynomial in 2θ of degree 2 is known from five values.
  constexpr int n = 5;
  struct Angle {
    Complex w, w2, w4; // e^{iθ}, e^{2iθ}, e^{4iθ}
  };
  static const std::array<Angle, n> angles = [] {
    std::array<Angle, n> result;
    for (std::size_t i = 0; i < n; ++i) {
      const double theta = double(i) * std::numbers::pi / n;
      result[i] = {std::polar(1.0, theta), std::polar(1.0, 2 * theta), std::polar(1.0, 4 * theta)};
    }
    return result;
  }();
  Fourth_order_form form;
  for (const auto& [w, w2, w4] : angles) {
    const double D = along_geodesic(d, s, w);
    form.D0 += D / n;
    form.D2 += 2 * D / n * w2;
    form.D4 += 2 * D / n * w4;
  }
  return form;
}

double extremality_derivative(const Local_shape& s, const Fourth_order_form& D, int family) {
  const Complex w = std::polar(1.0, 2 * principal_angle(s, family));
  return along_line_of_curvature(s, D.D0 + (std::conj(D.D2) * w + std::conj(D.D4) * w * w).real(), family);
}

namespace {

/// a power of two that takes x to the size of 1: by it numbers are scaled without rounding. Products of many of them would else
/// leave the range of numbers where a surface is given in a very small or large unit.
double scale_to_one(double x) {
  return x > 0 && std::isfinite(x) ? std::scalbn(1.0, -std::ilogb(x)) : 1;
}

/// the number of real roots of the cubic form a x³ + b x²y + c x y² + d y³ in the projective line, 1 or 3 (0 if a double root).
int real_roots(double a, double b, double c, double d) {
  const double discriminant =
      18 * a * b * c * d - 4 * b * b * b * d + b * b * c * c - 4 * a * c * c * c - 27 * a * a * d * d;
  return discriminant > 0 ? 3 : (discriminant < 0 ? 1 : 0);
}

/// the number of real lines on which Im(F) = 0 for F(z) = c0 z³ + c1 z² z̄ + c2 z z̄² + c3 z̄³.
int real_lines(const std::array<Complex, 4>& c) {
  // z = x + iy: gather Im F as a form in x, y by evaluating it on four lines.
  const auto form = [&](double x, double y) {
    const Complex z(x, y), w = std::conj(z);
    return (c[0] * z * z * z + c[1] * z * z * w + c[2] * z * w * w + c[3] * w * w * w).imag();
  };
  const double a = form(1, 0), d = form(0, 1);
  const double p = form(1, 1) - a - d, m = form(1, -1) - a + d; // b + c and −b + c
  return real_roots(a, (p - m) / 2, (p + m) / 2, d);
}

/// the number of extremal lines where P = p z + q z̄ and Q = α z + β z̄ vanish.
int lines_through_umbilic(Complex p, Complex q, Complex alpha, Complex beta) {
  const double of_P = scale_to_one(std::max(std::abs(p), std::abs(q))),
               of_Q = scale_to_one(std::max(std::abs(alpha), std::abs(beta)));
  p *= of_P;
  q *= of_P;
  alpha *= of_Q;
  beta *= of_Q;
  return real_lines(
      {p * p * alpha, p * p * beta + 2.0 * p * q * alpha, q * q * alpha + 2.0 * p * q * beta, q * q * beta});
}

int sign(double x) {
  return (x > 0) - (x < 0);
}

} // namespace

int lines_through_umbilic(const Linear_field& P, const Linear_field& Q) {
  // X = a z + b z̄
  const auto a = [](const Linear_field& X) { return (X.x - Complex(0, 1) * X.y) / 2.0; };
  const auto b = [](const Linear_field& X) { return (X.x + Complex(0, 1) * X.y) / 2.0; };
  return lines_through_umbilic(a(P), b(P), a(Q), b(Q));
}

Umbilic_fields fields_at_umbilic(Complex A1, Complex A3) {
  // Q ≈ α z + β z̄ (Codazzi), and P = Ā3 Q + A1 Q̄.
  const Complex alpha = A1 / 3.0, beta = A3, i(0, 1);
  const Linear_field Q{alpha + beta, i * (alpha - beta)};
  return {{std::conj(A3) * Q.x + A1 * std::conj(Q.x), std::conj(A3) * Q.y + A1 * std::conj(Q.y)}, Q};
}

Umbilic_class classify_umbilic(Complex A1, Complex A3) {
  const double a1 = std::norm(A1), a3 = std::norm(A3);
  Umbilic_class c;
  c.index = 0.5 * sign(a1 / 9 - a3);
  c.field_index = sign((a1 - a3) * (a1 / 9 - a3));
  if (c.index == 0 || c.field_index == 0)
    return c;

  const Umbilic_fields fields = fields_at_umbilic(A1, A3);
  c.ridges = lines_through_umbilic(fields.P, fields.Q);
  // Lines of curvature that end at the umbilic leave in directions z with Q ≈ A1/3 z + A3 z̄ parallel to z²: Im(Q z̄²) = 0.
  const int separatrices = real_lines({0, 0, A1 / 3.0, A3});
  c.type = c.index < 0 ? Umbilic_type::star : (separatrices == 1 ? Umbilic_type::lemon : Umbilic_type::monstar);
  return c;
}

Line_type line_type(double k1, double k2, int family, double derivative) {
  const double k = family == 1 ? k1 : k2, other = family == 1 ? k2 : k1;
  const bool largest = std::abs(k) >= std::abs(other);
  const bool maximum = (derivative < 0) == (k > 0);
  if (largest)
    return maximum ? Line_type::max_largest : Line_type::min_largest;
  return maximum ? Line_type::max_second : Line_type::min_second;
}

} // namespace CGAL::Extremal_mesh_3
