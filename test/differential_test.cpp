// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Local shapes against closed forms, finite differences on the surface, and the laws of MATHEMATICS 1 to 3.
#include <CGAL/Extremal_mesh_3/Differential_quantities.h>
#include <CGAL/Extremal_mesh_3/Formula.h>

#include "surfaces.h"

#include <complex>
#include <numbers>

using namespace CGAL::Extremal_mesh_3;

namespace {

using Complex = std::complex<double>;
using namespace surfaces;

const Formula& generic() {
  static const Formula f("x^2+1.3*y^2+1.7*z^2+0.2*x^3+0.15*y^3-0.4*x*y*z+0.2*x^2*z+0.1*x*y^2+0.3*y^4-1");
  return f;
}

/// the point of the surface on the ray from the origin.
Point on_surface(const Function_3& f, const Vector& direction) {
  double t = 0.5;
  Derivatives d;
  for (int i = 0; i < 50; ++i) {
    f.derivatives(along({0, 0, 0}, t, direction), 1, d);
    t -= d.value / dot(d.gradient, direction);
  }
  return along({0, 0, 0}, t, direction);
}

/// some 20 points of the generic surface, spread over it.
std::vector<Point> points() {
  std::vector<Point> all;
  for (int i = 0; i < 20; ++i) { // Fibonacci's spiral
    const double z = (i + 0.5) / 10 - 1, angle = 2.399963229728653 * i, r = std::sqrt(1 - z * z);
    all.push_back(on_surface(generic(), {r * std::cos(angle), r * std::sin(angle), z}));
  }
  return all;
}

Derivatives derivatives(const Function_3& f, const Point& p) {
  Derivatives d;
  f.derivatives(p, 4, d);
  return d;
}

Principal_quantities quantities(const Function_3& f, const Point& p) {
  return principal_quantities(local_shape(derivatives(f, p)));
}

/// follows the gradient to the surface.
Point projected(const Function_3& f, Point p) {
  for (int i = 0; i < 10; ++i) {
    const Derivatives d = derivatives(f, p);
    p = along(p, -d.value / dot(d.gradient, d.gradient), d.gradient);
  }
  return p;
}

/// the derivative, along the line of curvature through p, of a quantity that changes its sign with t_i, or does not.
template <class Quantity>
double slope(const Function_3& f, const Point& p, int family, bool signs_change, const Quantity& quantity) {
  const auto direction = [&](const Principal_quantities& q) { return family == 1 ? q.t1 : q.t2; };
  const Vector t = direction(quantities(f, p));
  const double h = 1e-4;
  std::array<double, 2> value{};
  for (std::size_t side = 0; side < 2; ++side) {
    const Principal_quantities q = quantities(f, projected(f, along(p, side == 0 ? -h : h, t)));
    value[side] = quantity(q) * (signs_change && dot(direction(q), t) < 0 ? -1 : 1);
  }
  return (value[1] - value[0]) / (2 * h);
}

/// the Monge patch z = ½(k1 x² + k2 y²) + ⅙(b0 x³ + 3 b1 x² y + 3 b2 x y² + b3 y³), the normal upwards.
Derivatives monge(double k1, double k2, double b0, double b1, double b2, double b3) {
  Derivatives d;
  d.gradient = {0, 0, 1};
  d.hessian = {-k1, 0, 0, -k2, 0, 0};
  d.third = {-b0, -b1, 0, -b2, 0, 0, -b3, 0, 0, 0};
  return d;
}

Derivatives negated(Derivatives d) {
  d.value = -d.value;
  for (double& x : d.gradient)
    x = -x;
  for (double& x : d.hessian)
    x = -x;
  for (double& x : d.third)
    x = -x;
  for (double& x : d.fourth)
    x = -x;
  return d;
}

} // namespace

