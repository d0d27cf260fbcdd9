// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What it costs to fit jets at the vertices of a mesh, and how exact they are: ours, with all that is needed around
// the fit, against CGAL's Monge_via_jet_fitting on the same two rings of neighbours, which are found beforehand. One
// thread. Then what the radius does on meshes with and without noise, from which the default radius was made.

#include <CGAL/Extremal_mesh_3/Functor_function.h>
#include <CGAL/Extremal_mesh_3/fit_vertex_shapes.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Monge_via_jet_fitting.h>

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <random>

using namespace CGAL::Extremal_mesh_3;

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Complex = std::complex<double>;

double dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <class Work> double microseconds(const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count();
}

/// The icosahedron with each edge divided in n, on the unit sphere: 10 n² + 2 vertices.
struct Sphere {
  std::vector<Point> points;
  std::vector<std::uint32_t> corners; ///< three a triangle

  explicit Sphere(int n) {
    const double g = (1 + std::sqrt(5.0)) / 2;
    const std::vector<std::array<double, 3>> base{{-1, g, 0}, {1, g, 0}, {-1, -g, 0}, {1, -g, 0},
                                                  {0, -1, g}, {0, 1, g}, {0, -1, -g}, {0, 1, -g},
                                                  {g, 0, -1}, {g, 0, 1}, {-g, 0, -1}, {-g, 0, 1}};
    const std::vector<std::array<int, 3>> faces{{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                                {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                                {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                                {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
    // A point is what parts it has of which corners.
    std::map<std::vector<std::pair<int, int>>, std::uint32_t> number;
    for (const auto& f : faces) {
      const auto vertex = [&](int i, int j) {
        std::vector<std::pair<int, int>> parts;
        for (const auto& [corner, part] : {std::pair{f[0], n - i - j}, std::pair{f[1], i}, std::pair{f[2], j}})
          if (part > 0)
            parts.emplace_back(corner, part);
        std::sort(parts.begin(), parts.end());
        const auto [it, added] = number.try_emplace(parts, std::uint32_t(points.size()));
        if (added) {
          Point p{};
          for (const auto& [corner, part] : parts)
            for (std::size_t a = 0; a < 3; ++a)
              p[a] += part * base[std::size_t(corner)][a];
          const double length = std::sqrt(dot(p, p));
          points.push_back({p[0] / length, p[1] / length, p[2] / length});
        }
        return it->second;
      };
      for (int i = 0; i < n; ++i)
        for (int j = 0; i + j < n; ++j) {
          corners.insert(corners.end(), {vertex(i, j), vertex(i + 1, j), vertex(i, j + 1)});
          if (i + j + 1 < n)
            corners.insert(corners.end(), {vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
        }
    }
  }

  Cell_complex cells() const {
    std::vector<std::size_t> begin;
    for (std::size_t i = 0; i <= corners.size(); i += 3)
      begin.push_back(i);
    return make_cell_complex(points, begin, corners);
  }
};

/// moves the points along the rays from the origin onto f = 0.
void move_onto(const Function_3& f, std::vector<Point>& points) {
  for (Point& p : points)
    for (int i = 0; i < 50; ++i) {
      Derivatives d;
      f.derivatives(p, 1, d);
      const double step = -f.value(p) / dot(d.gradient, p);
      p = {p[0] + step * p[0], p[1] + step * p[1], p[2] + step * p[2]};
    }
}

/// moves each point at random along its ray.
void add_noise(std::vector<Point>& points, double sigma) {
  std::mt19937 random(1);
  const auto uniform = [&] { return (double(random()) + 0.5) / 4294967296.0; };
  for (Point& p : points) {
    const double normal = std::sqrt(-2 * std::log(uniform())) * std::cos(6.283185307179586 * uniform());
    const double s = 1 + sigma * normal / std::sqrt(dot(p, p));
    p = {s * p[0], s * p[1], s * p[2]};
  }
}

std::vector<Local_shape> exact_shapes(const Function_3& f, const std::vector<Point>& points) {
  std::vector<Local_shape> shapes;
  for (const Point& p : points) {
    Derivatives d;
    f.derivatives(p, 3, d);
    shapes.push_back(local_shape(d));
  }
  return shapes;
}

/// Root mean squares of errors, over those of the exact values.
struct Errors {
  double k = 0, e = 0;
};

Errors errors(const std::vector<Principal_quantities>& values, const std::vector<Local_shape>& exact) {
  Errors sum, size;
  for (std::size_t v = 0; v < values.size(); ++v) {
    const Principal_quantities &a = values[v], b = principal_quantities(exact[v]);
    sum.k += std::pow(a.k1 - b.k1, 2) + std::pow(a.k2 - b.k2, 2);
    size.k += b.k1 * b.k1 + b.k2 * b.k2;
    if (b.k1 - b.k2 < 0.1 * std::max(std::abs(b.k1), std::abs(b.k2)))
      continue; // close to an umbilic directions, and so e, mean little
    const double e1 = dot(a.t1, b.t1) < 0 ? -a.e1 : a.e1, e2 = dot(a.t2, b.t2) < 0 ? -a.e2 : a.e2;
    sum.e += std::pow(e1 - b.e1, 2) + std::pow(e2 - b.e2, 2);
    size.e += b.e1 * b.e1 + b.e2 * b.e2;
  }
  return {std::sqrt(sum.k / size.k), std::sqrt(sum.e / size.e)};
}

void print_row(const char* what, double time, const Errors& e) {
  fmt::print("{:42} {:8.2f} {:12.2e} {:12.2e}\n", what, time, e.k, e.e);
}

std::vector<Principal_quantities> principal(const Vertex_shapes& shapes) {
  std::vector<Principal_quantities> result;
  for (const Local_shape& s : shapes.shapes)
    result.push_back(principal_quantities(s));
  return result;
}

/// the vertices within two edges of each.
std::vector<std::vector<std::uint32_t>> two_rings(const Cell_complex& cells) {
  std::vector<std::vector<std::uint32_t>> one(cells.points.size()), two(cells.points.size());
  for (const auto& [a, b] : cells.edges) {
    one[a].push_back(b);
    one[b].push_back(a);
  }
  for (std::uint32_t v = 0; v < two.size(); ++v) {
    two[v] = {v};
    for (const std::uint32_t w : one[v])
      for (const std::uint32_t x : one[w])
        two[v].push_back(x);
    two[v].insert(two[v].end(), one[v].begin(), one[v].end());
    std::sort(two[v].begin() + 1, two[v].end());
    two[v].erase(std::unique(two[v].begin() + 1, two[v].end()), two[v].end());
    two[v].erase(std::remove(two[v].begin() + 1, two[v].end(), v), two[v].end());
  }
  return two;
}

Principal_quantities by_cgal(const std::vector<Kernel::Point_3>& points, const Vector& normal) {
  CGAL::Monge_via_jet_fitting<Kernel> fitting;
  auto monge = fitting(points.begin(), points.end(), 4, 4);
  monge.comply_wrt_given_normal({normal[0], normal[1], normal[2]});
  const auto vector = [](const Kernel::Vector_3& v) { return Vector{v.x(), v.y(), v.z()}; };
  return {monge.principal_curvatures(0),
          monge.principal_curvatures(1),
          vector(monge.maximal_principal_direction()),
          vector(monge.minimal_principal_direction()),
          monge.third_order_coefficients(0),
          monge.third_order_coefficients(3)};
}

void compare_with_cgal() {
  const auto f = make_function([](auto x, auto y, auto z) {
    using std::sin;
    return x * x + 2 * (y * y) + 4 * (z * z) - 1 + 0.1 * (sin(3 * x + 1) * sin(4 * y) + sin(5 * z) * sin(2 * x));
  });
  Sphere mesh(100);
  move_onto(f, mesh.points);
  const Cell_complex cells = mesh.cells();
  const std::vector<Local_shape> exact = exact_shapes(f, cells.points);
  const double n = double(cells.points.size());
  fmt::print("{} vertices on a perturbed ellipsoid\n{:42} {:>8} {:>12} {:>12}\n", cells.points.size(), "", "us/vertex",
             "error of k", "error of e");

  Fit fit;
  Fit_options options;
  options.threads = 1;
  options.rings = 2;
  double time = microseconds([&] { fit = fit_vertex_shapes(cells, options); });
  print_row("ours, two rings, all included", time / n, errors(principal(fit.shapes), exact));
  options.rings = 0;
  time = microseconds([&] { fit = fit_vertex_shapes(cells, options); });
  print_row("ours, default radius, all included", time / n, errors(principal(fit.shapes), exact));

  const auto rings = two_rings(cells);
  std::vector<Principal_quantities> theirs;
  std::vector<Kernel::Point_3> points;
  time = microseconds([&] {
    for (std::size_t v = 0; v < rings.size(); ++v) {
      points.clear();
      for (const std::uint32_t w : rings[v])
        points.emplace_back(cells.points[w][0], cells.points[w][1], cells.points[w][2]);
      theirs.push_back(by_cgal(points, exact[v].n));
    }
  });
  print_row("CGAL's Monge_via_jet_fitting, two rings", time / n, errors(theirs, exact));
}

/// in the basis of b, how A1 of a shape in the basis of a is turned.
Complex turn(const Local_shape& a, const Local_shape& b) {
  const Complex w(dot(a.u, b.u), dot(a.u, b.v()));
  return w / std::abs(w);
}

void print_radii(double noise) {
  const auto f = make_function([](auto x, auto y, auto z) { return x * x + 2 * (y * y) + 4 * (z * z) - 1; });
  Sphere mesh(32);
  move_onto(f, mesh.points);
  const std::vector<Local_shape> exact = exact_shapes(f, mesh.points);
  const double h = fit_vertex_shapes(mesh.cells()).report.sampling;
  add_noise(mesh.points, noise * h);
  const Cell_complex cells = mesh.cells();
  fmt::print(
      "\n10242 vertices on an ellipsoid, noise {:g} h, h the distance of neighbours; errors over root mean squares\n"
      "{:>8} {:>8} {:>12} {:>12} {:>14} {:>12}\n",
      noise, "R/h", "points", "error of L", "error of C", "C, along edges", "as estimated");
  for (const double multiple : {0.0, 2.75, 3.5, 4.5, 6.0, 8.0, 10.0, 13.0, 16.0}) {
    Fit_options options;
    options.radius = multiple * h;
    const Fit fit = fit_vertex_shapes(cells, options);
    double L = 0, C = 0, L2 = 0, C2 = 0, estimated = 0, points = 0, jump = 0;
    std::vector<std::array<Complex, 2>> error;
    for (std::size_t v = 0; v < exact.size(); ++v) {
      const Local_shape &a = fit.shapes.shapes[v], &b = exact[v];
      const Complex w = turn(a, b);
      error.push_back({a.A1 * w - b.A1, a.A3 * w * w * w - b.A3});
      L += std::pow(a.H - b.H, 2) + std::norm(a.Q * w * w - b.Q) / 2;
      L2 += b.H * b.H + std::norm(b.Q) / 2;
      C += (std::norm(error[v][0]) + std::norm(error[v][1])) / 2;
      C2 += (std::norm(b.A1) + std::norm(b.A3)) / 2;
      estimated += std::pow(fit.shapes.quality[v].C_error, 2);
      points += fit.shapes.quality[v].points;
    }
    for (const auto& [p, q] : cells.edges) {
      const Complex w = turn(exact[q], exact[p]);
      jump += (std::norm(error[q][0] * w - error[p][0]) + std::norm(error[q][1] * w * w * w - error[p][1])) / 2;
    }
    const double n = double(exact.size());
    fmt::print("{:>8} {:8.1f} {:12.2e} {:12.2e} {:14.2e} {:12.2e}\n",
               multiple == 0 ? fmt::format("({:.2f})", fit.report.multiple) : fmt::format("{:.2f}", multiple),
               points / n, std::sqrt(L / L2), std::sqrt(C / C2),
               std::sqrt(jump / double(cells.edges.size()) / (C2 / n)), std::sqrt(estimated / C2));
  }
}

} // namespace

int main() {
  compare_with_cgal();
  for (const double noise : {0.0, 0.001, 0.01})
    print_radii(noise);
  fmt::print("(in brackets: the default)\n");
}
