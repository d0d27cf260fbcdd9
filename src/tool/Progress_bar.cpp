// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Progress_bar.h"

#include <CGAL/Extremal_mesh_3/errors.h>

#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <unistd.h>
#include <utility>

namespace CGAL::Extremal_mesh_3::tool {

namespace {

volatile std::sig_atomic_t interrupted_flag = 0;

void note_interrupt(int signal) {
  interrupted_flag = signal;
}

void catch_signal(int signal) {
  if (std::signal(signal, note_interrupt) == SIG_IGN) // as nohup wants it
    std::signal(signal, SIG_IGN);
}

constexpr int width = 40;
constexpr auto interval = std::chrono::milliseconds(100);

} // namespace

void catch_interrupts() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP})
    catch_signal(signal);
}

int interrupting_signal() {
  return interrupted_flag;
}

void stop_if_interrupted() {
  if (interrupted_flag != 0)
    throw Cancelled();
}

Progress_bar::Progress_bar(std::string what, bool quiet)
    : what_(std::move(what)), visible_(!quiet && ::isatty(STDERR_FILENO) != 0),
      next_(std::chrono::steady_clock::now() + interval) {}

Progress_bar::~Progress_bar() {
  if (drawn_)
    std::fputs("\r\033[K", stderr);
}

Progress Progress_bar::progress() {
  return [this](double share) { return show(share); };
}

bool Progress_bar::show(double share) {
  const auto now = std::chrono::steady_clock::now();
  if (visible_ && now >= next_) {
    next_ = now + interval;
    drawn_ = true;
    const int filled = std::clamp(int(share * width), 0, width);
    const std::string line =
        fmt::format("\r{:<10} [{:#<{}}{:.<{}}] {:3.0f} %", what_, "", filled, "", width - filled, 100 * share);
    std::fputs(line.c_str(), stderr);
    std::fflush(stderr);
  }
  return interrupted_flag == 0;
}

} // namespace CGAL::Extremal_mesh_3::tool
