// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What it costs to draw the lines on a mesh whose curvatures are known at the vertices: ours, all of the extremal mesh with
// its cells, against CGAL's Ridges_3, which traces the maxima and the minima. Both get the exact values on an ellipsoid. One
// thread; the best of three.

#include <CGAL/Extremal_mesh_3/Functor_function.h>
#include <CGAL/Extremal_mesh_3/extract_extremal_mesh.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Ridges.h>
#include <CGAL/Surface_mesh.h>

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numeric>

using namespace CGAL::Extremal_mesh_3;

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface_mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Numbers = Surface_mesh::Property_map<Surface_mesh::Vertex_index, double>;
using Vectors = Surface_mesh::Property_map<Surface_mesh::Vertex_index, Kernel::Vector_3>;

double best_of_three(const std::function<void()>& work) {
  double best = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    const auto start = std::chrono::steady_clock::now();
    work();
    best = std::min(best, std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count());
  }
  return best;
}

/// An octahedron, its triangles divided `levels` times, on x² + 2y² + 4z² = 1; turned, so that no vertex lies on a line.
struct Triangles {
  std::vector<Point> points{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  std::vector<std::array<std::uint32_t, 3>> triangles{{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                                                      {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};

  explicit Triangles(int levels) {
    for (int level = 0; level < levels; ++level) {
      std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middle;
      const auto between = [&](std::uint32_t a, std::uint32_t b) {
        const auto [it, added] = middle.try_emplace(std::minmax(a, b), std::uint32_t(points.size()));
        if (added) {
          const Point &p = points[a], &q = points[b];
          points.push_back({(p[0] + q[0]) / 2, (p[1] + q[1]) / 2, (p[2] + q[2]) / 2});
        }
        return it->second;
      };
      decltype(triangles) finer;
      for (const auto& [a, b, c] : triangles) {
        const std::uint32_t ab = between(a, b), bc = between(b, c), ca = between(c, a);
        finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
      }
      triangles = std::move(finer);
    }
    for (Point& p : points) {
      const Point q{0.48 * p[0] - 0.6 * p[1] + 0.64 * p[2], 0.64 * p[0] + 0.8 * p[1] - 0.48 * p[2] * 0,
                    -0.6 * p[0] + 0.0 * p[1] + 0.8 * p[2]};
      const double s = 1 / std::sqrt(q[0] * q[0] + 2 * q[1] * q[1] + 4 * q[2] * q[2]);
      p = {s * q[0], s * q[1], s * q[2]};
    }
  }
};

} // namespace

int main() {
  const Triangles mesh(8);
  const auto f = make_function([](auto x, auto y, auto z) { return x * x + 2 * (y * y) + 4 * (z * z) - 1; });
  Vertex_shapes shapes;
  for (const Point& p : mesh.points) {
    Derivatives d;
    f.derivatives(p, 4, d);
    shapes.shapes.push_back(local_shape(d));
    shapes.fourth.push_back(fourth_order_form(d, shapes.shapes.back()));
  }
  const double faces = double(mesh.triangles.size());
  fmt::print("{} triangles\n", mesh.triangles.size());

  std::vector<std::size_t> begin{0};
  std::vector<std::uint32_t> corners;
  for (const auto& t : mesh.triangles) {
    corners.insert(corners.end(), t.begin(), t.end());
    begin.push_back(corners.size());
  }
  const Cell_complex cells = make_cell_complex(mesh.points, begin, corners);
  Extraction_options options;
  options.threads = 1;
  Extraction extraction;
  const double ours = best_of_three([&] { extraction = extract_extremal_mesh(cells, shapes, options); });
  fmt::print("extremal mesh  {:.3f} µs per face: {} vertices, {} lines, {} cells\n", ours / faces,
             extraction.mesh.number_of_vertices(), extraction.mesh.number_of_edges(),
             extraction.mesh.number_of_cells());

  Surface_mesh surface;
  for (const Point& p : mesh.points)
    surface.add_vertex({p[0], p[1], p[2]});
  for (const auto& [a, b, c] : mesh.triangles)
    surface.add_face(Surface_mesh::Vertex_index(a), Surface_mesh::Vertex_index(b), Surface_mesh::Vertex_index(c));
  const auto numbers = [&](const char* name) {
    return surface.add_property_map<Surface_mesh::Vertex_index, double>(name).first;
  };
  const auto vectors = [&](const char* name) {
    return surface.add_property_map<Surface_mesh::Vertex_index, Kernel::Vector_3>(name).first;
  };
  const Numbers k1 = numbers("v:k1"), k2 = numbers("v:k2"), b0 = numbers("v:b0"), b3 = numbers("v:b3"),
                P1 = numbers("v:P1"), P2 = numbers("v:P2");
  const Vectors d1 = vectors("v:d1"), d2 = vectors("v:d2");
  for (const auto v : surface.vertices()) {
    const Local_shape& s = shapes.shapes[v];
    const Principal_quantities q = principal_quantities(s);
    k1[v] = q.k1;
    k2[v] = q.k2;
    b0[v] = q.e1;
    b3[v] = q.e2;
    P1[v] = (q.k1 - q.k2) * extremality_derivative(s, shapes.fourth[v], 1);
    P2[v] = (q.k2 - q.k1) * extremality_derivative(s, shapes.fourth[v], 2);
    d1[v] = {q.t1[0], q.t1[1], q.t1[2]};
    d2[v] = {q.t2[0], q.t2[1], q.t2[2]};
  }
  using Ridges = CGAL::Ridge_approximation<Surface_mesh, Numbers, Vectors>;
  std::size_t lines = 0;
  const double theirs = best_of_three([&] {
    Ridges ridges(surface, k1, k2, b0, b3, d1, d2, P1, P2);
    std::vector<CGAL::Ridge_line<Surface_mesh>*> found;
    ridges.compute_max_ridges(std::back_inserter(found), CGAL::Ridge_order_3);
    ridges.compute_min_ridges(std::back_inserter(found), CGAL::Ridge_order_3);
    lines = found.size();
    for (auto* line : found)
      delete line;
  });
  fmt::print("CGAL Ridges_3  {:.3f} µs per face: {} pieces of lines\n", theirs / faces, lines);
  fmt::print("ratio          {:.2f}\n", ours / theirs);
}
