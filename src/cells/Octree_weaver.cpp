// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Octree_weaver.h"

#include "cube.h"

#include <algorithm>
#include <cmath>

namespace CGAL::Extremal_mesh_3 {

namespace {

Grid_point moved(Grid_point p, std::size_t axis, std::int64_t by) {
  p[axis] += by;
  return p;
}

std::array<double, 3> in_steps(const Grid_point& p) {
  return {double(p[0]) / double(Octree::unit), double(p[1]) / double(Octree::unit),
          double(p[2]) / double(Octree::unit)};
}

} // namespace

double Octree_weaver::value(const Grid_point& node) {
  const auto [it, fresh] = values_.try_emplace(node, 0);
  if (fresh) {
    const auto at = in_steps(node);
    it->second = f_.value(lattice_.node(at[0], at[1], at[2]));
  }
  return it->second;
}

bool Octree_weaver::edge_divided(const Edge& edge) const {
  const std::size_t b = (edge.axis + 1) % 3, c = (edge.axis + 2) % 3;
  const std::int64_t s = Octree::side(edge.level);
  for (int i = 0; i < 4; ++i)
    if (divided({moved(moved(edge.base, b, i & 1 ? -s : 0), c, i & 2 ? -s : 0), edge.level}))
      return true;
  return false;
}

/// adds the cuts of an edge, walked along its axis or back.
void Octree_weaver::cut(const Edge& edge, bool forward, std::vector<Cut>& cuts) {
  const std::int64_t s = Octree::side(edge.level);
  if (divided_around_ != 0 && edge.level < Octree::levels && edge_divided(edge)) {
    const Edge low{edge.base, edge.axis, edge.level + 1},
        high{moved(edge.base, edge.axis, s / 2), edge.axis, edge.level + 1};
    cut(forward ? low : high, forward, cuts);
    cut(forward ? high : low, forward, cuts);
    return;
  }
  const Grid_point end = moved(edge.base, edge.axis, s);
  const double v0 = corner_value(edge.base), v1 = corner_value(end);
  if ((v0 >= 0) == (v1 >= 0))
    return;
  const auto [it, fresh] = points_.try_emplace(edge, next_point_);
  if (fresh) {
    ++next_point_;
    new_cut_edges.push_back({in_steps(edge.base), edge.axis, double(s) / double(Octree::unit), v0, v1});
  }
  cuts.push_back({it->second, (v0 >= 0) == forward});
}

bool Octree_weaver::ambiguous_face_joined(const Face& face) {
  const std::int64_t s = Octree::side(face.level);
  // In an order that does not depend on the side from which the face is seen.
  const std::size_t a = std::min(face.first, face.second), b = std::max(face.first, face.second);
  const std::array<double, 4> v{value(face.base), value(moved(face.base, a, s)), value(moved(face.base, b, s)),
                                value(moved(moved(face.base, a, s), b, s))};
  std::array<double, 3> along_a{}, along_b{};
  along_a[a] = along_b[b] = double(s) / double(Octree::unit);
  return plus_corners_joined(f_, lattice_, v, in_steps(face.base), along_a, along_b);
}

/// joins the cuts of a face by segments with the + side on their left.
void Octree_weaver::join(const Face& face, std::map<std::uint32_t, std::uint32_t>& next) {
  const std::int64_t s = Octree::side(face.level);
  const std::size_t normal = 3 - face.first - face.second;
  if (divided_around_ != 0 && face.level < Octree::levels &&
      (divided({face.base, face.level}) || divided({moved(face.base, normal, -s), face.level}))) {
    for (int i = 0; i < 4; ++i)
      join({moved(moved(face.base, face.first, i & 1 ? s / 2 : 0), face.second, i & 2 ? s / 2 : 0), face.first,
            face.second, face.level + 1},
           next);
    return;
  }
  std::vector<Cut> cuts;
  cut({face.base, face.first, face.level}, true, cuts);
  const std::size_t after_1 = cuts.size();
  cut({moved(face.base, face.first, s), face.second, face.level}, true, cuts);
  const std::size_t after_2 = cuts.size();
  cut({moved(face.base, face.second, s), face.first, face.level}, false, cuts);
  const std::size_t after_3 = cuts.size();
  cut({face.base, face.second, face.level}, false, cuts);

  const std::size_t n = cuts.size();
  const bool one_each = n == 4 && after_1 == 1 && after_2 == 2 && after_3 == 3;
  const bool joined = one_each && ambiguous_face_joined(face);
  ambiguous_side_ = ambiguous_side_ || (n >= 4 && !one_each);
  // A + run ends where the border leaves +. Its segment leads back to where the run began or, if the + runs are joined
  // through the middle of the face, on to where the next one begins. Cuts alternate.
  for (std::size_t i = 0; i < n; ++i)
    if (cuts[i].leaves_plus)
      next[cuts[i].point] = cuts[joined ? (i + 1) % n : (i + n - 1) % n].point;
}

/// tells that the cube at hand lies outside the domain of the function, or has equal signs at its corners and no finer cubes beside it.
bool Octree_weaver::plainly_empty() const {
  if (!std::all_of(at_corner_.begin(), at_corner_.end(), [](double v) { return std::isfinite(v); }))
    return true;
  const auto positive = std::count_if(at_corner_.begin(), at_corner_.end(), [](double v) { return v >= 0; });
  return (positive == 0 || positive == 8) && divided_around_ == 0;
}

/// makes a cube the one at hand.
void Octree_weaver::look_around(const Grid_cube& cube) {
  cube_ = cube;
  divided_around_ = tree_.divided_around(cube);
  for (unsigned c = 0; c < 8; ++c) {
    Grid_point corner = cube.base;
    for (std::size_t a = 0; a < 3; ++a)
      corner[a] += (c >> a & 1U) * Octree::side(cube.level);
    at_corner_[c] = value(corner);
  }
}

/// \param cube  around the cube at hand, of its size or smaller
bool Octree_weaver::divided(const Grid_cube& cube) const {
  if (cube.level != cube_.level)
    return tree_.divided(cube);
  return (divided_around_ >> Octree::place_beside(cube_, cube) & 1U) != 0;
}

/// \param node  on the border of the cube at hand
double Octree_weaver::corner_value(const Grid_point& node) {
  const std::int64_t s = Octree::side(cube_.level);
  std::size_t corner = 0;
  for (std::size_t a = 0; a < 3; ++a) {
    const std::int64_t d = node[a] - cube_.base[a];
    if (d != 0 && d != s)
      return value(node);
    corner |= std::size_t(d == s) << a;
  }
  return at_corner_[corner];
}

void Octree_weaver::weave(const Grid_cube& cube) {
  if (tree_.divided(cube)) {
    for (unsigned c = 0; c < 8; ++c)
      weave(Octree::child(cube, c));
    return;
  }
  look_around(cube);
  if (plainly_empty())
    return;
  const std::int64_t s = Octree::side(cube.level);
  std::map<std::uint32_t, std::uint32_t> next;
  std::size_t loops = 0;
  ambiguous_side_ = false;
  for (std::size_t a = 0; a < 3; ++a) {
    const std::size_t b = (a + 1) % 3, c = (a + 2) % 3;
    join({moved(cube.base, a, s), b, c, cube.level}, next); // seen from the side of greater coordinates
    join({cube.base, c, b, cube.level}, next);
  }
  for (; !next.empty(); ++loops) {
    const std::size_t first = corners.size();
    for (auto it = next.begin(); it != next.end();) {
      corners.push_back(it->first);
      const std::uint32_t to = it->second;
      next.erase(it);
      it = next.find(to);
    }
    // Two points joined twice, along two faces that share an edge: the cells beyond those faces meet in that one
    // segment.
    if (corners.size() - first < 3) {
      corners.resize(first);
      continue;
    }
    if (is_left_handed(lattice_))
      std::reverse(corners.begin() + std::ptrdiff_t(first), corners.end());
    polygon_begin.push_back(corners.size());
    polygon_cubes.push_back(cube);
  }
  if ((ambiguous_side_ || loops > 1) && divided_around_ != 0)
    ambiguous_cubes.push_back(cube);
}

} // namespace CGAL::Extremal_mesh_3
