// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_IO_OFF_FILE_H
#define CGAL_EXTREMAL_MESH_3_IO_OFF_FILE_H

#include "Text_file.h"
#include "colours.h"

#include <CGAL/Extremal_mesh_3/types.h>

#include <cstdint>
#include <span>
#include <string>

namespace CGAL::Extremal_mesh_3 {

/// An OFF file: points first, then polygons, both as many as announced.
class Off_file {
public:
  Off_file(const std::string& file, std::size_t number_of_points, std::size_t number_of_polygons) : out_(file) {
    out_.print(FMT_COMPILE("OFF\n{} {} 0\n"), number_of_points, number_of_polygons);
  }

  void add_point(const Point& p) { out_.print(FMT_COMPILE("{} {} {}\n"), p[0], p[1], p[2]); }
  void add_polygon(std::span<const std::uint32_t> corners) {
    add_corners(corners);
    out_ << "\n";
  }
  void add_polygon(std::span<const std::uint32_t> corners, const Colour& colour) {
    add_corners(corners);
    out_.print(FMT_COMPILE(" {} {} {}\n"), colour[0], colour[1], colour[2]);
  }
  void commit() { out_.commit(); }

private:
  void add_corners(std::span<const std::uint32_t> corners) {
    out_.print(FMT_COMPILE("{}"), corners.size());
    for (const std::uint32_t corner : corners)
      out_.print(FMT_COMPILE(" {}"), corner);
  }

  Text_file out_;
};

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_IO_OFF_FILE_H
