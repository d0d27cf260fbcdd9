// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The "weaving" of polygons in marching cubes. In each face of a cube the cut edges are joined by segments with the + side on
// their left (seen from outside the cube); the segments of the six faces close up to polygons. A face is decided by itself,
// so both its cubes see the same segments.
#include "Slab_walker.h"

#include "cube.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace CGAL::Extremal_mesh_3 {

namespace {

constexpr int edge_between(int a, int b) {
  for (int e = 0; e < 12; ++e)
    if ((edge_corners[std::size_t(e)][0] == a && edge_corners[std::size_t(e)][1] == b) ||
        (edge_corners[std::size_t(e)][0] == b && edge_corners[std::size_t(e)][1] == a))
      return e;
  return -1;
}

/// To which cut edge of a cube the segment from each leads; -1 for edges that are not cut.
using Next_edges = std::array<std::int8_t, 12>;

constexpr std::array<bool, 4> signs_of(const std::array<int, 4>& face, unsigned plus) {
  std::array<bool, 4> signs{};
  for (std::size_t c = 0; c < 4; ++c)
    signs[c] = (plus >> face[c] & 1U) != 0;
  return signs;
}

constexpr bool is_ambiguous(const std::array<bool, 4>& plus) {
  return plus[0] == plus[2] && plus[1] == plus[3] && plus[0] != plus[1];
}

/// joins the cut edges of one face.
/// \param plus  the corners with a + sign, a bit for each
/// \param joined  whether the two + corners of an ambiguous face are joined through its middle
constexpr void join(const std::array<int, 4>& face, unsigned plus_corners, bool joined, Next_edges& next) {
  const std::array<bool, 4> plus = signs_of(face, plus_corners);
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
    next[std::size_t(edge_between(face[c], face[d]))] = std::int8_t(edge_between(face[from], face[(from + 1) % 4]));
  }
}

/// The segments in a cube, by the signs at its corners, as far as these tell.
struct Segments {
  Next_edges next{};
  bool ambiguous = false; ///< in some face
};

std::array<Segments, 256> make_segments() {
  std::array<Segments, 256> table;
  for (unsigned plus = 0; plus < 256; ++plus) {
    table[plus].next.fill(-1);
    for (const auto& face : face_corners) {
      join(face, plus, false, table[plus].next);
      table[plus].ambiguous = table[plus].ambiguous || is_ambiguous(signs_of(face, plus));
    }
  }
  return table;
}

const Segments& segments_of(unsigned plus) {
  static const std::array<Segments, 256> table = make_segments();
  return table[plus];
}

} // namespace

Slab_walker::Slab_walker(const Function_3& f, const Lattice& lattice, const Active_cubes& active)
    : f_(f), lattice_(lattice), active_(active), nx_(lattice.size[0]), ny_(lattice.size[1]),
      left_handed_(is_left_handed(lattice)), low_{Points(nx_ * ny_), Points(nx_ * ny_)}, high_{Points(nx_ * ny_),
                                                                                               Points(nx_ * ny_)},
      z_(nx_ * ny_), columns_(nx_) {}

void Slab_walker::walk(std::size_t k, const Slice_values& low, const Slice_values& high) {
  k_ = k;
  slices_ = {low, high};
  for (std::size_t j = 0; j + 1 < ny_; ++j)
    for (const Active_cubes::Range& cubes : active_.row(j, k))
      row(j, cubes);
  std::swap(low_, high_);
  for (Points* points : {&high_[0], &high_[1], &z_})
    points->clear();
}

void Slab_walker::row(std::size_t j, const Active_cubes::Range& cubes) {
  const std::uint8_t *a = slices_[0].signs + j * nx_, *b = a + nx_, *c = slices_[1].signs + j * nx_, *d = c + nx_;
  for (std::size_t i = cubes.first; i <= cubes.last; ++i)
    columns_[i] = std::uint8_t(a[i] | b[i] << 1 | c[i] << 2 | d[i] << 3);
  constexpr std::size_t many = sizeof(std::uint64_t);
  for (std::size_t i = cubes.first; i < cubes.last;) {
    if (i + many <= cubes.last) { // so many cubes at once, if nothing changes there
      std::uint64_t here, next;
      std::memcpy(&here, columns_.data() + i, many);
      std::memcpy(&next, columns_.data() + i + 1, many);
      if (here == next && (here == 0 || here == 0x0f0f0f0f0f0f0f0fULL)) {
        i += many;
        continue;
      }
    }
    if (columns_[i] != columns_[i + 1] || (columns_[i] != 0 && columns_[i] != 15))
      cube(i, j);
    ++i;
  }
}

void Slab_walker::cube(std::size_t i, std::size_t j) {
  std::array<double, 8> value;
  unsigned plus = 0;
  for (unsigned c = 0; c < 8; ++c) {
    value[c] = slices_[c >> 2].values[(i + (c & 1)) + nx_ * (j + (c >> 1 & 1))];
    if (!std::isfinite(value[c]))
      return; // outside the domain: the surface has a border here
    plus |= unsigned(value[c] >= 0) << c;
  }
  const Segments& segments = segments_of(plus);
  Next_edges next = segments.next;
  if (segments.ambiguous)
    for (const auto& face : face_corners)
      if (is_ambiguous(signs_of(face, plus)) && plus_corners_joined(face, value, i, j))
        join(face, plus, true, next);
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

bool Slab_walker::plus_corners_joined(const std::array<int, 4>& face, const std::array<double, 8>& value, std::size_t i,
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

std::uint32_t Slab_walker::point_on(int edge, std::size_t i, std::size_t j, const std::array<double, 8>& value) {
  const auto [a, b] = edge_corners[std::size_t(edge)];
  const std::size_t axis = std::size_t(edge) / 4;
  const std::size_t ia = i + std::size_t(a & 1), ja = j + std::size_t(a >> 1 & 1);
  Points& points = axis == 2 ? z_ : (a >> 2 ? high_ : low_)[axis];
  const auto [id, is_new] = points.id_at(ia + nx_ * ja, woven.cuts.size());
  if (is_new)
    woven.cuts.push_back({{double(ia), double(ja), double(k_ + std::size_t(a >> 2))},
                          axis,
                          1,
                          value[std::size_t(a)],
                          value[std::size_t(b)]});
  return id;
}

} // namespace CGAL::Extremal_mesh_3
