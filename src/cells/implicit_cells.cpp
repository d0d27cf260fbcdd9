// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The polygonal cells of an implicit surface on a lattice: the "weaving" of polygons in marching cubes, without its
// tables. In each face of a cube the cut edges are joined by segments with the + side on their left (seen from outside
// the cube); the segments of the six faces close up to polygons. A face is decided by itself, so both its cubes see the
// same segments.
#include "Hidden_parts.h"
#include "cube.h"
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

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

constexpr int edge_between(int a, int b) {
  for (int e = 0; e < 12; ++e)
    if ((edge_corners[std::size_t(e)][0] == a && edge_corners[std::size_t(e)][1] == b) ||
        (edge_corners[std::size_t(e)][0] == b && edge_corners[std::size_t(e)][1] == a))
      return e;
  return -1;
}

/// Two neighbouring slices of values and what was made of their edges.
class Slab_walker {
public:
  Slab_walker(const Function_3& f, const Lattice& lattice)
      : f_(f), lattice_(lattice), nx_(lattice.size[0]), ny_(lattice.size[1]) {
    for (auto& slice : {&low_, &high_}) {
      slice->x.assign(nx_ * ny_, none);
      slice->y.assign(nx_ * ny_, none);
    }
    z_.assign(nx_ * ny_, none);
    left_handed_ = is_left_handed(lattice);
  }

  /// makes the polygons between slices k and k + 1, given the values on both.
  void walk(std::size_t k, const double* low, const double* high) {
    k_ = k;
    values_ = {low, high};
    for (std::size_t j = 0; j + 1 < ny_; ++j) {
      const std::array<const double*, 4> rows{low + j * nx_, low + (j + 1) * nx_, high + j * nx_, high + (j + 1) * nx_};
      const auto column = [&](std::size_t i) {
        return unsigned(rows[0][i] >= 0) | unsigned(rows[1][i] >= 0) << 1 | unsigned(rows[2][i] >= 0) << 2 |
               unsigned(rows[3][i] >= 0) << 3;
      };
      unsigned here = column(0);
      for (std::size_t i = 0; i + 1 < nx_; ++i) {
        const unsigned next = column(i + 1);
        if (here != next || (here != 0 && here != 15))
          cube(i, j);
        here = next;
      }
    }
    std::swap(low_, high_);
    std::fill(high_.x.begin(), high_.x.end(), none);
    std::fill(high_.y.begin(), high_.y.end(), none);
    std::fill(z_.begin(), z_.end(), none);
  }

  Woven_cells woven;

private:
  struct Slice {
    std::vector<std::uint32_t> x, y; // the point on the lattice edge from node (i, j) along x, along y
  };

  void cube(std::size_t i, std::size_t j) {
    std::array<double, 8> value;
    for (unsigned c = 0; c < 8; ++c) {
      value[c] = values_[c >> 2][(i + (c & 1)) + nx_ * (j + (c >> 1 & 1))];
      if (!std::isfinite(value[c]))
        return; // outside the domain: the surface has a border here
    }
    std::array<int, 12> next;
    next.fill(-1);
    for (const auto& face : face_corners)
      join(face, value, i, j, next);
    std::array<bool, 12> used{};
    for (int e = 0; e < 12; ++e) {
      if (next[std::size_t(e)] < 0 || used[std::size_t(e)])
        continue;
      const std::size_t first = woven.corners.size();
      for (int g = e; !used[std::size_t(g)]; g = next[std::size_t(g)]) {
        used[std::size_t(g)] = true;
        woven.corners.push_back(point_on(g, i, j, value));
      }
      if (left_handed_)
        std::reverse(woven.corners.begin() + std::ptrdiff_t(first), woven.corners.end());
      woven.polygon_begin.push_back(woven.corners.size());
      woven.cubes.push_back(
          {{std::int64_t(i) * Octree::unit, std::int64_t(j) * Octree::unit, std::int64_t(k_) * Octree::unit}, 0});
    }
  }

  /// joins the cut edges of one face: next[e] is the edge to which the segment from e leads.
  void join(const std::array<int, 4>& face, const std::array<double, 8>& value, std::size_t i, std::size_t j,
            std::array<int, 12>& next) const {
    std::array<bool, 4> plus;
    for (std::size_t c = 0; c < 4; ++c)
      plus[c] = value[std::size_t(face[c])] >= 0;
    const bool ambiguous = plus[0] == plus[2] && plus[1] == plus[3] && plus[0] != plus[1];
    const bool joined = ambiguous && plus_corners_joined(face, value, i, j);
    for (std::size_t c = 0; c < 4; ++c) {
      const std::size_t d = (c + 1) % 4;
      if (!plus[c] || plus[d])
        continue;
      // A + run ends on this side. Its segment leads to where that run began, or, if the two + runs are joined
      // through the middle of the face, to where the next one begins.
      std::size_t s = joined ? d : c;
      if (joined)
        while (!(plus[(s + 1) % 4] && !plus[s]))
          s = (s + 1) % 4;
      else
        while (!(plus[s] && !plus[(s + 3) % 4]))
          s = (s + 3) % 4;
      const std::size_t from = joined ? s : (s + 3) % 4;
      next[std::size_t(edge_between(face[c], face[d]))] = edge_between(face[from], face[(from + 1) % 4]);
    }
  }

