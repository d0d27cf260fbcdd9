// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_VIEW_VIEWER_H
#define EXTREMAL_MESH_3_SRC_VIEW_VIEWER_H

#include <string_view>

namespace CGAL::Extremal_mesh_3 {

/// viewer/page.html: the page up to its data.
extern const std::string_view viewer_page;
/// viewer/dist/viewer.js: the script that shows them.
extern const std::string_view viewer_script;

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_VIEW_VIEWER_H
