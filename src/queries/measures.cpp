// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measures follow from what each edge and cell has stored; integrals of curvature over a polyline are those of the
// piecewise linear function through its points.
#include <CGAL/Extremal_mesh_3/measures.h>

#include "../differential/vector.h"
#include "require.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace CGAL::Extremal_mesh_3 {

namespace {

/// ∫ f ds along the edge.
double integral(const Extremal_mesh_edge& edge, const std::vector<double>& f) {
  double sum = 0;
  for (std::size_t i = 0; i + 1 < f.size(); ++i)
    sum += distance(edge.polyline[i], edge.polyline[i + 1]) * (f[i] + f[i + 1]) / 2;
  return sum;
}

/// the mean of the family's curvature along the edge; that of its points if the edge has no length.
double mean_curvature(const Extremal_mesh_edge& edge) {
  const std::vector<double>& k = edge.family == 1 ? edge.k1 : edge.k2;
  const double length = integral(edge, std::vector<double>(k.size(), 1));
  return length > 0 ? integral(edge, k) / length : std::accumulate(k.begin(), k.end(), 0.0) / double(k.size());
}

double extreme_curvature(const Extremal_mesh_edge& edge) {
  const std::vector<double>& k = edge.family == 1 ? edge.k1 : edge.k2;
  return *std::max_element(k.begin(), k.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
}

bool is_max(Line_type type) {
  return type == Line_type::max_largest || type == Line_type::max_second;
}

} // namespace

Line_measures edge_measures(const Extremal_mesh& mesh, std::uint32_t e) {
  require_edge(mesh, e);
  const Extremal_mesh_edge& edge = mesh.edge(e);
  Line_measures m;
  m.length = edge.length;
  m.strength = edge.strength;
  m.sharpness = edge.sharpness;
  m.mean_curvature = mean_curvature(edge);
  m.extreme_curvature = extreme_curvature(edge);
  m.stability = std::sqrt(mesh.surface().area) * integral(edge, edge.extremality);
  return m;
}

Line_measures line_measures(const Extremal_mesh& mesh, const Extremal_line& line) {
  Line_measures m;
  if (line.half_edges.empty())
    return m;
  m.stability = std::numeric_limits<double>::infinity();
  double integral_of_curvature = 0, sum = 0;
  for (const Half_edge h : line.half_edges) {
    require_half_edge(mesh, h);
    const Line_measures of_edge = edge_measures(mesh, h / 2);
    m.stability = std::min(m.stability, of_edge.stability);
    m.length += of_edge.length;
    m.strength += of_edge.strength;
    m.sharpness += of_edge.sharpness;
    integral_of_curvature += of_edge.length * of_edge.mean_curvature;
    sum += of_edge.mean_curvature;
    if (std::abs(of_edge.extreme_curvature) > std::abs(m.extreme_curvature))
      m.extreme_curvature = of_edge.extreme_curvature;
  }
  m.mean_curvature = m.length > 0 ? integral_of_curvature / m.length : sum / double(line.half_edges.size());
  return m;
}

Cell_measures cell_measures(const Extremal_mesh& mesh, std::uint32_t c) {
  require_cell(mesh, c);
  const Extremal_mesh_cell& cell = mesh.cell(c);
  Cell_measures m;
  m.area = cell.area;
  m.weight = cell.weight;
  m.mean_extremality = cell.area > 0 ? cell.weight / cell.area : 0;
  for (const std::vector<Half_edge>& walk : cell.boundary)
    for (const Half_edge h : walk) {
      m.perimeter += mesh.edge(h / 2).length;
      ++m.sides;
    }
  if (m.perimeter > 0 && !cell.touches_border)
    m.compactness = 4 * std::numbers::pi * m.area / (m.perimeter * m.perimeter);
  return m;
}

std::string_view to_string(Extrema extrema) {
  switch (extrema) {
  case Extrema::max_max:
    return "max/max";
  case Extrema::max_min:
    return "max/min";
  case Extrema::min_max:
    return "min/max";
  case Extrema::min_min:
    return "min/min";
  }
  return "unknown";
}

Vertex_measures vertex_measures(const Extremal_mesh& mesh, std::uint32_t v) {
  require_vertex(mesh, v);
  const Extremal_mesh_vertex& vertex = mesh.vertex(v);
  Vertex_measures m;
  if (!vertex.star.empty())
    m.strength = m.stability = std::numeric_limits<double>::infinity();
  for (const Half_edge h : vertex.star) {
    double strength = mesh.edge(h / 2).strength;
    if (const auto next = next_on_line(mesh, h ^ 1U); next && *next / 2 != h / 2)
      strength += mesh.edge(*next / 2).strength;
    m.strength = std::min(m.strength, strength);
    m.stability = std::min(m.stability, edge_measures(mesh, h / 2).stability);
  }
  if (vertex.kind == Vertex_kind::extremal_point)
    m.extrema = is_max(vertex.extrema[0]) ? (is_max(vertex.extrema[1]) ? Extrema::max_max : Extrema::max_min)
                                          : (is_max(vertex.extrema[1]) ? Extrema::min_max : Extrema::min_min);
  return m;
}

} // namespace CGAL::Extremal_mesh_3
