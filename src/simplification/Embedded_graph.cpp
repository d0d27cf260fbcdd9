// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Embedded_graph.h"

#include "../algorithms/winding.h"
#include "../differential/vector.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace CGAL::Extremal_mesh_3 {

namespace {

Embedded_graph::Edge measured(const Extremal_mesh_edge& e, double surface_area) {
  Embedded_graph::Edge edge{};
  edge.family = e.family;
  edge.alive = true;
  edge.kept = false;
  edge.walk = 2 * e.id;
  edge.length = e.length;
  edge.strength = e.strength;
  edge.slope = surface_area > 0 ? e.sharpness / surface_area : 0;
  for (std::size_t i = 0; i < e.polyline.size(); ++i) {
    edge.split = std::max(edge.split, e.k1[i] - e.k2[i]);
    if (i > 0)
      edge.extremality += distance(e.polyline[i - 1], e.polyline[i]) * (e.extremality[i - 1] + e.extremality[i]) / 2;
  }
  edge.difference = edge.extremality;
  edge.life_time = e.life_time.value_or(0);
  return edge;
}

} // namespace

Embedded_graph::Embedded_graph(const Extremal_mesh& mesh)
    : cells_of_(mesh.number_of_cells()), walks_(mesh.number_of_edges()), alive_vertices_(mesh.number_of_vertices()),
      alive_edges_(mesh.number_of_edges()), alive_cells_(mesh.number_of_cells()) {
  const std::size_t half_edges = 2 * mesh.number_of_edges();
  source_.resize(half_edges);
  next_.resize(half_edges);
  previous_.resize(half_edges);
  cell_.resize(half_edges);
  for (const Extremal_mesh_cell& c : mesh.cells())
    cells_.emplace_back(Cell{c.sign, c.euler_characteristic, c.touches_border, c.area, c.weight});
  sides_.resize(cells_.size());
  for (std::uint32_t e = 0; e < mesh.number_of_edges(); ++e) {
    edges_.push_back(measured(mesh.edge(e), mesh.surface().area));
    for (const Half_edge h : {2 * e, 2 * e + 1}) {
      source_[h] = mesh.source(h);
      add_side(h, mesh.left_cell(h));
    }
  }
  for (std::uint32_t v = 0; v < mesh.number_of_vertices(); ++v) {
    const Extremal_mesh_vertex& x = mesh.vertex(v);
    Vertex& vertex = vertices_.emplace_back(Vertex{x.kind, int(std::lround(2 * x.umbilic_index)), x.field_index});
    vertex.point = x.point;
    vertex.k1 = x.k1;
    vertex.k2 = x.k2;
    vertex.life_time = x.life_time.value_or(0);
    vertex.degree = std::uint32_t(x.star.size());
    vertex.first = x.star.empty() ? none : x.star.front();
    for (std::size_t i = 0; i < x.star.size(); ++i) {
      const Half_edge next = x.star[(i + 1) % x.star.size()];
      next_[x.star[i]] = next;
      previous_[next] = x.star[i];
    }
    vertex.frozen = x.kind == Vertex_kind::boundary || x.star.empty() ||
                    half_turns_of_phi(mesh, x) != 2 * vertex.half_turns - 4 * vertex.field_index;
  }
  for (const Extremal_mesh_cell& c : mesh.cells())
    for (const auto& walk : c.boundary)
      for (std::size_t i = 0; i < walk.size(); ++i) {
        const std::uint32_t v = mesh.target(walk[i]), after = mesh.source(walk[(i + 1) % walk.size()]);
        if (mesh.vertex(v).kind == Vertex_kind::boundary) {
          vertices_[v].next_on_border = after;
          vertices_[after].previous_on_border = v;
        }
      }
}

std::vector<Half_edge> Embedded_graph::star(std::uint32_t v) const {
  std::vector<Half_edge> result;
  Half_edge h = vertices_[v].first;
  for (std::uint32_t i = 0; i < vertices_[v].degree; ++i, h = next_[h])
    result.push_back(h);
  return result;
}

std::vector<Half_edge> Embedded_graph::sides(std::uint32_t root) const {
  std::vector<Half_edge> result;
  for (const Half_edge h : sides_[root])
    if (edges_[h / 2].alive && left_cell(h) == root)
      result.push_back(h);
  return result;
}

std::vector<std::uint32_t> Embedded_graph::numbered_cells() const {
  std::vector<std::uint32_t> number(cells_.size());
  std::uint32_t count = 0;
  for (std::uint32_t c = 0; c < cells_.size(); ++c) { // a root is the smallest of its cells
    const std::uint32_t root = cells_of_.find(c);
    number[c] = root == c ? count++ : number[root];
  }
  return number;
}

