// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_EXTRACT_EXTREMAL_MESH_H
#define CGAL_EXTREMAL_MESH_3_EXTRACT_EXTREMAL_MESH_H

#include <CGAL/Extremal_mesh_3/Cell_complex.h>
#include <CGAL/Extremal_mesh_3/Extremal_mesh.h>
#include <CGAL/Extremal_mesh_3/Function_3.h>
#include <CGAL/Extremal_mesh_3/Vertex_shapes.h>
#include <CGAL/Extremal_mesh_3/errors.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

/// How to extract.
struct Extraction_options {
  int threads = 0; ///< 0: as many as the machine has cores. The result does not depend on it.
  /// a cell is divided at most so many times, each time into cells of half the size
  int max_level = 20;
  /// a cell that is known to hold no vertex, but in which the course of the lines is not certain, at most so many times.
  /// With less than `max_level` small closed lines may be missed and lines that nearly touch be joined otherwise, but
  /// no extremal point or umbilic; on noisy images most of the time is saved
  int max_line_level = 20;
  /// prove the shape of the surface although bounds of the function take long: with images. Where they do not, with
  /// formulas, it is always proved
  bool prove_surface = false;
  /// prove by interval arithmetic what cells hold, as far as the function can be bounded (formulas), and report for how many that
  /// succeeds. It changes nothing else, and takes many times as long as the extraction
  bool certify = false;
  /// how far a line may be from its polyline, in the input's unit of length; 0: the lines have a point on each edge of the
  /// divided cells, and as many as that makes. Surfaces that are known at points only have lines with a corner on each edge anyway
  double line_tolerance = 0;
  bool patches = false; ///< also return the surface cut along the lines
  Progress progress;    ///< told how far the work is; may stop it
};

/// How it is known that cells on a lattice have the topology of the surface.
enum class Surface_certainty : std::uint8_t {
  given,  ///< nothing is known: the cells come from elsewhere
  tested, ///< by signs and normals at points: parts that are small against a cube can be missed or joined
  proved  ///< by bounds of the function over all cubes, but for those that are undecided
};

/// What was found out about the surface in the cubes of a lattice.
struct Surface_report {
  Surface_certainty certainty = Surface_certainty::given; ///< how it is known
  /// cubes of the lattice that are divided, because the surface is too fine there for signs at their corners or for
  /// polygons in them; those beside them are, too
  std::size_t divided_cubes = 0;
  /// cubes, most of them parts of cubes of the lattice, in which the proof, or the test, failed to the end: parts of the
  /// surface may be missed or joined there, or the surface touches itself
  std::size_t undecided_cubes = 0;
  Point first_undecided{}; ///< in one of them
};

/// What was met on the way.
struct Extraction_report {
  Surface_report surface;             ///< what is known about the initial cells
  std::size_t surface_points = 0;     ///< vertices of the initial cells
  std::size_t surface_cells = 0;      ///< initial cells
  std::size_t refined_cells = 0;      ///< cells after subdivision
  std::size_t accepted_cells = 0;     ///< cells whose configuration passed every test
  std::size_t uncertain_cells = 0;    ///< cells taken as they were at the finest level, or turned over
  bool certified = false;             ///< proofs were asked for, and the function could be bounded
  std::size_t proved_empty_cells = 0; ///< accepted cells without lines in which it is proved that E_g has no zero
  /// further accepted cells without vertices, with lines or without, in which it is proved that there is no extremal point and no umbilic
  std::size_t proved_vertex_free_cells = 0;
  std::size_t interpolated_points = 0; ///< points that could not be placed on the surface itself
  std::size_t degenerate_cells = 0;    ///< initial cells in which E_g = 0 up to rounding
  /// initial cells with a corner at which no jet could be fitted, or one that contradicts the cells
  std::size_t unknown_cells = 0;
  int rounds = 0;                ///< of subdivision
  std::size_t line_segments = 0; ///< pieces of lines within one cell
  /// those of them that were left straight, or coarser than `line_tolerance`, as the points between could not be placed on the line
  std::size_t straight_segments = 0;
};

