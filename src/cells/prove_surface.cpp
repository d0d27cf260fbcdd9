// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Both conditions of the proof pass on to the parts of a box, so that one test may do for a large block of the lattice;
// only near what bends much are single cubes looked at.
#include "prove_surface.h"

#include "cube.h"

#include "../functions/sharp_bounds.h"

#include <CGAL/Extremal_mesh_3/internal/interval_arithmetic.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace CGAL::Extremal_mesh_3 {

namespace {

/// A block of cubes of the lattice, a cube, or a part of one.
struct Block {
  Grid_point base{};
  std::int64_t side = 0;
};

/// Blocks of at most so many cubes across are looked at again, with bounds by mean values, before they are divided:
/// those of larger ones are hardly better.
constexpr std::int64_t sharply_tested = 4 * Octree::unit;

bool has_no_zero(const Interval& value) {
  return !value.contains(0); // nor is there a surface where f is not defined
}

class Prover {
public:
  Prover(const Function_3& f, const Lattice& lattice) : f_(f), lattice_(lattice) {
    for (std::size_t a = 0; a < 3; ++a)
      size_[a] = std::int64_t(lattice.size[a] - 1) * Octree::unit;
  }

  Block whole() const {
    Block b{{}, Octree::unit};
    while (b.side < *std::max_element(size_.begin(), size_.end()))
      b.side *= 2;
    return b;
  }

  /// the eighths of a block, as far as they are in the lattice.
  void add_parts(const Block& b, std::vector<Block>& parts) const {
    for (unsigned corner = 0; corner < 8; ++corner) {
      Block part{b.base, b.side / 2};
      bool inside = true;
      for (std::size_t a = 0; a < 3; ++a) {
        part.base[a] += (corner >> a & 1U) * part.side;
        inside = inside && part.base[a] < size_[a];
      }
      if (inside)
        parts.push_back(part);
    }
  }

  /// tells whether one of the two conditions is proved to hold.
  bool is_proved(const Block& b) const {
    const Box_3 box = box_of(b);
    Derivative_bounds d;
    f_.bounds(box, 1, d);
    if (has_no_zero(d.value) || keeps_direction(d.gradient))
      return true;
    if (b.side > sharply_tested)
      return false;
    internal::sharp_bounds(f_, box, 1, d);
    if (has_no_zero(d.value) || keeps_direction(d.gradient))
      return true;
    // The cells change where a cube of the lattice is divided: not for the sake of loose bounds.
    return b.side == Octree::unit && is_proved_by_parts(b);
  }

  /// The cells have a border where f is not defined.
  bool is_outside_domain(const Block& b) const {
    for (unsigned corner = 0; corner < 8; ++corner) {
      const Point p = node({b.base[0] + (corner & 1U) * b.side, b.base[1] + (corner >> 1 & 1U) * b.side,
                            b.base[2] + (corner >> 2 & 1U) * b.side});
      if (!std::isfinite(f_.value(p)))
        return true;
    }
    return false;
  }

  Point middle_of(const Block& b) const {
    return node({b.base[0] + b.side / 2, b.base[1] + b.side / 2, b.base[2] + b.side / 2});
  }

private:
  Point node(const Grid_point& p) const {
    constexpr double unit(Octree::unit);
    return lattice_.node(double(p[0]) / unit, double(p[1]) / unit, double(p[2]) / unit);
  }

  /// the axis-parallel box around a block's corners, as far as they are in the lattice.
  Box_3 box_of(const Block& b) const {
    constexpr double unit(Octree::unit);
    std::array<double, 3> low, high;
    for (std::size_t a = 0; a < 3; ++a) {
      low[a] = double(b.base[a]) / unit;
      high[a] = double(std::min(size_[a], b.base[a] + b.side)) / unit;
    }
    return box_around(lattice_, low, high);
  }

