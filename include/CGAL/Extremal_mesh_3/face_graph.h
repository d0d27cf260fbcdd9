// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_FACE_GRAPH_H
#define CGAL_EXTREMAL_MESH_3_FACE_GRAPH_H

#include <CGAL/Extremal_mesh_3/extract_extremal_mesh.h>
#include <CGAL/Extremal_mesh_3/internal/Face_graph_cells.h>
#include <CGAL/Extremal_mesh_3/internal/Sampled_surface.h>
#include <CGAL/Extremal_mesh_3/named_parameters.h>

#include <type_traits>
#include <utility>

// Unlike the other public headers this one and named_parameters.h need CGAL's.
namespace CGAL::Extremal_mesh_3 {

namespace internal {
template <class Graph>
concept Has_vertices_and_faces = requires(const Graph& graph) {
  vertices(graph), faces(graph);
};
template <class Graph>
concept Has_face_descriptor = requires {
  typename boost::graph_traits<Graph>::face_descriptor;
};
} // namespace internal

/// A model of CGAL's concept `FaceListGraph`: `CGAL::Surface_mesh`, `CGAL::Polyhedron_3`, OpenMesh's `PolyMesh_ArrayKernelT`
/// and `TriMesh_ArrayKernelT` (with <CGAL/boost/graph/graph_traits_PolyMesh_ArrayKernelT.h>), and others.
// In this order: of what is no graph at all Boost's traits do not compile.
template <class Graph>
concept Face_list_graph = internal::Has_vertices_and_faces<Graph> && internal::Has_face_descriptor<Graph>;

/// makes a cell complex of the faces of a graph, which may have any number of sides and need not be plane. They are oriented as
/// in the graph. Its points are the vertices in the order of `vertices(graph)`, but those without a face.
/// O(n log n).
/// \tparam Graph  a model of `FaceListGraph`
/// \tparam NP  named parameters
/// \param np  `vertex_point_map`, by default the graph's own; `vertex_output_iterator`, by which to go from points to vertices
/// \param graph  the mesh
/// \return the cells
/// \throws std::invalid_argument if the faces are not a manifold with or without border
template <Face_list_graph Graph, class NP = CGAL::parameters::Default_named_parameters>
Cell_complex make_cell_complex(const Graph& graph, const NP& np = NP()) {
  return internal::face_graph_cells(graph, internal::as_cgal(np)).cells;
}

/// extracts the extremal mesh of the surface that the vertices of a graph sample. Unless told otherwise by named
/// parameters, its shape at each vertex is that of a jet fitted to the vertices around: see `fit_vertex_shapes()`.
/// \param np  the members of `Named_parameters`
/// \throws std::invalid_argument if the faces are not a manifold with or without border, a coordinate is not finite, or an
///         option is out of its range
///         Extraction_error and Degenerate_surface_error as `extract_extremal_mesh()` of cells does
/// \tparam Graph  a model of `FaceListGraph`
/// \tparam NP  named parameters
/// \param graph  the mesh
/// \return the extremal mesh, and a report of what is certain
template <Face_list_graph Graph, class NP = CGAL::parameters::Default_named_parameters>
Extraction extract_extremal_mesh(const Graph& graph, const NP& np = NP()) {
  namespace tags = internal::named_parameter;
  const auto& given = internal::as_cgal(np);
  using Given = std::remove_cvref_t<decltype(given)>;
  const auto copy = [](const auto& x) { return x; };

  auto mesh = internal::face_graph_cells(graph, given);
  internal::Sampled_surface surface;
  if constexpr (internal::is_given<tags::fit_options, Given>)
    surface.fit_options = CGAL::parameters::get_parameter(given, tags::fit_options_tag);
  if constexpr (internal::is_given<tags::extraction_options, Given>)
    surface.extraction_options = CGAL::parameters::get_parameter(given, tags::extraction_options_tag);
  if constexpr (internal::is_given<tags::radius, Given>)
    surface.fit_options.radius = CGAL::parameters::get_parameter(given, tags::radius_tag);
  if constexpr (internal::is_given<tags::rings, Given>)
    surface.fit_options.rings = CGAL::parameters::get_parameter(given, tags::rings_tag);
  if constexpr (internal::is_given<tags::threads, Given>)
    surface.fit_options.threads = surface.extraction_options.threads =
        CGAL::parameters::get_parameter(given, tags::threads_tag);
  if constexpr (internal::is_given<tags::fit_output, Given>)
    surface.fit = CGAL::parameters::get_parameter(given, tags::fit_output_tag);
  if constexpr (internal::is_given<tags::function, Given>)
    surface.function = CGAL::parameters::get_parameter(given, tags::function_tag);
  if constexpr (internal::is_given<CGAL::internal_np::vertex_normal_map_t, Given>)
    surface.fit_options.normals =
        mesh.values(CGAL::parameters::get_parameter(given, CGAL::internal_np::vertex_normal_map),
                    [](const auto& n) { return internal::to_array(n); });
  if constexpr (internal::is_given<tags::vertex_shapes, Given>)
    surface.given.shapes = mesh.values(CGAL::parameters::get_parameter(given, tags::vertex_shapes_tag), copy);
  if constexpr (internal::is_given<tags::vertex_fourth_order_forms, Given>)
    surface.given.fourth =
        mesh.values(CGAL::parameters::get_parameter(given, tags::vertex_fourth_order_forms_tag), copy);
  surface.cells = std::move(mesh.cells);
  return internal::extract_extremal_mesh(std::move(surface));
}

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_FACE_GRAPH_H
