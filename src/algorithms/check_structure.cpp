// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "checks.h"

#include "../differential/vector.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace CGAL::Extremal_mesh_3 {

namespace {

bool finite(const Vector& v) {
  return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
}

bool finite(const Extremal_mesh_vertex& v) {
  return finite(v.point) && finite(v.normal) && finite(v.t1) && finite(v.t2) && std::isfinite(v.k1) &&
         std::isfinite(v.k2);
}

bool finite(const Extremal_mesh_edge& e) {
  const auto is_finite = [](double x) { return std::isfinite(x); };
  return std::all_of(e.polyline.begin(), e.polyline.end(), [](const Point& p) { return finite(p); }) &&
         std::all_of(e.k1.begin(), e.k1.end(), is_finite) && std::all_of(e.k2.begin(), e.k2.end(), is_finite) &&
         std::all_of(e.normals.begin(), e.normals.end(), [](const Vector& n) { return finite(n); }) &&
         std::all_of(e.extremality.begin(), e.extremality.end(), [](double x) { return std::isfinite(x) && x >= 0; }) &&
         std::isfinite(e.length) && std::isfinite(e.strength) && std::isfinite(e.sharpness);
}

} // namespace

void Violations::at(const std::string& what, const Point& where) {
  constexpr std::size_t told_at_most = 5;
  if (count_++ < told_at_most)
    told_ +=
        fmt::format("{}{} at ({:.6g}, {:.6g}, {:.6g})", told_.empty() ? "" : "; ", what, where[0], where[1], where[2]);
}

Check Violations::check(std::string name, std::string claim, const std::string& if_it_holds) const {
  Check c{std::move(name), std::move(claim), true, count_ == 0, if_it_holds};
  if (count_ > 0)
    c.detail = fmt::format("{} violation{}: {}", count_, count_ == 1 ? "" : "s", told_);
  return c;
}

Check check_stars(const Extremal_mesh& mesh) {
  Violations bad;
  std::vector<int> met(2 * mesh.number_of_edges(), 0);
  for (std::size_t v = 0; v < mesh.number_of_vertices(); ++v)
    for (const Half_edge h : mesh.vertex(v).star) {
      if (mesh.source(h) != v)
        bad.at(fmt::format("half-edge {} stands in the star of vertex {}, from which it does not start,", h, v),
               mesh.vertex(v).point);
      ++met[h];
    }
  for (Half_edge h = 0; h < met.size(); ++h)
    if (met[h] != 1)
      bad.at(fmt::format("half-edge {} stands in {} stars", h, met[h]), mesh.vertex(mesh.source(h)).point);
  return bad.check("stars", "every half-edge leaves its vertex exactly once", fmt::format("{} half-edges", met.size()));
}

Check check_walks(const Extremal_mesh& mesh) {
  Violations bad;
  std::vector<int> met(2 * mesh.number_of_edges(), 0);
  std::size_t walks = 0;
  for (std::size_t c = 0; c < mesh.number_of_cells(); ++c)
    for (const auto& walk : mesh.cell(c).boundary) {
      ++walks;
      for (std::size_t i = 0; i < walk.size(); ++i) {
        const Half_edge h = walk[i], next = walk[(i + 1) % walk.size()];
        ++met[h];
        const std::uint32_t v = mesh.target(h);
        if (mesh.left_cell(h) != c)
          bad.at(fmt::format("half-edge {} bounds cell {} but has cell {} on its left", h, c, mesh.left_cell(h)),
                 mesh.vertex(v).point);
        if (mesh.vertex(v).kind == Vertex_kind::boundary) {
          if (mesh.vertex(mesh.source(next)).kind != Vertex_kind::boundary)
            bad.at(fmt::format("the walk around cell {} leaves the border where no line begins", c),
                   mesh.vertex(v).point);
          continue;
        }
        // With the cell on the left all the way, the walk leaves v by the branch clockwise of the one that came in.
        const auto& star = mesh.vertex(v).star;
        const auto in = std::find(star.begin(), star.end(), h ^ 1U);
        if (in == star.end() || *(in == star.begin() ? star.end() - 1 : in - 1) != next)
          bad.at(fmt::format("the walk around cell {} does not turn at vertex {} as its star says", c, v),
                 mesh.vertex(v).point);
      }
    }
  for (Half_edge h = 0; h < met.size(); ++h)
    if (met[h] != 1)
      bad.at(fmt::format("half-edge {} stands in {} boundary walks", h, met[h]), mesh.vertex(mesh.source(h)).point);
  return bad.check("walks", "every half-edge bounds exactly one cell, and walks turn as the stars say",
                   fmt::format("{} walks", walks));
}

