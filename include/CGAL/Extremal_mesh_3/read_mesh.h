// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_READ_MESH_H
#define CGAL_EXTREMAL_MESH_3_READ_MESH_H

#include <CGAL/Extremal_mesh_3/Cell_complex.h>
#include <CGAL/Extremal_mesh_3/errors.h>

#include <cstddef>
#include <optional>
#include <string>

namespace CGAL::Extremal_mesh_3 {

/// How to read a polygon mesh.
struct Mesh_reading_options {
  /// vertices that are no farther from each other than this length become one. 0: only those at the very same place. By
  /// default 0, but for STL, which stores each vertex once per triangle: two units in the last place of the largest
  /// coordinate as a float
  std::optional<double> weld_tolerance;
};

/// What had to be done to the vertices and faces of a file to make an oriented manifold of them, in the order in which it
/// is done.
struct Mesh_repairs {
  std::size_t isolated_vertices = 0; ///< dropped, as no face has them
  std::size_t welded_vertices = 0;   ///< became one with another, beyond what STL needs always
  std::size_t degenerate_faces = 0;  ///< with a vertex more than once: dropped, or divided there
  std::size_t duplicate_faces = 0;   ///< dropped, as another one has the same vertices in the same order or its reverse
  std::size_t non_manifold_edges = 0;    ///< with three or more faces, which were separated there
  std::size_t non_manifold_vertices = 0; ///< split, as the faces around them formed several fans, perhaps after that
  std::size_t flat_faces = 0;            ///< triangles without area, taken into the neighbour at their longest side
  /// reversed: to be oriented like their neighbours, or a whole component so that its normals point outwards if it is
  /// closed, and as most of its faces had it otherwise
  std::size_t turned_faces = 0;

  /// \return whether there was anything to repair
  bool any() const;
};

/// tells the repairs in one line: "repaired: 3 isolated vertices dropped, 2 faces turned". Empty if there were none.
/// \param repairs  what was done
/// \return one line without an end of line
std::string to_string(const Mesh_repairs& repairs);

/// A mesh from a file.
struct Mesh {
  Cell_complex cells;   ///< its coordinates are the file's, its normals point outwards where the surface is closed
  Mesh_repairs repairs; ///< what had to be done to them
};

/// whether the extension of the file's name, in upper or lower case, is one that `read_mesh()` knows.
/// \param file  a name
/// \return whether it can be given to `read_mesh()`
bool is_mesh_file(const std::string& file);

/// reads a polygon mesh: OFF (also with colours, normals and texture coordinates), OBJ, PLY (text and binary of both
/// byte orders), STL (text and binary) or OpenMesh's OM, by the extension of its name. Faces may have up to 65536
/// sides. What is wrong with the mesh is repaired where that is safe.
/// \throws Io_error naming the file, the place in it and what was expected: also if no face is left
///         std::invalid_argument if the tolerance is negative, not finite, or more than a hundredth of the mesh's size
/// O(n log n). A header that lies about the content takes no memory.
/// \param file  the name of the file to read
/// \param options  which vertices become one
/// \return the polygons, and what was repaired in them
Mesh read_mesh(const std::string& file, const Mesh_reading_options& options = {});

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_READ_MESH_H
