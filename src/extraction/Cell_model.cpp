// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Cell_model.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

namespace {

/// Derivatives weigh as much as what a field changes by over this part of the cell's radius.
constexpr double weight_of_derivatives = 0.5;
/// The degree follows from how many samples lie as far from each other, in parts of the cell's radius. Where edges are divided many lie
/// side by side: a model of the degree that all of them would allow meets them, and is off by a thousand times that elsewhere.
constexpr double apart = 0.25;
/// Residuals are those at samples: between them a model is up to so much worse. Products take the errors of their factors as if they
/// added up, which they seldom do: less is as safe. (In the cells of CTs P is worse than
/// that at 1 place in 1000.)
constexpr double safety = 3, safety_of_products = 2;

constexpr int monomials_of(int degree) {
  return (degree + 1) * (degree + 2) / 2;
}

template <int Degree> using Row = Eigen::Matrix<double, monomials_of(Degree), 1>;

/// calls use(k, i, j) for the monomials x^i y^j, the k-th of them, in the order of their degrees.
template <int Degree, class Use> void for_each_monomial(const Use& use) {
  int k = 0;
#pragma GCC unroll 6
  for (int degree = 0; degree <= Degree; ++degree)
#pragma GCC unroll 6
    for (int j = 0; j <= degree; ++j)
      use(k++, degree - j, j);
}

/// The powers of a number, after two zeros: the derivatives of low powers need no case of their own.
struct Powers {
  std::array<double, 8> p{0, 0, 1};
  explicit Powers(double x) {
    for (std::size_t i = 3; i < p.size(); ++i)
      p[i] = x * p[i - 1];
  }
  double operator()(int i) const { return p[std::size_t(i + 2)]; }
  double first(int i) const { return i * p[std::size_t(i + 1)]; }
  double second(int i) const { return i * (i - 1) * p[std::size_t(i)]; }
};

/// The monomials at a place, and their derivatives along the axes.
template <int Degree> struct Monomials {
  Row<Degree> f, x, y;
  explicit Monomials(Complex z) {
    const Powers px(z.real()), py(z.imag());
    for_each_monomial<Degree>([&](int k, int i, int j) {
      f[k] = px(i) * py(j);
      x[k] = px.first(i) * py(j);
      y[k] = px(i) * py.first(j);
    });
  }
};

using Parts = Eigen::Matrix<double, 1, 6>;

/// q1, q2, e1, e2, s1 and s2 of a value of Q, A1 and A3.
Parts parts_of(Complex Q, Complex A1, Complex A3) {
  const Complex e = A1 + std::conj(A3), s = A1 - std::conj(A3);
  Parts parts;
  parts << Q.real(), Q.imag(), e.real(), e.imag(), s.imag(), s.real();
  return parts;
}

/// a b + sign · c d.
Plane_jet sum_of_products(const Plane_jet& a, const Plane_jet& b, double sign, const Plane_jet& c, const Plane_jet& d) {
  const double f = sign * c.f, x = sign * c.x, y = sign * c.y;
  return {a.f * b.f + f * d.f,
          a.x * b.f + a.f * b.x + x * d.f + f * d.x,
          a.y * b.f + a.f * b.y + y * d.f + f * d.y,
          a.xx * b.f + 2 * a.x * b.x + a.f * b.xx + sign * c.xx * d.f + 2 * x * d.x + f * d.xx,
          a.xy * b.f + a.x * b.y + a.y * b.x + a.f * b.xy + sign * c.xy * d.f + x * d.y + y * d.x + f * d.xy,
          a.yy * b.f + 2 * a.y * b.y + a.f * b.yy + sign * c.yy * d.f + 2 * y * d.y + f * d.yy};
}

/// adds the range of a b.
void add_product(Plane_range& sum, const Plane_jet& a, const Plane_range& of_a, const Plane_jet& b,
                 const Plane_range& of_b, double r) {
  const double a0 = std::abs(a.f), b0 = std::abs(b.f), a1 = std::sqrt(a.x * a.x + a.y * a.y),
               b1 = std::sqrt(b.x * b.x + b.y * b.y);
  const double da = a1 * r + of_a.remainder, db = b1 * r + of_b.remainder; // how far a and b change
  sum.remainder += a0 * of_b.remainder + b0 * of_a.remainder + da * db;
  sum.turn += a0 * of_b.turn + b0 * of_a.turn + da * (b1 + of_b.turn) + db * (a1 + of_a.turn);
}

} // namespace