Check check_type_changes(const Extremal_mesh& mesh) {
  const std::string name = "type_changes",
                    claim = "the type of a line changes at vertices and at its type changes only";
  Violations bad;
  std::size_t told = 0;
  for (std::size_t e = 0; e < mesh.number_of_edges(); ++e) {
    const Extremal_mesh_edge& x = mesh.edge(e);
    told += x.type_changes.size();
    for (std::size_t i = 1; i < x.segment_types.size(); ++i)
      if (x.segment_types[i - 1] != x.segment_types[i] &&
          std::none_of(x.type_changes.begin(), x.type_changes.end(), [&](const auto& c) { return c.point == i; }))
        bad.at(fmt::format("edge {} changes from {} to {}", e, to_string(x.segment_types[i - 1]),
                           to_string(x.segment_types[i])),
               x.polyline[i]);
  }
  Check check = bad.check(name, claim, fmt::format("{} type changes", told));
  if (told == 0 && !check.holds)
    return {name, claim, false, true, "no type change is told, as in files of older versions"};
  return check;
}

Check check_geometry(const Extremal_mesh& mesh) {
  Violations bad;
  for (std::size_t v = 0; v < mesh.number_of_vertices(); ++v) {
    const Extremal_mesh_vertex& x = mesh.vertex(v);
    if (!finite(x))
      bad.at(fmt::format("vertex {} has a number that is not finite", v), x.point);
    else if (std::abs(norm(x.normal) - 1) > 1e-9)
      bad.at(fmt::format("the normal of vertex {} is not a unit vector", v), x.point);
    else if (x.k1 < x.k2)
      bad.at(fmt::format("vertex {} has k1 < k2", v), x.point);
  }
  for (std::size_t e = 0; e < mesh.number_of_edges(); ++e) {
    const Extremal_mesh_edge& x = mesh.edge(e);
    const Point& start = mesh.vertex(x.source).point;
    const std::size_t n = x.polyline.size();
    if (n < 2 || x.k1.size() != n || x.k2.size() != n || x.segment_types.size() != n - 1)
      bad.at(fmt::format("edge {} has {} points with {} and {} curvatures and {} segment types", e, n, x.k1.size(),
                         x.k2.size(), x.segment_types.size()),
             start);
    else if (x.polyline.front() != start || x.polyline.back() != mesh.vertex(x.target).point)
      bad.at(fmt::format("the polyline of edge {} does not end at its vertices", e), start);
    else if (!finite(x))
      bad.at(fmt::format("edge {} has a number that is not finite", e), start);
    else if (x.family != 1 && x.family != 2)
      bad.at(fmt::format("edge {} has the family {}", e, x.family), start);
  }
  for (std::size_t c = 0; c < mesh.number_of_cells(); ++c) {
    const Extremal_mesh_cell& x = mesh.cell(c);
    if (!std::isfinite(x.area) || !std::isfinite(x.weight))
      bad.at(fmt::format("cell {} has a number that is not finite", c),
             x.boundary.empty() || x.boundary[0].empty() ? Point{} : mesh.vertex(mesh.source(x.boundary[0][0])).point);
  }
  return bad.check("geometry", "numbers are finite, normals are unit vectors, k1 ≥ k2, polylines end at their vertices",
                   fmt::format("{} vertices, {} edges", mesh.number_of_vertices(), mesh.number_of_edges()));
}

} // namespace CGAL::Extremal_mesh_3
