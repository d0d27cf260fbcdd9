// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_INTERCHANGE_H
#define CGAL_EXTREMAL_MESH_3_INTERCHANGE_H

#include <CGAL/Extremal_mesh_3/Extremal_mesh.h>
#include <CGAL/Extremal_mesh_3/cell_patches.h>
#include <CGAL/Extremal_mesh_3/errors.h>

#include <string>

/// \file
/// Writers for other programs. All files appear whole or not at all, and are the same for the same mesh, byte for byte; all functions
/// throw `Io_error` if the file cannot be written. What only we read, and GraphML, is in io.h.
namespace CGAL::Extremal_mesh_3 {

/// writes the lines as OBJ: a polyline per edge, in one group for each type.
/// \param file  the name of the file to write
/// \param mesh  an extremal mesh
void write_obj(const std::string& file, const Extremal_mesh& mesh);

/// writes the lines as text PLY with an element `edge` per segment: colours, type, family, number of the edge. The points have
/// normals and curvatures.
/// \param file  the name of the file to write
/// \param mesh  an extremal mesh
void write_lines_ply(const std::string& file, const Extremal_mesh& mesh);

/// writes ParaView's XML PolyData: vertices, a polyline per edge and, if there are patches, the surface, with all their attributes.
/// \param file  the name of the file to write
/// \param mesh  an extremal mesh
/// \param patches  the surface cut along its lines, if it is to be shown
/// \throws std::invalid_argument if a patch makes no sense
void write_vtp(const std::string& file, const Extremal_mesh& mesh, const Cell_patches& patches = {});

/// writes glTF 2.0: lines by type, vertices by class and, if there are patches, the surface in the colours of its cells. A file that ends
/// in `.glb` is binary, others are text with the numbers in base64. Positions are rounded to single precision.
/// \param file  the name of the file to write
/// \param mesh  an extremal mesh
/// \param patches  the surface cut along its lines, if it is to be shown
/// \throws std::invalid_argument if a patch makes no sense
void write_gltf(const std::string& file, const Extremal_mesh& mesh, const Cell_patches& patches = {});

/// writes the vertices as a table, a row each.
/// \param file  the name of the file to write
/// \param mesh  an extremal mesh
void write_vertices_csv(const std::string& file, const Extremal_mesh& mesh);
/// writes the edges as a table, a row each; their polylines are not in it.
/// \param file  the name of the file to write
/// \param mesh  an extremal mesh
void write_edges_csv(const std::string& file, const Extremal_mesh& mesh);
/// writes the cells as a table, a row each.
/// \param file  the name of the file to write
/// \param mesh  an extremal mesh
void write_cells_csv(const std::string& file, const Extremal_mesh& mesh);

/// writes all that GraphML holds as one JSON object.
/// \param file  the name of the file to write
/// \param mesh  an extremal mesh
void write_json(const std::string& file, const Extremal_mesh& mesh);

/// writes markups of 3D Slicer: extremal points and umbilics as lists of points, each crest line as a curve.
/// \param file  the name of the file to write
/// \param mesh  an extremal mesh
void write_markups(const std::string& file, const Extremal_mesh& mesh);

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_INTERCHANGE_H