template <int Degree> void Cell_model::fit(const Flat_cell& flat, Complex w) {
  constexpr int size = monomials_of(Degree);
  const auto& points = flat.points.z;
  const Complex w_bar = std::conj(w), w2 = w_bar * w_bar, w3 = w2 * w_bar; // to the principal basis
  // Along the axes, over that part of the cell.
  const Complex along = weight_of_derivatives * length_ * axis_,
                across = weight_of_derivatives * width_ * Complex(0, 1) * axis_;
  const auto derivative = [](const Flat_value& v, Complex step) { return step.real() * v.x + step.imag() * v.y; };
  // Coordinates of size 1 keep the normal equations well enough conditioned.
  Eigen::Matrix<double, size, size> A = Eigen::Matrix<double, size, size>::Zero();
  Eigen::Matrix<double, size, 6> b = Eigen::Matrix<double, size, 6>::Zero();
  const auto each = [&](const auto& use) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Monomials<Degree> m(from_plane(points[i]));
      if (by_parts_) {
        const Flat_shape& s = flat.shapes[i];
        use(m.f, parts_of(w2 * s.Q.f, w_bar * s.A1.f, w3 * s.A3.f));
        const auto parts_along = [&](Complex step) {
          return parts_of(w2 * derivative(s.Q, step), w_bar * derivative(s.A1, step), w3 * derivative(s.A3, step));
        };
        use(weight_of_derivatives * m.x, parts_along(along));
        use(weight_of_derivatives * m.y, parts_along(across));
      } else {
        const Complex P = w * flat.P[i], Q = w2 * flat.Q[i];
        Parts values;
        values << Q.real(), Q.imag(), P.real(), P.imag(), 0, 0;
        use(m.f, values);
      }
    }
  };
  each([&](const Row<Degree>& row, const Parts& values) {
    A.noalias() += row * row.transpose();
    b.noalias() += row * values;
  });
  const Eigen::Matrix<double, size, 6> c = A.llt().solve(b);
  Parts residual = Parts::Zero();
  each([&](const Row<Degree>& row, const Parts& values) {
    residual = residual.cwiseMax((values - row.transpose() * c).cwiseAbs());
  });
  degree_ = Degree;
  c_.leftCols<size>() = c.transpose();
  residual_ = residual.transpose();
  // D³ of x^i y^j in a direction (cos, sin), where |z| ≤ 1: the sum of its terms is at most d (d − 1) (d − 2) for the
  // degree d, and 2/√27 of that for the mixed monomials of degree 3.
  for_each_monomial<Degree>([&](int k, int i, int j) {
    const int d = i + j;
    if (d >= 3)
      third_ += d * (d - 1) * (d - 2) * (d == 3 && i != 0 && j != 0 ? 0.385 : 1) * c_.col(k).abs();
  });
}

void Cell_model::choose_coordinates(const Planar_points& points) {
  constexpr double narrowest = 1e-3;
  const Planar_points::Moments m = points.moments();
  const double mean = (m.xx + m.yy) / 2, difference = std::hypot((m.xx - m.yy) / 2, m.xy);
  axis_ = std::polar(1.0, std::atan2(2 * m.xy, m.xx - m.yy) / 2);
  length_ = std::sqrt(mean + difference);
  width_ = std::max(std::sqrt(std::max(0.0, mean - difference)), narrowest * length_);
  double radius2 = 0;
  for (const Complex z : points.z)
    radius2 = std::max(radius2, std::norm(from_plane(z)));
  length_ *= std::sqrt(radius2);
  width_ *= std::sqrt(radius2);
}

