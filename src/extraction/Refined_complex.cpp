// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Rounds of two steps: edges are divided until P and Q turn little along each, then the cells that are not yet certain
// are divided. A divided edge is one for both its cells, so neighbours never disagree, and no cell needs to know how
// far the next one is divided. Within a step elements are independent; new ones are numbered in the order of their
// parents, so the result does not depend on threads.
#include "Refined_complex.h"

#include "../cells/parallel.h"
#include "../differential/distance_to_segment.h"
#include "analyse_cell.h"
#include "nudge.h"
#include "plain_cell.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace CGAL::Extremal_mesh_3 {

namespace {

constexpr double pi = std::numbers::pi;
/// An edge along which P or Q seems to turn further than this is divided: near π the direction of the turn would be a
/// guess.
constexpr double greatest_turn = 0.6 * pi;
/// Normals must not turn further along an edge (cos 60°): parallel transport is by the shortest way.
constexpr double least_normal_cosine = 0.5;
/// Edges may be divided this many times more than the cells beside them; the second while they are crossed more than once: beside
/// an umbilic three lines cross within its distance.
constexpr int extra_edge_levels = 6, extra_levels_to_part_crossings = 12;
/// Dividing ends when there are so many cells for each one of the beginning, and so many more. Only a surface on which
/// E_g is nearly 0 over an area comes near to it.
constexpr std::size_t most_cells_for_each = 20, most_cells_more = 50'000;

} // namespace

Refined_complex::Refined_complex(const Surface& surface, const Cell_complex& cells, std::vector<Sample> samples,
                                 const std::vector<char>& degenerate, const Extraction_options& options)
    : surface_(surface), options_(options), samples_(std::move(samples)) {
  edges_.reserve(room_for(cells.edges.size()));
  edges_.resize(cells.edges.size());
  cells_.reserve(room_for(cells.number_of_cells()));
  cells_.resize(cells.number_of_cells());
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    edges_[e].a = cells.edges[e][0];
    edges_[e].b = cells.edges[e][1];
    for (std::size_t side = 0; side < 2; ++side)
      if (cells.edge_cells[e][side] != Cell_complex::no_cell)
        edges_[e].cell[side] = std::uint32_t(cells.edge_cells[e][side]);
  }
  closed_ = std::none_of(edges_.begin(), edges_.end(),
                         [](const Refined_edge& e) { return e.cell[0] == no_id || e.cell[1] == no_id; });
  euler_characteristic_ = int(cells.euler_characteristic());
  for (std::size_t c = 0; c < cells_.size(); ++c) {
    cells_[c].sides.assign(cells.half_edges.begin() + std::ptrdiff_t(cells.cell_begin[c]),
                           cells.half_edges.begin() + std::ptrdiff_t(cells.cell_begin[c + 1]));
    cells_[c].degenerate = degenerate[c] != 0;
  }
  most_cells_ = most_cells_for_each * cells_.size() + most_cells_more;
  report_.surface_points = cells.points.size();
  report_.surface_cells = cells_.size();
}

Half_edge Refined_complex::half(Half_edge h, int which) const {
  const std::uint32_t child = edges_[h / 2].child;
  return h % 2 == 0 ? 2 * (child + std::uint32_t(which)) : 2 * (child + 1 - std::uint32_t(which)) + 1;
}

void Refined_complex::border(const Refined_cell& cell, std::vector<Half_edge>& half_edges) const {
  half_edges.clear();
  visit_border(cell, [&](Half_edge h) {
    half_edges.push_back(h);
    return true;
  });
}

void Refined_complex::own(Half_edge h, std::uint32_t cell) {
  edges_[h / 2].cell[h % 2] = cell;
  if (edges_[h / 2].divided()) {
    own(half(h, 0), cell);
    own(half(h, 1), cell);
  }
}

void Refined_complex::measure(std::uint32_t id) {
  Refined_edge& edge = edges_[id];
  const Sample &a = samples_[edge.a], &b = samples_[edge.b];
  const Complex z = folds_.transport(*this, 2 * id);
  edge.turn_P = std::arg(b.P * std::conj(a.P) * z);
  edge.turn_Q = std::arg(b.shape.Q * std::conj(a.shape.Q * z * z));
  edge.winding = std::int32_t(std::lround((2 * edge.turn_P + edge.turn_Q - (b.phase - a.phase)) / (2 * pi)));
  edge.wanted = should_divide(edge);
}

