// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_POLYGONS_WORD_READER_H
#define EXTREMAL_MESH_3_SRC_POLYGONS_WORD_READER_H

#include <cstdint>
#include <string>
#include <string_view>

namespace CGAL::Extremal_mesh_3 {

/// The words of a text, between blanks. Knows in which line it is, for errors, which are `std::runtime_error`s such as
/// "line 3: expected a coordinate, found 'abc'".
class Word_reader {
public:
  /// \param comment  from this character on the rest of a line is left out; 0: there are no comments
  explicit Word_reader(std::string_view text, char comment = 0, std::size_t line = 1)
      : text_(text), comment_(comment), line_(line) {}

  /// \return the next word; empty at the end
  std::string_view word();
  /// leaves out the rest of the line in which the last word is.
  void skip_line();

  /// \param expected  what the words below must be, for the error
  double coordinate();
  std::uint64_t number(const char* expected);
  /// a number of things of which each takes some characters of what follows.
  /// \param least  how many characters it takes at least, blanks between them included
  std::uint64_t count(const char* expected, std::size_t least);
  /// the index of one of n things.
  std::uint32_t index(const char* expected, std::size_t n);

  std::size_t line() const { return line_; }
  std::string_view rest() const { return text_.substr(at_); }

private:
  std::string_view text_;
  char comment_;
  std::size_t line_;
  std::size_t at_ = 0;
};

/// \throws std::runtime_error "place: expected something, found 'word'"
[[noreturn]] void throw_expected(const std::string& place, const std::string& expected, std::string_view found);
inline std::string line_name(std::size_t line) {
  return "line " + std::to_string(line);
}

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_POLYGONS_WORD_READER_H
