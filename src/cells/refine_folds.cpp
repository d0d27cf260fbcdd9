// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "refine_folds.h"

#include "../differential/vector.h"
#include "Octree_weaver.h"

#include <CGAL/Extremal_mesh_3/Cell_complex.h>

#include <algorithm>
#include <cmath>
#include <unordered_set>

namespace CGAL::Extremal_mesh_3 {

namespace {

/// Normals around a polygon may differ from their mean by so much (cos 75°)…
constexpr double least_normal_cosine = 0.26;
/// … the polygon's own normal by so much (cos 75°), unless it is a sliver …
constexpr double least_facing_cosine = 0.26;
/// … and only if they differ by more than this (cos 45°) is its middle looked at.
constexpr double plain_normal_cosine = 0.7;
/// More folds than this and one per cell are no surface that could be followed, but something like a pole.
constexpr std::size_t most_folded = std::size_t(1) << 14;

/// Cubes, in order, of which it is soon known whether one is among them.
class Cube_set {
public:
  explicit Cube_set(const Lattice& lattice) : rows_(lattice.size[1]), has_in_row_(rows_ * lattice.size[2], 0) {}
  /// \param c  a cube of the lattice
  void insert(const Grid_cube& c) {
    if (!known_.insert(c).second)
      return;
    cubes_.push_back(c);
    has_in_row_[row_of(c)] = 1;
  }
  void sort() { std::sort(cubes_.begin(), cubes_.end()); }
  bool has(const Grid_cube& c) const {
    return c.base[1] >= 0 && c.base[2] >= 0 && has_in_row_[row_of(c)] && known_.count(c) != 0;
  }
  auto begin() const { return cubes_.begin(); }
  auto end() const { return cubes_.end(); }

private:
  std::size_t row_of(const Grid_cube& c) const {
    return std::size_t(c.base[1] / Octree::unit) + rows_ * std::size_t(c.base[2] / Octree::unit);
  }

  std::vector<Grid_cube> cubes_;
  std::unordered_set<Grid_cube, Grid_hash> known_;
  std::size_t rows_;
  std::vector<char> has_in_row_; ///< most rows have none: there is nothing to look up
};

class Folds {
public:
  Folds(const Function_3& f, const Lattice& lattice, Woven_cells& cells, Thread_pool& pool, Octree& tree,
        bool keeps_balance)
      : f_(f), lattice_(lattice), coarse_(cells), pool_(pool), tree_(tree), keeps_balance_(keeps_balance) {}

  Unsettled_cubes refine() {
    add_normals();
    if (!tree_.divided_cubes().empty()) {
      weave();
      add_normals();
    }
    std::vector<Grid_cube> folded = folded_cubes();
    // Ambiguous cubes are divided along with the folds, and on after them.
    for (int round = 0; round < 2 * Octree::levels && folded.size() <= most_folded + coarse_.cubes.size(); ++round) {
      const std::size_t before = tree_.divided_cubes().size();
      if (round < Octree::levels)
        divide(folded, round == 0);
      for (const Grid_cube& c : ambiguous_)
        tree_.divide(c);
      if (keeps_balance_)
        tree_.balance();
      if (tree_.divided_cubes().size() == before)
        break;
      weave();
      add_normals();
      folded = folded_cubes();
    }
    if (is_woven_anew_) {
      drop_unused_points();
      coarse_ = std::move(woven_);
    }
    return {std::move(folded), std::move(ambiguous_)};
  }

private:
  /// what there is now.
  const Woven_cells& current() const { return is_woven_anew_ ? woven_ : coarse_; }

  void add_normals() {
    const std::size_t first = normals_.size();
    normals_.resize(current().points.size());
    pool_.for_each(normals_.size() - first, 128, [&](std::size_t i) {
      Derivatives d;
      f_.derivatives(current().points[first + i], 1, d);
      normals_[first + i] = (1 / norm(d.gradient)) * d.gradient;
    });
  }

