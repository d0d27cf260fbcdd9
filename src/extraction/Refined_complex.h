// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The cells of a surface, divided until the course of the extremal lines in each is certain.
#ifndef EXTREMAL_MESH_3_SRC_EXTRACTION_REFINED_COMPLEX_H
#define EXTREMAL_MESH_3_SRC_EXTRACTION_REFINED_COMPLEX_H

#include "Folds.h"
#include "Sample.h"

#include <CGAL/Extremal_mesh_3/Cell_complex.h>
#include <CGAL/Extremal_mesh_3/extract_extremal_mesh.h>

#include <cstdint>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

constexpr std::uint32_t no_id = 0xffffffffU;

/// An edge. Once divided it has two children, `child` from a to the middle and `child + 1` from the middle to b.
struct Refined_edge {
  std::uint32_t a = 0, b = 0;
  std::uint32_t child = no_id;
  std::array<std::uint32_t, 2> cell{no_id, no_id}; ///< the leaf cells left of a→b and of b→a
  std::uint8_t level = 0;
  bool wanted = false;           ///< is to be divided
  std::int32_t winding = 0;      ///< Φ turns by phase(b) − phase(a) + 2π·winding from a to b
  double turn_P = 0, turn_Q = 0; ///< the angles by which P and Q turn from a to b, after parallel transport

  bool divided() const { return child != no_id; }
};

/// Where an edge is to be divided: above a + t (b − a).
struct Edge_cut {
  std::uint32_t edge = no_id;
  double t = 0.5;
};

/// What lies in a cell.
enum class Content : std::uint8_t {
  undecided,
  lines,          ///< pieces of lines, or nothing
  extremal_point, ///< one, its four branches reach the border
  umbilic,        ///< one, with the branches it must have
  unresolved      ///< a vertex that stays complicated, with everything that crosses the border
};

/// Two sides of a cell, by their places among `Refined_cell::sides`; the same twice: none.
struct Side_pair {
  std::uint8_t i = 0, j = 0;
  bool none() const { return i == j; }
};

/// A cell. Its sides are half-edges of edges that may be divided further. A divided cell has two children, or one per side.
struct Refined_cell {
  std::vector<Half_edge> sides;
  std::uint32_t center = no_id; ///< sample at the middle, or at the vertex that the cell holds
  std::uint8_t level = 0;
  bool half_level = false; ///< halved once more than its level tells
  bool divided = false;
  bool degenerate = false; ///< E_g is 0 up to rounding: what is found here means nothing, and is not looked into
  bool waits = false;      ///< undecided until edges around it are cut
  bool certain = true;     ///< accepted by the tests, not for want of further levels
  Content content = Content::undecided;
  std::int8_t winding_P = 0, winding_Q = 0;
  /// where four crossings of one level can be joined in two ways: the sign of E_g on the side that is connected
  std::int8_t joined = 0;
  std::uint8_t crossings = 0; ///< of its border, when it was looked at
  Side_pair halved_between;   ///< to be divided in two, from the middle of one of these sides to that of the other
};

class Refined_complex {
public:
  /// \param samples  at the points of `cells`
  /// \param degenerate  of each cell: E_g is 0 there up to rounding
  Refined_complex(const Surface& surface, const Cell_complex& cells, std::vector<Sample> samples,
                  const std::vector<char>& degenerate, const Extraction_options& options);

  /// for how many elements to take memory where there are n to begin with: mostly few are added, and to move all of them costs more.
  static std::size_t room_for(std::size_t n) { return n + n / 8; }

  /// divides edges and cells until all are decided.
  void refine();

  const Surface& surface() const { return surface_; }
  const std::vector<Sample>& samples() const { return samples_; }
  const std::vector<Refined_edge>& edges() const { return edges_; }
  const std::vector<Refined_cell>& cells() const { return cells_; }
  Extraction_report& report() { return report_; }

  /// the undivided half-edges along the border of a cell, counter-clockwise.
  void border(const Refined_cell& cell, std::vector<Half_edge>& half_edges) const;
  /// calls visit(h) for each of them, until it returns false.
  /// \return whether it never did
  template <class Visit> bool visit_border(const Refined_cell& cell, const Visit& visit) const {
    for (const Half_edge side : cell.sides)
      if (!visit_parts(side, visit))
        return false;
    return true;
  }
  std::uint32_t source(Half_edge h) const { return h % 2 == 0 ? edges_[h / 2].a : edges_[h / 2].b; }
  std::uint32_t target(Half_edge h) const { return source(h ^ 1U); }
  /// the sample at which a divided half-edge was cut first.
  std::uint32_t middle_sample(Half_edge h) const { return edges_[edges_[h / 2].child].b; }
  /// the angle by which parallel transport turns around the border of a cell.
  double holonomy(const std::vector<Half_edge>& border) const { return folds_.holonomy(*this, border); }
  /// the cell on the left of an undivided half-edge, or `no_id`.
  std::uint32_t cell_of(Half_edge h) const { return edges_[h / 2].cell[h % 2]; }

private:
  void measure(std::uint32_t edge);
  bool should_divide(const Refined_edge& edge) const;
  void settle_edges(std::size_t first);
  void divide_edges(const std::vector<Edge_cut>& cuts);
  Sample middle_of(std::uint32_t edge) const;
  void cut_edges(std::vector<Edge_cut> cuts);
  void divide_cells(const std::vector<std::uint32_t>& ids);
  void quarter(std::uint32_t cell);
  void halve(std::uint32_t cell);
  void add_child(std::uint32_t cell, std::vector<Half_edge> sides);
  /// \param cuts  gets the cuts that cells ask for before they are decided; null: none is made any more
  void analyse(const std::vector<std::uint32_t>& all, bool may_divide, std::vector<Edge_cut>* cuts);
  void settle_folds();
  bool is_turned_over(const Refined_cell& cell) const;
  void own(Half_edge h, std::uint32_t cell);
  Half_edge half(Half_edge h, int which) const;
  template <class Visit> bool visit_parts(Half_edge h, const Visit& visit) const {
    if (!edges_[h / 2].divided())
      return visit(h);
    return visit_parts(half(h, 0), visit) && visit_parts(half(h, 1), visit);
  }

  const Surface& surface_;
  Extraction_options options_;
  std::vector<Sample> samples_;
  std::vector<Refined_edge> edges_;
  std::vector<Refined_cell> cells_;
  Folds folds_;
  bool closed_ = true;
  std::size_t most_cells_ = 0; ///< no cell is divided once there are so many
  int euler_characteristic_ = 0;
  std::vector<std::uint32_t> touched_; ///< cells to be looked at again, as edges around them were divided
  Extraction_report report_;
};

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_EXTRACTION_REFINED_COMPLEX_H
