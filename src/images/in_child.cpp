// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "in_child.h"

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <exception>
#include <fcntl.h>
#include <fstream>
#include <new>
#include <stdexcept>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace CGAL::Extremal_mesh_3 {
namespace {

/// A counter that a process shares with its child.
class Shared_counter {
public:
  Shared_counter() : page_(mmap(nullptr, sizeof(Counter), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0)) {
    if (page_ == MAP_FAILED)
      throw std::bad_alloc();
    counter_ = new (page_) Counter(0);
  }
  Shared_counter(const Shared_counter&) = delete;
  Shared_counter& operator=(const Shared_counter&) = delete;
  ~Shared_counter() { munmap(page_, sizeof(Counter)); }

  std::atomic<std::size_t>& value() { return *counter_; }

private:
  using Counter = std::atomic<std::size_t>;
  void* page_;
  Counter* counter_;
};

/// the addresses that this process has, in bytes.
std::size_t own_size() {
  std::size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * std::size_t(sysconf(_SC_PAGESIZE));
}

/// has signals end the child without a core file, and what its libraries say go nowhere.
void become_quiet(const Child_limits& limits) {
  for (const int number : std::array{SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGINT, SIGTERM})
    std::signal(number, SIG_DFL);
  rlimit limit{0, 0};
  setrlimit(RLIMIT_CORE, &limit);
  limit = {limits.seconds, limits.seconds};
  setrlimit(RLIMIT_CPU, &limit);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  if (const std::size_t size = own_size(); size > 0) {
    limit = {size + limits.bytes, size + limits.bytes};
    setrlimit(RLIMIT_AS, &limit);
    std::set_new_handler([] { _exit(1); }); // before a library catches the exception
  }
#endif
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (nowhere >= 0) {
    dup2(nowhere, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);
  }
}

} // namespace

std::optional<std::size_t> first_that_ends_a_child(std::size_t number, const std::function<void(std::size_t)>& attempt,
                                                   const Child_limits& limits) {
  Shared_counter counter;
  const pid_t child = fork();
  if (child < 0)
    throw std::runtime_error("there is no room for a child process, in which it is looked at first");
  if (child == 0) {
    become_quiet(limits);
    for (std::size_t i = 0; i < number; ++i) {
      counter.value() = i;
      try {
        attempt(i);
      } catch (const std::exception&) { // told where it is caught again
      }
    }
    _exit(0); // without what the program does at its end
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0)
    return std::nullopt;
  return counter.value().load();
}

} // namespace CGAL::Extremal_mesh_3
