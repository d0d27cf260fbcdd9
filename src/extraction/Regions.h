// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_EXTRACTION_REGIONS_H
#define EXTREMAL_MESH_3_SRC_EXTRACTION_REGIONS_H

#include "Arrangement.h"

namespace CGAL::Extremal_mesh_3 {

/// The components of the surface minus the lines, with what is summed over each. Their boundary walks are left empty.
class Regions {
public:
  /// \param patches  if not null, gets the pieces as polygons
  Regions(const Arrangement& arrangement, Cell_patches* patches);

  /// the region to which an interval of an edge belongs.
  std::uint32_t region(std::uint32_t edge, std::uint32_t ordinal) const {
    return region_[arrangement_.interval(edge, ordinal)];
  }
  std::vector<Extremal_mesh_cell>& cells() { return cells_; }

private:
  void unite_pieces();
  void count();
  void add_patches(Cell_patches& patches) const;

  const Arrangement& arrangement_;
  std::vector<std::uint32_t> region_; ///< of each interval
  std::vector<Extremal_mesh_cell> cells_;
};

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_EXTRACTION_REGIONS_H
