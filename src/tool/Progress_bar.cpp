// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Progress_bar.h"

#include <CGAL/Extremal_mesh_3/errors.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
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

constexpr int width = 30; // the line has room in 80 columns
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

std::string progress_line(const std::string& what, double share, double elapsed_seconds) {
  const int filled = std::clamp(int(share * width), 0, width);
  std::string line =
      fmt::format("{:<10} [{:#<{}}{:.<{}}] {:3.0f} %", what, "", filled, "", width - filled, 100 * share);
  if (elapsed_seconds < 0.5 || share < 1e-3)
    return line;
  const double rate = share / elapsed_seconds;
  const auto left = std::lround(std::max(0.0, 1 - share) / rate);
  line += fmt::format("  {:.3g} %/s  ", 100 * rate);
  line += left < 3600 ? fmt::format("{}:{:02} left", left / 60, left % 60)
                      : fmt::format("{}:{:02}:{:02} left", left / 3600, left / 60 % 60, left % 60);
  return line;
}

Progress_bar::Progress_bar(std::string what, bool quiet)
    : what_(std::move(what)), visible_(!quiet && ::isatty(STDERR_FILENO) != 0),
      start_(std::chrono::steady_clock::now()), next_(start_ + interval) {}

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
    const std::string line = progress_line(what_, share, std::chrono::duration<double>(now - start_).count());
    std::fputs(("\r" + line + "\033[K").c_str(), stderr);
    std::fflush(stderr);
  }
  return interrupted_flag == 0;
}

} // namespace CGAL::Extremal_mesh_3::tool
