// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Loops over independent elements, on a given number of threads.
#ifndef EXTREMAL_MESH_3_SRC_CELLS_PARALLEL_H
#define EXTREMAL_MESH_3_SRC_CELLS_PARALLEL_H

#ifdef __SANITIZE_THREAD__
#include "parallel_without_tbb.h"
#else
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#endif
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>

namespace CGAL::Extremal_mesh_3 {

/// Runs loops on a number of threads, but no more than there are cores: TBB prints a warning if it is asked for more. 0 is one
/// per core.
class Thread_pool {
public:
  /// \throws std::invalid_argument if `threads` is negative
  explicit Thread_pool(int threads) : arena_(threads == 0 ? tbb::task_arena::automatic : checked(threads)) {}

  /// calls body(begin, end) for parts of [0, n) that cover it, of `grain` elements at least but for what is left over, in any order. A part
  /// may write only what is its own. What a body throws ends the loop, and is thrown again.
  template <class Body> void for_ranges(std::size_t n, std::size_t grain, const Body& body) {
    if (n == 0)
      return;
#ifdef __SANITIZE_THREAD__
    for_ranges_without_tbb(arena_.max_concurrency(), n, grain, body);
#else
    arena_.execute([&] {
      tbb::parallel_for(tbb::blocked_range<std::size_t>(0, n, grain),
                        [&](const auto& range) { body(range.begin(), range.end()); });
    });
#endif
  }

  /// calls body(i) for i in [0, n), in any order. Element i may write only what is its own.
  template <class Body> void for_each(std::size_t n, std::size_t grain, const Body& body) {
    for_ranges(n, grain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i != end; ++i)
        body(i);
    });
  }

private:
  static int checked(int threads) {
    if (threads < 0)
      throw std::invalid_argument("the number of threads is " + std::to_string(threads) + ", not 0 or more");
    using tbb::global_control;
    return int(std::min(std::size_t(threads), global_control::active_value(global_control::max_allowed_parallelism)));
  }
  tbb::task_arena arena_;
};

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_CELLS_PARALLEL_H
