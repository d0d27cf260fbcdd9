// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Extraction from what no reader would let through: small polygon complexes and functions whose derivatives are anything.
#include "targets.h"

#include <CGAL/Extremal_mesh_3/check.h>
#include <CGAL/Extremal_mesh_3/extract_extremal_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace fuzz {

namespace {

using namespace CGAL::Extremal_mesh_3;

/// Numbers made of bytes, one each: mostly small ones, and each kind that is dangerous. 0s after the last byte.
class Numbers {
public:
  explicit Numbers(Bytes bytes) : bytes_(bytes) {}

  std::uint8_t byte() {
    if (at_ == bytes_.size())
      return 0;
    return bytes_[at_++];
  }
  std::size_t below(std::size_t n) { return byte() % n; }
  double number() {
    using Limits = std::numeric_limits<double>;
    static constexpr std::array special{Limits::quiet_NaN(),
                                        Limits::infinity(),
                                        -Limits::infinity(),
                                        -0.0,
                                        Limits::max(),
                                        -Limits::max(),
                                        Limits::min(),
                                        Limits::denorm_min(),
                                        1e154,
                                        -1e154,
                                        1e-154,
                                        1e100,
                                        1e-100,
                                        1e18,
                                        1e-18,
                                        1e-8};
    const std::uint8_t b = byte();
    return b < 240 ? (b - 120) / 32.0 : special[b - 240U];
  }
  bool at_end() const { return at_ == bytes_.size(); }

private:
  Bytes bytes_;
  std::size_t at_ = 0;
};

struct Base {
  std::vector<Point> points;
  std::vector<std::vector<std::uint32_t>> polygons;
};

Base octahedron() {
  return {{{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
          {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {1, 0, 5}, {2, 1, 5}, {3, 2, 5}, {0, 3, 5}}};
}

Base cube() {
  return {{{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}},
          {{3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};
}

/// an n-gon alone.
Base polygon(std::size_t n) {
  Base base;
  for (std::size_t i = 0; i < n; ++i) {
    const double t = 6.283185307179586 * double(i) / double(n);
    base.points.push_back({std::cos(t), std::sin(t), 0.1 * std::cos(2 * t)});
  }
  base.polygons.emplace_back();
  for (std::size_t i = 0; i < n; ++i)
    base.polygons[0].push_back(std::uint32_t(i));
  return base;
}

/// a sheet of n × n quadrilaterals, closed to an annulus or a torus if asked for.
Base sheet(std::uint32_t n, bool around, bool along) {
  Base base;
  const std::uint32_t columns = around ? n : n + 1, rows = along ? n : n + 1;
  for (std::uint32_t j = 0; j < rows; ++j)
    for (std::uint32_t i = 0; i < columns; ++i) {
      const double s = 6.283185307179586 * i / n, t = 6.283185307179586 * j / n;
      if (around)
        base.points.push_back({(3 + std::cos(s)) * std::cos(t / (along ? 1 : 2)),
                               (3 + std::cos(s)) * std::sin(t / (along ? 1 : 2)), std::sin(s)});
      else
        base.points.push_back({double(i), double(j), 0.2 * i * j - 0.1 * i * i});
    }
  const auto at = [&](std::uint32_t i, std::uint32_t j) { return i % columns + columns * (j % rows); };
  for (std::uint32_t j = 0; j < n; ++j)
    for (std::uint32_t i = 0; i < n; ++i)
      base.polygons.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
  return base;
}

Base make_base(Numbers& numbers) {
  switch (numbers.below(8)) {
  case 0:
    return octahedron();
  case 1:
    return cube();
  case 2:
    return polygon(3 + numbers.below(10));
  case 3:
    return sheet(std::uint32_t(1 + numbers.below(4)), false, false);
  case 4:
    return sheet(std::uint32_t(3 + numbers.below(3)), true, false);
  case 5:
    return sheet(std::uint32_t(3 + numbers.below(3)), true, true);
  case 6: { // a corner that is cut off, or a tetrahedron whose faces are doubled
    Base base = cube();
    base.polygons.pop_back();
    return base;
  }
  default: { // two parts
    Base base = octahedron();
    const Base other = polygon(5);
    for (auto corners : other.polygons) {
      for (std::uint32_t& corner : corners)
        corner += std::uint32_t(base.points.size());
      base.polygons.push_back(corners);
    }
    for (Point p : other.points) {
      p[2] += 3;
      base.points.push_back(p);
    }
    return base;
  }
  }
}

Extraction_options make_options(Numbers& numbers) {
  Extraction_options options;
  const std::uint8_t b = numbers.byte();
  options.threads = 1;
  options.max_level = b % 4;
  options.max_line_level = b / 4 % 4;
  options.patches = b / 16 % 2 == 1;
  return options;
}

/// \throws std::logic_error if something fails
void require_checked(const Extraction& extraction) {
  for (const Check& claim : check(extraction.mesh))
    if (claim.applies && !claim.holds)
      throw std::logic_error("a result whose check '" + claim.name + "' fails: " + claim.detail);
}

/// calls `extract`, which may refuse what it is given.
template <typename Extract> void extract_any(bool checked, const Extract& extract) {
  try {
    const Extraction extraction = extract();
    if (checked)
      require_checked(extraction);
  } catch (const std::invalid_argument&) {
  } catch (const Extraction_error&) {
  }
}

/// A polynomial of degree 4 about the origin whose derivatives are true in one part of space, and what the bytes say in the rest.
class Any_function : public Function_3 {
public:
  explicit Any_function(Numbers& numbers) : max_order_(3 + int(numbers.below(2))), lie_(numbers.byte()) {
    for (double& c : squares_)
      c = 1 + numbers.number() / 8;
    for (double& c : cubic_)
      c = numbers.number() / 8;
    for (double& c : quartic_)
      c = numbers.number() / 16;
    for (double& c : lies_)
      c = numbers.number();
  }

  double value(const Point& p) const override {
    double sum = -1;
    for (std::size_t a = 0; a < 3; ++a) {
      const double x = p[a];
      sum += x * x * (squares_[a] + x * (cubic_[a] + x * quartic_[a]));
    }
    return sum + cubic_[3] * p[0] * p[1] * p[2];
  }
  void derivatives(const Point& p, int, Derivatives& d) const override {
    d = {};
    d.value = value(p);
    static constexpr std::array<std::size_t, 3> second{0, 3, 5}, third{0, 6, 9}, fourth{0, 10, 14};
    for (std::size_t a = 0; a < 3; ++a) {
      const double x = p[a], s = squares_[a], c = cubic_[a], q = quartic_[a];
      d.gradient[a] = x * (2 * s + x * (3 * c + x * 4 * q)) + cubic_[3] * p[(a + 1) % 3] * p[(a + 2) % 3];
      d.hessian[second[a]] = 2 * s + x * (6 * c + 12 * x * q);
      d.third[third[a]] = 6 * c + 24 * x * q;
      d.fourth[fourth[a]] = 24 * q;
    }
    d.hessian[1] = cubic_[3] * p[2];
    d.hessian[2] = cubic_[3] * p[1];
    d.hessian[4] = cubic_[3] * p[0];
    d.third[4] = cubic_[3];
    const unsigned octant = unsigned(p[0] > 0) + 2 * unsigned(p[1] > 0) + 4 * unsigned(p[2] > 0);
    if (((lie_ >> octant) & 1U) == 0)
      return;
    for (std::size_t i = 0; i < lies_.size(); ++i)
      (i < 3 ? d.gradient[i] : i < 9 ? d.hessian[i - 3] : i < 19 ? d.third[i - 9] : d.fourth[i - 19]) += lies_[i];
  }
  int max_order() const override { return max_order_; }
  bool is_true() const { return lie_ == 0; }

private:
  int max_order_;
  unsigned lie_;
  std::array<double, 3> squares_, quartic_;
  std::array<double, 4> cubic_;
  std::array<double, 34> lies_;
};

} // namespace

void extract_from_shapes(Bytes bytes) {
  Numbers numbers(bytes);
  const Extraction_options options = make_options(numbers);
  Base base = make_base(numbers);
  const std::uint8_t flags = numbers.byte();
  if (flags % 2 == 1)
    for (Point& p : base.points)
      for (double& x : p)
        x += numbers.number();
  const double scale = flags / 2 % 8 == 0 ? numbers.number() : 1;
  for (Point& p : base.points)
    for (double& x : p)
      x *= scale;
  std::vector<std::size_t> begin{0};
  std::vector<std::uint32_t> corners;
  for (const auto& polygon : base.polygons) {
    corners.insert(corners.end(), polygon.begin(), polygon.end());
    begin.push_back(corners.size());
  }
  // Frames that belong to the cells; or some that do not, of which nothing can be demanded but an end.
  const bool are_frames_true = flags / 16 % 2 == 0;
  std::vector<Vector> normals(base.points.size());
  for (const auto& polygon : base.polygons)
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Point &a = base.points[polygon[i]], &b = base.points[polygon[(i + 1) % polygon.size()]];
      for (const std::uint32_t corner : polygon)
        for (std::size_t k = 0; k < 3; ++k)
          normals[corner][k] += a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
    }
  Vertex_shapes shapes;
  for (const Vector& n : normals) {
    Local_shape& s = shapes.shapes.emplace_back();
    const double length = std::hypot(n[0], n[1], n[2]), across = std::hypot(n[0], n[1]);
    if (are_frames_true && length > 0 && across > 0 && std::isfinite(length)) {
      s.n = {n[0] / length, n[1] / length, n[2] / length};
      s.u = {-n[1] / across, n[0] / across, 0};
    } else if (are_frames_true && length > 0 && n[2] < 0) {
      s.n = {0, 0, -1};
    }
    if (numbers.at_end())
      continue;
    s.H = numbers.number();
    s.Q = {numbers.number(), numbers.number()};
    s.A1 = {numbers.number(), numbers.number()};
    s.A3 = {numbers.number(), numbers.number()};
    if (flags / 32 % 2 == 1)
      shapes.fourth.push_back(
          {numbers.number(), {numbers.number(), numbers.number()}, {numbers.number(), numbers.number()}});
  }
  extract_any(true,
              [&] { return extract_extremal_mesh(make_cell_complex(base.points, begin, corners), shapes, options); });
}

void extract_from_function(Bytes bytes) {
  Numbers numbers(bytes);
  const Extraction_options options = make_options(numbers);
  const std::size_t cubes = 2 + numbers.below(2);
  const Any_function f(numbers);
  // What derivatives tell that contradict each other has no identities.
  extract_any(f.is_true(), [&] {
    return extract_extremal_mesh(f, make_lattice({-1.7, -1.6, -1.8}, {1.75, 1.85, 1.65}, cubes), options);
  });
}

} // namespace fuzz
