// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_CELLS_OCTREE_H
#define EXTREMAL_MESH_3_SRC_CELLS_OCTREE_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <unordered_set>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

/// Whole coordinates in which a cube of the lattice has the side `Octree::unit`.
using Grid_point = std::array<std::int64_t, 3>;

/// A cube of the lattice (level 0) or an eighth of one of the level before.
struct Grid_cube {
  Grid_point base{};
  int level = 0;
  /// by level first
  friend auto operator<=>(const Grid_cube& a, const Grid_cube& b) {
    return std::tie(a.level, a.base) <=> std::tie(b.level, b.base);
  }
  friend bool operator==(const Grid_cube& a, const Grid_cube& b) = default;
};

/// mixes whole numbers into a hash.
struct Grid_hash {
  static std::size_t mix(std::size_t h, std::int64_t x) {
    h = (h ^ std::size_t(x)) * 0x9e3779b97f4a7c15ULL;
    return h ^ (h >> 29);
  }
  std::size_t operator()(const Grid_point& p) const { return mix(mix(mix(0, p[0]), p[1]), p[2]); }
  std::size_t operator()(const Grid_cube& c) const { return mix((*this)(c.base), c.level); }
};

/// The cubes of a lattice that are divided, each into eight. Neighbours may differ by any number of levels.
class Octree {
public:
  static constexpr int levels = 6; ///< the finest cubes have level 6
  static constexpr std::int64_t unit = std::int64_t(1) << levels;
  static std::int64_t side(int level) { return unit >> level; }

  explicit Octree(const std::array<std::size_t, 3>& nodes) {
    for (std::size_t a = 0; a < 3; ++a)
      size_[a] = std::int64_t(nodes[a] - 1) * unit;
  }

  bool inside(const Grid_cube& c) const {
    for (std::size_t a = 0; a < 3; ++a)
      if (c.base[a] < 0 || c.base[a] >= size_[a])
        return false;
    return true;
  }
  bool divided(const Grid_cube& c) const { return divided_at_[std::size_t(c.level)] != 0 && divided_.count(c) != 0; }
  /// divides a cube, and the cubes that it lies in.
  void divide(const Grid_cube& c) {
    if (!inside(c) || c.level >= levels || !divided_.insert(c).second)
      return;
    ++divided_at_[std::size_t(c.level)];
    if (c.level > 0)
      divide(ancestor(c, c.level - 1));
  }
  static Grid_cube ancestor(const Grid_cube& c, int level) {
    Grid_cube a{c.base, level};
    for (std::int64_t& x : a.base)
      x &= ~(side(level) - 1);
    return a;
  }
  static Grid_cube child(const Grid_cube& c, unsigned corner) {
    Grid_cube r{c.base, c.level + 1};
    for (std::size_t a = 0; a < 3; ++a)
      r.base[a] += (corner >> a & 1U) * side(r.level);
    return r;
  }
  /// tells whether visit(cube) is true for the cube or one of its size around it, 27 in all, as far as they are inside.
  template <class Visit> bool any_around(const Grid_cube& c, const Visit& visit) const {
    for (int i = 0; i < 27; ++i)
      if (const Grid_cube n = beside(c, i); inside(n) && visit(n))
        return true;
    return false;
  }
  /// the cubes of its size around a cube that are divided: bit `place_beside()` tells of each.
  std::uint32_t divided_around(const Grid_cube& c) const {
    std::uint32_t mask = 0;
    if (divided_at_[std::size_t(c.level)] != 0)
      for (int i = 0; i < 27; ++i)
        mask |= std::uint32_t(divided(beside(c, i))) << i;
    return mask;
  }
  /// the number among the 27 around a cube of one of them
  static int place_beside(const Grid_cube& c, const Grid_cube& n) {
    const std::int64_t s = side(c.level);
    return int((n.base[0] - c.base[0]) / s + 1 + 3 * ((n.base[1] - c.base[1]) / s + 1) +
               9 * ((n.base[2] - c.base[2]) / s + 1));
  }
  /// these cubes.
  std::vector<Grid_cube> around(const Grid_cube& c) const {
    std::vector<Grid_cube> cubes;
    any_around(c, [&](const Grid_cube& n) {
      cubes.push_back(n);
      return false;
    });
    return cubes;
  }
  /// divides larger cubes beside smaller ones, until the levels of neighbours differ by one at most.
  void balance() {
    for (int level = levels - 1; level > 0; --level) {
      std::vector<Grid_cube> cubes;
      for (const Grid_cube& c : divided_)
        if (c.level == level)
          cubes.push_back(c);
      for (const Grid_cube& c : cubes)
        for (const Grid_cube& n : around(c))
          divide(ancestor(n, level - 1));
    }
  }
  const std::unordered_set<Grid_cube, Grid_hash>& divided_cubes() const { return divided_; }

private:
  static Grid_cube beside(const Grid_cube& c, int i) {
    const std::int64_t s = side(c.level);
    return {{c.base[0] + (i % 3 - 1) * s, c.base[1] + (i / 3 % 3 - 1) * s, c.base[2] + (i / 9 - 1) * s}, c.level};
  }

  Grid_point size_{};
  std::unordered_set<Grid_cube, Grid_hash> divided_;
  std::array<std::size_t, levels + 1> divided_at_{}; ///< how many of each level
};

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_CELLS_OCTREE_H