  /// tells whether any two gradients, taken in steps of the lattice, make an angle below 90°.
  bool keeps_direction(const std::array<Interval, 3>& gradient) const {
    Interval product;
    for (std::size_t a = 0; a < 3; ++a) {
      const Interval along =
          lattice_.step[a][0] * gradient[0] + lattice_.step[a][1] * gradient[1] + lattice_.step[a][2] * gradient[2];
      product = product + along * along;
    }
    return product.low > 0;
  }

  bool is_proved_by_parts(const Block& b) const {
    std::vector<Block> parts;
    add_parts(b, parts);
    bool empty = true;
    std::array<Interval, 3> gradient{internal::no_number, internal::no_number, internal::no_number};
    for (const Block& part : parts) {
      Derivative_bounds d;
      internal::sharp_bounds(f_, box_of(part), 1, d);
      empty = empty && has_no_zero(d.value);
      for (std::size_t a = 0; a < 3; ++a)
        gradient[a] = hull(gradient[a], d.gradient[a]);
      if (!empty && !keeps_direction(gradient))
        return false;
    }
    return true;
  }

  const Function_3& f_;
  const Lattice& lattice_;
  Grid_point size_{};
};

int level_of(const Block& b) {
  int level = 0;
  while (Octree::side(level) > b.side)
    ++level;
  return level;
}

/// The cubes of the lattice with the fewest parts that are not proved come first, `room` parts in all: a pole or a double
/// sheet, where nothing helps, must not take the room of a place where little is missing.
std::vector<char> choose(const std::vector<Block>& blocks, std::size_t room) {
  std::map<Grid_point, std::size_t> parts;
  const auto root = [](const Block& b) { return Octree::ancestor({b.base, level_of(b)}, 0).base; };
  for (const Block& b : blocks)
    ++parts[root(b)];
  std::vector<std::pair<std::size_t, Grid_point>> order;
  for (const auto& [base, n] : parts)
    order.emplace_back(n, base);
  std::sort(order.begin(), order.end());
  for (const auto& [n, base] : order) {
    room = n <= room ? room : 0; // the first that has no room is the last
    parts[base] = n <= room;
    room -= n <= room ? n : 0;
  }
  std::vector<char> chosen;
  for (const Block& b : blocks)
    chosen.push_back(char(parts[root(b)] != 0));
  return chosen;
}

} // namespace

void prove_surface(const Function_3& f, const Lattice& lattice, std::size_t most_divided, Thread_pool& pool,
                   Octree& tree, Surface_report& report) {
  const Prover prover(f, lattice);
  std::size_t divided = 0;
  std::vector<Block> blocks{prover.whole()};
  while (!blocks.empty()) {
    const bool are_cubes = blocks.front().side <= Octree::unit;
    std::vector<char> open(blocks.size());
    pool.for_each(blocks.size(), 16, [&](std::size_t i) {
      open[i] = !prover.is_proved(blocks[i]) && !(are_cubes && prover.is_outside_domain(blocks[i]));
    });
    std::size_t n = 0;
    for (std::size_t i = 0; i < blocks.size(); ++i)
      if (open[i])
        blocks[n++] = blocks[i];
    blocks.resize(n);

    std::vector<char> dividable(n, 1);
    if (are_cubes) {
      if (level_of(blocks.empty() ? Block{{}, Octree::unit} : blocks.front()) == Octree::levels)
        dividable.assign(n, 0);
      else if (divided + n > most_divided)
        dividable = choose(blocks, most_divided - std::min(divided, most_divided));
    }
    std::vector<Block> parts;
    for (std::size_t i = 0; i < n; ++i) {
      if (!dividable[i]) {
        if (report.undecided_cubes++ == 0)
          report.first_undecided = prover.middle_of(blocks[i]);
        continue;
      }
      if (are_cubes) {
        tree.divide({blocks[i].base, level_of(blocks[i])});
        ++divided;
      }
      prover.add_parts(blocks[i], parts);
    }
    blocks = std::move(parts);
  }
  tree.balance();
}

} // namespace CGAL::Extremal_mesh_3
