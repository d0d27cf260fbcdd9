// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads our own GraphML, also after another program has added attributes, renamed the keys' ids, put the edges in
// another order or exchanged their ends, as NetworkX does.
#include "Xml_reader.h"
#include "cells_json.h"
#include "graphml_schema.h"

#include <CGAL/Extremal_mesh_3/io.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <system_error>
#include <unordered_map>

namespace CGAL::Extremal_mesh_3 {

namespace {

using graphml::Field;
using Tag = Xml_reader::Tag;

std::string read_text(const std::string& file) {
  std::error_code error;
  if (std::filesystem::is_directory(file, error))
    throw Io_error(fmt::format("cannot read '{}': it is a folder", file));
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  if (!stream)
    throw Io_error(fmt::format("cannot read '{}': {}", file, std::generic_category().message(errno)));
  std::string text;
  if (const std::uintmax_t size = std::filesystem::file_size(file, error); !error)
    text.reserve(size);
  std::vector<char> buffer(1U << 20);
  while (stream.read(buffer.data(), std::ptrdiff_t(buffer.size())) || stream.gcount() > 0)
    text.append(buffer.data(), std::size_t(stream.gcount()));
  if (stream.bad())
    throw Io_error(fmt::format("cannot read '{}': {}", file, std::generic_category().message(errno)));
  if (text.empty())
    throw Io_error(fmt::format("'{}' is empty; expected GraphML", file));
  return text;
}

/// The keys declared for one kind of element. Elements tell their properties in about the order of the declarations,
/// so a search that goes on where the last one ended finds at once.
class Keys {
public:
  void declare(std::string_view id, std::string_view name) { keys_.push_back({std::string(id), std::string(name)}); }
  bool has(std::string_view name) const {
    return std::any_of(keys_.begin(), keys_.end(), [&](const Key& key) { return key.name == name; });
  }
  /// the name of the attribute with this key; null if there is none.
  const std::string* name(std::string_view id) {
    for (std::size_t i = 0; i < keys_.size(); ++i) {
      last_ = last_ + 1 < keys_.size() ? last_ + 1 : 0;
      if (keys_[last_].id == id)
        return &keys_[last_].name;
    }
    return nullptr;
  }

private:
  struct Key {
    std::string id, name;
  };
  std::vector<Key> keys_;
  std::size_t last_ = 0;
};

/// Puts values into an element of type `T` and knows which are still missing.
template <typename T, std::size_t n> class Element_reader {
public:
  Element_reader(const std::array<Field<T>, n>& fields, T& element) : fields_(fields), element_(element) {}

  /// \return `false` if there is no such property
  bool read(std::string_view name, std::string_view text) {
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t f = (next_ + i) % n;
      if (fields_[f].name != name)
        continue;
      if (fields_[f].read)
        fields_[f].read(text, element_);
      seen_[f] = true;
      next_ = f + 1;
      return true;
    }
    return false;
  }
  /// \return the first property that should be there and is not; empty if there is none
  std::string_view missing() const {
    for (std::size_t f = 0; f < n; ++f)
      if (fields_[f].required && !seen_[f])
        return fields_[f].name;
    return {};
  }

private:
  const std::array<Field<T>, n>& fields_;
  T& element_;
  std::array<bool, n> seen_{};
  std::size_t next_ = 0;
};

struct String_hash : std::hash<std::string_view> {
  using is_transparent = void;
};

class Graphml_reader {
public:
  Graphml_reader(const std::string& file, std::string_view text) : file_(file), xml_(file, text) {}

  Extremal_mesh read() {
    if (xml_.next() != Tag::start || xml_.name() != "graphml")
      xml_.fail(fmt::format("this is not GraphML; its first element is <{}>", xml_.name()));
    bool has_graph = false;
    while (xml_.next() == Tag::start) {
      if (xml_.name() == "graph") {
        if (has_graph)
          xml_.fail("there is a second graph; expected one");
        has_graph = true;
        read_graph();
        continue;
      }
      if (xml_.name() == "key")
        declare_key();
      xml_.skip_element();
    }
    while (xml_.next() != Tag::end_of_text) {
    }
    if (!has_graph)
      xml_.fail("there is no graph");
    try {
      sort_edges();
      return Extremal_mesh(std::move(vertices_), std::move(edges_), std::move(cells_), std::move(surface_));
    } catch (const std::invalid_argument& error) {
      throw Io_error(fmt::format("'{}' holds no extremal mesh: {}", file_, error.what()));
    }
  }

private:
  void declare_key() {
    const std::string_view id = xml_.attribute("id"), name = xml_.attribute("attr.name"),
                           domain = xml_.attribute("for");
    if (domain == "graph" || domain == "all")
      graph_keys_.declare(id, name);
    if (domain == "node" || domain == "all")
      node_keys_.declare(id, name);
    if (domain == "edge" || domain == "all")
      edge_keys_.declare(id, name);
  }

