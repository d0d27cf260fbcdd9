// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_IO_H
#define CGAL_EXTREMAL_MESH_3_IO_H

#include <CGAL/Extremal_mesh_3/Extremal_mesh.h>
#include <CGAL/Extremal_mesh_3/cell_patches.h>
#include <CGAL/Extremal_mesh_3/errors.h>
#include <CGAL/Extremal_mesh_3/extract_extremal_mesh.h>

#include <string>

namespace CGAL::Extremal_mesh_3 {

/// tests, before long work, what the writers below will need.
/// \param file  the name of the file to write
/// \throws Io_error with their message if `file` cannot be
/// written
void check_writable(const std::string& file);

/// writes GraphML, the native format: typed keys that NetworkX, igraph and Gephi read, doubles that read back bit for
/// bit. The file appears whole or not at all. Characters of the texts that XML cannot hold become U+FFFD.
/// \param file  the name of the file to write
/// \param mesh  an extremal mesh
/// \throws Io_error, also if a number is not finite
void write_graphml(const std::string& file, const Extremal_mesh& mesh);

/// reads what `write_graphml()` wrote, also if another program such as NetworkX has written it again with further
/// attributes.
/// \param file  the name of the file to read
/// \return the mesh, bit for bit
/// \throws Io_error naming the file, the element and what was expected
Extremal_mesh read_graphml(const std::string& file);

/// writes the cells that are disks as coloured polygons whose corners are the mesh's vertices and polyline points, as OFF.
/// \param file  the name of the file to write
/// \param mesh  an extremal mesh
/// \param colouring  what colours tell
/// \throws Io_error
void write_off(const std::string& file, const Extremal_mesh& mesh, Cell_colouring colouring = Cell_colouring::sign);

/// writes the lines as thin tubes coloured by type, as OFF.
/// \param radius  of the tubes; 0 chooses one from the size of the mesh
/// \param file  the name of the file to write
/// \param mesh  an extremal mesh
/// \throws Io_error
void write_lines_off(const std::string& file, const Extremal_mesh& mesh, double radius = 0);

/// writes the surface cut along the lines, each polygon in the colour of its cell, as OFF.
/// \throws Io_error
///         std::invalid_argument if a polygon is in a cell that the mesh does not have
/// \param file  the name of the file to write
/// \param patches  the surface cut along the lines
/// \param mesh  an extremal mesh
/// \param colouring  what colours tell
void write_off(const std::string& file, const Cell_patches& patches, const Extremal_mesh& mesh,
               Cell_colouring colouring = Cell_colouring::sign);

/// writes the surface cut along the lines as binary PLY: points with normals, polygons with their colour and the number of
/// their cell, a comment with the frame.
/// \throws Io_error
///         std::invalid_argument if a polygon is in a cell that the mesh does not have
/// \param file  the name of the file to write
/// \param patches  the surface cut along the lines
/// \param mesh  an extremal mesh
/// \param colouring  what colours tell
void write_ply(const std::string& file, const Cell_patches& patches, const Extremal_mesh& mesh,
               Cell_colouring colouring = Cell_colouring::sign);

/// reads what `write_ply()` wrote, bit for bit, also if another program has written it again (as text or binary) and
/// kept the normals and the property `cell` of faces. O(size of the file).
/// \param file  the name of the file to read
/// \return the surface cut along the lines
/// \throws Io_error naming the file, the place in it and what was expected
Cell_patches read_cell_patches(const std::string& file);

/// writes a text as a file that appears whole or not at all.
/// \param file  the name of the file to write
/// \param text  its content
/// \throws Io_error
void write_text_file(const std::string& file, const std::string& text);

/// writes a cell complex as OFF, without colours.
/// \param file  the name of the file to write
/// \param cells  the polygons
/// \throws Io_error
void write_off(const std::string& file, const Cell_complex& cells);

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_IO_H