bool Refined_complex::should_divide(const Refined_edge& edge) const {
  int level = 0;
  for (const std::uint32_t c : edge.cell)
    if (c != no_id) {
      if (cells_[c].degenerate)
        return false;
      level = std::max(level, cells_[c].level + int(cells_[c].half_level));
    }
  const Sample &a = samples_[edge.a], &b = samples_[edge.b];
  const int from = a.positive ? 0 : -1, to = (b.positive ? 0 : -1) + 2 * edge.winding;
  if (std::abs(to - from) > 1) // at most one crossing an edge
    return edge.level < level + extra_levels_to_part_crossings;
  return edge.level < level + extra_edge_levels &&
         (dot(a.shape.n, b.shape.n) < least_normal_cosine || std::abs(edge.turn_P) > greatest_turn ||
          std::abs(edge.turn_Q) > greatest_turn);
}

void Refined_complex::settle_edges(std::size_t first) {
  Thread_pool pool(options_.threads);
  std::vector<Edge_cut> cuts;
  while (first < edges_.size()) {
    pool.for_each(edges_.size() - first, 256, [&](std::size_t i) { measure(std::uint32_t(first + i)); });
    cuts.clear();
    for (std::size_t e = first; e < edges_.size(); ++e)
      if (edges_[e].wanted)
        cuts.push_back({std::uint32_t(e), 0.5});
    first = edges_.size();
    divide_edges(cuts);
  }
}

void Refined_complex::divide_edges(const std::vector<Edge_cut>& cuts) {
  Thread_pool pool(options_.threads);
  const std::size_t first_sample = samples_.size(), first_edge = edges_.size();
  samples_.resize(first_sample + cuts.size());
  edges_.resize(first_edge + 2 * cuts.size());
  pool.for_each(cuts.size(), 32, [&](std::size_t i) {
    const Refined_edge& edge = edges_[cuts[i].edge];
    // Who asks for a cut elsewhere than in the middle wants to see what is there, however near to a line.
    samples_[first_sample + i] = cuts[i].t == 0.5
                                     ? middle_of(cuts[i].edge)
                                     : sample_between(surface_, samples_[edge.a], samples_[edge.b], cuts[i].t);
  });
  for (std::size_t i = 0; i < cuts.size(); ++i) {
    Refined_edge& edge = edges_[cuts[i].edge];
    const std::uint32_t middle = std::uint32_t(first_sample + i);
    edge.child = std::uint32_t(first_edge + 2 * i);
    for (std::uint32_t c = 0; c < 2; ++c) {
      Refined_edge& child = edges_[edge.child + c];
      child.a = c == 0 ? edge.a : middle;
      child.b = c == 0 ? middle : edge.b;
      child.cell = edge.cell;
      child.level = std::uint8_t(edge.level + 1);
    }
    for (const std::uint32_t cell : edge.cell)
      if (cell != no_id)
        touched_.push_back(cell);
  }
}

/// the middle of an edge, moved a little where it would lie on a line or beside a zero: then its phase, and the turns along
/// the edges to it, would be rounding.
Sample Refined_complex::middle_of(std::uint32_t id) const {
  const Refined_edge& edge = edges_[id];
  const Sample &a = samples_[edge.a], &b = samples_[edge.b];
  const Sample middle = sample_between(surface_, a, b, 0.5);
  const double P = std::max(std::abs(a.P), std::abs(b.P)), Q = std::max(std::abs(a.shape.Q), std::abs(b.shape.Q));
  const double size = 0.5 * distance(a.p, b.p);
  if (!should_be_nudged(middle, size, P, Q))
    return middle;
  // It must not leave the two cells.
  double room = std::numeric_limits<double>::infinity();
  for (const std::uint32_t cell : edge.cell)
    if (cell != no_id)
      visit_border(cells_[cell], [&](Half_edge h) {
        if (h / 2 != id)
          room = std::min(room, distance_to_segment(middle.p, samples_[source(h)].p, samples_[target(h)].p));
        return true;
      });
  return nudged(surface_, middle, size, room, P, Q, {&a, &b});
}

/// of the cuts of one edge the first is made.
void Refined_complex::cut_edges(std::vector<Edge_cut> cuts) {
  std::stable_sort(cuts.begin(), cuts.end(), [](const Edge_cut& a, const Edge_cut& b) { return a.edge < b.edge; });
  cuts.erase(
      std::unique(cuts.begin(), cuts.end(), [](const Edge_cut& a, const Edge_cut& b) { return a.edge == b.edge; }),
      cuts.end());
  const std::size_t first = edges_.size();
  divide_edges(cuts);
  settle_edges(first);
}

