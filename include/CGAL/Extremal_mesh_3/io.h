// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_IO_H
#define CGAL_EXTREMAL_MESH_3_IO_H

#include <CGAL/Extremal_mesh_3/Extremal_mesh.h>
#include <CGAL/Extremal_mesh_3/errors.h>
#include <CGAL/Extremal_mesh_3/extract_extremal_mesh.h>

#include <string>

namespace CGAL::Extremal_mesh_3 {

/// tests, before long work, what the writers below will need.
/// \throws Io_error with their message if `file` cannot be
/// written
void check_writable(const std::string& file);

/// writes GraphML, the native format: typed keys that NetworkX, igraph and Gephi read, doubles that read back bit for
/// bit. The file appears whole or not at all. Characters of the texts that XML cannot hold become U+FFFD.
/// \throws Io_error, also if a number is not finite
void write_graphml(const std::string& file, const Extremal_mesh& mesh);

/// reads what `write_graphml()` wrote, also if another program such as NetworkX has written it again with further
/// attributes.
/// \throws Io_error naming the file, the element and what was expected
Extremal_mesh read_graphml(const std::string& file);

/// writes the cells that are disks as polygons whose corners are the mesh's vertices and polyline points, coloured by
/// the sign of E_g, as OFF.
/// \throws Io_error
void write_off(const std::string& file, const Extremal_mesh& mesh);

/// writes the lines as thin tubes coloured by type, as OFF.
/// \throws Io_error
/// \param radius  of the tubes; 0 chooses one from the size of the mesh
void write_lines_off(const std::string& file, const Extremal_mesh& mesh, double radius = 0);

/// writes the surface cut along the lines, each polygon coloured by the sign of E_g in its cell, as OFF.
/// \throws Io_error
void write_off(const std::string& file, const Cell_patches& patches, const Extremal_mesh& mesh);

/// writes a text as a file that appears whole or not at all.
/// \throws Io_error
void write_text_file(const std::string& file, const std::string& text);

/// writes a cell complex as OFF, without colours.
/// \throws Io_error
void write_off(const std::string& file, const Cell_complex& cells);

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_IO_H
