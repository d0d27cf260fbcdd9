// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_VIEW_VIEW_DATA_H
#define EXTREMAL_MESH_3_SRC_VIEW_VIEW_DATA_H

#include <CGAL/Extremal_mesh_3/view.h>

#include <string>

namespace CGAL::Extremal_mesh_3 {

/// makes the JSON object that viewer/src/data.js reads. No `<` is in it, so that it can stand in a script element.
std::string view_data(const Extremal_mesh& mesh, const Cell_patches& patches, const View_options& options);

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_VIEW_VIEW_DATA_H
