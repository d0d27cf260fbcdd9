// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Extremal_mesh_3/check.h>

#include "checks.h"

#include <algorithm>

namespace CGAL::Extremal_mesh_3 {

std::vector<Check> check(const Extremal_mesh& mesh) {
  return {check_stars(mesh),       check_walks(mesh),
          check_geometry(mesh),    check_degrees(mesh),
          check_families(mesh),    check_umbilics(mesh),
          check_winding(mesh),     check_alternation(mesh),
          check_cells(mesh),       check_euler(mesh),
          check_faces(mesh),       check_umbilic_index(mesh),
          check_field_index(mesh), check_even_extremal_points(mesh),
          check_border(mesh),      check_border_parity(mesh),
          check_type_changes(mesh)};
}

bool all_hold(const std::vector<Check>& checks) {
  return std::all_of(checks.begin(), checks.end(), [](const Check& c) { return !c.applies || c.holds; });
}

} // namespace CGAL::Extremal_mesh_3
