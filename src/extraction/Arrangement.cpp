// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Arrangement.h"

#include "../cells/parallel.h"
#include "../differential/vector.h"
#include "find_root.h"
#include "join_pairs.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace CGAL::Extremal_mesh_3 {

Arrangement::Arrangement(Refined_complex& complex, const Extraction_options& options) : complex_(complex) {
  number_crossings();
  place_crossings(options);
  crossed_.assign(complex.cells().size(), 0);
  for (const Crossing& c : crossings_)
    for (const std::uint32_t cell : complex.edges()[c.edge].cell)
      if (cell != no_id)
        crossed_[cell] = 1;
  for (std::size_t c = 0; c < complex.cells().size(); ++c)
    if (is_crossed(std::uint32_t(c)))
      draw(std::uint32_t(c));
  refine_segments(options);
}

void Arrangement::number_crossings() {
  const auto& edges = complex_.edges();
  const auto& samples = complex_.samples();
  first_crossing_.assign(edges.size() + 1, 0);
  first_interval_.assign(edges.size(), 0);
  std::uint32_t intervals = std::uint32_t(samples.size());
  for (std::uint32_t e = 0; e < edges.size(); ++e) {
    std::int32_t from = 0, to = 0;
    if (!edges[e].divided()) {
      from = samples[edges[e].a].positive ? 0 : -1;
      to = (samples[edges[e].b].positive ? 0 : -1) + 2 * edges[e].winding;
    }
    const std::uint32_t count = std::uint32_t(std::abs(to - from));
    first_crossing_[e + 1] = first_crossing_[e] + count;
    first_interval_[e] = intervals;
    if (count > 1)
      intervals += count - 1;
    for (std::uint32_t i = 0; i < count; ++i) {
      Crossing c;
      c.edge = e;
      c.ordinal = i;
      const std::int32_t level = to > from ? from + 1 + std::int32_t(i) : from - std::int32_t(i);
      c.family = level % 2 != 0 ? 1 : 2;
      c.level = level;
      crossings_.push_back(c);
    }
  }
  number_of_intervals_ = intervals;
}

std::uint32_t Arrangement::interval(std::uint32_t edge, std::uint32_t ordinal) const {
  if (ordinal == 0)
    return complex_.edges()[edge].a;
  if (ordinal == crossings_of(edge))
    return complex_.edges()[edge].b;
  return first_interval_[edge] + ordinal - 1;
}

void Arrangement::place_crossings(const Extraction_options& options) {
  Thread_pool pool(options.threads);
  pool.for_each(crossings_.size(), 32, [&](std::size_t i) { place(crossings_[i], crossings_of(crossings_[i].edge)); });
  for (std::uint32_t e = 0; e < complex_.edges().size(); ++e)
    if (crossings_of(e) > 1)
      spread(e);
}

/// distributes the crossings of an edge over it, unless they were found in their order.
void Arrangement::spread(std::uint32_t e) {
  const Refined_edge& edge = complex_.edges()[e];
  const bool backwards = complex_.samples()[edge.b].p < complex_.samples()[edge.a].p;
  const std::uint32_t count = crossings_of(e);
  Crossing* const all = &crossings_[first_crossing_[e]];
  bool good = all[0].placed;
  for (std::uint32_t i = 1; i < count; ++i)
    good = good && all[i].placed && (backwards ? all[i].t < all[i - 1].t : all[i - 1].t < all[i].t);
  if (good)
    return;
  for (std::uint32_t i = 0; i < count; ++i) {
    all[i].placed = false;
    all[i].t = double(backwards ? count - i : i + 1) / (count + 1);
    static_cast<Line_place&>(all[i]) =
        line_place(complex_.surface(), sample_of(all[i]), all[i].family,
                   1e-3 * distance(complex_.samples()[edge.a].p, complex_.samples()[edge.b].p));
  }
}

