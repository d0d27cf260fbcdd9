// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_TEST_MESHES_H
#define CGAL_EXTREMAL_MESH_3_TEST_MESHES_H

#include "surfaces.h"

#include <CGAL/Extremal_mesh_3/Cell_complex.h>
#include <CGAL/Extremal_mesh_3/Differential_quantities.h>
#include <CGAL/Extremal_mesh_3/Vertex_shapes.h>

#include <map>
#include <numeric>

/// Meshes of surfaces for tests.
namespace meshes {

using namespace CGAL::Extremal_mesh_3;

/// Polygons as indices of points.
struct Polygons {
  std::vector<Point> points;
  std::vector<std::vector<std::uint32_t>> polygons;

  Cell_complex cells() const {
    std::vector<std::size_t> begin{0};
    std::vector<std::uint32_t> corners;
    for (const auto& p : polygons) {
      corners.insert(corners.end(), p.begin(), p.end());
      begin.push_back(corners.size());
    }
    return make_cell_complex(points, begin, corners);
  }
};

/// the icosahedron with each triangle divided in four `levels` times, its vertices on the unit sphere: 10·4^levels + 2.
inline Polygons icosphere(int levels) {
  const double g = (1 + std::sqrt(5.0)) / 2;
  Polygons m;
  m.points = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
              {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  m.polygons = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middle;
    const auto between = [&](std::uint32_t a, std::uint32_t b) {
      const auto [it, added] = middle.try_emplace(std::minmax(a, b), std::uint32_t(m.points.size()));
      if (added)
        m.points.push_back(surfaces::along(m.points[a], 1, m.points[b]));
      return it->second;
    };
    std::vector<std::vector<std::uint32_t>> finer;
    for (const auto& t : m.polygons) {
      const std::uint32_t ab = between(t[0], t[1]), bc = between(t[1], t[2]), ca = between(t[2], t[0]);
      finer.insert(finer.end(), {{t[0], ab, ca}, {t[1], bc, ab}, {t[2], ca, bc}, {ab, bc, ca}});
    }
    m.polygons = finer;
  }
  for (Point& p : m.points)
    p = surfaces::unit(p);
  return m;
}

/// moves all points onto x²/a² + y²/b² + z²/c² = 1, away from the origin.
inline Polygons on_ellipsoid(Polygons m, double a, double b, double c) {
  for (Point& p : m.points) {
    const double s = 1 / std::sqrt(p[0] * p[0] / (a * a) + p[1] * p[1] / (b * b) + p[2] * p[2] / (c * c));
    p = surfaces::along({0, 0, 0}, s, p);
  }
  return m;
}

/// the mean length of the edges.
inline double mean_edge_length(const Polygons& m) {
  const Cell_complex cells = m.cells();
  double sum = 0;
  for (const auto& [a, b] : cells.edges)
    sum += surfaces::distance(m.points[a], m.points[b]);
  return sum / double(cells.edges.size());
}

/// moves each point by a normally distributed length along the direction from the origin.
inline Polygons with_radial_noise(Polygons m, double sigma, unsigned seed) {
  std::mt19937 random(seed);
  const auto uniform = [&] { return (double(random()) + 0.5) / 4294967296.0; };
  for (Point& p : m.points) {
    const double normal = std::sqrt(-2 * std::log(uniform())) * std::cos(6.283185307179586 * uniform());
    p = surfaces::along(p, sigma * normal, surfaces::unit(p));
  }
  return m;
}

inline Polygons moved(Polygons m, const surfaces::Motion& motion) {
  for (Point& p : m.points)
    p = motion(p);
  return m;
}

/// the same mesh with its points and polygons in another order, and polygons that begin elsewhere.
inline Polygons shuffled(const Polygons& m, unsigned seed) {
  std::mt19937 random(seed);
  const auto permutation = [&](std::size_t n) {
    std::vector<std::uint32_t> order(n);
    std::iota(order.begin(), order.end(), 0U);
    for (std::size_t i = n; i > 1; --i)
      std::swap(order[i - 1], order[random() % i]);
    return order;
  };
  const auto to = permutation(m.points.size()), from = permutation(m.polygons.size());
  Polygons s;
  s.points.resize(m.points.size());
  for (std::size_t i = 0; i < to.size(); ++i)
    s.points[to[i]] = m.points[i];
  for (const std::uint32_t f : from) {
    std::vector<std::uint32_t> p = m.polygons[f];
    std::rotate(p.begin(), p.begin() + std::ptrdiff_t(random() % p.size()), p.end());
    for (std::uint32_t& v : p)
      v = to[v];
    s.polygons.push_back(p);
  }
  return s;
}

/// the exact shapes of f = 0 at points that lie on it.
inline Vertex_shapes exact_shapes(const Function_3& f, const std::vector<Point>& points) {
  Vertex_shapes result;
  for (const Point& p : points) {
    Derivatives d;
    f.derivatives(p, 4, d);
    result.shapes.push_back(local_shape(d));
    result.fourth.push_back(fourth_order_form(d, result.shapes.back()));
  }
  return result;
}

} // namespace meshes

#endif // CGAL_EXTREMAL_MESH_3_TEST_MESHES_H
