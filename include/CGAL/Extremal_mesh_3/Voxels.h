// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_VOXELS_H
#define CGAL_EXTREMAL_MESH_3_VOXELS_H

#include <cstddef>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

/// Gives room for voxels: in memory, or in a temporary file that is mapped into it. Of the latter the system keeps in memory what
/// there is room for. The file has no name, so nothing of it is left whatever happens.
class Voxel_allocator {
public:
  using value_type = float;
  using propagate_on_container_copy_assignment = std::true_type;
  using propagate_on_container_move_assignment = std::true_type;
  using propagate_on_container_swap = std::true_type;
  using is_always_equal = std::false_type;
  /// what the concept Allocator asks for
  template <class Number> struct rebind {
    static_assert(std::is_same_v<Number, float>, "voxels are floats");
    using other = Voxel_allocator;
  };

  /// in memory
  Voxel_allocator() = default;
  /// in temporary files
  /// \param folder  where these are made; it should not be one that is itself kept in memory
  explicit Voxel_allocator(std::string folder) : folder_(std::move(folder)) {}

  bool is_in_file() const { return !folder_.empty(); }

  /// \param n  how many voxels
  /// \return room for them, not initialised
  /// \throws std::bad_alloc if memory has not so much room
  /// \throws Io_error if no file of that size can be made, saying why
  float* allocate(std::size_t n);
  /// \param p  what `allocate()` returned
  /// \param n  for so many voxels
  void deallocate(float* p, std::size_t n) noexcept;

  /// \return whether what one allocator gave the other can take back
  friend bool operator==(const Voxel_allocator& a, const Voxel_allocator& b) = default;

private:
  std::string folder_;
};

/// The values of a volume.
using Voxels = std::vector<float, Voxel_allocator>;

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_VOXELS_H