std::size_t Cell_model::samples_apart(const std::vector<Complex>& points) const {
  std::vector<Complex> chosen;
  for (const Complex point : points) {
    const Complex z = from_plane(point);
    if (std::none_of(chosen.begin(), chosen.end(), [&](Complex other) { return std::norm(z - other) < apart * apart; }))
      chosen.push_back(z);
  }
  return chosen.size();
}

Cell_model::Cell_model(const Flat_cell& flat, Complex Q) : by_parts_(flat.has_derivatives) {
  choose_coordinates(flat.points);
  const Complex w = std::polar(1.0, std::arg(Q) / 2);
  // A few equations more than unknowns tell how good the model is.
  const std::size_t equations = 3 * samples_apart(flat.points.z);
  if (!by_parts_)
    fit<2>(flat, w);
  else if (equations < 24)
    fit<3>(flat, w);
  else if (equations < 33)
    fit<4>(flat, w);
  else
    fit<5>(flat, w);
}

template <int Degree> Cell_model::Values Cell_model::values_of_degree(Complex z) const {
  const Powers px(z.real()), py(z.imag());
  Values v = Values::Zero();
  for_each_monomial<Degree>([&](int k, int i, int j) { v += px(i) * py(j) * c_.col(k); });
  return v;
}

template <int Degree> Cell_model::Jets Cell_model::jets_of_degree(Complex z) const {
  const Powers px(z.real()), py(z.imag());
  Values f = Values::Zero(), x = f, y = f, xx = f, xy = f, yy = f;
  for_each_monomial<Degree>([&](int k, int i, int j) {
    const Values c = c_.col(k);
    f += px(i) * py(j) * c;
    if (i > 0)
      x += px.first(i) * py(j) * c;
    if (j > 0)
      y += px(i) * py.first(j) * c;
    if (i > 1)
      xx += px.second(i) * py(j) * c;
    if (i > 0 && j > 0)
      xy += px.first(i) * py.first(j) * c;
    if (j > 1)
      yy += px(i) * py.second(j) * c;
  });
  Jets jets;
  for (int part = 0; part < parts; ++part)
    jets[std::size_t(part)] = {f[part], x[part], y[part], xx[part], xy[part], yy[part]};
  return jets;
}

Cell_model::Values Cell_model::values(Complex z) const {
  switch (degree_) {
  case 2:
    return values_of_degree<2>(z);
  case 3:
    return values_of_degree<3>(z);
  case 4:
    return values_of_degree<4>(z);
  default:
    return values_of_degree<5>(z);
  }
}

Cell_model::Jets Cell_model::jets(Complex z) const {
  switch (degree_) {
  case 2:
    return jets_of_degree<2>(z);
  case 3:
    return jets_of_degree<3>(z);
  case 4:
    return jets_of_degree<4>(z);
  default:
    return jets_of_degree<5>(z);
  }
}

Plane_range Cell_model::range(Part part, const Plane_jet& here, double r) const {
  const double second = std::max(std::abs(here.xx), std::abs(here.yy)) + std::abs(here.xy);
  return {r * r * (second / 2 + r * third_[part] / 6), r * (second + r * third_[part] / 2)};
}

Cell_model::Fields Cell_model::operator()(Complex z) const {
  const Values v = values(z);
  const Complex Q(v[q1], v[q2]);
  if (!by_parts_)
    return {{v[e1], v[e2]}, Q};
  return {{v[q1] * v[e1] + v[q2] * v[s1], v[q1] * v[e2] - v[q2] * v[s2]}, Q};
}

Field_jets Cell_model::jets_of(Field field, const Jets& j) const {
  if (field == Field::Q)
    return {j[q1], j[q2]};
  if (!by_parts_)
    return {j[e1], j[e2]};
  return {sum_of_products(j[q1], j[e1], 1, j[q2], j[s1]), sum_of_products(j[q1], j[e2], -1, j[q2], j[s2])};
}