TEST(Principal_quantities, of_an_ellipsoid_at_the_ends_of_its_axes) {
  // At (a, 0, 0) the sections are ellipses with curvatures a/b² and a/c²; the normal points outwards, so they are
  // negative.
  const double a = 3, b = 2, c = 1;
  const Formula f("x^2/9+y^2/4+z^2-1");
  const auto expect = [&](const Point& p, double first, double second) {
    const Principal_quantities q = quantities(f, p);
    EXPECT_NEAR(q.k1, -std::min(first, second), 1e-14);
    EXPECT_NEAR(q.k2, -std::max(first, second), 1e-14);
    EXPECT_NEAR(q.e1, 0, 1e-14);
    EXPECT_NEAR(q.e2, 0, 1e-14);
  };
  expect({a, 0, 0}, a / (b * b), a / (c * c));
  expect({0, b, 0}, b / (a * a), b / (c * c));
  expect({0, 0, c}, c / (a * a), c / (b * b));
}

TEST(Principal_quantities, of_an_ellipsoid_satisfy_gauss) {
  // K = (product of the semi-axes squared)⁻¹ (x²/a⁴ + y²/b⁴ + z²/c⁴)⁻².
  const Formula f("x^2/9+y^2/4+z^2-1");
  for (const Vector& direction : {Vector{1, 2, 0.5}, Vector{-1, 0.3, 0.8}, Vector{0.2, -0.7, 0.4}}) {
    const Point p = on_surface(f, direction);
    const Principal_quantities q = quantities(f, p);
    const double w = p[0] * p[0] / 81 + p[1] * p[1] / 16 + p[2] * p[2];
    EXPECT_NEAR(q.k1 * q.k2, 1 / (36 * w * w), 1e-13 / (w * w));
  }
}

TEST(Principal_quantities, of_a_paraboloid_at_its_apex) {
  // z = x² − y²/2 has curvatures 2 and −1 with respect to the upward normal.
  const Principal_quantities q = quantities(Formula("z-x^2+y^2/2"), {0, 0, 0});
  EXPECT_DOUBLE_EQ(q.k1, 2);
  EXPECT_DOUBLE_EQ(q.k2, -1);
  EXPECT_DOUBLE_EQ(std::abs(q.t1[0]), 1);
  EXPECT_DOUBLE_EQ(std::abs(q.t2[1]), 1);
  EXPECT_DOUBLE_EQ(dot(cross(q.t1, q.t2), {0, 0, 1}), 1);
}

TEST(Principal_quantities, of_a_monge_patch_are_its_coefficients) {
  // MATHEMATICS 1: C111 = b0 = e1, C222 = b3 = e2, up to the orientation of t1 and t2.
  const Derivatives up = monge(1.5, 0.5, 0.7, -0.3, 0.2, 0.4);
  const Principal_quantities q = principal_quantities(local_shape(up));
  EXPECT_DOUBLE_EQ(q.k1, 1.5);
  EXPECT_DOUBLE_EQ(q.k2, 0.5);
  EXPECT_NEAR(q.e1 * q.t1[0], 0.7, 1e-15);
  EXPECT_NEAR(q.e2 * q.t2[1], 0.4, 1e-15);
  EXPECT_NEAR(q.gaussian_extremality(), 0.28, 1e-15);

  // Downwards: k1' = −k2, k2' = −k1, and the families are exchanged; E_g stays.
  const Principal_quantities down = principal_quantities(local_shape(negated(up)));
  EXPECT_DOUBLE_EQ(down.k1, -0.5);
  EXPECT_DOUBLE_EQ(down.k2, -1.5);
  EXPECT_NEAR(down.e1 * down.t1[1], -0.4, 1e-15);
  EXPECT_NEAR(down.e2 * down.t2[0], -0.7, 1e-15);
  EXPECT_NEAR(down.gaussian_extremality(), 0.28, 1e-15);
}

