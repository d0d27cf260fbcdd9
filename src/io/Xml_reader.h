// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_IO_XML_READER_H
#define CGAL_EXTREMAL_MESH_3_IO_XML_READER_H

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

/// Walks through the tags of an XML text (UTF-8, no internal DTD) once, in order, checking that it is well formed. A
/// document tree of a large extremal mesh would take several times the memory of the mesh.
class Xml_reader {
public:
  enum class Tag { start, end, end_of_text };

  /// \param file  the name for messages
  Xml_reader(std::string file, std::string_view text);

  /// goes to the next tag; an empty element `<a/>` gives a start and an end.
  /// \throws Io_error with file, line and what is wrong
  Tag next();

  /// the name of the current tag, without a namespace's prefix.
  std::string_view name() const { return name_; }
  /// the characters between the tag before and the current one. Valid until `next()`.
  std::string_view text() const { return characters_; }
  /// the value of an attribute of the current start tag; empty if there is none.
  std::string_view attribute(std::string_view name) const;

  /// goes past the end of the element whose start is the current tag.
  void skip_element();

  /// \throws Io_error saying `file:line: message`
  [[noreturn]] void fail(std::string_view message) const;

private:
  void read_characters();
  bool read_markup(); ///< comment, CDATA, processing instruction or document type
  void read_attributes();
  std::string_view read_name();
  void decode(std::string_view raw, std::string& out) const;
  void skip_space();
  std::size_t find(std::string_view what, std::string_view missing) const;
  bool starts_with(std::string_view what) const { return text_.substr(at_).starts_with(what); }

  std::string file_;
  std::string_view text_;
  std::size_t at_ = 0;
  bool pending_end_ = false, root_closed_ = false;
  std::string_view name_, characters_;
  std::string decoded_; ///< `characters_` where they are not a part of the text as they stand
  std::vector<std::pair<std::string_view, std::string>> attributes_;
  std::size_t number_of_attributes_ = 0; ///< `attributes_` never shrinks, so that its strings keep their memory
  std::vector<std::string_view> open_;   ///< full names of the elements around
};

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_IO_XML_READER_H
