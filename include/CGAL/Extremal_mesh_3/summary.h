// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_SUMMARY_H
#define CGAL_EXTREMAL_MESH_3_SUMMARY_H

#include <CGAL/Extremal_mesh_3/Extremal_mesh.h>
#include <CGAL/Extremal_mesh_3/check.h>
#include <CGAL/Extremal_mesh_3/extract_extremal_mesh.h>

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

/// What an extremal mesh consists of, counted.
struct Summary {
  std::array<std::size_t, 5> vertices{};             ///< by `Vertex_kind`
  std::array<std::size_t, 4> umbilics{};             ///< by `Umbilic_type`; `none`: not generic
  std::size_t one_ridge = 0;                         ///< umbilics with one line through them
  std::size_t three_ridge = 0;                       ///< umbilics with three
  std::array<std::size_t, 4> edges{};                ///< by `Line_type`
  std::array<std::size_t, 4> type_changes{};         ///< by `Type_change_kind`
  std::map<std::size_t, std::size_t> cells_by_edges; ///< how many cells have so many edges
  double umbilic_index_sum = 0;                      ///< χ on a closed surface
};

/// counts. O(V + E + F).
/// \param mesh  an extremal mesh
/// \return the counts
Summary summarize(const Extremal_mesh& mesh);

/// makes the JSON object that `info --json` and `extract --report` print: the counts, the surface, where it comes from,
/// and the outcome of the checks. A check that does not apply counts as not violated; `details` tells which.
/// \param mesh  an extremal mesh
/// \param checks  by `check(mesh)`
/// \param report  what was met during the extraction, if that is known
/// \return the object as text
std::string to_json(const Extremal_mesh& mesh, const std::vector<Check>& checks,
                    const Extraction_report* report = nullptr);

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_SUMMARY_H