/// The surface cut along the extremal lines: polygons, each within one cell of the extremal mesh.
struct Cell_patches {
  std::vector<Point> points;          ///< on the surface
  std::vector<Vector> normals;        ///< of the surface at the points, unit
  std::vector<std::size_t> begin{0};  ///< polygon i has corners[begin[i] … begin[i+1])
  std::vector<std::uint32_t> corners; ///< indices of points, counter-clockwise seen from the normals' side
  std::vector<std::uint32_t> cell;    ///< of each polygon: the cell of the extremal mesh
};

/// The extremal mesh of a surface, and what was met on the way.
struct Extraction {
  Extremal_mesh mesh;       ///< the graph with its cells
  Extraction_report report; ///< what is certain, and what is not
  Cell_patches patches;     ///< empty unless asked for
};

/// makes polygonal cells of the surface `f = 0` on a lattice: in each cube one or more polygons of any number of sides, whose
/// vertices lie on the surface. Their normals point to where `f` is positive. sign(0) is taken as +.
///
/// Cubes that are too coarse for the surface are divided, up to 6 times, into cubes of half the side. Where `f` can be bounded
/// (`Function_3::bounds()`), they are those in which it is not proved that the cells are isotopic to the surface. This proof supposes
/// that `f` is smooth there, and that its signs at nodes are not falsified by rounding; it says nothing about the way in which the surface leaves the
/// lattice or the domain of `f`. Otherwise they are those in which normals differ much, or in which values at nodes make a
/// hidden part of the surface likely.
/// \param report  if given, is filled with what is known about the surface
/// \param f  the function; negative inside, so that normals point outwards
/// \param lattice  where the surface is looked for
/// \param options  threads, subdivision, progress
/// \return a closed oriented 2-manifold but for borders where the surface leaves the lattice, or the domain of `f`
/// \throws Extraction_error if the surface does not meet the lattice
Cell_complex make_implicit_cells(const Function_3& f, const Lattice& lattice, const Extraction_options& options = {},
                                 Surface_report* report = nullptr);

/// extracts the extremal mesh of the surface `f = 0` from cells that lie on it.
/// \param f  the function; negative inside, so that normals point outwards
/// \param cells  polygons whose points lie on the surface, counter-clockwise seen from where `f` is positive
/// \param options  threads, subdivision, progress
/// \return the mesh, and a report of what is certain
/// \throws std::invalid_argument if a point is not finite; Degenerate_surface_error if `E_g = 0` (up to rounding) over most of the surface; Extraction_error if it is not 1e-35 to 1e35 long
Extraction extract_extremal_mesh(const Function_3& f, const Cell_complex& cells,
                                 const Extraction_options& options = {});

/// extracts the extremal mesh of a surface that is known at the points of its cells only. Between them L and C are
/// interpolated in a common frame, by their values and derivatives (exactly where they are quadratic), so that Φ is a polynomial
/// along every edge. Areas in which `E_g = 0` (up to
/// the shapes' errors) or no jet could be fitted are cut out: lines end at their border, in `boundary` vertices.
/// \param shapes  one per point of `cells`, by `fit_vertex_shapes()` or from the caller's own knowledge
/// \throws std::invalid_argument if there are not as many shapes as points, a point or a shape is not finite, or most normals are on the
///         wrong side of the cells
///         Extraction_error if hardly any vertex could be fitted
///         Degenerate_surface_error if `E_g = 0` (up to the shapes' errors) over most of the surface
/// \param cells  an oriented manifold of polygons
/// \param options  threads, subdivision, progress
/// \return the mesh, and a report of what is certain
Extraction extract_extremal_mesh(const Cell_complex& cells, const Vertex_shapes& shapes,
                                 const Extraction_options& options = {});

/// extracts the extremal mesh of the surface `f = 0`: `make_implicit_cells()`, then extraction from these cells.
/// \param f  the function; negative inside, so that normals point outwards
/// \param lattice  where the surface is looked for
/// \param options  threads, subdivision, progress
/// \return the mesh, and a report of what is certain
/// \throws Extraction_error, Degenerate_surface_error as these do
Extraction extract_extremal_mesh(const Function_3& f, const Lattice& lattice, const Extraction_options& options = {});

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_EXTRACT_EXTREMAL_MESH_H
