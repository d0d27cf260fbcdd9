// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What holds for the extremal mesh of any surface, on surfaces with border in the form that the border leaves.
#include "checks.h"
#include "winding.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

namespace {

std::size_t count(const Extremal_mesh& mesh, Vertex_kind kind) {
  std::size_t n = 0;
  for (std::size_t v = 0; v < mesh.number_of_vertices(); ++v)
    n += mesh.vertex(v).kind == kind;
  return n;
}

Check not_applicable(std::string name, std::string claim, std::string why) {
  return {std::move(name), std::move(claim), false, true, std::move(why)};
}

Check equality(std::string name, std::string claim, double left, double right) {
  return {std::move(name), std::move(claim), true, left == right,
          fmt::format("{} {} {}", left, left == right ? "=" : "≠", right)};
}

/// a vertex of a cell; the origin for a cell without lines.
Point place_of(const Extremal_mesh& mesh, std::size_t c) {
  if (c >= mesh.number_of_cells() || mesh.cell(c).boundary.empty() || mesh.cell(c).boundary[0].empty())
    return {};
  return mesh.vertex(mesh.source(mesh.cell(c).boundary[0][0])).point;
}

const std::string border_frees = "the surface has a border";

} // namespace

Check check_degrees(const Extremal_mesh& mesh) {
  Violations bad;
  for (std::size_t v = 0; v < mesh.number_of_vertices(); ++v) {
    const Extremal_mesh_vertex& x = mesh.vertex(v);
    const std::size_t degree = x.star.size();
    const bool good = x.kind == Vertex_kind::extremal_point ? degree == 4
                      : x.kind == Vertex_kind::umbilic
                          ? (x.ridges == 1 || x.ridges == 3) && degree == std::size_t(2 * x.ridges)
                      : x.kind == Vertex_kind::boundary ? degree == 1
                      : x.kind == Vertex_kind::anchor   ? degree == 2
                                                        : degree >= 2 && degree % 2 == 0;
    if (!good)
      bad.at(fmt::format("{} {} of degree {}", to_string(x.kind), v, degree), x.point);
  }
  return bad.check("degrees",
                   "extremal points have degree 4, umbilics 2 or 6, anchors 2, boundary vertices 1, others an even one",
                   fmt::format("{} vertices", mesh.number_of_vertices()));
}

Check check_families(const Extremal_mesh& mesh) {
  Violations bad;
  for (std::size_t v = 0; v < mesh.number_of_vertices(); ++v) {
    const Extremal_mesh_vertex& x = mesh.vertex(v);
    const std::size_t n = x.star.size();
    const auto family = [&](std::size_t i) { return mesh.edge(x.star[i % n] / 2).family; };
    bool good = true;
    for (std::size_t i = 0; i < n; ++i) {
      if (x.kind == Vertex_kind::extremal_point)
        good = good && family(i) != family(i + 1);
      if (x.kind == Vertex_kind::umbilic) // opposite branches are one line, which changes its family here
        good = good && family(i) != family(i + n / 2);
    }
    if (!good)
      bad.at(fmt::format("{} {}", to_string(x.kind), v), x.point);
  }
  return bad.check("families", "families alternate around extremal points, and lines change family at umbilics",
                   fmt::format("{} vertices", mesh.number_of_vertices()));
}

Check check_umbilics(const Extremal_mesh& mesh) {
  Violations bad;
  for (std::size_t v = 0; v < mesh.number_of_vertices(); ++v) {
    const Extremal_mesh_vertex& x = mesh.vertex(v);
    const double index = x.umbilic_type == Umbilic_type::none ? 0 : x.umbilic_type == Umbilic_type::star ? -0.5 : 0.5;
    const bool umbilic = x.kind == Vertex_kind::umbilic;
    if ((umbilic != (x.umbilic_type != Umbilic_type::none)) ||
        (x.kind != Vertex_kind::non_generic && x.umbilic_index != index) ||
        2 * x.umbilic_index != std::round(2 * x.umbilic_index))
      bad.at(fmt::format("{} {} is a {} of index {}", to_string(x.kind), v, to_string(x.umbilic_type), x.umbilic_index),
             x.point);
  }
  return bad.check("umbilics", "lemons and monstars have index ½, stars −½, other vertices 0",
                   fmt::format("{} umbilics", count(mesh, Vertex_kind::umbilic)));
}

