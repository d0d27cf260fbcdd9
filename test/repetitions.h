// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_TEST_REPETITIONS_H
#define CGAL_EXTREMAL_MESH_3_TEST_REPETITIONS_H

#include <algorithm>

/// how often to repeat what is done `n` times over random input: a tenth of that under a sanitizer, where it takes ten times as long and what is
/// looked for is in the code, not in the input.
constexpr unsigned repetitions(unsigned n) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  return std::min(n, std::max(2U, n / 10));
#else
  return n;
#endif
}

#endif // CGAL_EXTREMAL_MESH_3_TEST_REPETITIONS_H
