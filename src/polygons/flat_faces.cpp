// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "flat_faces.h"

#include "../differential/vector.h"

#include <algorithm>
#include <optional>
#include <unordered_map>

namespace CGAL::Extremal_mesh_3 {

namespace {

/// \return where the longest side of the polygon begins, if all corners lie on it up to rounding
std::optional<std::size_t> longest_side_if_flat(const std::vector<Point>& points, const Polygon& polygon) {
  // Coordinates that were computed from others are off by some units in the last place.
  constexpr double rounding = 0x1p-48;
  const auto after = [n = polygon.size()](std::size_t i) { return i + 1 < n ? i + 1 : 0; };
  std::size_t longest = 0;
  double length = 0, size = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point &p = points[polygon[i]], &q = points[polygon[after(i)]];
    if (const double d = distance(p, q); d > length) {
      length = d;
      longest = i;
    }
    size = std::max({size, std::abs(p[0]), std::abs(p[1]), std::abs(p[2])});
  }
  if (length == 0)
    return std::nullopt;
  const Point& origin = points[polygon[longest]];
  const Vector direction = (1 / length) * (points[polygon[after(longest)]] - origin);
  const bool is_flat = std::all_of(polygon.begin(), polygon.end(), [&](std::uint32_t corner) {
    return norm(cross(direction, points[corner] - origin)) <= rounding * size;
  });
  return is_flat ? std::optional(longest) : std::nullopt;
}

/// Which polygon runs along its border from one point to another.
class Sides {
public:
  explicit Sides(const std::vector<Polygon>& polygons) {
    for (std::uint32_t f = 0; f < polygons.size(); ++f)
      set_owner(polygons[f], f);
  }
  std::optional<std::uint32_t> owner(std::uint32_t from, std::uint32_t to) const {
    const auto found = owner_.find(key(from, to));
    return found == owner_.end() ? std::nullopt : std::optional(found->second);
  }
  void set_owner(const Polygon& polygon, std::uint32_t f) {
    for (std::size_t i = 0; i < polygon.size(); ++i)
      owner_[key(polygon[i], polygon[(i + 1) % polygon.size()])] = f;
  }

private:
  static std::uint64_t key(std::uint32_t from, std::uint32_t to) { return std::uint64_t(from) << 32U | to; }
  std::unordered_map<std::uint64_t, std::uint32_t> owner_;
};

bool have_common_corner(const Polygon& polygon, const Polygon& others) {
  return std::find_first_of(polygon.begin(), polygon.end(), others.begin(), others.end()) != polygon.end();
}

} // namespace

std::size_t merge_flat_faces(Polygon_soup& soup, std::vector<bool>& flags) {
  std::vector<Polygon>& polygons = soup.polygons;
  std::optional<Sides> sides; // hardly any mesh needs them
  for (std::uint32_t f = 0; f < polygons.size(); ++f) {
    const auto longest = longest_side_if_flat(soup.points, polygons[f]);
    if (!longest)
      continue;
    if (!sides)
      sides.emplace(polygons);
    // With the longest side a → b first the others are b, …, a: what the neighbour is to have between b and a.
    Polygon& flat = polygons[f];
    std::rotate(flat.begin(), flat.begin() + std::ptrdiff_t(*longest), flat.end());
    const std::uint32_t a = flat[0], b = flat[1];
    const Polygon between(flat.begin() + 2, flat.end());
    const auto neighbour = sides->owner(b, a);
    if (!neighbour || *neighbour == f || have_common_corner(polygons[*neighbour], between))
      continue;
    Polygon& other = polygons[*neighbour];
    other.insert(std::find(other.begin(), other.end(), b) + 1, between.begin(), between.end());
    flat.clear();
    sides->set_owner(other, *neighbour);
  }
  std::size_t kept = 0;
  for (std::size_t f = 0; f < polygons.size(); ++f)
    if (!polygons[f].empty()) {
      flags[kept] = flags[f];
      polygons[kept++].swap(polygons[f]);
    }
  const std::size_t gone = polygons.size() - kept;
  polygons.resize(kept);
  flags.resize(kept);
  return gone;
}

} // namespace CGAL::Extremal_mesh_3
