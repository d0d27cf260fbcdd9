// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cells_json.h"

#include "json_text.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdint>
#include <limits>

namespace CGAL::Extremal_mesh_3 {

namespace {

using nlohmann::json;

/// JSON readers take "-0" for the integer 0.
void append_number(fmt::memory_buffer& out, double value) {
  graphml::append(out, value);
  if (value == 0 && std::signbit(value))
    out.append(std::string_view(".0"));
}

int integer(const json& object, const char* key, std::size_t c) {
  const json& value = object.at(key);
  using Limits = std::numeric_limits<int>;
  const bool fits = value.is_number_unsigned()  ? value.get<std::uint64_t>() <= std::uint64_t(Limits::max())
                    : value.is_number_integer() ? value.get<std::int64_t>() >= Limits::min()
                                                : false;
  if (!fits)
    throw graphml::Value_error(fmt::format("cell {}: its {} is '{}'; expected an integer", c, key, json_text(value)));
  return value.get<int>();
}

Extremal_mesh_cell cell_of(const json& object, std::size_t c) {
  if (!object.is_object())
    throw graphml::Value_error(fmt::format("cell {} is not a JSON object", c));
  if (const json& id = object.at("id"); !id.is_number_unsigned() || id.get<std::uint64_t>() != c)
    throw graphml::Value_error(fmt::format("cell {} has id {}; ids must be 0, 1, 2, …", c, json_text(id)));
  Extremal_mesh_cell cell;
  cell.sign = integer(object, "sign", c);
  cell.area = object.at("area").get<double>();
  cell.weight = object.at("weight").get<double>();
  cell.euler_characteristic = integer(object, "euler_characteristic", c);
  cell.touches_border = object.at("touches_border").get<bool>();
  for (const json& walk : object.at("boundary")) {
    std::vector<Half_edge>& half_edges = cell.boundary.emplace_back();
    for (const json& h : walk) {
      if (!h.is_number_unsigned() || h.get<std::uint64_t>() > std::numeric_limits<Half_edge>::max())
        throw graphml::Value_error(fmt::format("cell {}: '{}' is not the number of a half-edge", c, json_text(h)));
      half_edges.push_back(h.get<Half_edge>());
    }
  }
  return cell;
}

} // namespace

void append_json(fmt::memory_buffer& out, const Extremal_mesh_cell& cell, std::size_t id) {
  const auto to = std::back_inserter(out);
  fmt::format_to(to, R"({{"id":{},"sign":{},"area":)", id, cell.sign);
  append_number(out, cell.area);
  fmt::format_to(to, R"(,"weight":)");
  append_number(out, cell.weight);
  fmt::format_to(to, R"(,"euler_characteristic":{},"touches_border":{},"boundary":[)", cell.euler_characteristic,
                 cell.touches_border);
  for (std::size_t walk = 0; walk < cell.boundary.size(); ++walk)
    fmt::format_to(to, "{}[{}]", walk == 0 ? "" : ",", fmt::join(cell.boundary[walk], ","));
  fmt::format_to(to, "]}}");
}

std::vector<Extremal_mesh_cell> parse_cells(std::string_view text) {
  std::vector<Extremal_mesh_cell> cells;
  // Each cell is taken as soon as its object is complete, and thrown away: the array as a whole would need several
  // times the memory of the cells.
  const auto take_cell = [&](int depth, json::parse_event_t event, json& value) {
    if (event == json::parse_event_t::value && depth == 1)
      throw graphml::Value_error(fmt::format("cell {} is not a JSON object", cells.size()));
    if (depth != 1 || event != json::parse_event_t::object_end)
      return true;
    cells.push_back(cell_of(value, cells.size()));
    return false;
  };
  try {
    if (!json::parse(text, take_cell).is_array())
      throw graphml::Value_error("it is not a JSON array");
  } catch (const json::exception& error) {
    throw graphml::Value_error(fmt::format("it is not the JSON of cells, at cell {}: {}", cells.size(), error.what()));
  }
  return cells;
}

} // namespace CGAL::Extremal_mesh_3
