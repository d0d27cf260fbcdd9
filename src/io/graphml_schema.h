// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_IO_GRAPHML_SCHEMA_H
#define CGAL_EXTREMAL_MESH_3_IO_GRAPHML_SCHEMA_H

#include "graphml_values.h"

/// What our GraphML files hold, said once for the writer and the reader. No key's id may be used for two kinds of
/// elements, or be `d` and a number, on which Gephi stumbles.
namespace CGAL::Extremal_mesh_3::graphml {

/// How one property of an element of type `T` is written and read.
template <typename T> struct Field {
  std::string_view name; ///< the key's id and attribute name
  std::string_view type;
  bool required = true;                         ///< to be there when read
  void (*write)(Text&, const T&) = nullptr;     ///< writes nothing if there is nothing to tell
  void (*read)(std::string_view, T&) = nullptr; ///< null: the property follows from others
};

/// A field that is one member of `T`.
template <auto member, typename T> constexpr Field<T> field_of(std::string_view name, bool required) {
  using Value = std::remove_cvref_t<decltype(std::declval<T>().*member)>;
  return {name, type_name<Value>, required, [](Text& out, const T& t) { append(out, t.*member); },
          [](std::string_view text, T& t) { parse(text, t.*member); }};
}

/// A field that is one coordinate of a member of `T`.
template <auto member, std::size_t i, typename T> constexpr Field<T> coordinate_of(std::string_view name) {
  return {name, type_name<double>, true, [](Text& out, const T& t) { append(out, (t.*member)[i]); },
          [](std::string_view text, T& t) { parse(text, (t.*member)[i]); }};
}

namespace internal {

using V = Extremal_mesh_vertex;
using E = Extremal_mesh_edge;
using S = Surface_info;

/// the extremum of a family is of use at extremal points only.
template <std::size_t i> void write_extremum(Text& out, const V& v) {
  if (v.kind == Vertex_kind::extremal_point || v.extrema[i] != V().extrema[i])
    append(out, v.extrema[i]);
}
template <std::size_t i> void read_extremum(std::string_view text, V& v) {
  parse(text, v.extrema[i]);
}

} // namespace internal

inline constexpr std::array node_fields = {
    field_of<&internal::V::kind, internal::V>("kind", true),
    coordinate_of<&internal::V::point, 0, internal::V>("x"),
    coordinate_of<&internal::V::point, 1, internal::V>("y"),
    coordinate_of<&internal::V::point, 2, internal::V>("z"),
    coordinate_of<&internal::V::normal, 0, internal::V>("nx"),
    coordinate_of<&internal::V::normal, 1, internal::V>("ny"),
    coordinate_of<&internal::V::normal, 2, internal::V>("nz"),
    field_of<&internal::V::k1, internal::V>("k_max", true),
    field_of<&internal::V::k2, internal::V>("k_min", true),
    coordinate_of<&internal::V::t1, 0, internal::V>("t1x"),
    coordinate_of<&internal::V::t1, 1, internal::V>("t1y"),
    coordinate_of<&internal::V::t1, 2, internal::V>("t1z"),
    coordinate_of<&internal::V::t2, 0, internal::V>("t2x"),
    coordinate_of<&internal::V::t2, 1, internal::V>("t2y"),
    coordinate_of<&internal::V::t2, 2, internal::V>("t2z"),
    field_of<&internal::V::umbilic_index, internal::V>("index", true),
    field_of<&internal::V::field_index, internal::V>("field_index", true),
    field_of<&internal::V::umbilic_type, internal::V>("umbilic_type", true),
    field_of<&internal::V::ridges, internal::V>("ridges", true),
    Field<internal::V>{"degree", "int", false, [](Text& out, const internal::V& v) { append(out, v.star.size()); }},
    Field<internal::V>{"extremum_1", "string", false, internal::write_extremum<0>, internal::read_extremum<0>},
    Field<internal::V>{"extremum_2", "string", false, internal::write_extremum<1>, internal::read_extremum<1>},
    field_of<&internal::V::star, internal::V>("star", false),
    field_of<&internal::V::life_time, internal::V>("life_time", false),
};

inline constexpr std::array edge_fields = {
    field_of<&internal::E::family, internal::E>("family", true),
    field_of<&internal::E::type, internal::E>("type", true),
    field_of<&internal::E::length, internal::E>("length", true),
    field_of<&internal::E::strength, internal::E>("strength", true),
    field_of<&internal::E::sharpness, internal::E>("sharpness", true),
    field_of<&internal::E::left_cell, internal::E>("left_cell", true),
    field_of<&internal::E::right_cell, internal::E>("right_cell", true),
    field_of<&internal::E::polyline, internal::E>("polyline", true),
    field_of<&internal::E::normals, internal::E>("normals_along", true),
    field_of<&internal::E::k1, internal::E>("k_max_along", true),
    field_of<&internal::E::k2, internal::E>("k_min_along", true),
    field_of<&internal::E::extremality, internal::E>("extremality_along", true),
    field_of<&internal::E::segment_types, internal::E>("segment_types", true),
    field_of<&internal::E::type_changes, internal::E>("type_changes", false),
    field_of<&internal::E::life_time, internal::E>("line_life_time", false),
};

inline constexpr std::array graph_fields = {
    field_of<&internal::S::euler_characteristic, internal::S>("euler_characteristic", true),
    field_of<&internal::S::closed, internal::S>("closed", true),
    field_of<&internal::S::components, internal::S>("components", true),
    field_of<&internal::S::area, internal::S>("area", true),
    field_of<&internal::S::degenerate_area, internal::S>("degenerate_area", true),
    field_of<&internal::S::source, internal::S>("source", false),
    field_of<&internal::S::parameters, internal::S>("parameters", false),
    field_of<&internal::S::frame, internal::S>("frame", false),
};

/// Graph keys that are not properties of the surface.
inline constexpr std::string_view version_key = "version"; ///< of the program that wrote the file
inline constexpr std::string_view format_key = "format";   ///< `format_name` below
inline constexpr std::string_view cells_key = "cells";     ///< JSON, see cells_json.h

/// Changes whenever older readers could not read the file.
inline constexpr std::string_view format_name = "Extremal_mesh_3 2";

} // namespace CGAL::Extremal_mesh_3::graphml

#endif // CGAL_EXTREMAL_MESH_3_IO_GRAPHML_SCHEMA_H
