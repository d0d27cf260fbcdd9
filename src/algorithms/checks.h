// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The single checks of `check()`.
#ifndef EXTREMAL_MESH_3_SRC_ALGORITHMS_CHECKS_H
#define EXTREMAL_MESH_3_SRC_ALGORITHMS_CHECKS_H

#include <CGAL/Extremal_mesh_3/check.h>

#include <cstddef>
#include <string>

namespace CGAL::Extremal_mesh_3 {

/// Gathers violations of one claim: the first few are told with their positions, the others counted.
class Violations {
public:
  void at(const std::string& what, const Point& where);
  Check check(std::string name, std::string claim, const std::string& if_it_holds) const;

private:
  std::size_t count_ = 0;
  std::string told_;
};

// Structure: the parts of the mesh agree with each other.
Check check_stars(const Extremal_mesh& mesh);
Check check_walks(const Extremal_mesh& mesh);
Check check_geometry(const Extremal_mesh& mesh);

// Identities: what the theory says of every extremal mesh.
Check check_degrees(const Extremal_mesh& mesh);
Check check_families(const Extremal_mesh& mesh);
Check check_umbilics(const Extremal_mesh& mesh);
Check check_winding(const Extremal_mesh& mesh);
Check check_alternation(const Extremal_mesh& mesh);
Check check_cells(const Extremal_mesh& mesh);
Check check_euler(const Extremal_mesh& mesh);
Check check_faces(const Extremal_mesh& mesh);
Check check_umbilic_index(const Extremal_mesh& mesh);
Check check_field_index(const Extremal_mesh& mesh);
Check check_even_extremal_points(const Extremal_mesh& mesh);
Check check_border(const Extremal_mesh& mesh);
Check check_border_parity(const Extremal_mesh& mesh);
Check check_type_changes(const Extremal_mesh& mesh);

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_ALGORITHMS_CHECKS_H
