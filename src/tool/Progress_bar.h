// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_TOOL_PROGRESS_BAR_H
#define EXTREMAL_MESH_3_SRC_TOOL_PROGRESS_BAR_H

#include <CGAL/Extremal_mesh_3/types.h>

#include <chrono>
#include <string>

namespace CGAL::Extremal_mesh_3::tool {

/// makes Ctrl-C, and what else asks a program to end, ask for a stop instead of ending it, so that no output is missing beside
/// another one. What is ignored stays ignored.
void catch_interrupts();
/// the signal that asked for it; 0 if there was none.
int interrupting_signal();

/// \throws Cancelled if there was such a signal
void stop_if_interrupted();

/// the text of a bar: what is done, a share in [0, 1] of it, how many percent are done in a second and how long the rest takes if it goes on
/// like that. Rate and rest are told as soon as something can be said: after half a second and a thousandth of the work.
std::string progress_line(const std::string& what, double share, double elapsed_seconds);

/// A bar on standard error while something long runs, if that is a terminal. It is wiped away at the end.
class Progress_bar {
public:
  Progress_bar(std::string what, bool quiet);
  Progress_bar(const Progress_bar&) = delete;
  Progress_bar& operator=(const Progress_bar&) = delete;
  ~Progress_bar();

  /// for the options of an algorithm; must not outlive the bar.
  Progress progress();

private:
  bool show(double share);

  std::string what_;
  bool visible_;
  bool drawn_ = false;
  std::chrono::steady_clock::time_point start_, next_;
};

} // namespace CGAL::Extremal_mesh_3::tool

#endif // EXTREMAL_MESH_3_SRC_TOOL_PROGRESS_BAR_H
