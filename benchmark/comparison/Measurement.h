// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the programs of the comparison tell the script that runs them: one line of JSON.
#ifndef EXTREMAL_MESH_3_BENCHMARK_COMPARISON_MEASUREMENT_H
#define EXTREMAL_MESH_3_BENCHMARK_COMPARISON_MEASUREMENT_H

#include <cstdio>
#include <ctime>
#include <utility>

/// the CPU time of the process, in seconds: other work on the machine disturbs it less than the time on the wall.
inline double cpu_seconds() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
}

/// measures some work.
template <class Work> double seconds_of(Work&& work) {
  const double start = cpu_seconds();
  std::forward<Work>(work)();
  return cpu_seconds() - start;
}

/// \param items  what the time is spent on: vertices, say
inline void report(double seconds, std::size_t items) {
  std::printf("{\"seconds\": %.6f, \"items\": %zu}\n", seconds, items);
}

inline void report_error(double error) {
  std::printf("{\"error\": %.6g}\n", error);
}

#endif // EXTREMAL_MESH_3_BENCHMARK_COMPARISON_MEASUREMENT_H