void Embedded_graph::add_side(Half_edge h, std::uint32_t cell) {
  cell_[h] = cell;
  ++cells_[cell].sides;
  cells_[cell].exclusive_or ^= h;
  sides_[cell].push_back(h);
}

void Embedded_graph::remove_side(Half_edge h) {
  Cell& c = cells_[left_cell(h)];
  --c.sides;
  c.exclusive_or ^= h;
}

void Embedded_graph::kill_edge(std::uint32_t e) {
  edges_[e].alive = false;
  --alive_edges_;
}

void Embedded_graph::kill_vertex(std::uint32_t v) {
  vertices_[v].alive = false;
  --alive_vertices_;
}

void Embedded_graph::remove_from_star(Half_edge h) {
  Vertex& v = vertices_[source_[h]];
  next_[previous_[h]] = next_[h];
  previous_[next_[h]] = previous_[h];
  if (v.first == h)
    v.first = next_[h] == h ? none : next_[h];
  --v.degree;
}

void Embedded_graph::replace_in_star(Half_edge old, Half_edge h) {
  Vertex& v = vertices_[source_[old]];
  source_[h] = source_[old];
  if (next_[old] == old) {
    next_[h] = previous_[h] = h;
  } else {
    next_[h] = next_[old];
    previous_[h] = previous_[old];
    next_[previous_[h]] = h;
    previous_[next_[h]] = h;
  }
  if (v.first == old)
    v.first = h;
}

void Embedded_graph::merge_cells(std::uint32_t kept, std::uint32_t other, int euler_characteristic) {
  Cell merged = cells_[kept];
  if (kept != other) {
    const Cell& c = cells_[other];
    merged.area += c.area;
    merged.weight += c.weight;
    merged.touches_border = merged.touches_border || c.touches_border;
    merged.sides += c.sides;
    merged.exclusive_or ^= c.exclusive_or;
    cells_of_.unite(kept, other);
    --alive_cells_;
    const std::uint32_t root = cells_of_.find(kept), absorbed = root == kept ? other : kept;
    if (sides_[root].size() < sides_[absorbed].size())
      std::swap(sides_[root], sides_[absorbed]);
    sides_[root].insert(sides_[root].end(), sides_[absorbed].begin(), sides_[absorbed].end());
    sides_[absorbed] = {};
  }
  merged.euler_characteristic = euler_characteristic;
  cells_[cells_of_.find(kept)] = merged;
}

void Embedded_graph::contract(Half_edge h) {
  const Half_edge back = h ^ 1U;
  const std::uint32_t u = source(h), w = source(back);
  for (Half_edge x = next_[back]; x != back; x = next_[x]) {
    source_[x] = u;
    Edge& e = edges_[x / 2];
    const Edge& along = edges_[h / 2];
    e.walk = x % 2 == 0 ? walks_.join(walk(h), e.walk) : walks_.join(e.walk, walk(back));
    e.length += along.length;
    e.strength += along.strength;
    e.slope += along.slope;
    e.extremality += along.extremality;
    e.split = std::max(e.split, along.split);
    e.life_time = std::max(e.life_time, along.life_time);
  }
  remove_side(h);
  remove_side(back);
  kill_edge(h / 2);
  // The branches of w take the place of h, from the one counter-clockwise of the way back.
  const Half_edge first = next_[back], last = previous_[back];
  const bool had_others = first != back;
  const Half_edge before = previous_[h], after = next_[h];
  const bool has_others = before != h;
  Vertex &kept = vertices_[u], &gone = vertices_[w];
  if (had_others && has_others) {
    next_[before] = first;
    previous_[first] = before;
    next_[last] = after;
    previous_[after] = last;
  } else if (had_others) {
    next_[last] = first;
    previous_[first] = last;
  } else if (has_others) {
    next_[before] = after;
    previous_[after] = before;
  }
  kept.first = had_others ? first : has_others ? after : none;
  kept.degree += gone.degree - 2;
  kept.half_turns += gone.half_turns;
  kept.field_index += gone.field_index;
  kept.life_time = std::max(kept.life_time, gone.life_time);
  kill_vertex(w);
}

