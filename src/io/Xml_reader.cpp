// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The part of XML 1.0 that GraphML files use.
#include "Xml_reader.h"

#include <CGAL/Extremal_mesh_3/errors.h>

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdint>

namespace CGAL::Extremal_mesh_3 {

namespace {

constexpr bool is_space(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}

constexpr bool ends_name(char c) {
  return is_space(c) || c == '=' || c == '/' || c == '>' || c == '<' || c == '"' || c == '\'' || c == '&';
}

std::string_view without_prefix(std::string_view name) {
  return name.substr(name.find(':') + 1);
}

void append_utf8(std::string& out, std::uint32_t c) {
  const auto byte = [&](std::uint32_t b) { out += char(static_cast<unsigned char>(b)); };
  if (c < 0x80) {
    byte(c);
  } else if (c < 0x800) {
    byte(0xC0 | (c >> 6));
    byte(0x80 | (c & 0x3F));
  } else if (c < 0x10000) {
    byte(0xE0 | (c >> 12));
    byte(0x80 | ((c >> 6) & 0x3F));
    byte(0x80 | (c & 0x3F));
  } else {
    byte(0xF0 | (c >> 18));
    byte(0x80 | ((c >> 12) & 0x3F));
    byte(0x80 | ((c >> 6) & 0x3F));
    byte(0x80 | (c & 0x3F));
  }
}

} // namespace

Xml_reader::Xml_reader(std::string file, std::string_view text) : file_(std::move(file)), text_(text) {
  if (starts_with("\xEF\xBB\xBF")) // byte order mark
    at_ = 3;
  skip_space();
  if (!starts_with("<"))
    fail("this is not XML; it should begin with '<'");
}

Xml_reader::Tag Xml_reader::next() {
  characters_ = {};
  if (pending_end_) {
    pending_end_ = false;
    open_.pop_back();
    root_closed_ = open_.empty();
    return Tag::end;
  }
  decoded_.clear();
  do
    read_characters();
  while (at_ < text_.size() && read_markup());
  if (at_ == text_.size()) {
    if (!open_.empty())
      fail(fmt::format("the file ends inside <{}>; it is truncated", open_.back()));
    if (!root_closed_)
      fail("the file has no element");
    return Tag::end_of_text;
  }
  ++at_; // '<'
  const bool closing = starts_with("/");
  if (closing)
    ++at_;
  const std::string_view full_name = read_name();
  name_ = without_prefix(full_name);
  if (closing) {
    number_of_attributes_ = 0;
    skip_space();
    if (!starts_with(">"))
      fail(fmt::format("expected '>' after '</{}'", full_name));
    ++at_;
    if (open_.empty() || open_.back() != full_name)
      fail(fmt::format("</{}> closes an element that is not open", full_name));
    open_.pop_back();
    root_closed_ = open_.empty();
    return Tag::end;
  }
  if (root_closed_)
    fail(fmt::format("<{}> comes after the end of the document", full_name));
  read_attributes();
  pending_end_ = starts_with("/");
  if (pending_end_)
    ++at_;
  if (!starts_with(">"))
    fail(fmt::format("expected '>' at the end of the tag <{}", full_name));
  ++at_;
  open_.push_back(full_name);
  return Tag::start;
}

std::string_view Xml_reader::attribute(std::string_view name) const {
  for (std::size_t i = 0; i < number_of_attributes_; ++i)
    if (attributes_[i].first == name)
      return attributes_[i].second;
  return {};
}

void Xml_reader::skip_element() {
  for (const std::size_t depth = open_.size(); open_.size() >= depth;)
    next();
}

void Xml_reader::fail(std::string_view message) const {
  const std::size_t end = std::min(at_, text_.size());
  const auto line = 1 + std::count(text_.begin(), text_.begin() + std::ptrdiff_t(end), '\n');
  throw Io_error(fmt::format("{}:{}: {}", file_, line, message));
}

void Xml_reader::read_characters() {
  const std::size_t end = std::min(text_.find('<', at_), text_.size());
  const std::string_view raw = text_.substr(at_, end - at_);
  if (open_.empty() && !std::all_of(raw.begin(), raw.end(), is_space))
    fail("there are characters outside of the document's element");
  if (decoded_.empty() && characters_.empty() && raw.find('&') == raw.npos && raw.find('\r') == raw.npos) {
    characters_ = raw;
  } else {
    if (decoded_.empty())
      decoded_ = characters_;
    decode(raw, decoded_);
    characters_ = decoded_;
  }
  at_ = end;
}

bool Xml_reader::read_markup() {
  if (starts_with("<!--")) {
    at_ = find("-->", "this comment does not end") + 3;
  } else if (starts_with("<?")) {
    at_ = find("?>", "this processing instruction does not end") + 2;
  } else if (starts_with("<![CDATA[")) {
    const std::size_t begin = at_ + 9, end = find("]]>", "this CDATA section does not end");
    if (decoded_.empty())
      decoded_ = characters_;
    decoded_ += text_.substr(begin, end - begin);
    characters_ = decoded_;
    at_ = end + 3;
  } else if (starts_with("<!")) {
    const std::size_t end = find(">", "this declaration does not end");
    if (text_.substr(at_, end - at_).find('[') != text_.npos)
      fail("document types with declarations of their own are not supported");
    at_ = end + 1;
  } else {
    return false;
  }
  return true;
}

void Xml_reader::read_attributes() {
  number_of_attributes_ = 0;
  for (skip_space(); at_ < text_.size() && text_[at_] != '>' && text_[at_] != '/'; skip_space()) {
    const std::string_view name = read_name();
    skip_space();
    if (!starts_with("="))
      fail(fmt::format("attribute '{}' has no value", name));
    ++at_;
    skip_space();
    if (!starts_with("\"") && !starts_with("'"))
      fail(fmt::format("the value of attribute '{}' is not in quotes", name));
    const std::size_t end = text_.find(text_[at_], at_ + 1);
    if (end == text_.npos)
      fail(fmt::format("the value of attribute '{}' does not end", name));
    ++at_;
    if (number_of_attributes_ == attributes_.size())
      attributes_.emplace_back();
    auto& attribute = attributes_[number_of_attributes_++];
    attribute.first = name;
    attribute.second.clear();
    decode(text_.substr(at_, end - at_), attribute.second);
    at_ = end + 1;
  }
}

std::string_view Xml_reader::read_name() {
  std::size_t end = at_;
  while (end < text_.size() && !ends_name(text_[end]))
    ++end;
  if (end == at_)
    fail("expected a name");
  const std::string_view name = text_.substr(at_, end - at_);
  at_ = end;
  return name;
}

void Xml_reader::decode(std::string_view raw, std::string& out) const {
  static constexpr std::pair<std::string_view, char> entities[] = {
      {"lt", '<'}, {"gt", '>'}, {"amp", '&'}, {"quot", '"'}, {"apos", '\''}};
  for (std::size_t i = 0; i < raw.size(); ++i) {
    if (raw[i] == '\r') { // every end of line is one line feed to XML
      if (i + 1 == raw.size() || raw[i + 1] != '\n')
        out += '\n';
      continue;
    }
    if (raw[i] != '&') {
      out += raw[i];
      continue;
    }
    const std::size_t end = raw.find(';', i);
    if (end == raw.npos)
      fail("expected ';' after '&'");
    std::string_view entity = raw.substr(i + 1, end - i - 1);
    i = end;
    if (const auto* known = std::find_if(std::begin(entities), std::end(entities),
                                         [&](const auto& candidate) { return candidate.first == entity; });
        known != std::end(entities)) {
      out += known->second;
      continue;
    }
    std::uint32_t code = 0;
    const bool is_hexadecimal = entity.starts_with("#x");
    const std::string_view digits = entity.substr(std::min<std::size_t>(is_hexadecimal ? 2 : 1, entity.size()));
    const auto [last, error] =
        std::from_chars(digits.data(), digits.data() + digits.size(), code, is_hexadecimal ? 16 : 10);
    if (!entity.starts_with("#") || error != std::errc() || last != digits.data() + digits.size() || code == 0 ||
        code > 0x10FFFF || (code >= 0xD800 && code < 0xE000))
      fail(fmt::format("'&{};' is not a known entity", entity));
    append_utf8(out, code);
  }
}

void Xml_reader::skip_space() {
  while (at_ < text_.size() && is_space(text_[at_]))
    ++at_;
}

std::size_t Xml_reader::find(std::string_view what, std::string_view missing) const {
  const std::size_t position = text_.find(what, at_);
  if (position == text_.npos)
    fail(missing);
  return position;
}

} // namespace CGAL::Extremal_mesh_3
