// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Formula_lexer.h"

#include <CGAL/Extremal_mesh_3/Formula.h>

#include <array>
#include <charconv>
#include <system_error>
#include <utility>

#include <fmt/format.h>

namespace CGAL::Extremal_mesh_3::internal {
namespace {

// Not <cctype>: formulas do not depend on the locale.
bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}
bool is_space(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

/// the length of the well-formed UTF-8 sequence at the start of `s`, or 0.
std::size_t utf8_length(std::string_view s) {
  const auto lead = static_cast<unsigned char>(s[0]);
  const std::size_t length = lead < 0x80   ? 1
                             : lead < 0xC2 ? 0
                             : lead < 0xE0 ? 2
                             : lead < 0xF0 ? 3
                             : lead < 0xF5 ? 4
                                           : 0;
  if (length > s.size())
    return 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((static_cast<unsigned char>(s[i]) & 0xC0) != 0x80)
      return 0;
  return length;
}

// Characters that come with text pasted from papers and word processors, and what to write for them.
constexpr std::array<std::pair<std::string_view, std::string_view>, 21> replacements{{
    {"²", "^2"},
    {"³", "^3"},
    {"⁴", "^4"},
    {"⁻", "^-"},
    {"·", "*"},
    {"⋅", "*"},
    {"×", "*"},
    {"∗", "*"},
    {"÷", "/"},
    {"∕", "/"},
    {"−", "-"},
    {"–", "-"},
    {"—", "-"},
    {"π", "pi"},
    {"√", "sqrt(...)"},
    {"\u00A0", "a plain space"},
    {"\u2009", "a plain space"},
    {"[", "("},
    {"]", ")"},
    {"{", "("},
    {"|", "abs(...)"},
}};

} // namespace

void formula_error(std::size_t position, const std::string& what) {
  throw Formula_error(fmt::format("formula, column {}: {}", position + 1, what), position);
}

std::string describe(const Token& token) {
  return token.kind == Token::end ? "the end" : fmt::format("\"{}\"", token.text);
}

Token Formula_lexer::next() {
  while (position_ < text_.size() && is_space(text_[position_]))
    ++position_;
  Token token{Token::end, position_, {}, 0};
  if (position_ == text_.size())
    return token;
  const std::string_view rest = text_.substr(position_);
  const char c = rest[0];
  if (is_digit(c) || (c == '.' && rest.size() > 1 && is_digit(rest[1])))
    return number();
  std::size_t length = 1;
  if (is_letter(c)) {
    token.kind = Token::name;
    while (length < rest.size() && (is_letter(rest[length]) || is_digit(rest[length])))
      ++length;
    token.text = rest.substr(0, length);
  } else if (std::string_view("+-*/^(),=").find(c) != std::string_view::npos) {
    token.kind = Token::symbol;
    token.text = rest.substr(0, 1);
    if (rest.starts_with("**")) {
      length = 2;
      token.text = "^";
    }
  } else {
    unexpected_character();
  }
  position_ += length;
  return token;
}

Token Formula_lexer::number() {
  Token token{Token::number, position_, {}, 0};
  const char* const first = text_.data() + position_;
  const auto [last, error] = std::from_chars(first, text_.data() + text_.size(), token.value);
  token.text = {first, static_cast<std::size_t>(last - first)};
  if (error == std::errc::result_out_of_range)
    formula_error(position_,
                  fmt::format("the number {} is out of the range of double precision", token.text.substr(0, 40)));
  position_ += token.text.size();
  return token;
}

void Formula_lexer::unexpected_character() const {
  const std::string_view rest = text_.substr(position_);
  for (const auto& [character, replacement] : replacements)
    if (rest.starts_with(character))
      formula_error(position_, fmt::format("unexpected character \"{}\"; write {} instead", character, replacement));
  const std::size_t length = utf8_length(rest);
  const auto byte = static_cast<unsigned char>(rest[0]);
  if (length == 0 || byte < 0x20 || byte == 0x7F)
    formula_error(position_, fmt::format("unexpected byte 0x{:02X}", byte));
  formula_error(position_, fmt::format("unexpected character \"{}\"", rest.substr(0, length)));
}

} // namespace CGAL::Extremal_mesh_3::internal