void Arrangement::place(Crossing& crossing, std::uint32_t count) const {
  const Refined_edge& edge = complex_.edges()[crossing.edge];
  const Sample *a = &complex_.samples()[edge.a], *b = &complex_.samples()[edge.b];
  std::int32_t level = crossing.level, winding = edge.winding;
  if (b->p < a->p) { // the same bits whatever way the edge is numbered
    std::swap(a, b);
    level -= 2 * winding;
    winding = -winding;
  }
  // The phase above its level. It is nearly linear along the edge, also close to an extremal point, where Φ is not. Between several
  // crossings it turns too far to be told without P and Q, each of which turns by less than half a turn.
  const double turned = crossing.family == 1 ? -1 : 1, above = a->phase - std::numbers::pi * level;
  const auto height = [&](const Sample& s) {
    if (count == 1)
      return std::arg(turned * s.shape.Phi());
    const Moved_fields from = moved_to(*a, s);
    return above + 2 * std::arg(s.P * std::conj(from.P)) + std::arg(s.shape.Q * std::conj(from.Q));
  };
  Sample s = *a;
  const auto at = [&](double t) {
    crossing.t = t;
    return sample_between(complex_.surface(), *a, *b, t, Surface::to_place, Detail::third_order);
  };
  double low = 0, high = 1, h_low = count == 1 ? height(*a) : above;
  double h_high = count == 1 ? height(*b) : b->phase + std::numbers::pi * (2 * winding - level);
  crossing.placed = count == 1 || (h_low < 0) != (h_high < 0);
  const auto value = [&](double t) { return height(s = at(t)); };
  bool at_an_end = false;
  if (complex_.surface().interpolates()) {
    // Where samples cannot be moved off a line, crossings keep a little away from them: cells shall have an area.
    constexpr double margin = 1e-6;
    low = margin;
    high = 1 - margin;
    const double beside_low = value(low);
    at_an_end = (beside_low < 0) != (h_low < 0);
    h_low = beside_low;
    if (!at_an_end) {
      const double beside_high = value(high);
      at_an_end = (beside_high < 0) != (h_high < 0);
      h_high = beside_high;
    }
  }
  constexpr double tolerance = 1e-12; // of the edge
  if (!at_an_end && (h_low < 0) != (h_high < 0))
    find_root(value, low, high, h_low, h_high, tolerance);
  if (count > 1)
    crossing.placed = crossing.placed && std::abs(std::arg(turned * s.shape.Phi())) < 1e-3; // not across a jump
  static_cast<Line_place&>(crossing) = line_place(complex_.surface(), s, crossing.family, 1e-3 * distance(a->p, b->p));
}

std::uint32_t Arrangement::id(const Border_crossings& met, std::size_t i) const {
  const Half_edge h = met.crossings[i].half_edge;
  std::uint32_t before = 0; // crossings of the same half-edge that come earlier on the walk
  while (before < i && met.crossings[i - before - 1].half_edge == h)
    ++before;
  const std::uint32_t ordinal = h % 2 == 0 ? before : crossings_of(h / 2) - 1 - before;
  return first_crossing_[h / 2] + ordinal;
}

void Arrangement::draw(std::uint32_t c) {
  const Refined_cell& cell = complex_.cells()[c];
  std::vector<Half_edge> border;
  complex_.border(cell, border);
  const Border_crossings met = border_crossings(complex_, border);

  std::vector<int> partner(met.crossings.size(), -1);
  // A vertex whose branches are certain, or hopeless, takes all; another one what is left when pairs are joined.
  const bool all = cell.content == Content::unresolved || (cell.certain && cell.content != Content::lines);
  if (!all)
    join_pairs(met, cell.joined, partner);

  Node node;
  node.cell = c;
  for (std::size_t i = 0; i < met.crossings.size(); ++i) {
    const std::uint32_t crossing = id(met, i);
    const std::uint8_t side = met.crossings[i].half_edge % 2;
    if (partner[i] >= 0) {
      crossings_[crossing].next[side] = {id(met, std::size_t(partner[i])), false};
    } else {
      crossings_[crossing].next[side] = {std::uint32_t(nodes_.size()), true};
      node.crossings.push_back(crossing);
      node.sides.push_back(side);
    }
  }
  if (!node.crossings.empty())
    nodes_.push_back(std::move(node));
}

