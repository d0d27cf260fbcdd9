// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What each format of mesh files holds, given the content of a file. Our own readers, as CGAL's tell that a file is wrong but
// not where, take what memory a header asks for, drop the rest of a face at a tab (OBJ) or at the end of the file (PLY) and
// refuse lines of OBJ that they do not know; OpenMesh's lose faces after a comment (OFF), and write where a damaged OM file
// tells them to.
#ifndef EXTREMAL_MESH_3_SRC_POLYGONS_SOUP_READERS_H
#define EXTREMAL_MESH_3_SRC_POLYGONS_SOUP_READERS_H

#include "../cells/Polygon_soup.h"

#include <string_view>

namespace CGAL::Extremal_mesh_3 {

/// Coordinates are finite, and faces' corners are indices of points; there is no other promise.
/// \throws std::runtime_error telling the place and what was expected
Polygon_soup read_off(std::string_view content);
Polygon_soup read_obj(std::string_view content);
Polygon_soup read_ply(std::string_view content);
/// Each triangle has points of its own.
Polygon_soup read_stl(std::string_view content);
Polygon_soup read_om(std::string_view content);

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_POLYGONS_SOUP_READERS_H