void Refined_complex::divide_cells(const std::vector<std::uint32_t>& ids) {
  std::vector<std::uint32_t> sides; // that get a middle
  for (const std::uint32_t c : ids) {
    const Side_pair& between = cells_[c].halved_between;
    for (std::size_t i = 0; i < cells_[c].sides.size(); ++i)
      if (const std::uint32_t e = cells_[c].sides[i] / 2;
          !edges_[e].divided() && (between.none() || i == between.i || i == between.j))
        sides.push_back(e);
  }
  std::sort(sides.begin(), sides.end());
  sides.erase(std::unique(sides.begin(), sides.end()), sides.end());
  const std::size_t first_edge = edges_.size();
  std::vector<Edge_cut> cuts;
  cuts.reserve(sides.size());
  for (const std::uint32_t side : sides)
    cuts.push_back({side, 0.5});
  divide_edges(cuts);
  for (const std::uint32_t c : ids)
    if (cells_[c].halved_between.none())
      quarter(c);
    else
      halve(c);
  settle_edges(first_edge);
}

/// joins the middle of every side with the middle of the cell, which leaves a quadrilateral around each corner.
void Refined_complex::quarter(std::uint32_t c) {
  const std::vector<Half_edge> around = cells_[c].sides;
  const std::uint32_t n = std::uint32_t(around.size()), first_spoke = std::uint32_t(edges_.size()),
                      first_child = std::uint32_t(cells_.size());
  for (std::uint32_t i = 0; i < n; ++i) {
    Refined_edge spoke; // from the middle of side i to the centre
    spoke.a = middle_sample(around[i]);
    spoke.b = cells_[c].center;
    spoke.level = std::uint8_t(cells_[c].level + 1);
    spoke.cell = {first_child + i, first_child + (i + 1) % n};
    edges_.push_back(spoke);
  }
  for (std::uint32_t i = 0; i < n; ++i) { // around the corner at which side i begins
    const std::uint32_t before = (i + n - 1) % n;
    add_child(c, {half(around[before], 1), half(around[i], 0), 2 * (first_spoke + i), 2 * (first_spoke + before) + 1});
  }
}

/// joins the middles of two sides.
void Refined_complex::halve(std::uint32_t c) {
  const std::vector<Half_edge> around = cells_[c].sides;
  const std::size_t n = around.size(), i = cells_[c].halved_between.i, j = cells_[c].halved_between.j;
  const std::uint32_t id = std::uint32_t(edges_.size()), first_child = std::uint32_t(cells_.size());
  Refined_edge line; // from the middle of side i to that of side j
  line.a = middle_sample(around[i]);
  line.b = middle_sample(around[j]);
  line.level = std::uint8_t(cells_[c].level + 1);
  line.cell = {first_child + 1, first_child};
  edges_.push_back(line);
  const auto part = [&](std::size_t from, std::size_t to, Half_edge back) {
    std::vector<Half_edge> sides{half(around[from], 1)};
    for (std::size_t k = (from + 1) % n; k != to; k = (k + 1) % n)
      sides.push_back(around[k]);
    sides.push_back(half(around[to], 0));
    sides.push_back(back);
    return sides;
  };
  add_child(c, part(i, j, 2 * id + 1));
  add_child(c, part(j, i, 2 * id));
}

void Refined_complex::add_child(std::uint32_t cell, std::vector<Half_edge> sides) {
  const std::uint32_t id = std::uint32_t(cells_.size());
  cells_[cell].divided = true;
  const bool halves = !cells_[cell].halved_between.none();
  Refined_cell child;
  child.level = std::uint8_t(cells_[cell].level + (halves && !cells_[cell].half_level ? 0 : 1));
  child.half_level = halves != cells_[cell].half_level;
  for (const Half_edge side : sides)
    own(side, id);
  child.sides = std::move(sides);
  cells_.push_back(std::move(child));
  touched_.push_back(id);
}

