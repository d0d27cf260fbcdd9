// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_SRC_IMAGES_LANES_H
#define CGAL_EXTREMAL_MESH_3_SRC_IMAGES_LANES_H

namespace CGAL::Extremal_mesh_3 {

// Several numbers at once, in GCC's and Clang's own types: they compile for any processor, and always to the same
// operations in the same order. Plain loops were left with their sums in memory, three times slower.
using Sixteen_floats = float __attribute__((vector_size(64)));

using Four_doubles = double __attribute__((vector_size(32)));
using Eight_doubles = double __attribute__((vector_size(64)));
using Eight_floats = float __attribute__((vector_size(32)));

namespace internal {

#ifdef __x86_64__
template <class Work> [[gnu::target("avx2")]] void on_avx2(const Work& work) {
  work();
}

inline bool has_avx512() {
  return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl");
}
template <class Work> [[gnu::target("avx512f,avx512dq,avx512vl")]] void on_avx512(const Work& work) {
  work();
}
#endif

/// does some work, compiled for the widest vectors that this processor has: eight doubles are one operand, two or four. The
/// operations and their order are the same, and so is the result, to the last bit.
/// \param work  a function whose body is always inlined
template <class Work> void on_widest_vectors(const Work& work) {
#ifdef __x86_64__
  static const bool avx512 = has_avx512(), avx2 = __builtin_cpu_supports("avx2");
  if (avx512)
    return on_avx512(work);
  if (avx2)
    return on_avx2(work);
#endif
  work();
}

} // namespace internal
} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_SRC_IMAGES_LANES_H
