// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The lines drawn across the refined cells: crossings of edges, segments between them, vertices in cells, and the
// regions that they leave. Everything is found by ids, nothing by comparing coordinates.
#ifndef EXTREMAL_MESH_3_SRC_EXTRACTION_ARRANGEMENT_H
#define EXTREMAL_MESH_3_SRC_EXTRACTION_ARRANGEMENT_H

#include "Refined_complex.h"
#include "analyse_cell.h"
#include "refine_segment.h"

#include <cstdint>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

/// What a segment leads to.
struct Segment_end {
  std::uint32_t id = no_id; ///< of a crossing, or of a node if `node`
  bool node = false;
};

/// A point in which a line crosses an undivided edge.
struct Crossing : Line_place {
  std::uint32_t edge = no_id;
  std::uint32_t ordinal = 0; ///< among the crossings of the edge, from a to b
  int family = 1;
  /// where the line goes from here, in the cells on the left of half-edges 2·edge and 2·edge + 1
  std::array<Segment_end, 2> next;
  std::int32_t level = 0; ///< the phase, lifted from `a`, is π·level here
  double t = 0;           ///< where it lies on the edge, from the end with the smaller coordinates
  bool placed = true;     ///< on the line; not where the edge has more crossings than can be told apart
};

/// A vertex inside a cell with the crossings to which its branches lead, counter-clockwise.
struct Node {
  std::uint32_t cell = no_id;
  std::vector<std::uint32_t> crossings;
  std::vector<std::uint8_t> sides;    ///< of each crossing: the side on which this node's cell is
  std::array<double, 2> derivative{}; ///< ∇e_i·t_i of both families, at an extremal point
};

/// The points of a line between a crossing and what its segment leads to: ids, counted up or down.
struct Points_between {
  std::uint32_t first = 0, count = 0;
  bool downwards = false;
  std::uint32_t id(std::uint32_t i) const { return downwards ? first - i : first + i; }
};

/// A polygonal part of a cell within one region.
struct Piece {
  struct Corner {
    enum class Kind : std::uint8_t { sample, crossing, node, line_point } kind;
    std::uint32_t id;
  };
  std::vector<Corner> corners;          ///< counter-clockwise
  std::vector<std::uint32_t> intervals; ///< one per connected part of the cell's border in the piece
};

class Arrangement {
public:
  explicit Arrangement(Refined_complex& complex, const Extraction_options& options);

  const Refined_complex& complex() const { return complex_; }
  const std::vector<Crossing>& crossings() const { return crossings_; }
  const std::vector<Node>& nodes() const { return nodes_; }
  /// the points of lines inside cells.
  const std::vector<Line_point>& line_points() const { return line_points_; }
  /// those on the segment from a crossing into the cell on a side, in that order.
  Points_between points_between(std::uint32_t crossing, std::uint32_t side) const;
  /// a node as a place on a line of a family. At an umbilic ∇e·t may be infinite and e_j has no limit: there they are those
  /// of the place `beside` it on the line.
  Line_place at_node(std::uint32_t node, int family, const Line_place& beside) const;

  std::size_t number_of_segments() const { return number_of_segments_; }
  /// of segments that are coarser than they should be.
  std::size_t number_of_straight_segments() const { return number_of_straight_segments_; }

  /// An edge with m crossings has m + 1 intervals. Those at its ends belong to the end points; intervals are numbered
  /// so that interval i < samples().size() stands for the point i and the parts of edges next to it.
  std::uint32_t interval(std::uint32_t edge, std::uint32_t ordinal) const;
  std::uint32_t number_of_intervals() const { return number_of_intervals_; }
  std::uint32_t crossings_of(std::uint32_t edge) const { return first_crossing_[edge + 1] - first_crossing_[edge]; }

  /// tells whether a line meets the border of a cell.
  bool is_crossed(std::uint32_t cell) const { return crossed_[cell] != 0; }
  /// the pieces into which the lines cut an undivided cell.
  void pieces(std::uint32_t cell, std::vector<Piece>& pieces) const;
  const Point& position(const Piece::Corner& corner) const;
  const Vector& normal(const Piece::Corner& corner) const;

private:
  void number_crossings();
  void place_crossings(const Extraction_options& options);
  void place(Crossing& crossing, std::uint32_t count) const;
  void spread(std::uint32_t edge);
  Sample sample_of(const Crossing& crossing) const;
  void draw(std::uint32_t cell);
  void refine_segments(const Extraction_options& options);
  std::uint32_t other_end(std::uint32_t end) const;
  Segment segment_from(std::uint32_t end) const;
  double size_of(std::uint32_t cell) const;
  std::optional<Line_place> behind(std::uint32_t end) const;
  std::uint32_t id(const Border_crossings& met, std::size_t i) const;

  Refined_complex& complex_;
  std::vector<std::uint32_t> first_crossing_, first_interval_;
  std::uint32_t number_of_intervals_ = 0;
  std::vector<Crossing> crossings_;
  std::vector<Node> nodes_;
  std::vector<char> crossed_; ///< of each cell
  /// A segment has the number 2·crossing + side of the end from which its points are numbered; range i are its points.
  std::vector<std::uint32_t> first_line_point_;
  std::vector<Line_point> line_points_;
  std::size_t number_of_segments_ = 0, number_of_straight_segments_ = 0;
};

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_EXTRACTION_ARRANGEMENT_H
