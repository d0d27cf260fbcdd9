// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_IO_CELLS_JSON_H
#define CGAL_EXTREMAL_MESH_3_IO_CELLS_JSON_H

#include "graphml_values.h"

#include <CGAL/Extremal_mesh_3/Extremal_mesh.h>

#include <string_view>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

/// appends a cell as an object on one line:
/// `{"id":0,"sign":1,"area":…,"weight":…,"euler_characteristic":1,"touches_border":false, "boundary":[[half-edges of a
/// walk], …]}`.
/// \throws graphml::Value_error if a number is not finite
void append_json(fmt::memory_buffer& out, const Extremal_mesh_cell& cell, std::size_t id);

/// reads an array of such objects.
/// \throws graphml::Value_error
std::vector<Extremal_mesh_cell> parse_cells(std::string_view json);

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_IO_CELLS_JSON_H