Field_jets Cell_model::jets(Field field, Complex z) const {
  return jets_of(field, jets(z));
}

template <class Part_value> Field_errors Cell_model::errors_of(Field field, const Part_value& value) const {
  if (field == Field::Q)
    return {safety * residual_[q1], safety * residual_[q2]};
  if (!by_parts_)
    return {safety * residual_[e1], safety * residual_[e2]};
  const auto of_product = [&](Part a, Part b) {
    constexpr double times = safety_of_products;
    return times * (std::abs(value(a)) * residual_[b] + (std::abs(value(b)) + times * residual_[b]) * residual_[a]);
  };
  return {of_product(q1, e1) + of_product(q2, s1), of_product(q1, e2) + of_product(q2, s2)};
}

Field_errors Cell_model::errors(Field field, Complex z) const {
  const Values v = values(z);
  return errors_of(field, [&](Part part) { return v[part]; });
}

Field_view Cell_model::view_of(Field field, const Jets& j, double r) const {
  Field_view view{jets_of(field, j), {}, {}, errors_of(field, [&](Part part) { return j[part].f; })};
  const auto of = [&](Part part) { return range(part, j[part], r); };
  if (field == Field::Q) {
    view.re = of(q1);
    view.im = of(q2);
  } else if (!by_parts_) {
    view.re = of(e1);
    view.im = of(e2);
  } else {
    const Plane_range of_q1 = of(q1), of_q2 = of(q2);
    add_product(view.re, j[q1], of_q1, j[e1], of(e1), r);
    add_product(view.re, j[q2], of_q2, j[s1], of(s1), r);
    add_product(view.im, j[q1], of_q1, j[e2], of(e2), r);
    add_product(view.im, j[q2], of_q2, j[s2], of(s2), r);
  }
  return view;
}

double Cell_model::phase_error(Complex z) const {
  const Values v = values(z);
  const auto value = [&](Part part) { return v[part]; };
  const auto [p, q] = (*this)(z);
  const double size = std::sqrt(std::norm(p));
  // Along the direction that P would have on the nearest level an error only stretches the way to the level.
  const double phase = std::arg(p * p * q);
  const double off = (phase - std::numbers::pi * std::round(phase / std::numbers::pi)) / 2;
  const Complex level = p / size * std::polar(1.0, -off);
  const Field_errors of_p = errors_of(Field::P, value), of_q = errors_of(Field::Q, value);
  const double across = std::abs(level.real()) * of_p.im + std::abs(level.imag()) * of_p.re;
  return 2 * across / size +
         (std::abs(q.imag()) * of_q.re + std::abs(q.real()) * of_q.im + of_q.re * of_q.im) / std::norm(q);
}

Cell_model::Slopes Cell_model::slopes(Complex z) const {
  // φ = Im(2 log P + log Q)
  Slopes s{};
  const auto add = [&](const Field_jets& F, double factor) {
    const double inverse = 1 / (F.re.f * F.re.f + F.im.f * F.im.f), re = inverse * F.re.f, im = -inverse * F.im.f;
    const double x_re = F.re.x * re - F.im.x * im, x_im = F.re.x * im + F.im.x * re;
    const double y_re = F.re.y * re - F.im.y * im, y_im = F.re.y * im + F.im.y * re;
    s.log_x += 2 * x_re;
    s.log_y += 2 * y_re;
    s.x += factor * x_im;
    s.y += factor * y_im;
    s.xx += factor * (F.re.xx * im + F.im.xx * re - 2 * x_re * x_im);
    s.xy += factor * (F.re.xy * im + F.im.xy * re - x_re * y_im - x_im * y_re);
    s.yy += factor * (F.re.yy * im + F.im.yy * re - 2 * y_re * y_im);
  };
  const Jets j = jets(z);
  add(jets_of(Field::P, j), 2);
  add(jets_of(Field::Q, j), 1);
  return s;
}

} // namespace CGAL::Extremal_mesh_3
