// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// GraphML as http://graphml.graphdrawing.org defines it. boost::write_graphml prints six digits of a double.
#include "Text_file.h"
#include "cells_json.h"
#include "graphml_schema.h"

#include <CGAL/Extremal_mesh_3/io.h>

namespace CGAL::Extremal_mesh_3 {

namespace {

using graphml::Field;

void write_key(Text_file& out, std::string_view domain, std::string_view name, std::string_view type) {
  out << "  <key id=\"" << name << "\" for=\"" << domain << "\" attr.name=\"" << name << "\" attr.type=\"" << type
      << "\"/>\n";
}

/// writes what there is to tell of an element, one line for a property.
/// \param scratch  for the text of a value
template <typename T, std::size_t n>
void write_data(Text_file& out, const std::array<Field<T>, n>& fields, const T& element, std::string_view indent,
                graphml::Text& scratch) {
  for (const Field<T>& field : fields) {
    scratch.clear();
    try {
      field.write(scratch, element);
    } catch (const graphml::Value_error& error) {
      throw graphml::Value_error(fmt::format("{}: {}", field.name, error.what()));
    }
    if (scratch.size() != 0)
      out << indent << "<data key=\"" << field.name << "\">" << std::string_view(scratch.data(), scratch.size())
          << "</data>\n";
  }
}

void write_cells(Text_file& out, const std::vector<Extremal_mesh_cell>& cells, graphml::Text& scratch) {
  out << "    <data key=\"" << graphml::cells_key << "\">[";
  for (std::size_t c = 0; c < cells.size(); ++c) {
    scratch.clear();
    append_json(scratch, cells[c], c);
    out << (c == 0 ? "\n" : ",\n") << std::string_view(scratch.data(), scratch.size());
  }
  out << "]</data>\n";
}

} // namespace

void write_graphml(const std::string& file, const Extremal_mesh& mesh) {
  Text_file out(file);
  graphml::Text scratch;
  out << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
         "<graphml xmlns=\"http://graphml.graphdrawing.org/xmlns\" "
         "xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\" "
         "xsi:schemaLocation=\"http://graphml.graphdrawing.org/xmlns "
         "http://graphml.graphdrawing.org/xmlns/1.0/graphml.xsd\">\n";
  for (const std::string_view name : {graphml::format_key, graphml::version_key, graphml::cells_key})
    write_key(out, "graph", name, "string");
  for (const auto& field : graphml::graph_fields)
    write_key(out, "graph", field.name, field.type);
  for (const auto& field : graphml::node_fields)
    write_key(out, "node", field.name, field.type);
  for (const auto& field : graphml::edge_fields)
    write_key(out, "edge", field.name, field.type);

  std::string element; // in which a value is wrong
  try {
    element = "the surface";
    out << "  <graph id=\"extremal_mesh\" edgedefault=\"undirected\">\n";
    out << "    <data key=\"" << graphml::format_key << "\">" << graphml::format_name << "</data>\n";
    out << "    <data key=\"" << graphml::version_key << "\">" << EXTREMAL_MESH_3_VERSION << "</data>\n";
    write_data(out, graphml::graph_fields, mesh.surface(), "    ", scratch);
    element = "the cells";
    write_cells(out, mesh.cells(), scratch);
    for (std::size_t v = 0; v < mesh.number_of_vertices(); ++v) {
      element = fmt::format("vertex {}", v);
      out.print(FMT_COMPILE("    <node id=\"n{}\">\n"), v);
      write_data(out, graphml::node_fields, mesh.vertex(v), "      ", scratch);
      out << "    </node>\n";
    }
    for (std::size_t e = 0; e < mesh.number_of_edges(); ++e) {
      const Extremal_mesh_edge& edge = mesh.edge(e);
      element = fmt::format("edge {}", e);
      out.print(FMT_COMPILE("    <edge id=\"e{}\" source=\"n{}\" target=\"n{}\">\n"), e, edge.source, edge.target);
      write_data(out, graphml::edge_fields, edge, "      ", scratch);
      out << "    </edge>\n";
    }
  } catch (const graphml::Value_error& error) {
    throw Io_error(fmt::format("cannot write '{}': {}: {}", file, element, error.what()));
  }
  out << "  </graph>\n</graphml>\n";
  out.commit();
}

} // namespace CGAL::Extremal_mesh_3
