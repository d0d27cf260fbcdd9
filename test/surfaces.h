// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_TEST_SURFACES_H
#define CGAL_EXTREMAL_MESH_3_TEST_SURFACES_H

#include <CGAL/Extremal_mesh_3/Function_3.h>
#include <CGAL/Extremal_mesh_3/check.h>
#include <CGAL/Extremal_mesh_3/extract_extremal_mesh.h>

#include "motion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <sstream>
#include <string>
#include <utility>

/// Surfaces for tests, and motions that put them anywhere.
namespace surfaces {

using namespace CGAL::Extremal_mesh_3;

/// ±f moved: its zero set is the moved zero set of f, its derivatives are exact.
class Moved_function : public Function_3 {
public:
  Moved_function(const Function_3& f, const Motion& motion, double sign = 1) : f_(f), motion_(motion), sign_(sign) {}

  double value(const Point& y) const override { return sign_ * f_.value(motion_.back(y)); }
  int max_order() const override { return f_.max_order(); }
  void derivatives(const Point& y, int order, Derivatives& d) const override {
    f_.derivatives(motion_.back(y), order, d);
    d.value *= sign_;
    transform(1, d.gradient.data());
    if (order >= 2)
      transform(2, d.hessian.data());
    if (order >= 3)
      transform(3, d.third.data());
    if (order >= 4)
      transform(4, d.fourth.data());
  }

private:
  /// turns a symmetric tensor along all its indices: c[p, q, …] = Σ R[p][i] R[q][j] … c[i, j, …].
  void transform(int order, double* c) const {
    std::size_t size = 1;
    for (int i = 0; i < order; ++i)
      size *= 3;
    std::array<double, 81> full{}, next{};
    for (std::size_t i = 0; i < size; ++i)
      full[i] = c[position(order, i)];
    for (std::size_t stride = 1; stride < size; stride *= 3) {
      for (std::size_t i = 0; i < size; ++i) {
        const std::size_t digit = i / stride % 3, first = i - digit * stride;
        next[i] = dot(motion_.R[digit], {full[first], full[first + stride], full[first + 2 * stride]});
      }
      full = next;
    }
    const double factor = sign_ / std::pow(motion_.scale, order);
    for (std::size_t i = 0; i < size; ++i)
      c[position(order, i)] = factor * full[i];
  }

  /// where the entry whose indices are the digits of i in base 3 stands in `Derivatives`.
  static std::size_t position(int order, std::size_t i) {
    std::size_t y = 0, z = 0;
    for (int k = 0; k < order; ++k, i /= 3) {
      y += i % 3 == 1;
      z += i % 3 == 2;
    }
    return (y + z) * (y + z + 1) / 2 + z;
  }

  const Function_3& f_;
  Motion motion_;
  double sign_;
};

struct Box {
  Point low{}, high{};
  double size() const { return std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]}); }
  Box widened(double part) const {
    Box b = *this;
    for (std::size_t a = 0; a < 3; ++a) {
      b.low[a] -= part * size();
      b.high[a] += part * size();
    }
    return b;
  }
};

inline Box box_of(const std::vector<Point>& points) {
  Box b{points.at(0), points.at(0)};
  for (const Point& p : points)
    for (std::size_t a = 0; a < 3; ++a) {
      b.low[a] = std::min(b.low[a], p[a]);
      b.high[a] = std::max(b.high[a], p[a]);
    }
  return b;
}

/// the axis-parallel box of a moved box.
inline Box moved(const Box& box, const Motion& motion) {
  std::vector<Point> corners;
  for (int c = 0; c < 8; ++c)
    corners.push_back(
        motion({c & 1 ? box.high[0] : box.low[0], c & 2 ? box.high[1] : box.low[1], c & 4 ? box.high[2] : box.low[2]}));
  return box_of(corners);
}

/// a lattice whose box is a little larger than the surface in the given box.
inline Lattice lattice_around(const Function_3& f, const Box& rough, std::size_t resolution) {
  // Points of coarse cells lie on the surface; between them it bulges out by less than 3 % of its size.
  const Box box = box_of(make_implicit_cells(f, make_lattice(rough.low, rough.high, 20)).points).widened(0.03);
  return make_lattice(box.low, box.high, resolution);
}

/// the vertices of one kind.
inline std::vector<std::size_t> vertices_of(const Extremal_mesh& mesh, Vertex_kind kind) {
  std::vector<std::size_t> found;
  for (std::size_t v = 0; v < mesh.number_of_vertices(); ++v)
    if (mesh.vertex(v).kind == kind)
      found.push_back(v);
  return found;
}

inline void expect_all_checks_hold(const Extremal_mesh& mesh) {
  for (const Check& c : check(mesh))
    EXPECT_TRUE(!c.applies || c.holds) << c.name << ": " << c.claim << ". " << c.detail;
}

/// How many there are of what.
struct Counts {
  std::size_t extremal_points = 0, umbilics = 0, three_ridge = 0, edges = 0, cells = 0, others = 0;
  double umbilic_index = 0;

  friend bool operator==(const Counts&, const Counts&) = default;
  friend std::ostream& operator<<(std::ostream& out, const Counts& c) {
    return out << c.extremal_points << " extremal points, " << c.umbilics << " umbilics (" << c.three_ridge
               << " with 3 ridges, index " << c.umbilic_index << "), " << c.others << " other vertices, " << c.edges
               << " edges, " << c.cells << " cells";
  }
};

inline Counts counts_of(const Extremal_mesh& mesh) {
  Counts c;
  for (std::size_t v = 0; v < mesh.number_of_vertices(); ++v) {
    const Extremal_mesh_vertex& x = mesh.vertex(v);
    c.extremal_points += x.kind == Vertex_kind::extremal_point;
    c.umbilics += x.kind == Vertex_kind::umbilic;
    c.others += x.kind != Vertex_kind::extremal_point && x.kind != Vertex_kind::umbilic;
    c.three_ridge += x.ridges == 3;
    c.umbilic_index += x.umbilic_index;
  }
  c.edges = mesh.number_of_edges();
  c.cells = mesh.number_of_cells();
  return c;
}

} // namespace surfaces

#endif // CGAL_EXTREMAL_MESH_3_TEST_SURFACES_H
