// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
//   with_cgal jets RINGS FILE.off   Monge_via_jet_fitting of degree 4 at the vertices
//   with_cgal fit FILE.off          the errors of k and e that these jets have, with two rings
//   with_cgal ridges FILE.off       jets with two rings, ridges of both curvatures, umbilics
//
// One thread.
#include "Ellipsoid.h"
#include "Measurement.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Monge_via_jet_fitting.h>
#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Ridges.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Umbilics.h>

#include <fstream>
#include <string>
#include <vector>

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;
using Numbers = Mesh::Property_map<Vertex, double>;
using Vectors = Mesh::Property_map<Vertex, Kernel::Vector_3>;
using Monge = CGAL::Monge_via_jet_fitting<Kernel>::Monge_form;

double sum; // printed at the end, so that no work can be left out

Mesh read(const std::string& file) {
  Mesh mesh;
  std::ifstream in(file);
  in >> mesh;
  return mesh;
}

/// calls visit(v, jet) for each vertex, the jet turned to a normal that points outwards.
template <class Visit> void fit(Mesh& mesh, int rings, const Visit& visit) {
  const auto [normal, added] = mesh.add_property_map<Vertex, Kernel::Vector_3>("v:normal");
  CGAL::Polygon_mesh_processing::compute_vertex_normals(mesh, normal);
  std::vector<int> visited(mesh.number_of_vertices(), -1);
  std::vector<Vertex> found;
  std::vector<Kernel::Point_3> points;
  for (const Vertex v : mesh.vertices()) {
    found.assign(1, v);
    visited[v] = int(v.idx());
    for (std::size_t i = 0, ring = 0, end = 1; ring < std::size_t(rings); ++ring, end = found.size())
      for (; i < end; ++i)
        for (const Vertex w : mesh.vertices_around_target(mesh.halfedge(found[i])))
          if (visited[w] != int(v.idx())) {
            visited[w] = int(v.idx());
            found.push_back(w);
          }
    points.clear();
    for (const Vertex w : found)
      points.push_back(mesh.point(w));
    CGAL::Monge_via_jet_fitting<Kernel> fitting;
    Monge monge = fitting(points.begin(), points.end(), 4, 4);
    monge.comply_wrt_given_normal(normal[v]);
    visit(v, monge);
  }
}

void jets(int rings, const std::string& file) {
  Mesh mesh = read(file);
  const double seconds = seconds_of(
      [&] { fit(mesh, rings, [](Vertex, const Monge& monge) { sum += monge.third_order_coefficients(0); }); });
  report(seconds, mesh.number_of_vertices());
}

void errors_of_fit(const std::string& file) {
  Mesh mesh = read(file);
  Ellipsoid_errors errors;
  fit(mesh, 2, [&](Vertex v, const Monge& monge) {
    const Kernel::Point_3& p = mesh.point(v);
    const auto vector = [](const Kernel::Vector_3& d) { return CGAL::Extremal_mesh_3::Vector{d.x(), d.y(), d.z()}; };
    errors.add({p.x(), p.y(), p.z()},
               {monge.principal_curvatures(0), monge.principal_curvatures(1),
                vector(monge.maximal_principal_direction()), vector(monge.minimal_principal_direction()),
                monge.third_order_coefficients(0), monge.third_order_coefficients(3)});
  });
  errors.report();
}

void ridges(const std::string& file) {
  Mesh mesh;
  std::size_t lines = 0;
  const double seconds = seconds_of([&] {
    mesh = read(file);
    const auto numbers = [&](const char* name) { return mesh.add_property_map<Vertex, double>(name).first; };
    const auto vectors = [&](const char* name) { return mesh.add_property_map<Vertex, Kernel::Vector_3>(name).first; };
    Numbers k1 = numbers("v:k1"), k2 = numbers("v:k2"), b0 = numbers("v:b0"), b3 = numbers("v:b3"),
            P1 = numbers("v:P1"), P2 = numbers("v:P2");
    Vectors d1 = vectors("v:d1"), d2 = vectors("v:d2");
    fit(mesh, 2, [&](Vertex v, const Monge& monge) {
      d1[v] = monge.maximal_principal_direction();
      d2[v] = monge.minimal_principal_direction();
      k1[v] = monge.principal_curvatures(0);
      k2[v] = monge.principal_curvatures(1);
      const auto third = [&](std::size_t i) { return monge.third_order_coefficients(i); };
      const auto fourth = [&](std::size_t i) { return monge.fourth_order_coefficients(i); };
      b0[v] = third(0);
      b3[v] = third(3);
      P1[v] = 3 * third(1) * third(1) + (k1[v] - k2[v]) * (fourth(0) - 3 * k1[v] * k1[v] * k1[v]);
      P2[v] = 3 * third(2) * third(2) + (k2[v] - k1[v]) * (fourth(4) - 3 * k2[v] * k2[v] * k2[v]);
    });
    CGAL::Ridge_approximation<Mesh, Numbers, Vectors> ridges(mesh, k1, k2, b0, b3, d1, d2, P1, P2);
    std::vector<CGAL::Ridge_line<Mesh>*> found;
    ridges.compute_max_ridges(std::back_inserter(found), CGAL::Ridge_order_3);
    ridges.compute_min_ridges(std::back_inserter(found), CGAL::Ridge_order_3);
    CGAL::Umbilic_approximation<Mesh, Numbers, Vectors> umbilics(mesh, k1, k2, d1, d2);
    std::vector<CGAL::Umbilic<Mesh>*> points;
    umbilics.compute(std::back_inserter(points), 2);
    lines = found.size();
    for (auto* line : found)
      delete line;
    for (auto* point : points)
      delete point;
  });
  report(seconds, mesh.number_of_vertices());
  sum += double(lines);
}

} // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  if (arguments.size() == 3 && arguments[0] == "jets")
    jets(std::stoi(arguments[1]), arguments[2]);
  else if (arguments.size() == 2 && arguments[0] == "fit")
    errors_of_fit(arguments[1]);
  else if (arguments.size() == 2 && arguments[0] == "ridges")
    ridges(arguments[1]);
  else
    return 2;
  return sum == 0.125 ? 3 : 0;
}