Check check_winding(const Extremal_mesh& mesh) {
  Violations bad;
  for (std::size_t v = 0; v < mesh.number_of_vertices(); ++v) {
    const Extremal_mesh_vertex& x = mesh.vertex(v);
    if (x.kind == Vertex_kind::boundary)
      continue;
    const int half_turns = half_turns_of_phi(mesh, x);
    if (half_turns != std::lround(4 * (x.umbilic_index - x.field_index)))
      bad.at(fmt::format("around {} {} of indices {} and {} it turns by {} half turns", to_string(x.kind), v,
                         x.umbilic_index, x.field_index, half_turns),
             x.point);
  }
  return bad.check("winding",
                   "around a vertex the signs of its cells and the families of its lines make Φ = P²Q turn 2·(index of "
                   "the lines of curvature − index of R (e1 t1 − e2 t2)) times",
                   fmt::format("{} vertices", mesh.number_of_vertices() - count(mesh, Vertex_kind::boundary)));
}

Check check_alternation(const Extremal_mesh& mesh) {
  Violations bad;
  for (std::size_t e = 0; e < mesh.number_of_edges(); ++e) {
    const Extremal_mesh_edge& x = mesh.edge(e);
    if (mesh.cell(x.left_cell).sign + mesh.cell(x.right_cell).sign != 0)
      bad.at(fmt::format("edge {} between cells {} and {}", e, x.left_cell, x.right_cell), mesh.vertex(x.source).point);
  }
  return bad.check("alternation", "E_g changes its sign across every line",
                   fmt::format("{} edges", mesh.number_of_edges()));
}

Check check_cells(const Extremal_mesh& mesh) {
  Violations bad;
  double area = 0;
  for (std::size_t c = 0; c < mesh.number_of_cells(); ++c) {
    const Extremal_mesh_cell& x = mesh.cell(c);
    area += x.area;
    // An open surface of genus g with b holes has χ = 2 − 2g − b.
    const int holes = int(x.boundary.size()), rest = 2 - x.euler_characteristic - holes;
    // 0 on a mesh where a line leaves a straight edge and comes back to it.
    const bool good =
        x.area >= 0 && (x.sign == 1 || x.sign == -1) && (x.touches_border || (rest >= 0 && rest % 2 == 0));
    if (!good)
      bad.at(
          fmt::format("cell {} with χ = {}, {} boundary walks, area {:.3g}", c, x.euler_characteristic, holes, x.area),
          place_of(mesh, c));
  }
  if (std::abs(area - mesh.surface().area) > 1e-9 * std::abs(area))
    bad.at(fmt::format("the areas of the cells sum to {}, the surface has {}", area, mesh.surface().area), Point{});
  return bad.check("cells",
                   "areas of cells are not negative, and χ = 2 − 2g − (boundary walks) with a whole genus g ≥ 0",
                   fmt::format("{} cells", mesh.number_of_cells()));
}

Check check_euler(const Extremal_mesh& mesh) {
  // The border of the surface and the vertices on it, cut into as many arcs, cancel.
  const std::int64_t vertices = std::int64_t(mesh.number_of_vertices() - count(mesh, Vertex_kind::boundary));
  std::int64_t cells = 0;
  for (const Extremal_mesh_cell& c : mesh.cells())
    cells += c.euler_characteristic;
  Check check = equality("euler", "V − E + Σ χ(cell) = χ of the surface",
                         double(vertices - std::int64_t(mesh.number_of_edges()) + cells),
                         double(mesh.surface().euler_characteristic));
  check.detail += fmt::format(" ({} − {} + {})", vertices, mesh.number_of_edges(), cells);
  return check;
}

Check check_faces(const Extremal_mesh& mesh) {
  const std::string name = "faces", claim = "F = χ + #EP + 2·#(3-ridge umbilics), if all cells are disks";
  if (!mesh.surface().closed)
    return not_applicable(name, claim, border_frees);
  for (std::size_t c = 0; c < mesh.number_of_cells(); ++c)
    if (mesh.cell(c).euler_characteristic != 1)
      return not_applicable(name, claim, fmt::format("cell {} is not a disk", c));
  std::int64_t surplus = 0; // half the degree less 1: 1 for an EP, 2 for a 3-ridge umbilic
  for (std::size_t v = 0; v < mesh.number_of_vertices(); ++v)
    surplus += std::int64_t(mesh.vertex(v).star.size()) / 2 - 1;
  return equality(name, claim, double(mesh.number_of_cells()), double(mesh.surface().euler_characteristic + surplus));
}

Check check_umbilic_index(const Extremal_mesh& mesh) {
  const std::string name = "umbilic_index", claim = "the indices of the umbilics sum to χ";
  if (!mesh.surface().closed)
    return not_applicable(name, claim, border_frees);
  double sum = 0;
  for (std::size_t v = 0; v < mesh.number_of_vertices(); ++v)
    sum += mesh.vertex(v).umbilic_index;
  return equality(name, claim, sum, double(mesh.surface().euler_characteristic));
}