void Arrangement::pieces(std::uint32_t c, std::vector<Piece>& pieces) const {
  using Kind = Piece::Corner::Kind;
  pieces.clear();
  std::vector<Half_edge> border;
  complex_.border(complex_.cells()[c], border);

  // The walk around the cell: points and crossings.
  struct Item {
    Piece::Corner corner;
    std::uint32_t after = 0; // interval that follows a crossing
  };
  std::vector<Item> walk;
  std::vector<std::size_t> met; // positions of the crossings in the walk
  for (const Half_edge h : border) {
    walk.push_back({{Kind::sample, complex_.source(h)}, 0});
    const std::uint32_t e = h / 2, count = crossings_of(e);
    for (std::uint32_t k = 0; k < count; ++k) {
      const std::uint32_t ordinal = h % 2 == 0 ? k : count - 1 - k;
      met.push_back(walk.size());
      walk.push_back({{Kind::crossing, first_crossing_[e] + ordinal}, interval(e, h % 2 == 0 ? k + 1 : count - 1 - k)});
    }
  }
  if (met.empty()) {
    Piece whole;
    for (const Item& item : walk)
      whole.corners.push_back(item.corner);
    whole.intervals.push_back(walk[0].corner.id);
    pieces.push_back(std::move(whole));
    return;
  }

  const auto side = [&](std::uint32_t crossing) {
    return complex_.edges()[crossings_[crossing].edge].cell[0] == c ? 0U : 1U;
  };
  const std::size_t n = met.size();
  std::vector<char> used(n, 0);
  for (std::size_t start = 0; start < n; ++start) {
    if (used[start])
      continue;
    Piece piece;
    for (std::size_t i = start; !used[i];) {
      used[i] = 1;
      piece.intervals.push_back(walk[met[i]].after);
      const std::size_t k = (i + 1) % n;
      for (std::size_t at = met[i]; at != met[k]; at = (at + 1) % walk.size())
        piece.corners.push_back(walk[at].corner);
      piece.corners.push_back(walk[met[k]].corner);
      // Turn left into the cell, along the segment that ends here.
      const auto add_points = [&](std::uint32_t crossing, bool backwards = false) {
        const Points_between points = points_between(crossing, side(crossing));
        for (std::uint32_t j = 0; j < points.count; ++j)
          piece.corners.push_back({Kind::line_point, points.id(backwards ? points.count - 1 - j : j)});
      };
      const Segment_end next = crossings_[walk[met[k]].corner.id].next[side(walk[met[k]].corner.id)];
      add_points(walk[met[k]].corner.id);
      if (next.node) {
        piece.corners.push_back({Kind::node, next.id});
        // Back out along the branch before this one.
        for (i = (k + n - 1) % n;; i = (i + n - 1) % n)
          if (crossings_[walk[met[i]].corner.id].next[side(walk[met[i]].corner.id)].node)
            break;
        add_points(walk[met[i]].corner.id, true);
      } else {
        for (i = 0; walk[met[i]].corner.id != next.id;)
          ++i;
      }
    }
    pieces.push_back(std::move(piece));
  }
}

const Point& Arrangement::position(const Piece::Corner& corner) const {
  switch (corner.kind) {
  case Piece::Corner::Kind::sample:
    return complex_.samples()[corner.id].p;
  case Piece::Corner::Kind::crossing:
    return crossings_[corner.id].p;
  case Piece::Corner::Kind::line_point:
    return line_points_[corner.id].p;
  default:
    return complex_.samples()[complex_.cells()[nodes_[corner.id].cell].center].p;
  }
}

const Vector& Arrangement::normal(const Piece::Corner& corner) const {
  switch (corner.kind) {
  case Piece::Corner::Kind::sample:
    return complex_.samples()[corner.id].shape.n;
  case Piece::Corner::Kind::crossing:
    return crossings_[corner.id].n;
  case Piece::Corner::Kind::line_point:
    return line_points_[corner.id].n;
  default:
    return complex_.samples()[complex_.cells()[nodes_[corner.id].cell].center].shape.n;
  }
}

} // namespace CGAL::Extremal_mesh_3
