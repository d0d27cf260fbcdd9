// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Extremal_mesh_3/read_mesh.h>

#include <fmt/format.h>

#include <string_view>

namespace CGAL::Extremal_mesh_3 {

bool Mesh_repairs::any() const {
  return isolated_vertices + welded_vertices + degenerate_faces + duplicate_faces + non_manifold_edges +
             non_manifold_vertices + flat_faces + turned_faces !=
         0;
}

std::string to_string(const Mesh_repairs& r) {
  std::string text;
  const auto add = [&](std::size_t count, std::string_view one, std::string_view several, std::string_view done) {
    if (count != 0)
      text += fmt::format("{}{} {} {}", text.empty() ? "repaired: " : ", ", count, count == 1 ? one : several, done);
  };
  add(r.isolated_vertices, "isolated vertex", "isolated vertices", "dropped");
  add(r.welded_vertices, "vertex", "vertices", "welded");
  add(r.degenerate_faces, "degenerate face", "degenerate faces", "dropped or divided");
  add(r.duplicate_faces, "duplicate face", "duplicate faces", "dropped");
  add(r.non_manifold_edges, "non-manifold edge", "non-manifold edges", "cut");
  add(r.non_manifold_vertices, "vertex", "vertices", "split");
  add(r.flat_faces, "face", "faces", "without area merged");
  add(r.turned_faces, "face", "faces", "turned");
  return text;
}

} // namespace CGAL::Extremal_mesh_3