void Refined_complex::analyse(const std::vector<std::uint32_t>& all, bool may_divide, std::vector<Edge_cut>* cuts) {
  Thread_pool pool(options_.threads);
  // Most cells are plain: what is found out about the others takes far less memory.
  enum class Known : char { no, empty, crossed, as_before };
  std::vector<Known> known(all.size(), Known::no);
  pool.for_each(all.size(), 256, [&](std::size_t i) {
    const Refined_cell& cell = cells_[all[i]];
    if (cuts && still_holds(*this, cell))
      known[i] = Known::as_before;
    else if (const auto crossings = crossings_of_plain_cell(*this, cell))
      known[i] = *crossings == 0 ? Known::empty : Known::crossed;
  });
  std::vector<std::uint32_t> cells;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (known[i] == Known::no)
      cells.push_back(all[i]);
    if (known[i] == Known::no || known[i] == Known::as_before)
      continue;
    Refined_cell& cell = cells_[all[i]];
    cell.content = Content::lines;
    cell.certain = true;
    cell.waits = false;
    cell.crossings = known[i] == Known::empty ? 0 : 2;
    cell.joined = 0;
    cell.winding_P = cell.winding_Q = 0;
  }
  std::vector<Cell_analysis> found(cells.size());
  pool.for_each(cells.size(), 32, [&](std::size_t i) {
    const Refined_cell& cell = cells_[cells[i]];
    const bool may = may_divide && !cell.degenerate && cell.level < options_.max_level;
    found[i] = analyse_cell(*this, cell, may, may && cell.level < options_.max_line_level,
                            cuts && !cell.degenerate ? cell.level + cell.half_level + extra_edge_levels : 0);
  });
  for (std::size_t i = 0; i < cells.size(); ++i) {
    Refined_cell& cell = cells_[cells[i]];
    cell.content = found[i].content;
    cell.certain = found[i].certain;
    cell.winding_P = std::int8_t(std::clamp(found[i].winding_P, -100, 100));
    cell.winding_Q = std::int8_t(std::clamp(found[i].winding_Q, -100, 100));
    cell.joined = found[i].joined;
    cell.crossings = std::uint8_t(std::min<std::size_t>(found[i].crossings, 255));
    cell.halved_between = found[i].halved_between;
    if (found[i].sample) {
      cell.center = std::uint32_t(samples_.size());
      samples_.push_back(*found[i].sample);
    }
    if (cuts)
      cuts->insert(cuts->end(), found[i].cuts.begin(), found[i].cuts.end());
    cell.waits = !found[i].cuts.empty();
  }
}

void Refined_complex::refine() {
  settle_edges(0);
  touched_.resize(cells_.size());
  for (std::size_t c = 0; c < cells_.size(); ++c)
    touched_[c] = std::uint32_t(c);

  std::vector<std::uint32_t> active, divide;
  std::vector<Edge_cut> cuts;
  while (!touched_.empty()) {
    std::sort(touched_.begin(), touched_.end());
    touched_.erase(std::unique(touched_.begin(), touched_.end()), touched_.end());
    active.clear();
    std::copy_if(touched_.begin(), touched_.end(), std::back_inserter(active),
                 [&](std::uint32_t c) { return !cells_[c].divided; });
    touched_.clear();
    cuts.clear();
    analyse(active, cells_.size() < most_cells_, &cuts);
    divide.clear();
    std::copy_if(active.begin(), active.end(), std::back_inserter(divide),
                 [&](std::uint32_t c) { return cells_[c].content == Content::undecided && !cells_[c].waits; });
    if (options_.progress && !options_.progress(1 - double(divide.size()) / double(cells_.size())))
      throw Cancelled();
    report_.rounds += !divide.empty();
    cut_edges(cuts);
    divide_cells(divide);
  }
  settle_folds();

  for (Refined_cell& cell : cells_)
    if (!cell.divided) {
      cell.certain = cell.certain && !(cell.crossings > 0 && is_turned_over(cell));
      ++report_.refined_cells;
      ++(cell.certain ? report_.accepted_cells : report_.uncertain_cells);
    }
  for (const Sample& s : samples_)
    report_.interpolated_points += !s.exact;
}

/// tells whether a part of a cell lies on the surface the other way round, so that other cells lie there too: what was found in each is
/// right, but not what it comes to. What is interpolated may be folded itself.
bool Refined_complex::is_turned_over(const Refined_cell& cell) const {
  if (surface_.interpolates() || (cell.level == 0 && !cell.half_level))
    return false;
  const Point& first = samples_[source(cell.sides[0])].p;
  Vector normal{}, area{};
  visit_border(cell, [&](Half_edge h) {
    normal = normal + samples_[source(h)].shape.n;
    area = area + cross(samples_[source(h)].p - first, samples_[target(h)].p - first);
    return true;
  });
  return dot(area, normal) < 0;
}

void Refined_complex::settle_folds() {
  int sum = 0;
  for (const Refined_cell& cell : cells_)
    sum += cell.divided ? 0 : cell.winding_Q;
  if (!closed_ || sum == 2 * euler_characteristic_)
    return;
  const std::vector<char> folded = folds_.find(*this);
  std::vector<std::uint32_t> cells;
  for (std::uint32_t e = 0; e < edges_.size(); ++e) {
    if (edges_[e].divided() || (!folded[edges_[e].a] && !folded[edges_[e].b]))
      continue;
    measure(e);
    for (const std::uint32_t c : edges_[e].cell)
      if (c != no_id)
        cells.push_back(c);
  }
  std::sort(cells.begin(), cells.end());
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  analyse(cells, false, nullptr);
}

} // namespace CGAL::Extremal_mesh_3
