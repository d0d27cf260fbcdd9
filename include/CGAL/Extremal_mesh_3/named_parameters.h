// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_NAMED_PARAMETERS_H
#define CGAL_EXTREMAL_MESH_3_NAMED_PARAMETERS_H

#include <CGAL/Extremal_mesh_3/Function_3.h>
#include <CGAL/Extremal_mesh_3/extract_extremal_mesh.h>
#include <CGAL/Extremal_mesh_3/fit_vertex_shapes.h>

#include <CGAL/Named_function_parameters.h>

namespace CGAL::Extremal_mesh_3 {

/// What names the parameters that CGAL does not have.
namespace internal::named_parameter {
enum vertex_output { vertex_output_tag };
enum vertex_shapes { vertex_shapes_tag };
enum vertex_fourth_order_forms { vertex_fourth_order_forms_tag };
enum function { function_tag };
enum radius { radius_tag };
enum rings { rings_tag };
enum threads { threads_tag };
enum fit_options { fit_options_tag };
enum fit_output { fit_output_tag };
enum extraction_options { extraction_options_tag };
} // namespace internal::named_parameter

/// CGAL's named parameters, and ours, of the functions of face_graph.h. They are chained in any order, beginning in our
/// namespace:
///
///     namespace params = CGAL::Extremal_mesh_3::parameters;
///     extract_extremal_mesh(mesh, params::radius(0.2).vertex_point_map(map));
///
/// Where CGAL's alone are needed, `CGAL::parameters::vertex_point_map(map)` does as well.
template <class T = bool, class Tag = CGAL::internal_np::all_default_t, class Base = CGAL::internal_np::No_property>
class Named_parameters : public CGAL::Named_function_parameters<T, Tag, Base> {
  using Cgal = CGAL::Named_function_parameters<T, Tag, Base>;
  template <class Other_tag, class Value> auto with(const Value& value) const {
    return Named_parameters<Value, Other_tag, Cgal>(value, *this);
  }

public:
  using Cgal::Cgal;

  /// the points of the vertices: from vertices to points with x(), y() and z(), or [0], [1] and [2].
  /// \param map  a property map
  /// \return the chain
  template <class Map> auto vertex_point_map(const Map& map) const {
    return with<CGAL::internal_np::vertex_point_t>(map);
  }
  /// the surface's normals, of any length: from vertices to vectors. They help to fit jets. By default those of the cells.
  /// \param map  a property map
  /// \return the chain
  template <class Map> auto vertex_normal_map(const Map& map) const {
    return with<CGAL::internal_np::vertex_normal_map_t>(map);
  }
  /// an output iterator that is given the vertex of each point of the cell complex, in their order.
  /// \param vertices  an output iterator
  /// \return the chain
  template <class Iterator> auto vertex_output_iterator(const Iterator& vertices) const {
    return with<internal::named_parameter::vertex_output>(vertices);
  }
  /// the surface's exact shape: from vertices to `Local_shape`. Nothing is fitted then.
  /// \param map  a property map
  /// \return the chain
  template <class Map> auto vertex_shape_map(const Map& map) const {
    return with<internal::named_parameter::vertex_shapes>(map);
  }
  /// from vertices to `Fourth_order_form`, if that is known too.
  /// \param map  a property map
  /// \return the chain
  template <class Map> auto vertex_fourth_order_map(const Map& map) const {
    return with<internal::named_parameter::vertex_fourth_order_forms>(map);
  }
  /// a function on whose zero surface the vertices lie, or nearly: they are moved onto it, and nothing is fitted. Faces
  /// are turned so that they look to where it is positive.
  /// \param f  the function; it must outlive the call
  /// \return the chain
  auto function(const Function_3& f) const { return with<internal::named_parameter::function>(&f); }
  /// of the neighbourhoods to which jets are fitted, as in `Fit_options`.
  /// \param length  in the mesh's unit
  /// \return the chain
  auto radius(double length) const { return with<internal::named_parameter::radius>(length); }
  /// of the neighbourhoods to which jets are fitted, as in `Fit_options`.
  /// \param number  of edges
  /// \return the chain
  auto rings(int number) const { return with<internal::named_parameter::rings>(number); }
  /// 0: as many as the machine has cores. The result does not depend on it.
  /// \param number  of threads
  /// \return the chain
  auto threads(int number) const { return with<internal::named_parameter::threads>(number); }
  /// all of how to fit; `radius`, `rings`, `threads` and normals given by name take precedence.
  /// \param options  how to fit
  /// \return the chain
  auto fit_options(const Fit_options& options) const { return with<internal::named_parameter::fit_options>(options); }
  /// takes the fitted shapes, with the quality of each, and the report. Its shapes are those of the cell complex' points.
  /// \param fit  gets them; it must outlive the call
  /// \return the chain
  auto fit_output(Fit& fit) const { return with<internal::named_parameter::fit_output>(&fit); }
  /// all of how to extract; `threads` given by name takes precedence.
  /// \param options  how to extract
  /// \return the chain
  auto extraction_options(const Extraction_options& options) const {
    return with<internal::named_parameter::extraction_options>(options);
  }

