// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_CELL_SURFACE_H
#define CGAL_EXTREMAL_MESH_3_CELL_SURFACE_H

#include <CGAL/Extremal_mesh_3/cell_patches.h>
#include <CGAL/Extremal_mesh_3/internal/Face_graph_cells.h>
#include <CGAL/Extremal_mesh_3/internal/manifold_patches.h>
#include <CGAL/Extremal_mesh_3/named_parameters.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

// Needs CGAL's headers, as face_graph.h does.
namespace CGAL::Extremal_mesh_3 {

/// adds the surface that was cut along the extremal lines to a mesh of CGAL's: a face for each polygon, counter-clockwise seen
/// from the normals' side. Polygons share vertices, so that the surface is closed where the original is, and an edge between faces
/// of different cells is a piece of a line: one segment of it, or half of one where otherwise two edges would join the same
/// vertices. `CGAL::Surface_mesh` gets a property map "f:cell" of `std::uint32_t`, the
/// cell in which a face is.
///
/// `patches_of_cell()` and `triangulate()` make other patches to give here: one cell, triangles.
/// \tparam Graph  a model of `MutableFaceGraph`
/// \param patches  of an `Extraction`
/// \param graph  what it has already is kept, and gets no connection with what is added
/// \param np  CGAL's `vertex_point_map`, `vertex_normal_map` and `face_patch_map`, the last one to get the cells; by
///            default the graph's own points. (OpenMesh's own map rounds to float.)
/// \throws std::invalid_argument if the arrays of the patches do not fit together, or they are no manifold
/// O(n log n).
template <class Graph, class NP = CGAL::parameters::Default_named_parameters>
void make_cell_surface(const Cell_patches& patches, Graph& graph, const NP& np = NP()) {
  using Traits = boost::graph_traits<Graph>;
  using Face = typename Traits::face_descriptor;
  using Vertex = typename Traits::vertex_descriptor;
  using Given = std::remove_cvref_t<decltype(internal::as_cgal(np))>;
  const auto& given = internal::as_cgal(np);
  auto point_of =
      CGAL::parameters::choose_parameter(CGAL::parameters::get_parameter(given, CGAL::internal_np::vertex_point),
                                         CGAL::get_property_map(CGAL::vertex_point, graph));
  using Graph_point = typename boost::property_traits<decltype(point_of)>::value_type;

  const Cell_patches surface = internal::manifold_patches(patches);
  std::vector<Vertex> vertex;
  vertex.reserve(surface.points.size());
  for (std::size_t i = 0; i < surface.points.size(); ++i) {
    const auto& [x, y, z] = surface.points[i];
    vertex.push_back(add_vertex(graph));
    put(point_of, vertex.back(), Graph_point(x, y, z));
    if constexpr (internal::is_given<CGAL::internal_np::vertex_normal_map_t, Given>) {
      auto normal_of = CGAL::parameters::get_parameter(given, CGAL::internal_np::vertex_normal_map);
      const auto& [nx, ny, nz] = surface.normals[i];
      put(normal_of, vertex.back(), typename boost::property_traits<decltype(normal_of)>::value_type(nx, ny, nz));
    }
  }

  std::vector<Face> faces;
  faces.reserve(surface.cell.size());
  std::vector<Vertex> corners;
  for (std::size_t i = 0; i < surface.cell.size(); ++i) {
    corners.clear();
    for (std::size_t j = surface.begin[i]; j < surface.begin[i + 1]; ++j)
      corners.push_back(vertex[surface.corners[j]]);
    faces.push_back(CGAL::Euler::add_face(corners, graph));
    if (faces.back() == Traits::null_face())
      throw std::invalid_argument("polygon " + std::to_string(i) + " of the patches, in cell " +
                                  std::to_string(surface.cell[i]) + ", cannot be added: they are no manifold");
  }
  const auto tell = [&](auto cell_of) {
    for (std::size_t i = 0; i < faces.size(); ++i)
      put(cell_of, faces[i], surface.cell[i]);
  };
  if constexpr (internal::is_given<CGAL::internal_np::face_patch_t, Given>)
    tell(CGAL::parameters::get_parameter(given, CGAL::internal_np::face_patch));
  if constexpr (requires { graph.template add_property_map<Face, std::uint32_t>("f:cell"); })
    tell(graph.template add_property_map<Face, std::uint32_t>("f:cell").first);
}

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_CELL_SURFACE_H
