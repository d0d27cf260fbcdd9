// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_SRC_IMAGES_IN_CHILD_H
#define CGAL_EXTREMAL_MESH_3_SRC_IMAGES_IN_CHILD_H

#include <cstddef>
#include <functional>
#include <optional>

namespace CGAL::Extremal_mesh_3 {

/// what a child process may take.
struct Child_limits {
  unsigned seconds = 60; ///< of processor time
  std::size_t bytes = 0; ///< beyond what its parent has; not limited under sanitizers, which reserve all addresses
};

/// tries something with each of `number` things in a child process, for libraries that end the program, or take all memory, where they should
/// fail. Exceptions are no failure, as they can be caught afterwards.
/// \return the thing with which the child came to its end, if it did
/// \throws std::runtime_error if there is no room for a child
std::optional<std::size_t> first_that_ends_a_child(std::size_t number, const std::function<void(std::size_t)>& attempt,
                                                   const Child_limits& limits);

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_SRC_IMAGES_IN_CHILD_H