  /// \return the chain as CGAL's own functions take it
  const Cgal& cgal() const { return *this; }
};

/// What begins a chain of named parameters: see `Named_parameters`.
namespace parameters {

/// \return a chain without a parameter: all defaults
inline auto default_values() {
  return Named_parameters<>();
}
/// begins a chain with `Named_parameters::vertex_point_map()`.
/// \param map  a property map
/// \return the chain
template <class Map> auto vertex_point_map(const Map& map) {
  return default_values().vertex_point_map(map);
}
/// begins a chain with `Named_parameters::vertex_normal_map()`.
/// \param map  a property map
/// \return the chain
template <class Map> auto vertex_normal_map(const Map& map) {
  return default_values().vertex_normal_map(map);
}
/// begins a chain with `Named_parameters::vertex_output_iterator()`.
/// \param vertices  an output iterator
/// \return the chain
template <class Iterator> auto vertex_output_iterator(const Iterator& vertices) {
  return default_values().vertex_output_iterator(vertices);
}
/// begins a chain with `Named_parameters::vertex_shape_map()`.
/// \param map  a property map
/// \return the chain
template <class Map> auto vertex_shape_map(const Map& map) {
  return default_values().vertex_shape_map(map);
}
/// begins a chain with `Named_parameters::vertex_fourth_order_map()`.
/// \param map  a property map
/// \return the chain
template <class Map> auto vertex_fourth_order_map(const Map& map) {
  return default_values().vertex_fourth_order_map(map);
}
/// begins a chain with `Named_parameters::function()`.
/// \param f  the function; it must outlive the call
/// \return the chain
inline auto function(const Function_3& f) {
  return default_values().function(f);
}
/// begins a chain with `Named_parameters::radius()`.
/// \param length  in the mesh's unit
/// \return the chain
inline auto radius(double length) {
  return default_values().radius(length);
}
/// begins a chain with `Named_parameters::rings()`.
/// \param number  of edges
/// \return the chain
inline auto rings(int number) {
  return default_values().rings(number);
}
/// begins a chain with `Named_parameters::threads()`.
/// \param number  of threads
/// \return the chain
inline auto threads(int number) {
  return default_values().threads(number);
}
/// begins a chain with `Named_parameters::fit_options()`.
/// \param options  how to fit
/// \return the chain
inline auto fit_options(const Fit_options& options) {
  return default_values().fit_options(options);
}
/// begins a chain with `Named_parameters::fit_output()`.
/// \param fit  gets them; it must outlive the call
/// \return the chain
inline auto fit_output(Fit& fit) {
  return default_values().fit_output(fit);
}
/// begins a chain with `Named_parameters::extraction_options()`.
/// \param options  how to extract
/// \return the chain
inline auto extraction_options(const Extraction_options& options) {
  return default_values().extraction_options(options);
}

} // namespace parameters

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_NAMED_PARAMETERS_H