TEST(Principal_quantities, extremalities_are_derivatives_of_curvatures) {
  for (const Point& p : points()) {
    const Principal_quantities q = quantities(generic(), p);
    // Central differences with step 1e-4: error h² times the third derivatives (some 100 here), and rounding 1e-15 / h.
    EXPECT_NEAR(q.e1, slope(generic(), p, 1, false, [](const auto& x) { return x.k1; }), 1e-5);
    EXPECT_NEAR(q.e2, slope(generic(), p, 2, false, [](const auto& x) { return x.k2; }), 1e-5);
  }
}

TEST(Extremality_derivative, is_the_derivative_of_the_extremality) {
  for (const Point& p : points()) {
    const Derivatives d = derivatives(generic(), p);
    const Local_shape s = local_shape(d);
    const double scale = 1 + 1 / std::abs(s.Q); // near umbilics everything varies faster
    EXPECT_NEAR(extremality_derivative(d, s, 1), slope(generic(), p, 1, true, [](const auto& x) { return x.e1; }),
                1e-5 * scale * scale * scale);
    EXPECT_NEAR(extremality_derivative(d, s, 2), slope(generic(), p, 2, true, [](const auto& x) { return x.e2; }),
                1e-5 * scale * scale * scale);
  }
}

TEST(Local_shape, turns_with_spins_2_1_3) {
  const Complex Q(0.3, -0.5), A1(1.1, 0.2), A3(-0.4, 0.6);
  Local_shape s;
  s.H = 0.8;
  s.Q = Q;
  s.A1 = A1;
  s.A3 = A3;
  const Principal_quantities q = principal_quantities(s);
  for (const double alpha : {0.3, 1.7, -2.5}) {
    Local_shape turned = s;
    turned.u = along(along({0, 0, 0}, std::cos(alpha), s.u), std::sin(alpha), s.v());
    turned.Q = Q * std::polar(1.0, -2 * alpha);
    turned.A1 = A1 * std::polar(1.0, -alpha);
    turned.A3 = A3 * std::polar(1.0, -3 * alpha);
    EXPECT_NEAR(std::abs(turned.Phi() - s.Phi()), 0, 1e-14);
    const Principal_quantities r = principal_quantities(turned);
    const double same = dot(r.t1, q.t1) > 0 ? 1 : -1;
    EXPECT_NEAR(distance(r.t1, along({0, 0, 0}, same, q.t1)), 0, 1e-14);
    EXPECT_NEAR(r.e1, same * q.e1, 1e-14);
    EXPECT_NEAR(r.e2, same * q.e2, 1e-14);
  }
}

TEST(Local_shape, does_not_depend_on_the_position_of_the_surface) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    SCOPED_TRACE(seed);
    const Motion motion = random_motion(seed);
    const Moved_function moved(generic(), motion), mirror(generic(), mirrored(motion)), back(generic(), motion, -1);
    for (const Point& p : points()) {
      const Local_shape s = local_shape(derivatives(generic(), p));
      const Local_shape m = local_shape(derivatives(moved, motion(p)));
      const double size = std::abs(s.Phi()) + 1e-3; // rounding is relative to terms of that size
      EXPECT_NEAR(m.H, s.H, 1e-12);
      EXPECT_NEAR(std::abs(m.Phi() - s.Phi()), 0, 1e-10 * size);
      // The basis has turned by some angle; each quantity takes its spin of it.
      const Vector u = motion.turned(s.u);
      const Complex z(dot(m.u, u), dot(m.u, motion.turned(s.v())));
      EXPECT_NEAR(std::abs(m.Q * z * z - s.Q), 0, 1e-12);
      EXPECT_NEAR(std::abs(m.A1 * z - s.A1), 0, 1e-11);
      EXPECT_NEAR(std::abs(m.A3 * z * z * z - s.A3), 0, 1e-11);
      // A mirror changes the sign of E_g, hence of Im Φ; reversing the normal exchanges e1² and e2², hence Re Φ.
      const Complex in_mirror = local_shape(derivatives(mirror, mirrored(motion)(p))).Phi();
      EXPECT_NEAR(std::abs(in_mirror - std::conj(s.Phi())), 0, 1e-10 * size);
      const Local_shape b = local_shape(derivatives(back, motion(p)));
      EXPECT_NEAR(std::abs(b.Phi() + std::conj(s.Phi())), 0, 1e-10 * size);
      EXPECT_NEAR(b.H, -s.H, 1e-12);
    }
  }
}

