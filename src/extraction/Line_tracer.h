// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_EXTRACTION_LINE_TRACER_H
#define EXTREMAL_MESH_3_SRC_EXTRACTION_LINE_TRACER_H

#include "Arrangement.h"
#include "Regions.h"

#include <CGAL/Extremal_mesh_3/Extremal_mesh.h>

namespace CGAL::Extremal_mesh_3 {

/// Stitches the segments of an arrangement into the vertices and edges of the extremal mesh, and walks around its
/// cells.
class Line_tracer {
public:
  /// \param regions  gets the boundary walks of its cells
  Line_tracer(const Arrangement& arrangement, Regions& regions);

  std::vector<Extremal_mesh_vertex> vertices;
  std::vector<Extremal_mesh_edge> edges;

private:
  /// A step on a line: from a crossing into the cell on one side of its edge.
  struct Step {
    std::uint32_t crossing = no_id;
    std::uint32_t side = 0;
  };

  void make_vertices();
  Extremal_mesh_vertex vertex_of(const Node& node) const;
  void trace_from_nodes();
  void trace_from_border();
  void trace_closed_lines();
  Step follow(Step step, std::vector<Step>& met) const;
  void add_edge(std::uint32_t source, std::size_t source_slot, const std::vector<Step>& met, Step last);
  std::vector<Line_point> points_of(std::uint32_t source, std::uint32_t target, int family,
                                    const std::vector<Step>& met) const;
  void measure(Extremal_mesh_edge& edge, const std::vector<double>& derivative) const;
  void walk_around_cells();
  std::vector<std::uint32_t> next_on_border() const;

  const Arrangement& arrangement_;
  Regions& regions_;
  double area_ = 0;                          ///< of the surface
  std::vector<char> used_;                   ///< crossings that belong to an edge already
  std::vector<std::uint32_t> border_vertex_; ///< the boundary vertex at a crossing, or `no_id`
};

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_EXTRACTION_LINE_TRACER_H
