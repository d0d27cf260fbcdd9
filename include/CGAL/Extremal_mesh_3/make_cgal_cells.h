// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_MAKE_CGAL_CELLS_H
#define CGAL_EXTREMAL_MESH_3_MAKE_CGAL_CELLS_H

#include <CGAL/Extremal_mesh_3/Cell_complex.h>
#include <CGAL/Extremal_mesh_3/Function_3.h>

#include <cstddef>

namespace CGAL::Extremal_mesh_3 {

/// How CGAL's mesher is to mesh a surface.
struct Cgal_mesh_options {
  double angle = 30; ///< least angle of the triangles, in degrees. With more than 30 the mesher may not come to an end
  double radius = 0; ///< greatest radius of a ball around a triangle, a length. 0: the longest step of the lattice
  double distance =
      0; ///< greatest distance of a triangle's circumcentre from the surface, a length. 0: a tenth of `radius`
  /// with more the work is given up. 0: 100 times what is to be expected of the lattice's cells and `radius`
  std::size_t max_points = 0;
  int threads = 0;   ///< for the lattice, by which components are found. The mesher has one thread
  Progress progress; ///< by the points expected: may stay near the end for a while
};

/// makes triangles of the surface `f = 0` with CGAL's surface mesher: a Delaunay triangulation restricted to the surface, whose
/// triangles are of good shape, and smaller where the surface bends more. Their vertices lie on the surface up to rounding, and they
/// are counter-clockwise seen from where `f` is positive.
/// \param lattice  the surface is meshed within its box; all components are found that `make_implicit_cells()` finds on it
/// \return a closed oriented 2-manifold but for borders where the surface leaves the box, or the domain of `f`
/// \throws std::invalid_argument if an option is out of its range
///         Extraction_error if the surface does not meet the lattice, or the triangles do not follow it because they are too large,
///         or the mesher does not come to an end
/// The same in every call. CGAL's handler of errors is replaced meanwhile; calls from several threads wait for each other.
/// \param f  the function; negative inside, so that normals point outwards
/// \param options  sizes and angles of the triangles
Cell_complex make_cgal_cells(const Function_3& f, const Lattice& lattice, const Cgal_mesh_options& options = {});

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_MAKE_CGAL_CELLS_H
