// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "memory_limit.h"

#include "commands.h"

#include <fmt/format.h>

#include <charconv>
#include <limits>
#include <string_view>
#include <sys/resource.h>
#include <unistd.h>

namespace CGAL::Extremal_mesh_3::tool {

namespace {

std::uint64_t parse(const std::string& text) {
  constexpr std::string_view units = "KMGT";
  std::string_view rest = text;
  if (rest.ends_with('B') || rest.ends_with('b'))
    rest.remove_suffix(1);
  double size = 0;
  const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), size);
  rest.remove_prefix(std::size_t(end - rest.data()));
  if (rest.ends_with('i')) // KiB is what KB is here
    rest.remove_suffix(1);
  const char letter = rest.size() == 1 ? char(rest[0] >= 'a' ? rest[0] - 'a' + 'A' : rest[0]) : ' ';
  const std::size_t unit = units.find(letter);
  constexpr double most = 0x1p62;
  const bool is_known = error == std::errc() && (rest.empty() || unit != units.npos);
  if (is_known && unit != units.npos)
    for (std::size_t i = 0; i <= unit; ++i)
      size *= 1024;
  if (!is_known || !(size >= 1 && size <= most))
    throw Usage_error(fmt::format("'{}' is not a size of memory; give --memory-limit a number of bytes, or one such as "
                                  "500M or 2G",
                                  text));
  return std::uint64_t(size);
}

std::uint64_t memory_of_machine() {
  const long pages = ::sysconf(_SC_PHYS_PAGES), size = ::sysconf(_SC_PAGE_SIZE);
  return pages > 0 && size > 0 ? std::uint64_t(pages) * std::uint64_t(size) : std::numeric_limits<std::uint64_t>::max();
}

std::string readable(double bytes) {
  constexpr double mega = 0x1p20, giga = 0x1p30;
  return bytes < giga ? fmt::format("{:.0f} MB", bytes / mega) : fmt::format("{:.1f} GB", bytes / giga);
}

} // namespace

Memory_limit::Memory_limit(const std::string& text)
    : bytes_(text.empty() ? memory_of_machine() : parse(text)), is_given_(!text.empty()) {
  if (!is_given_)
    return;
  // What can be written to: other than the address space, it has no part that is only reserved.
  ::rlimit limit{};
  if (::getrlimit(RLIMIT_DATA, &limit) == 0 && bytes_ < limit.rlim_cur) {
    limit.rlim_cur = bytes_;
    ::setrlimit(RLIMIT_DATA, &limit);
  }
}

void Memory_limit::require(double bytes, const std::string& what) const {
  if (bytes > double(bytes_))
    throw std::runtime_error(fmt::format("{} takes {} of memory at least, more than the {} {}", what, readable(bytes),
                                         readable(double(bytes_)),
                                         is_given_ ? "that --memory-limit allows" : "that this machine has"));
}

} // namespace CGAL::Extremal_mesh_3::tool