  bool is_folded(std::size_t polygon) const {
    const std::size_t begin = current().polygon_begin[polygon], end = current().polygon_begin[polygon + 1];
    const double share = 1 / double(end - begin);
    Point middle{};
    Vector n{}, area{};
    for (std::size_t i = begin; i < end; ++i) {
      middle = middle + share * current().points[current().corners[i]];
      n = n + share * normals_[current().corners[i]];
    }
    const double length = norm(n);
    if (!(length > least_normal_cosine))
      return true;
    double worst = 1, radius = 0;
    for (std::size_t i = begin; i < end; ++i) {
      const Point& p = current().points[current().corners[i]];
      const Point& q = current().points[current().corners[i + 1 < end ? i + 1 : begin]];
      worst = std::min(worst, dot(normals_[current().corners[i]], n) / length);
      radius = std::max(radius, distance(p, middle));
      area = area + 0.5 * cross(p - middle, q - middle);
    }
    if (worst > plain_normal_cosine)
      return false;
    constexpr double sliver = 0.05; // of the square of the radius: its own normal means nothing
    return worst < least_normal_cosine ||
           (norm(area) > sliver * radius * radius && dot(area, n) < least_facing_cosine * norm(area) * length) ||
           !project(f_, middle, (1 / length) * n, radius);
  }

  std::vector<Grid_cube> folded_cubes() {
    std::vector<char> folded(current().cubes.size());
    pool_.for_each(folded.size(), 128, [&](std::size_t i) { folded[i] = is_folded(i); });
    std::vector<Grid_cube> cubes;
    for (std::size_t i = 0; i < folded.size(); ++i)
      if (folded[i])
        cubes.push_back(current().cubes[i]);
    return cubes;
  }

  /// divides cubes, at first twice, and those that share a face with them.
  void divide(const std::vector<Grid_cube>& cubes, bool twice) {
    for (const Grid_cube& c : cubes) {
      if (c.level == Octree::levels)
        continue;
      for (std::size_t a = 0; a < 3; ++a)
        for (const std::int64_t by : {-Octree::side(c.level), std::int64_t(0), Octree::side(c.level)}) {
          Grid_cube n = c;
          n.base[a] += by;
          tree_.divide(n);
        }
      if (twice)
        for (unsigned k = 0; k < 8; ++k)
          tree_.divide(Octree::child(c, k));
    }
  }

  /// the cubes of the lattice that are divided or touch a divided one.
  Cube_set cubes_to_weave() const {
    Cube_set result(lattice_);
    for (const Grid_cube& c : tree_.divided_cubes())
      if (c.level == 0)
        for (const Grid_cube& n : tree_.around(c))
          result.insert(n);
    result.sort();
    return result;
  }

  void weave() {
    const Cube_set cubes = cubes_to_weave();
    Octree_weaver weaver(f_, lattice_, tree_);
    give_values(cubes, weaver);
    give_points(cubes, weaver);
    for (const Grid_cube& c : cubes)
      weaver.weave(c);
    ambiguous_ = std::move(weaver.ambiguous_cubes);
    take(cubes, weaver);
  }

  /// puts together the coarse cells outside of the woven cubes and those that the weaver made.
  void take(const Cube_set& cubes, const Octree_weaver& weaver) {
    is_woven_anew_ = true;
    woven_ = {};
    woven_.points.reserve(coarse_.points.size() + weaver.new_cut_edges.size());
    woven_.points = coarse_.points;
    woven_.corners.reserve(coarse_.corners.size() + weaver.corners.size());
    woven_.polygon_begin.reserve(coarse_.polygon_begin.size() + weaver.polygon_cubes.size());
    woven_.cubes.reserve(coarse_.cubes.size() + weaver.polygon_cubes.size());
    normals_.resize(coarse_.points.size());
    for (std::size_t i = 0; i < coarse_.cubes.size(); ++i) {
      if (cubes.has(coarse_.cubes[i]))
        continue;
      woven_.corners.insert(woven_.corners.end(), coarse_.corners.begin() + std::ptrdiff_t(coarse_.polygon_begin[i]),
                            coarse_.corners.begin() + std::ptrdiff_t(coarse_.polygon_begin[i + 1]));
      woven_.polygon_begin.push_back(woven_.corners.size());
      woven_.cubes.push_back(coarse_.cubes[i]);
    }
    const std::size_t offset = woven_.corners.size();
    woven_.corners.insert(woven_.corners.end(), weaver.corners.begin(), weaver.corners.end());
    for (std::size_t i = 0; i < weaver.polygon_cubes.size(); ++i)
      woven_.polygon_begin.push_back(offset + weaver.polygon_begin[i + 1]);
    woven_.cubes.insert(woven_.cubes.end(), weaver.polygon_cubes.begin(), weaver.polygon_cubes.end());
    const std::size_t first = coarse_.points.size();
    woven_.points.resize(first + weaver.new_cut_edges.size());
    pool_.for_each(weaver.new_cut_edges.size(), 64, [&](std::size_t i) {
      woven_.points[first + i] = surface_point(f_, lattice_, weaver.new_cut_edges[i]);
    });
  }