  bool plus_corners_joined(const std::array<int, 4>& face, const std::array<double, 8>& value, std::size_t i,
                           std::size_t j) const {
    // In an order that does not depend on the cube from which the face is seen.
    std::array<int, 4> c = face;
    std::sort(c.begin(), c.end());
    const auto offset = [](int corner) {
      return std::array<double, 3>{double(corner & 1), double(corner >> 1 & 1), double(corner >> 2 & 1)};
    };
    const auto first = offset(c[0]);
    return CGAL::Extremal_mesh_3::plus_corners_joined(
        f_, lattice_,
        {value[std::size_t(c[0])], value[std::size_t(c[1])], value[std::size_t(c[2])], value[std::size_t(c[3])]},
        {double(i) + first[0], double(j) + first[1], double(k_) + first[2]}, offset(c[1] - c[0]), offset(c[2] - c[0]));
  }

  std::uint32_t point_on(int edge, std::size_t i, std::size_t j, const std::array<double, 8>& value) {
    const auto [a, b] = edge_corners[std::size_t(edge)];
    const std::size_t axis = std::size_t(edge) / 4;
    const std::size_t ia = i + std::size_t(a & 1), ja = j + std::size_t(a >> 1 & 1);
    Slice& slice = a >> 2 ? high_ : low_;
    std::uint32_t& id = (axis == 0 ? slice.x : axis == 1 ? slice.y : z_)[ia + nx_ * ja];
    if (id == none) {
      id = std::uint32_t(woven.cuts.size());
      woven.cuts.push_back({{double(ia), double(ja), double(k_ + std::size_t(a >> 2))},
                            axis,
                            1,
                            value[std::size_t(a)],
                            value[std::size_t(b)]});
    }
    return id;
  }

  const Function_3& f_;
  const Lattice& lattice_;
  std::size_t nx_, ny_, k_ = 0;
  bool left_handed_ = false;
  std::array<const double*, 2> values_{};
  Slice low_, high_;
  std::vector<std::uint32_t> z_;
};

/// Room for what is small or thin without end where there is nothing to find, as around poles: some seconds of work.
constexpr std::size_t most_divided = std::size_t(1) << 14;

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

  // Values are computed for a block of slices at a time, then the block is walked in order.
  const std::size_t nodes = lattice.size[0] * lattice.size[1], slices = lattice.size[2];
  const std::size_t block = std::clamp<std::size_t>((std::size_t(1) << 21) / nodes, 2, 16);
  std::vector<double> values((block + 1) * nodes); // slice 0 is the last one of the block before
  const bool proves =
      f.bounds_cost() == Bounds_cost::low || (f.bounds_cost() != Bounds_cost::unknown && options.prove_surface);
  Slab_walker walker(f, lattice);
  Hidden_parts hidden(lattice);
  for (std::size_t first = 0; first < slices; first += block) {
    const std::size_t count = std::min(block, slices - first);
    pool.for_each(count, 1,
                  [&](std::size_t s) { f.lattice_values(lattice, first + s, values.data() + (s + 1) * nodes); });
    for (std::size_t s = 0; !proves && s < count; ++s)
      hidden.add_slice(values.data() + (s + 1) * nodes);
    for (std::size_t s = first == 0 ? 1 : 0; s < count; ++s)
      walker.walk(first + s - 1, values.data() + s * nodes, values.data() + (s + 1) * nodes);
    std::copy_n(values.begin() + std::ptrdiff_t(count * nodes), nodes, values.begin());
    if (options.progress && !options.progress(double(first + count) / double(slices)))
      throw Cancelled();
  }
  Woven_cells& woven = walker.woven;
  woven.points.resize(woven.cuts.size());
  pool.for_each(woven.points.size(), 256,
                [&](std::size_t p) { woven.points[p] = surface_point(f, lattice, woven.cuts[p]); });
  Surface_report found;
  Octree tree(lattice.size);
  found.certainty = proves ? Surface_certainty::proved : Surface_certainty::tested;
  if (proves)
    prove_surface(f, lattice, most_divided + woven.cubes.size(), pool, tree, found);
  else {
    hidden.end_slices();
    hidden.divide(f, woven.cubes, pool, tree);
  }
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
  return make_cell_complex(std::move(woven.points), woven.polygon_begin, woven.corners);
}

} // namespace CGAL::Extremal_mesh_3