  void read_graph() {
    if (!graph_keys_.has(graphml::format_key))
      xml_.fail("this graph was not written by Extremal_mesh_3; make one with 'extremal_mesh extract'");
    Element_reader surface(graphml::graph_fields, surface_);
    bool has_format = false, has_cells = false;
    while (xml_.next() == Tag::start) {
      if (xml_.name() == "node") {
        read_node();
      } else if (xml_.name() == "edge") {
        read_edge();
      } else if (xml_.name() == "data") {
        read_data(graph_keys_, "the graph", [&](std::string_view name, std::string_view text) {
          if (name == graphml::format_key && text != graphml::format_name)
            throw graphml::Value_error(fmt::format("it is '{}'; this program reads '{}'", text, graphml::format_name));
          has_format = has_format || name == graphml::format_key;
          if (name == graphml::cells_key)
            cells_ = parse_cells(text);
          has_cells = has_cells || name == graphml::cells_key;
          surface.read(name, text);
        });
      } else {
        xml_.skip_element();
      }
    }
    require_no_missing(!has_format  ? graphml::format_key
                       : !has_cells ? graphml::cells_key
                                    : surface.missing(),
                       "the graph");
  }

  void read_node() {
    const std::string id(xml_.attribute("id"));
    if (!vertex_of_.emplace(id, std::uint32_t(vertices_.size())).second)
      xml_.fail(fmt::format("there is a second node '{}'", id));
    read_element(node_keys_, graphml::node_fields, vertices_.emplace_back(), fmt::format("node '{}'", id));
  }

  void read_edge() {
    const std::string id(xml_.attribute("id"));
    Extremal_mesh_edge& edge = edges_.emplace_back();
    try {
      graphml::parse(id.starts_with('e') ? std::string_view(id).substr(1) : std::string_view(), edge.id);
    } catch (const graphml::Value_error&) {
      xml_.fail(fmt::format("'{}' is not the id of an edge; expected e0, e1, …", id));
    }
    edge.source = vertex(xml_.attribute("source"), id);
    edge.target = vertex(xml_.attribute("target"), id);
    read_element(edge_keys_, graphml::edge_fields, edge, fmt::format("edge '{}'", id));
    if (edge.polyline.empty())
      xml_.fail(fmt::format("edge '{}' has a polyline without points", id));
    const Point& source = vertices_[edge.source].point;
    if (edge.polyline.front() != source && edge.polyline.back() == source)
      std::swap(edge.source, edge.target);
  }

  std::uint32_t vertex(std::string_view node, std::string_view edge) const {
    const auto found = vertex_of_.find(node);
    if (found == vertex_of_.end())
      xml_.fail(fmt::format("edge '{}' ends at node '{}', which does not exist", edge, node));
    return found->second;
  }

  template <typename T, std::size_t n>
  void read_element(Keys& keys, const std::array<Field<T>, n>& fields, T& element, const std::string& name) {
    Element_reader<T, n> reader(fields, element);
    while (xml_.next() == Tag::start) {
      if (xml_.name() == "data")
        read_data(keys, name, [&](std::string_view key, std::string_view text) { reader.read(key, text); });
      else
        xml_.skip_element();
    }
    require_no_missing(reader.missing(), name);
  }

  /// reads a data element, whose start is the current tag.
  template <typename Take> void read_data(Keys& keys, std::string_view element, const Take& take) {
    const std::string* const name = keys.name(xml_.attribute("key"));
    if (!name)
      xml_.fail(fmt::format("{} has data of key '{}', which is not declared", element, xml_.attribute("key")));
    if (xml_.next() != Tag::end)
      xml_.fail(fmt::format("{}: there is an element in '{}'; expected a value", element, *name));
    try {
      take(*name, xml_.text());
    } catch (const graphml::Value_error& error) {
      xml_.fail(fmt::format("{}: {}: {}", element, *name, error.what()));
    }
  }

  void require_no_missing(std::string_view missing, std::string_view element) const {
    if (!missing.empty())
      xml_.fail(fmt::format("{} has no '{}'", element, missing));
  }

  void sort_edges() {
    const auto by_id = [](const Extremal_mesh_edge& a, const Extremal_mesh_edge& b) { return a.id < b.id; };
    if (!std::is_sorted(edges_.begin(), edges_.end(), by_id))
      std::sort(edges_.begin(), edges_.end(), by_id);
  }

  const std::string& file_;
  Xml_reader xml_;
  Keys graph_keys_, node_keys_, edge_keys_;
  std::unordered_map<std::string, std::uint32_t, String_hash, std::equal_to<>> vertex_of_;
  std::vector<Extremal_mesh_vertex> vertices_;
  std::vector<Extremal_mesh_edge> edges_;
  std::vector<Extremal_mesh_cell> cells_;
  Surface_info surface_;
};

} // namespace

Extremal_mesh read_graphml(const std::string& file) {
  const std::string text = read_text(file);
  return Graphml_reader(file, text).read();
}

} // namespace CGAL::Extremal_mesh_3