  static bool touches(const Cube_set& cubes, const Grid_point& base, std::size_t axis) {
    for (int i = 1; i < 4; ++i) {
      Grid_cube c{base, 0};
      c.base[(axis + 1) % 3] -= i & 1 ? Octree::unit : 0;
      c.base[(axis + 2) % 3] -= i & 2 ? Octree::unit : 0;
      if (cubes.has(c))
        return true;
    }
    return false;
  }

  void give_points(const Cube_set& cubes, Octree_weaver& weaver) const {
    for (std::uint32_t p = 0; p < coarse_.cuts.size(); ++p) {
      const Cut_edge& cut = coarse_.cuts[p];
      Grid_point base;
      for (std::size_t a = 0; a < 3; ++a)
        base[a] = std::int64_t(cut.node[a]) * Octree::unit;
      if (cubes.has({base, 0}) || touches(cubes, base, cut.axis))
        weaver.set_point(base, cut.axis, p);
    }
    weaver.set_first_new_point(std::uint32_t(coarse_.points.size()));
  }

  /// At the nodes of the lattice the weaver must see the values that the lattice was woven with.
  void give_values(const Cube_set& cubes, Octree_weaver& weaver) const {
    std::vector<Grid_point> nodes;
    for (const Grid_cube& c : cubes)
      for (unsigned k = 0; k < 8; ++k)
        nodes.push_back({c.base[2] / Octree::unit + (k >> 2 & 1U), c.base[1] / Octree::unit + (k >> 1 & 1U),
                         c.base[0] / Octree::unit + (k & 1U)}); // z first: sorted by slices
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    std::vector<double> slice(lattice_.size[0] * lattice_.size[1]);
    std::int64_t k = -1;
    for (const auto& [z, y, x] : nodes) {
      if (z != k)
        f_.lattice_values(lattice_, std::size_t(k = z), slice.data());
      weaver.set_value({x * Octree::unit, y * Octree::unit, z * Octree::unit},
                       slice[std::size_t(x) + lattice_.size[0] * std::size_t(y)]);
    }
  }

  void drop_unused_points() {
    std::vector<std::uint32_t> number(woven_.points.size(), 0);
    for (const std::uint32_t c : woven_.corners)
      number[c] = 1;
    std::uint32_t kept = 0;
    for (std::size_t p = 0; p < number.size(); ++p)
      if (number[p]) {
        woven_.points[kept] = woven_.points[p];
        number[p] = kept++;
      }
    woven_.points.resize(kept);
    for (std::uint32_t& c : woven_.corners)
      c = number[c];
  }

  const Function_3& f_;
  const Lattice& lattice_;
  Woven_cells& coarse_;
  Thread_pool& pool_;
  Octree& tree_;
  bool keeps_balance_;
  std::vector<Grid_cube> ambiguous_; ///< of the last weaving
  bool is_woven_anew_ = false;
  Woven_cells woven_;           ///< then
  std::vector<Vector> normals_; ///< of the current points
};

} // namespace

Unsettled_cubes refine_folds(const Function_3& f, const Lattice& lattice, Woven_cells& cells, Thread_pool& pool,
                             Octree& tree, bool keeps_balance) {
  return Folds(f, lattice, cells, pool, tree, keeps_balance).refine();
}

} // namespace CGAL::Extremal_mesh_3
