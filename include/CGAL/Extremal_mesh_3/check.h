// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_CHECK_H
#define CGAL_EXTREMAL_MESH_3_CHECK_H

#include <CGAL/Extremal_mesh_3/Extremal_mesh.h>

#include <string>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

/// The outcome of one check.
struct Check {
  std::string name;    ///< a short identifier such as "euler"
  std::string claim;   ///< what must hold, in words
  bool applies = true; ///< `false`: nothing can be said here (`detail` tells why: border, degenerate area)
  bool holds = true;   ///< `false`: it is violated
  std::string detail;  ///< the numbers met; on a violation the offending elements with their positions
};

/// tests every identity of the extremal mesh that can be tested on the graph and its cells alone: degrees, families around
/// vertices, turns of Φ around them, links (stars, boundary walks, cells on both sides agree), alternation of signs, Euler characteristic, sums of the umbilic and the
/// vector field indices, geometry (finite, polylines end at their vertices). O(V + E + F).
/// \param mesh  an extremal mesh
/// \return one outcome per identity
std::vector<Check> check(const Extremal_mesh& mesh);

/// \param checks  the outcomes
/// \return `true` if no check that applies is violated
bool all_hold(const std::vector<Check>& checks);

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_CHECK_H