Check check_field_index(const Extremal_mesh& mesh) {
  const std::string name = "field_index",
                    claim = "the indices of R (e1 t1 − e2 t2) at extremal points and umbilics sum to χ";
  if (!mesh.surface().closed)
    return not_applicable(name, claim, border_frees);
  std::int64_t sum = 0;
  for (std::size_t v = 0; v < mesh.number_of_vertices(); ++v)
    sum += mesh.vertex(v).field_index;
  return equality(name, claim, double(sum), double(mesh.surface().euler_characteristic));
}

Check check_even_extremal_points(const Extremal_mesh& mesh) {
  const std::string name = "even_extremal_points",
                    claim = "a closed generic surface has an even number of extremal points";
  if (!mesh.surface().closed)
    return not_applicable(name, claim, border_frees);
  if (count(mesh, Vertex_kind::non_generic) > 0)
    return not_applicable(name, claim, "the surface has non-generic vertices");
  const std::size_t points = count(mesh, Vertex_kind::extremal_point);
  return {name, claim, true, points % 2 == 0, fmt::format("{} extremal points", points)};
}

namespace {

/// A loop of the border on which lines end.
struct Loop {
  std::size_t vertex = 0; ///< one of its boundary vertices
  std::size_t ends = 0;   ///< how many it has
};

std::vector<Loop> loops_with_ends(const Extremal_mesh& mesh) {
  // A walk around a cell that comes to the border goes along it to the next boundary vertex.
  const std::size_t none = mesh.number_of_vertices();
  std::vector<std::size_t> next(none, none);
  for (const Extremal_mesh_cell& cell : mesh.cells())
    for (const auto& walk : cell.boundary)
      for (std::size_t i = 0; i < walk.size(); ++i) {
        const std::uint32_t v = mesh.target(walk[i]);
        if (mesh.vertex(v).kind == Vertex_kind::boundary)
          next[v] = mesh.source(walk[(i + 1) % walk.size()]);
      }
  std::vector<Loop> loops;
  std::vector<char> seen(none, 0);
  for (std::size_t start = 0; start < none; ++start) {
    Loop loop{start, 0};
    for (std::size_t v = start; v != none && next[v] != none && !seen[v]; v = next[v], ++loop.ends)
      seen[v] = 1;
    if (loop.ends > 0)
      loops.push_back(loop);
  }
  return loops;
}

} // namespace

Check check_border(const Extremal_mesh& mesh) {
  Violations bad;
  const std::vector<Loop> loops = loops_with_ends(mesh);
  bool touched = false;
  for (std::size_t c = 0; c < mesh.number_of_cells(); ++c)
    if (mesh.cell(c).touches_border) {
      touched = true;
      if (mesh.surface().closed)
        bad.at(fmt::format("cell {} touches the border of a closed surface", c), place_of(mesh, c));
    }
  if (mesh.surface().closed) {
    for (std::size_t v = 0; v < mesh.number_of_vertices(); ++v)
      if (mesh.vertex(v).kind == Vertex_kind::boundary)
        bad.at(fmt::format("boundary vertex {} of a closed surface", v), mesh.vertex(v).point);
  } else {
    if (!touched)
      bad.at("no cell of a surface with border touches it; the first one is", place_of(mesh, 0));
    for (const Loop& loop : loops)
      if (loop.ends % 2 != 0)
        bad.at(fmt::format("{} lines end on the loop of the border with vertex {}", loop.ends, loop.vertex),
               mesh.vertex(loop.vertex).point);
  }
  return bad.check("border",
                   "lines end on each loop of the border an even number of times, and nowhere on a closed surface",
                   fmt::format("{} boundary vertices on {} loops of a {} surface", count(mesh, Vertex_kind::boundary),
                               loops.size(), mesh.surface().closed ? "closed" : "bordered"));
}

Check check_border_parity(const Extremal_mesh& mesh) {
  std::array<std::int64_t, 2> ends{};
  std::int64_t half_turns = 0;
  for (std::size_t v = 0; v < mesh.number_of_vertices(); ++v) {
    const Extremal_mesh_vertex& x = mesh.vertex(v);
    if (x.kind == Vertex_kind::boundary && !x.star.empty())
      ++ends[std::size_t(mesh.edge(x.star[0] / 2).family - 1)];
    half_turns += std::llround(2 * x.umbilic_index);
  }
  return {"border_parity",
          "lines of either family end on the border as often, modulo 2, as there are half turns of the principal "
          "directions around the umbilics",
          true, (ends[0] - half_turns) % 2 == 0 && (ends[1] - half_turns) % 2 == 0,
          fmt::format("{} ends of family 1, {} of family 2, {} half turns", ends[0], ends[1], half_turns)};
}

} // namespace CGAL::Extremal_mesh_3
