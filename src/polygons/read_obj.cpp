// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Vertices and faces of Wavefront's object format; all else in it is left out.
#include "Word_reader.h"
#include "soup_readers.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>
#include <stdexcept>
#include <string>

namespace CGAL::Extremal_mesh_3 {

namespace {

/// The lines of a text. One that ends with a backslash goes on in the next.
class Lines {
public:
  explicit Lines(std::string_view text) : text_(text) {}

  /// \return false at the end
  bool next(std::string_view& line) {
    if (at_ >= text_.size())
      return false;
    number_ = next_number_;
    line = one();
    if (!line.ends_with('\\'))
      return true;
    joined_.clear();
    while (line.ends_with('\\') && at_ < text_.size()) {
      joined_ += line.substr(0, line.size() - 1);
      joined_ += ' ';
      line = one();
    }
    joined_ += line;
    line = joined_;
    return true;
  }
  std::size_t number() const { return number_; }

private:
  std::string_view one() {
    const std::size_t end = std::min(text_.find('\n', at_), text_.size());
    std::string_view line = text_.substr(at_, end - at_);
    at_ = end + 1;
    ++next_number_;
    if (line.ends_with('\r'))
      line.remove_suffix(1);
    return line;
  }

  std::string_view text_;
  std::size_t at_ = 0, number_ = 0, next_number_ = 1;
  std::string joined_;
};

/// "3", "3/1", "3/1/2" or "3//2"; counted from 1, or backwards from −1, the last vertex before.
/// \return counted from 0
std::uint32_t corner(std::string_view word, std::size_t vertices, std::size_t line) {
  const std::string_view text = word.substr(0, word.find('/'));
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (value < 0)
    value += std::int64_t(vertices) + 1;
  if (error != std::errc() || end != text.data() + text.size() || value < 1 ||
      value > std::numeric_limits<std::uint32_t>::max())
    throw_expected(line_name(line), fmt::format("the number of a vertex, with {} before it", vertices), word);
  return std::uint32_t(value - 1);
}

} // namespace

Polygon_soup read_obj(std::string_view content) {
  Polygon_soup soup;
  std::uint32_t largest = 0; // faces may come before their vertices
  std::size_t line_of_largest = 0;
  Lines lines(content);
  for (std::string_view line; lines.next(line);) {
    Word_reader words(line, '#', lines.number());
    const std::string_view keyword = words.word();
    if (keyword == "v") {
      const double x = words.coordinate(), y = words.coordinate(), z = words.coordinate();
      soup.points.push_back({x, y, z});
    } else if (keyword == "f" || keyword == "fo") {
      Polygon polygon;
      for (std::string_view word = words.word(); !word.empty(); word = words.word()) {
        polygon.push_back(corner(word, soup.points.size(), lines.number()));
        if (line_of_largest == 0 || polygon.back() > largest) {
          largest = polygon.back();
          line_of_largest = lines.number();
        }
      }
      soup.polygons.push_back(std::move(polygon));
    } else if (!keyword.empty() && (keyword.front() < 'A' || keyword.front() > 'z'))
      throw_expected(line_name(lines.number()), "a keyword such as v or f", keyword);
  }
  if (line_of_largest != 0 && largest >= soup.points.size())
    throw_expected(line_name(line_of_largest), fmt::format("the number of one of {} vertices", soup.points.size()),
                   std::to_string(std::uint64_t(largest) + 1));
  return soup;
}

} // namespace CGAL::Extremal_mesh_3
