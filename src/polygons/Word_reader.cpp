// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Word_reader.h"

#include "../images/parse_number.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>

namespace CGAL::Extremal_mesh_3 {

namespace {

bool is_blank(char c) {
  return c == ' ' || (c >= '\t' && c <= '\r');
}

} // namespace

void throw_expected(const std::string& place, const std::string& expected, std::string_view found) {
  constexpr std::size_t longest = 20;
  if (found.empty())
    throw std::runtime_error(fmt::format("{}: expected {}, found the end", place, expected));
  throw std::runtime_error(fmt::format("{}: expected {}, found '{}{}'", place, expected, found.substr(0, longest),
                                       found.size() > longest ? "…" : ""));
}

std::string_view Word_reader::word() {
  while (at_ < text_.size()) {
    const char c = text_[at_];
    if (comment_ != 0 && c == comment_)
      at_ = std::min(text_.find('\n', at_), text_.size());
    else if (is_blank(c)) {
      line_ += c == '\n';
      ++at_;
    } else
      break;
  }
  const std::size_t begin = at_;
  while (at_ < text_.size() && !is_blank(text_[at_]) && (comment_ == 0 || text_[at_] != comment_))
    ++at_;
  return text_.substr(begin, at_ - begin);
}

void Word_reader::skip_line() {
  at_ = std::min(text_.find('\n', at_), text_.size());
}

double Word_reader::coordinate() {
  const std::string_view text = word();
  const auto value = parse_number(text);
  if (!value || !std::isfinite(*value))
    throw_expected(line_name(line_), "a finite coordinate", text);
  return *value;
}

std::uint64_t Word_reader::number(const char* expected) {
  const std::string_view text = word();
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size())
    throw_expected(line_name(line_), expected, text);
  return value;
}

std::uint64_t Word_reader::count(const char* expected, std::size_t least) {
  const std::uint64_t n = number(expected);
  const std::uint64_t most = (text_.size() - at_ + 1) / least; // + 1: the last blank may be missing
  if (n > most)
    throw std::runtime_error(fmt::format(
        "line {}: expected {}, found {}, which is more than the rest of the file can hold", line_, expected, n));
  return n;
}

std::uint32_t Word_reader::index(const char* expected, std::size_t n) {
  const std::string_view text = word();
  std::uint32_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || value >= n)
    throw_expected(line_name(line_), fmt::format("{} from 0 to {}", expected, std::int64_t(n) - 1), text);
  return value;
}

} // namespace CGAL::Extremal_mesh_3
