// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The course of a line within one cell: the points at which its type changes, and as many more as a tolerance asks for.
#ifndef EXTREMAL_MESH_3_SRC_EXTRACTION_REFINE_SEGMENT_H
#define EXTREMAL_MESH_3_SRC_EXTRACTION_REFINE_SEGMENT_H

#include "Sample.h"

#include <CGAL/Extremal_mesh_3/Extremal_mesh.h>

#include <array>
#include <optional>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

/// A point of a line with what is stored there.
struct Line_place {
  Point p{};
  Vector n{};
  double k1 = 0, k2 = 0;
  double derivative = 0;  ///< ∇e_i·t_i of the line's family i; NaN where it is not known
  double extremality = 0; ///< |e_j| of the other family
  Vector tangent{};       ///< of the line, unit; 0 where it is not known
};

/// what is stored at a point of a line.
/// \param step  a length that is small there, for surfaces that must take differences
Line_place line_place(const Surface& surface, Sample s, int family, double step);

/// A point of a line within a cell.
struct Line_point : Line_place {
  std::optional<Type_change_kind> change; ///< what makes the type change here, if it does
};

/// A piece of a line from a crossing or vertex to the next one.
struct Segment {
  struct End {
    Line_place at;
    /// here and at the place behind it on the same line, as one comes from the segment, if there is one
    std::optional<Line_place> behind;
    Sample sample;        ///< needed on surfaces that interpolate
    bool umbilic = false; ///< ∇e_i·t_i is infinite here, or nearly so
  };
  std::array<End, 2> ends;
  int family = 1;
  double sign_on_left = 1; ///< of E_g, looking along the segment with the normal upwards
  /// whether the line may be looked for beside the segment. If not, the segment is taken for the line
  bool may_bend = true;
  bool certain = true; ///< the line runs from end to end; otherwise it may run elsewhere, and is looked for nearby only
  double reach = 0;    ///< the size of the cell: the line goes nowhere farther from its ends
  int divided = 0;     ///< how many times what it is a piece of was divided
};

/// tells whether there is anything to be found on the segment, or may be. Cheap, and does not look at the samples.
bool may_have_points(const Segment& segment, double tolerance);

struct Segment_points {
  std::vector<Line_point> points; ///< from the first end to the second, without them
  bool straight = false;          ///< points that there should be could not be placed on the line
};

/// finds the points of a line between the ends of a segment: where its type changes, and where it bends so that no point
/// of it is farther than `tolerance` from the polyline (0: than a small part of the segment, as far as the tangents at its ends
/// tell).
Segment_points refine_segment(const Surface& surface, const Segment& segment, double tolerance);

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_EXTRACTION_REFINE_SEGMENT_H
