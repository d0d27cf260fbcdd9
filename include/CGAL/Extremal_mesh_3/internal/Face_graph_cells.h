// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_INTERNAL_FACE_GRAPH_CELLS_H
#define CGAL_EXTREMAL_MESH_3_INTERNAL_FACE_GRAPH_CELLS_H

#include <CGAL/Extremal_mesh_3/Cell_complex.h>
#include <CGAL/Extremal_mesh_3/named_parameters.h>

#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Extremal_mesh_3::internal {

template <class T, class Tag, class Base> const auto& as_cgal(const Named_parameters<T, Tag, Base>& np) {
  return np.cgal();
}
template <class T, class Tag, class Base> const auto& as_cgal(const CGAL::Named_function_parameters<T, Tag, Base>& np) {
  return np;
}

template <class Tag, class NP> inline constexpr bool is_given = !CGAL::parameters::is_default_parameter<NP, Tag>::value;

/// a point or vector of the user's as ours.
template <class P> std::array<double, 3> to_array(const P& p) {
  if constexpr (requires { p.x(); })
    return {double(CGAL::to_double(p.x())), double(CGAL::to_double(p.y())), double(CGAL::to_double(p.z()))};
  else
    return {double(p[0]), double(p[1]), double(p[2])};
}

/// The cells of a face graph.
template <class Graph> struct Face_graph_cells {
  using vertex_descriptor = typename boost::graph_traits<Graph>::vertex_descriptor;
  Cell_complex cells;
  std::vector<vertex_descriptor> vertices; ///< of each point of the cells

  /// the values of a property map at the points.
  template <class Map, class Convert> auto values(const Map& map, Convert convert) const {
    std::vector<decltype(convert(get(map, vertices.front())))> result;
    result.reserve(vertices.size());
    for (const vertex_descriptor& v : vertices)
      result.push_back(convert(get(map, v)));
    return result;
  }
};

/// Vertices are numbered in the graph's order, those without a face left out.
template <class Graph, class NP> Face_graph_cells<Graph> face_graph_cells(const Graph& g, const NP& np) {
  const auto point_of =
      CGAL::parameters::choose_parameter(CGAL::parameters::get_parameter(np, CGAL::internal_np::vertex_point),
                                         CGAL::get_const_property_map(CGAL::vertex_point, g));
  constexpr std::uint32_t isolated = std::numeric_limits<std::uint32_t>::max();
  const auto number = get(CGAL::dynamic_vertex_property_t<std::uint32_t>(), g);
  for (const auto v : CGAL::make_range(vertices(g)))
    put(number, v, isolated);

  // Corners are vertices until all are known that have a face.
  Face_graph_cells<Graph> result;
  std::vector<typename Face_graph_cells<Graph>::vertex_descriptor> corners;
  std::vector<std::size_t> begin{0};
  for (const auto f : CGAL::make_range(faces(g))) {
    const auto first = halfedge(f, g);
    auto h = first;
    do {
      corners.push_back(target(h, g));
      put(number, corners.back(), 0);
      h = next(h, g);
    } while (h != first);
    begin.push_back(corners.size());
  }
  std::vector<Point> points;
  for (const auto v : CGAL::make_range(vertices(g)))
    if (get(number, v) != isolated) {
      put(number, v, std::uint32_t(points.size()));
      points.push_back(to_array(get(point_of, v)));
      result.vertices.push_back(v);
    }
  std::vector<std::uint32_t> indices(corners.size());
  std::transform(corners.begin(), corners.end(), indices.begin(), [&](const auto& v) { return get(number, v); });
  result.cells = make_cell_complex(std::move(points), begin, indices);

  if constexpr (is_given<named_parameter::vertex_output, NP>)
    std::copy(result.vertices.begin(), result.vertices.end(),
              CGAL::parameters::get_parameter(np, named_parameter::vertex_output_tag));
  return result;
}

} // namespace CGAL::Extremal_mesh_3::internal

#endif // CGAL_EXTREMAL_MESH_3_INTERNAL_FACE_GRAPH_CELLS_H