TEST(Fourth_order_form, turns_with_spins_2_and_4_and_gives_the_extremality_derivatives) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE(seed);
    const Motion motion = random_motion(seed);
    const Moved_function moved(generic(), motion);
    for (const Point& p : points()) {
      const Derivatives d = derivatives(generic(), p), e = derivatives(moved, motion(p));
      const Local_shape s = local_shape(d), m = local_shape(e);
      const Fourth_order_form D = fourth_order_form(d, s), F = fourth_order_form(e, m);
      const Complex z(dot(m.u, motion.turned(s.u)), dot(m.u, motion.turned(s.v())));
      const double size = 1 + std::abs(D.D0) + std::abs(D.D2) + std::abs(D.D4);
      EXPECT_NEAR(F.D0, D.D0, 1e-11 * size);
      EXPECT_NEAR(std::abs(F.D2 * z * z - D.D2), 0, 1e-11 * size);
      EXPECT_NEAR(std::abs(F.D4 * z * z * z * z - D.D4), 0, 1e-11 * size);
      for (int family = 1; family <= 2; ++family) {
        const double expected = extremality_derivative(d, s, family);
        EXPECT_NEAR(extremality_derivative(s, D, family), expected, 1e-11 * (size + std::abs(expected)));
      }
    }
  }
}

TEST(Local_shape, scales) {
  // Curvatures are 1/length, extremalities 1/length²; the size of f does not matter.
  for (const double scale : {1e-3, 0.5, 1e4}) {
    Motion motion;
    motion.scale = scale;
    const Moved_function moved(generic(), motion, 7);
    for (const Point& p : points()) {
      const Derivatives d = derivatives(generic(), p), e = derivatives(moved, motion(p));
      const Local_shape s = local_shape(d), m = local_shape(e);
      EXPECT_NEAR(std::abs(m.Q * scale - s.Q), 0, 1e-12);
      EXPECT_NEAR(std::abs(m.A1 * scale * scale - s.A1), 0, 1e-11);
      EXPECT_NEAR(std::abs(m.A3 * scale * scale - s.A3), 0, 1e-11);
      const double D = extremality_derivative(d, s, 1);
      EXPECT_NEAR(extremality_derivative(e, m, 1) * scale * scale * scale, D, 1e-10 * (1 + std::abs(D)));
    }
  }
}

TEST(Local_shape, phi_and_V_are_what_they_stand_for) {
  for (const Point& p : points()) {
    const Local_shape s = local_shape(derivatives(generic(), p));
    const Principal_quantities q = principal_quantities(s);
    const double R = std::abs(s.Q), R3 = R * R * R;
    EXPECT_NEAR(2 * R, q.k1 - q.k2, 1e-14);
    EXPECT_NEAR(2 * s.H, q.k1 + q.k2, 1e-14);
    const double size = R3 * (q.e1 * q.e1 + q.e2 * q.e2);
    EXPECT_NEAR(s.Phi().imag(), 2 * R3 * q.gaussian_extremality(), 1e-13 * size);
    EXPECT_NEAR(s.Phi().real(), R3 * (q.e1 * q.e1 - q.e2 * q.e2), 1e-13 * size);
    const Vector V = along(along({0, 0, 0}, R * q.e1, q.t1), -R * q.e2, q.t2);
    EXPECT_NEAR(dot(V, s.u), s.P().real(), 1e-13 * (1 + R));
    EXPECT_NEAR(dot(V, s.v()), -s.P().imag(), 1e-13 * (1 + R));
  }
}
