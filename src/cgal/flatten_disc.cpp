// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "flatten_disc.h"
#include "surface_mesh.h"

#include <CGAL/Eigen_solver_traits.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh_parameterization/Barycentric_mapping_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Mean_value_coordinates_parameterizer_3.h>

#include <Eigen/SparseLU>

#include <cmath>

namespace CGAL::Extremal_mesh_3 {

namespace {

namespace Parameterization = CGAL::Surface_mesh_parameterization;
using Mesh = Surface_of_triangles;
using Vertex = Mesh::Vertex_index;

/// Model of CGAL's concept Parameterizer_3 for borders: places that are given.
struct Given_border {
  const std::vector<std::uint32_t>* border = nullptr;
  const std::vector<Plane_point>* places = nullptr;

  template <class Place_of, class Index_of, class Is_placed>
  Parameterization::Error_code parameterize(const Mesh&, Mesh::Halfedge_index, Place_of place_of, Index_of,
                                            Is_placed is_placed) {
    for (std::size_t i = 0; i < border->size(); ++i) {
      const auto& [u, v] = (*places)[i];
      put(place_of, Vertex((*border)[i]), Surface_kernel::Point_2(u, v));
      put(is_placed, Vertex((*border)[i]), true);
    }
    return Parameterization::OK;
  }
  bool is_border_convex() const { return true; }
};

// A direct solver: its result has no tolerance.
using Solver = CGAL::Eigen_solver_traits<
    Eigen::SparseLU<CGAL::Eigen_sparse_matrix<double>::EigenType, Eigen::COLAMDOrdering<int>>>;
using Mean_value = Parameterization::Mean_value_coordinates_parameterizer_3<Mesh, Given_border, Solver>;
using Uniform = Parameterization::Barycentric_mapping_parameterizer_3<Mesh, Given_border, Solver>;

template <class Method>
bool solve(Mesh& mesh, const Given_border& border, Mesh::Property_map<Vertex, Surface_kernel::Point_2> place_of) {
  const auto is_placed = mesh.add_property_map<Vertex, bool>("v:is_placed", false).first;
  Mesh::Halfedge_index start;
  for (const auto h : mesh.halfedges())
    if (mesh.is_border(h)) {
      start = h;
      break;
    }
  return Method(border).parameterize(mesh, start, place_of, get(boost::vertex_index, mesh), is_placed) ==
         Parameterization::OK;
}

} // namespace

std::vector<Plane_point> flatten_disc(const Triangles& disc, const std::vector<std::uint32_t>& border,
                                      const std::vector<Plane_point>& places, Flat_weights weights) {
  Mesh mesh = surface_mesh_of(disc);
  const auto place_of = mesh.add_property_map<Vertex, Surface_kernel::Point_2>("v:place").first;
  const Given_border given{&border, &places};
  const bool solved = weights == Flat_weights::mean_value ? solve<Mean_value>(mesh, given, place_of)
                                                          : solve<Uniform>(mesh, given, place_of);
  if (!solved)
    return {};
  std::vector<Plane_point> result;
  for (const Vertex v : mesh.vertices())
    result.push_back({place_of[v].x(), place_of[v].y()});
  return result;
}

std::size_t number_of_flipped(const Triangles& disc, const std::vector<Plane_point>& places) {
  using Exact = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;
  std::size_t flipped = 0;
  const auto is_finite = [](const Plane_point& p) { return std::isfinite(p[0]) && std::isfinite(p[1]); };
  for (const auto& [a, b, c] : disc.corners) {
    const Plane_point &p = places[a], &q = places[b], &r = places[c];
    flipped += !is_finite(p) || !is_finite(q) || !is_finite(r) ||
                       CGAL::orientation(Exact(p[0], p[1]), Exact(q[0], q[1]), Exact(r[0], r[1])) != CGAL::LEFT_TURN
                   ? 1
                   : 0;
  }
  return flipped;
}

} // namespace CGAL::Extremal_mesh_3
