// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_SRC_FORMULA_LEXER_H
#define CGAL_EXTREMAL_MESH_3_SRC_FORMULA_LEXER_H

#include <cstddef>
#include <string>
#include <string_view>

namespace CGAL::Extremal_mesh_3::internal {

/// throws Formula_error with "formula, column N: what".
[[noreturn]] void formula_error(std::size_t position, const std::string& what);

struct Token {
  enum Kind { number, name, symbol, end } kind = end;
  std::size_t position = 0;
  std::string_view text; ///< of a symbol: one of + - * / ^ ( ) , = with ** given as ^
  double value = 0;      ///< of a number
};

/// Cuts a formula into numbers, names and symbols. Whatever is not ASCII is an error, so that up to the first error
/// bytes and characters are the same.
class Formula_lexer {
public:
  explicit Formula_lexer(std::string_view text) : text_(text) {}

  /// \throws Formula_error at a character that no formula has, or a number that no double can hold
  Token next();

private:
  Token number();
  [[noreturn]] void unexpected_character() const;

  std::string_view text_;
  std::size_t position_ = 0;
};

/// describes a token in an error message.
std::string describe(const Token& token);

} // namespace CGAL::Extremal_mesh_3::internal

#endif // CGAL_EXTREMAL_MESH_3_SRC_FORMULA_LEXER_H
