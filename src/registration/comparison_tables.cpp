// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Extremal_mesh_3/compare.h>

#include "../io/json_text.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace CGAL::Extremal_mesh_3 {

std::string to_text(const Comparison& c) {
  std::string text = fmt::format("{:<16} {:>8} {:>8} {:>9} {:>9} {:>8} {:>10} {:>8}\n", "type", "nb1", "nb2",
                                 "matched %", "back %", "chance %", "deviation", "rms");
  for (const Comparison_row& row : c.rows)
    text +=
        fmt::format("{:<16} {:>8} {:>8} {:>9.1f} {:>9.1f} {:>8.1f} {:>10.4g} {:>8.4g}\n", row.type, row.number_a,
                    row.number_b, 100 * row.matched, 100 * row.matched_back, 100 * row.chance, row.deviation, row.rms);
  text += fmt::format("{:<34} {:>9.1f} {:>9.1f}\n", "edges that correspond", 100 * c.edges, 100 * c.edges_back);
  text += fmt::format("{:<34} {:>9.1f} {:>9.1f}\n", "cells that correspond", 100 * c.cells, 100 * c.cells_back);
  text += fmt::format("{:<34} {:>9.1f}\n", "their area", 100 * c.area_of_cells);
  text += fmt::format("{:<34} {:>9.4g}\n", "tolerance", c.tolerance);
  return text;
}

std::string to_csv(const Comparison& c) {
  std::string csv = "type,nb1,nb2,matched_percent,matched_back_percent,chance_percent,deviation,rms\n";
  for (const Comparison_row& row : c.rows)
    csv += fmt::format("{},{},{},{},{},{},{},{}\n", row.type, row.number_a, row.number_b, 100 * row.matched,
                       100 * row.matched_back, 100 * row.chance, row.deviation, row.rms);
  return csv;
}

std::string to_json(const Comparison& c) {
  using Json = nlohmann::ordered_json;
  Json json = {{"tolerance", c.tolerance}, {"rows", Json::array()}};
  for (const Comparison_row& row : c.rows)
    json["rows"].push_back({{"type", row.type},
                            {"nb1", row.number_a},
                            {"nb2", row.number_b},
                            {"matched_percent", 100 * row.matched},
                            {"matched_back_percent", 100 * row.matched_back},
                            {"chance_percent", 100 * row.chance},
                            {"deviation", row.deviation},
                            {"rms", row.rms}});
  json["edges_percent"] = 100 * c.edges;
  json["edges_back_percent"] = 100 * c.edges_back;
  json["cells_percent"] = 100 * c.cells;
  json["cells_back_percent"] = 100 * c.cells_back;
  json["cells_area_percent"] = 100 * c.area_of_cells;
  return json_text(json, 2);
}

} // namespace CGAL::Extremal_mesh_3
