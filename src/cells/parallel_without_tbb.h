// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What TBB does with a loop, for ThreadSanitizer: it sees neither forks nor joins in a TBB that was not built for it, and would call
// everything that one loop writes and the next one reads a race.
#ifndef EXTREMAL_MESH_3_SRC_CELLS_PARALLEL_WITHOUT_TBB_H
#define EXTREMAL_MESH_3_SRC_CELLS_PARALLEL_WITHOUT_TBB_H

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

/// calls body(begin, end) for parts of [0, n) on a number of threads, this one among them
/// \pre threads > 0
template <class Body> void for_ranges_without_tbb(int threads, std::size_t n, std::size_t grain, const Body& body) {
  const std::size_t part = std::max({grain, n / (4 * std::size_t(threads)), std::size_t(1)});
  std::atomic<std::size_t> next = 0;
  std::exception_ptr thrown;
  std::mutex mutex;
  const auto take_parts = [&] {
    for (std::size_t begin = next.fetch_add(part); begin < n; begin = next.fetch_add(part)) {
      try {
        body(begin, std::min(n, begin + part));
      } catch (...) {
        const std::scoped_lock lock(mutex);
        if (!thrown)
          thrown = std::current_exception();
        next = n;
      }
    }
  };
  std::vector<std::thread> others;
  for (std::size_t i = 1; i < std::min(std::size_t(threads), (n + part - 1) / part); ++i)
    others.emplace_back(take_parts);
  take_parts();
  for (std::thread& t : others)
    t.join();
  if (thrown)
    std::rethrow_exception(thrown);
}

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_CELLS_PARALLEL_WITHOUT_TBB_H
