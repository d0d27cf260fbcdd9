// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The polygonal cells of an implicit surface on a lattice: its values slice by slice, the polygons between slices, then
// smaller cubes where these are too coarse.
#include "Active_cubes.h"
#include "Hidden_parts.h"
#include "Slab_walker.h"
#include "Slices.h"
#include "parallel.h"
#include "prove_surface.h"
#include "refine_folds.h"

#include <CGAL/Extremal_mesh_3/extract_extremal_mesh.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL::Extremal_mesh_3 {

namespace {

/// Room for what is small or thin without end where there is nothing to find, as around poles: some seconds of work.
constexpr std::size_t most_divided = std::size_t(1) << 14;

/// the polygons as the signs at the nodes of the lattice tell them.
/// \param hidden  gets what there is to look at; null: nothing
Woven_cells weave(const Function_3& f, const Lattice& lattice, const Progress& progress, Hidden_parts* hidden,
                  Thread_pool& pool) {
  const Active_cubes active =
      f.bounds_cost() == Bounds_cost::low ? Active_cubes(f, lattice, pool) : Active_cubes(lattice);
  Slab_walker walker(f, lattice, active);
  Slices values(f, lattice, active);
  for (std::size_t first = 0; first < lattice.size[2]; first = values.end()) {
    values.compute_more(pool);
    for (std::size_t k = std::max<std::size_t>(first, 1); k < values.end(); ++k)
      walker.walk(k - 1, values[k - 1], values[k]);
    if (hidden)
      hidden->look(first, values, pool);
    if (progress && !progress(double(values.end()) / double(lattice.size[2])))
      throw Cancelled();
  }
  return std::move(walker.woven);
}

std::string no_surface_text(const Surface_report& report) {
  std::string text = "the function has no zero surface in the box";
  if (report.undecided_cubes != 0) {
    const Point& p = report.first_undecided;
    text += fmt::format(", or only where this cannot be decided, as around ({}, {}, {})", p[0], p[1], p[2]);
  }
  return text;
}

} // namespace

Cell_complex make_implicit_cells(const Function_3& f, const Lattice& lattice, const Extraction_options& options,
                                 Surface_report* report) {
  for (const std::size_t n : lattice.size)
    if (n < 2)
      throw std::invalid_argument("a lattice must have at least 2 nodes along each axis");
  Thread_pool pool(options.threads);

  const bool proves =
      f.bounds_cost() == Bounds_cost::low || (f.bounds_cost() != Bounds_cost::unknown && options.prove_surface);
  Hidden_parts hidden(lattice);
  Woven_cells woven = weave(f, lattice, options.progress, proves ? nullptr : &hidden, pool);
  woven.points.resize(woven.cuts.size());
  pool.for_each(woven.points.size(), 256,
                [&](std::size_t p) { woven.points[p] = surface_point(f, lattice, woven.cuts[p]); });
  Surface_report found;
  Octree tree(lattice.size);
  found.certainty = proves ? Surface_certainty::proved : Surface_certainty::tested;
  if (proves)
    prove_surface(f, lattice, most_divided + woven.cubes.size(), pool, tree, found);
  else
    hidden.divide(f, woven.cubes, pool, tree);
  const Unsettled_cubes unsettled = refine_folds(f, lattice, woven, pool, tree, proves);
  // Folds do not belie a proof, other ways to weave do.
  const std::vector<Grid_cube>& doubtful = proves ? unsettled.ambiguous : unsettled.folded;
  if (!doubtful.empty()) {
    constexpr double unit(Octree::unit);
    const Grid_point& at = doubtful.front().base;
    if (found.undecided_cubes == 0)
      found.first_undecided = lattice.node(double(at[0]) / unit, double(at[1]) / unit, double(at[2]) / unit);
    found.undecided_cubes += doubtful.size();
  }
  for (const Grid_cube& cube : tree.divided_cubes())
    found.divided_cubes += cube.level == 0;
  if (report)
    *report = found;
  if (woven.cubes.empty())
    throw Extraction_error(no_surface_text(found));
  woven.cuts = {};
  woven.cubes = {};
  return make_cell_complex(std::move(woven.points), woven.polygon_begin, woven.corners);
}

} // namespace CGAL::Extremal_mesh_3