Half_edge Embedded_graph::add_edge(Half_edge a, Half_edge b, double difference) {
  const Edge &x = edges_[a / 2], &y = edges_[b / 2];
  Edge e{};
  e.family = x.family;
  e.alive = true;
  e.kept = x.kept || y.kept;
  e.walk = walks_.join(walk(a) ^ 1U, walk(b));
  e.length = x.length + y.length;
  e.strength = x.strength + y.strength;
  e.slope = x.slope + y.slope;
  e.extremality = x.extremality + y.extremality;
  e.difference = difference;
  e.split = std::max(x.split, y.split);
  e.life_time = std::max(x.life_time, y.life_time);
  const Half_edge h = Half_edge(2 * edges_.size());
  edges_.push_back(e);
  ++alive_edges_;
  for (auto* array : {&source_, &cell_, &next_, &previous_})
    array->resize(edges_.size() * 2, none);
  return h;
}

Half_edge Embedded_graph::detach(Half_edge a, Half_edge b, double difference) {
  const std::uint32_t v = source(a);
  const std::uint32_t between = left_cell(a), right = left_cell(a ^ 1U), left = left_cell(b);
  Half_edge h = a;
  if (a == (b ^ 1U)) {
    remove_from_star(a);
    remove_from_star(b);
    const auto anchor = std::uint32_t(vertices_.size());
    Vertex& x = vertices_.emplace_back(Vertex{Vertex_kind::anchor, 0, 0});
    x.degree = 2;
    x.first = a;
    x.point = vertices_[v].point;
    ++alive_vertices_;
    source_[a] = source_[b] = anchor;
    next_[a] = previous_[a] = b;
    next_[b] = previous_[b] = a;
  } else {
    for (const Half_edge x : {a, a ^ 1U, b, b ^ 1U})
      remove_side(x);
    h = add_edge(a, b, difference);
    remove_from_star(a);
    remove_from_star(b);
    replace_in_star(a ^ 1U, h);
    replace_in_star(b ^ 1U, h ^ 1U);
    kill_edge(a / 2);
    kill_edge(b / 2);
    add_side(h, right);
    add_side(h ^ 1U, between);
  }
  if (vertices_[v].degree > 0) // the strip between the line and the vertex joins them
    merge_cells(right, left,
                cells_[right].euler_characteristic + (right == left ? 0 : cells_[left].euler_characteristic) - 1);
  return h;
}

void Embedded_graph::remove_loop(Half_edge h) {
  const std::uint32_t inside = left_cell(h), outside = left_cell(h ^ 1U);
  remove_side(h);
  remove_side(h ^ 1U);
  remove_from_star(h);
  remove_from_star(h ^ 1U);
  kill_edge(h / 2);
  merge_cells(outside, inside, cells_[outside].euler_characteristic + cells_[inside].euler_characteristic - 1);
}

void Embedded_graph::dissolve(std::uint32_t v, double difference) {
  const Half_edge a = vertices_[v].first, b = next_[a];
  if (a == (b ^ 1U)) {
    vertices_[v].kind = Vertex_kind::anchor;
    return;
  }
  detach(a, b, difference);
  kill_vertex(v);
}

void Embedded_graph::drop_closed_line(Half_edge h) {
  const std::uint32_t inside = left_cell(h), outside = left_cell(h ^ 1U);
  remove_side(h);
  remove_side(h ^ 1U);
  kill_vertex(source(h));
  kill_edge(h / 2);
  merge_cells(outside, inside, cells_[outside].euler_characteristic + cells_[inside].euler_characteristic);
}

void Embedded_graph::remove_disk(const std::vector<std::uint32_t>& vertices, const std::vector<std::uint32_t>& edges,
                                 const std::vector<std::uint32_t>& inner, std::uint32_t outer) {
  const int euler_characteristic = cells_[outer].euler_characteristic + 1;
  for (const std::uint32_t e : edges) {
    remove_side(2 * e);
    remove_side(2 * e + 1);
    kill_edge(e);
  }
  for (const std::uint32_t v : vertices)
    kill_vertex(v);
  for (const std::uint32_t c : inner)
    merge_cells(root(outer), root(c), euler_characteristic);
}

void Embedded_graph::drop_border_line(Half_edge h) {
  const std::uint32_t inside = left_cell(h), outside = left_cell(h ^ 1U);
  remove_side(h);
  remove_side(h ^ 1U);
  for (const std::uint32_t v : {source(h), target(h)}) {
    unlink_from_border(v);
    kill_vertex(v);
  }
  kill_edge(h / 2);
  merge_cells(outside, inside, cells_[outside].euler_characteristic + cells_[inside].euler_characteristic - 1);
}

void Embedded_graph::unlink_from_border(std::uint32_t v) {
  const Vertex& x = vertices_[v];
  vertices_[x.previous_on_border].next_on_border = x.next_on_border;
  vertices_[x.next_on_border].previous_on_border = x.previous_on_border;
}

} // namespace CGAL::Extremal_mesh_3
